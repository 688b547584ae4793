#include "plate_impact/plate/plate_section.h"

#include "plate_impact/plate/ply.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Of angles that are multiples of 90 degrees what round-off leaves.
    constexpr double negligible = 1e-9;



    /// Turns strains e_x, e_y, gamma_xy into those of axes turned by an angle;
    /// its transpose turns stresses back.
    Eigen::Matrix3d
    turned_strains(const double angle)
    {
      const double    c = std::cos(angle), s = std::sin(angle);
      Eigen::Matrix3d T;
      T << c * c, s * s, c * s, //
        s * s, c * c, -c * s,   //
        -2. * c * s, 2. * c * s, c * c - s * s;
      return T;
    }

  } // namespace



  PlateSection::PlateSection(const PlateParameters &plate)
    : shear_correction_factor(plate.shear_correction_factor > 0. ?
                                plate.shear_correction_factor :
                                5. / 6.)
    , thickness(plate.thickness)
  {
    const double t = thickness;
    coupling_stiffness.setZero();
    mass_per_area  = plate.density * t;
    rotary_inertia = plate.density * t * t * t / 12.;
    if (plate.is_laminate())
      set_laminate(plate);
    else
      set_isotropic(plate);
    bending_compliance = bending_stiffness.inverse();
    shear_compliance   = shear_stiffness.inverse();
    for (Eigen::Matrix3d &stress : stress_of_ply)
      stress *= bending_compliance;
  }



  void
  PlateSection::set_isotropic(const PlateParameters &plate)
  {
    const double E = plate.youngs_modulus, nu = plate.poissons_ratio,
                 t = thickness;
    const double D = E * t * t * t / (12. * (1. - nu * nu));
    bending_stiffness << D, D * nu, 0., //
      D * nu, D, 0.,                    //
      0., 0., D * (1. - nu) / 2.;
    shear_modulus   = E / (2. * (1. + nu));
    shear_stiffness = shear_correction_factor * E / (2. * (1. + nu)) * t *
      Eigen::Matrix2d::Identity();
    poissons_ratio        = nu;
    contact_modulus       = E;
    half_space_compliance = (1. - nu * nu) / E;
  }



  void
  PlateSection::set_laminate(const PlateParameters &plate)
  {
    const Ply             ply(plate.ply);
    const PlyParameters  &constants = ply.constants();
    const auto           &angles    = plate.layup.angles;
    const Eigen::Matrix3d Q         = ply.plane_stiffness();
    const double          t         = thickness / angles.size();

    std::vector<Eigen::Matrix3d> plane_stiffness;
    std::vector<Eigen::Matrix2d> shear_moduli;
    bending_stiffness.setZero();
    shear_stiffness.setZero();
    for (std::size_t k = 0; k < angles.size(); ++k)
      {
        const double angle = angles[k] * std::acos(-1.) / 180.,
                     c = std::cos(angle), s = std::sin(angle);
        // faces of the ply from the middle surface
        const double          near = -0.5 * thickness + k * t, far = near + t;
        const Eigen::Matrix3d T = turned_strains(angle);
        plane_stiffness.push_back(T.transpose() * Q * T);
        bending_stiffness +=
          (far * far * far - near * near * near) / 3. * plane_stiffness.back();
        coupling_stiffness +=
          (far * far - near * near) / 2. * plane_stiffness.back();
        Eigen::Matrix2d turn;
        turn << c, s, -s, c;
        shear_moduli.push_back(
          turn.transpose() *
          Eigen::Vector2d(constants.longitudinal_shear_modulus,
                          constants.transverse_shear_modulus)
            .asDiagonal() *
          turn);
        shear_stiffness += shear_correction_factor * t * shear_moduli.back();
        // the farther face; sigma = Q T z kappa
        stress_of_ply.push_back(std::max(std::abs(near), std::abs(far)) * Q *
                                T);
      }
    if (plate.shear_correction_factor == 0.)
      shear_stiffness = thickness *
        shear_stiffness_of_equilibrium(plane_stiffness, shear_moduli);

    half_space_compliance = 1. / ply.half_space_modulus();
    poissons_ratio        = ply.layer_poissons_ratio();
    shear_modulus   = 0.5 * (1. - poissons_ratio) * ply.half_space_modulus();
    contact_modulus = constants.transverse_modulus;
  }



  double
  PlateSection::bending_stiffness_along(const double angle) const
  {
    const double    c = std::cos(angle), s = std::sin(angle);
    Eigen::Vector3d curvature(c * c, s * s, 2. * c * s);
    return curvature.dot(bending_stiffness * curvature);
  }



  double
  PlateSection::mean_bending_stiffness() const
  {
    if (twists_when_bent())
      {
        // Olsson's formula holds in the axes of an orthotropic plate; this is
        // the mean over directions that it stands for
        const unsigned int n    = 180;
        double             mean = 0.;
        for (unsigned int i = 0; i < n; ++i)
          mean +=
            1. / std::sqrt(bending_stiffness_along(std::acos(-1.) * i / n));
        return n / mean * (n / mean);
      }
    const double along =
      std::sqrt(bending_stiffness(0, 0)) * std::sqrt(bending_stiffness(1, 1));
    return std::sqrt(0.5 *
                     (1. +
                      (bending_stiffness(0, 1) + 2. * bending_stiffness(2, 2)) /
                        along)) *
      along;
  }



  double
  PlateSection::mean_shear_stiffness() const
  {
    return std::sqrt(shear_stiffness(0, 0)) * std::sqrt(shear_stiffness(1, 1));
  }



  double
  PlateSection::fastest_wave() const
  {
    double             largest = 0.;
    const unsigned int n       = 180;
    for (unsigned int i = 0; i < n; ++i)
      largest =
        std::max(largest, bending_stiffness_along(std::acos(-1.) * i / n));
    return std::sqrt(largest / rotary_inertia);
  }



  bool
  PlateSection::twists_when_bent() const
  {
    return bending_stiffness.topRightCorner<2, 1>().cwiseAbs().maxCoeff() >
      negligible * bending_stiffness.norm() ||
      std::abs(shear_stiffness(0, 1)) > negligible * shear_stiffness.norm();
  }



  bool
  PlateSection::is_unsymmetric() const
  {
    return coupling_stiffness.norm() * thickness >
      negligible * bending_stiffness.norm();
  }



  double
  PlateSection::squared_energy_norm(const Resultants &resultants) const
  {
    const auto M = resultants.head<3>();
    const auto Q = resultants.tail<2>();
    return M.dot(bending_compliance * M) + Q.dot(shear_compliance * Q);
  }



  Eigen::Matrix<double, 5, 5>
  PlateSection::stiffness() const
  {
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
    matrix.topLeftCorner<3, 3>()       = bending_stiffness;
    matrix.bottomRightCorner<2, 2>()   = shear_stiffness;
    return matrix;
  }



  Eigen::Matrix<double, 5, 5>
  PlateSection::root_of_compliance() const
  {
    Eigen::Matrix<double, 5, 5> root = Eigen::Matrix<double, 5, 5>::Zero();
    root.topLeftCorner<3, 3>()       = bending_compliance.llt().matrixU();
    root.bottomRightCorner<2, 2>()   = shear_compliance.llt().matrixU();
    return root;
  }



  const std::vector<std::string> &
  PlateSection::stress_names() const
  {
    static const std::vector<std::string> isotropic = {"von_mises_stress"},
                                          of_plies  = {"fibre_stress",
                                                       "transverse_stress",
                                                       "ply_shear_stress"};
    return stress_of_ply.empty() ? isotropic : of_plies;
  }



  Eigen::MatrixXd
  PlateSection::stresses(const double m_x,
                         const double m_y,
                         const double m_xy) const
  {
    if (stress_of_ply.empty())
      // sigma = 6 M / t^2
      return Eigen::MatrixXd::Constant(
        1,
        1,
        6. / (thickness * thickness) *
          std::sqrt(m_x * m_x - m_x * m_y + m_y * m_y + 3. * m_xy * m_xy));
    Eigen::MatrixXd result(stress_of_ply.size(), 3);
    for (std::size_t k = 0; k < stress_of_ply.size(); ++k)
      result.row(k) =
        (stress_of_ply[k] * Eigen::Vector3d(m_x, m_y, m_xy)).cwiseAbs();
    return result;
  }
} // namespace PlateImpact
