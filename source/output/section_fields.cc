#include "plate_impact/output/section_fields.h"


namespace PlateImpact
{
  std::vector<SectionField>
  section_fields(const PlateSection &section, const Eigen::MatrixXd &resultants)
  {
    std::vector<SectionField> fields = {
      {"moment M_x", "N", "moment_x", {{false, false}}, {}},
      {"moment M_y", "N", "moment_y", {{false, false}}, {}},
      {"moment M_xy", "N", "moment_xy", {{true, true}}, {}},
      {"shear force Q_x", "N/m", "shear_force_x", {{true, false}}, {}},
      {"shear force Q_y", "N/m", "shear_force_y", {{false, true}}, {}},
      {"membrane force N_x", "N/m", "membrane_force_x", {{false, false}}, {}},
      {"membrane force N_y", "N/m", "membrane_force_y", {{false, false}}, {}},
      {"membrane force N_xy", "N/m", "membrane_force_xy", {{true, true}}, {}}};
    fields.resize(resultants.rows());
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
      largest.row(p) = section.stresses(resultants.col(p)).colwise().maxCoeff();
    for (std::size_t k = 0; k < stresses.size(); ++k)
      fields.push_back({stresses[k],
                        "Pa",
                        section.stress_names()[k],
                        {{false, false}},
                        largest.col(k)});
    return fields;
  }
} // namespace PlateImpact
