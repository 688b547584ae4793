#ifndef plate_impact_output_section_fields_h
#define plate_impact_output_section_fields_h

#include "plate_impact/plate/plate_section.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A resultant of the section, or a stress that it causes, at some points.
  struct SectionField
  {
    std::string         name, unit; ///< "moment M_x", "N"
    std::string         name_in_file;
    std::array<bool, 2> is_odd; ///< changes its sign across x = 0, y = 0
    Eigen::VectorXd     values;
  };

  /// The resultants, and the largest stresses of the section under them: von
  /// Mises at the faces, or the three of the plies.
  /// @param resultants  M_x, M_y, M_xy [N], Q_x, Q_y [N/m] and, of plates that
  ///                    stretch, N_x, N_y, N_xy [N/m], a column per point
  std::vector<SectionField>
  section_fields(const PlateSection    &section,
                 const Eigen::MatrixXd &resultants);
} // namespace PlateImpact

#endif
