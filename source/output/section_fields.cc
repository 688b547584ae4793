#include "plate_impact/output/section_fields.h"

#include <utility>

namespace PlateImpact
{
  std::vector<SectionField>
  section_fields(const PlateSection                             &section,
                 const Eigen::Matrix<double, 5, Eigen::Dynamic> &resultants)
  {
    std::vector<SectionField> fields = {
      {"moment M_x", "N", {{false, false}}, {}},
      {"moment M_y", "N", {{false, false}}, {}},
      {"moment M_xy", "N", {{true, true}}, {}},
      {"shear force Q_x", "N/m", {{true, false}}, {}},
      {"shear force Q_y", "N/m", {{false, true}}, {}}};
    for (std::size_t i = 0; i < fields.size(); ++i)
      fields[i].values = resultants.row(i);

    const std::vector<std::string> stresses =
      section.stress_names().size() == 1 ?
      std::vector<std::string>{"von Mises stress at the faces"} :
      std::vector<std::string>{"largest stress along fibres",
                               "largest stress across fibres",
                               "largest shear stress of plies"};
    Eigen::MatrixXd largest(resultants.cols(), stresses.size());
    for (Eigen::Index p = 0; p < resultants.cols(); ++p)
      largest.row(p) =
        section.stresses(resultants(0, p), resultants(1, p), resultants(2, p))
          .colwise()
          .maxCoeff();
    for (std::size_t k = 0; k < stresses.size(); ++k)
      fields.push_back({stresses[k], "Pa", {{false, false}}, largest.col(k)});
    return fields;
  }
} // namespace PlateImpact
