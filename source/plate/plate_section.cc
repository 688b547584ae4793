#include "plate_impact/plate/plate_section.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>

namespace PlateImpact
{
  PlateSection::PlateSection(const PlateParameters &plate)
    : thickness(plate.thickness)
  {
    const double E = plate.youngs_modulus, nu = plate.poissons_ratio,
                 t = plate.thickness;
    const double D = E * t * t * t / (12. * (1. - nu * nu));

    bending_stiffness << D, D * nu, 0., //
      D * nu, D, 0.,                    //
      0., 0., D * (1. - nu) / 2.;
    bending_compliance = bending_stiffness.inverse();
    shear_stiffness = plate.shear_correction_factor * E / (2. * (1. + nu)) * t;
    mass            = plate.density * t;
    rotary_inertia  = plate.density * t * t * t / 12.;
  }



  double
  PlateSection::energy_density(const Resultants &resultants) const
  {
    const auto M = resultants.head<3>();
    const auto Q = resultants.tail<2>();
    return M.dot(bending_compliance * M) + Q.squaredNorm() / shear_stiffness;
  }



  Eigen::Matrix<double, 5, 5>
  PlateSection::stiffness() const
  {
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
    matrix.topLeftCorner<3, 3>()       = bending_stiffness;
    matrix(3, 3) = matrix(4, 4) = shear_stiffness;
    return matrix;
  }



  Eigen::Matrix<double, 5, 5>
  PlateSection::root_of_compliance() const
  {
    Eigen::Matrix<double, 5, 5> root = Eigen::Matrix<double, 5, 5>::Zero();
    root.topLeftCorner<3, 3>()       = bending_compliance.llt().matrixU();
    root(3, 3) = root(4, 4) = 1. / std::sqrt(shear_stiffness);
    return root;
  }



  double
  PlateSection::surface_von_mises_stress(const double m_x,
                                         const double m_y,
                                         const double m_xy) const
  {
    return 6. / (thickness * thickness) *
      std::sqrt(m_x * m_x - m_x * m_y + m_y * m_y + 3. * m_xy * m_xy);
  }
} // namespace PlateImpact
