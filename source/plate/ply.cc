#include "plate_impact/plate/ply.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    PlyParameters
    without_zeros(PlyParameters ply)
    {
      if (ply.through_thickness_modulus == 0.)
        ply.through_thickness_modulus = ply.transverse_modulus;
      if (ply.through_thickness_poissons_ratio == 0.)
        ply.through_thickness_poissons_ratio = ply.poissons_ratio;
      if (ply.transverse_poissons_ratio == 0.)
        ply.transverse_poissons_ratio =
          ply.transverse_modulus / (2. * ply.transverse_shear_modulus) - 1.;
      return ply;
    }



    /// Strains e_1, e_2, e_3 per stresses.
    Eigen::Matrix3d
    normal_compliance(const PlyParameters &ply)
    {
      const auto &[E1, E2, nu12, G12, G13, G23, E3, nu13, nu23, G_IIc] = ply;
      Eigen::Matrix3d S;
      S << 1. / E1, -nu12 / E1, -nu13 / E1, //
        -nu12 / E1, 1. / E2, -nu23 / E2,    //
        -nu13 / E1, -nu23 / E2, 1. / E3;
      return S;
    }



    /// E* of a half-space that is the same in all directions of its surface.
    double
    modulus_of_half_space(const double C11,
                          const double C33,
                          const double C13,
                          const double C44)
    {
      const double determinant = C11 * C33 - C13 * C13;
      return 2. * determinant /
        (C11 *
         std::sqrt((determinant - 2. * C13 * C44) / (C11 * C44) +
                   2. * std::sqrt(C33 / C11)));
    }
  } // namespace



  Ply::Ply(const PlyParameters &given)
    : constants(without_zeros(given))
    , stiffness(normal_compliance(constants).inverse())
  {}



  bool
  Ply::is_elastic() const
  {
    // without units, so that stiff and soft directions count alike
    const Eigen::Matrix3d compliance = normal_compliance(constants);
    const Eigen::Vector3d scale =
      compliance.diagonal().cwiseSqrt().cwiseInverse();
    return (scale.asDiagonal() * compliance * scale.asDiagonal())
             .eval()
             .llt()
             .info() == Eigen::Success;
  }



  Eigen::Matrix3d
  Ply::plane_stiffness() const
  {
    const double E1   = constants.longitudinal_modulus,
                 E2   = constants.transverse_modulus,
                 nu12 = constants.poissons_ratio, nu21 = nu12 * E2 / E1;
    Eigen::Matrix3d Q;
    Q << E1, nu12 * E2, 0., //
      nu21 * E1, E2, 0.,    //
      0., 0., constants.in_plane_shear_modulus * (1. - nu12 * nu21);
    return Q / (1. - nu12 * nu21);
  }



  double
  Ply::half_space_modulus() const
  {
    const Eigen::Matrix3d &C   = stiffness;
    const double           G12 = constants.in_plane_shear_modulus,
                 G13           = constants.longitudinal_shear_modulus,
                 G23           = constants.transverse_shear_modulus;
    const double bulk          = modulus_of_half_space(
      (3. * C(0, 0) + 3. * C(1, 1) + 2. * C(0, 1) + 4. * G12) / 8.,
      C(2, 2),
      (C(0, 2) + C(1, 2)) / 2.,
      2. / (1. / G13 + 1. / G23));
    const double along  = modulus_of_half_space(C(0, 0), C(2, 2), C(0, 2), G13),
                 across = modulus_of_half_space(C(1, 1), C(2, 2), C(1, 2), G23);
    return 2. / (1. / bulk + 0.5 * (1. / along + 1. / across));
  }



  Eigen::Matrix2d
  shear_stiffness_of_equilibrium(
    const std::vector<Eigen::Matrix3d> &plane_stiffness,
    const std::vector<Eigen::Matrix2d> &shear_moduli)
  {
    const dealii::QGauss<1> gauss(3); // exact: tau is a parabola in every ply
    const unsigned int      n_directions = 24;
    const std::size_t       n_plies      = plane_stiffness.size();
    Eigen::Matrix<double, -1, 3> products(n_directions, 3);
    Eigen::VectorXd              energies = Eigen::VectorXd::Zero(n_directions);
    std::vector<Eigen::Matrix2d> shear_compliances;
    for (const Eigen::Matrix2d &moduli : shear_moduli)
      shear_compliances.push_back(moduli.inverse());
    for (unsigned int i = 0; i < n_directions; ++i)
      {
        const double angle = std::acos(-1.) * i / n_directions,
                     c = std::cos(angle), s = std::sin(angle);
        Eigen::Matrix<double, 2, 3> N;
        N << c, 0., s, 0., s, c;
        const Eigen::Vector3d curvature(c * c, s * s, 2. * c * s);
        Eigen::Vector2d       at_far_face = Eigen::Vector2d::Zero(),
                        force             = Eigen::Vector2d::Zero();
        for (std::size_t k = n_plies; k-- > 0;)
          {
            const double near = static_cast<double>(k) / n_plies - 0.5,
                         t = 1. / n_plies, far = near + t;
            const Eigen::Vector2d slope = N * (plane_stiffness[k] * curvature);
            const auto            tau   = [&](const double z) {
              return (at_far_face + 0.5 * (far * far - z * z) * slope).eval();
            };
            for (unsigned int q = 0; q < gauss.size(); ++q)
              {
                const Eigen::Vector2d stress =
                  tau(near + gauss.point(q)[0] * t);
                force += gauss.weight(q) * t * stress;
                energies(i) += gauss.weight(q) * t *
                  stress.dot(shear_compliances[k] * stress);
              }
            at_far_face = tau(near);
          }
        energies(i) /= force.squaredNorm();
        force.normalize();
        products.row(i) << force(0) * force(0), force(1) * force(1),
          2. * force(0) * force(1);
      }
    const Eigen::Vector3d H = products.colPivHouseholderQr().solve(energies);
    Eigen::Matrix2d       compliance;
    compliance << H(0), H(2), H(2), H(1);
    return compliance.inverse();
  }
} // namespace PlateImpact
