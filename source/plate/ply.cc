#include "plate_impact/plate/plate_section.h"

#include <Eigen/LU>

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
    return normal_compliance(constants).llt().info() == Eigen::Success;
  }



  Eigen::Matrix3d
  Ply::plane_stiffness() const
  {
    const auto &[E1, E2, nu12, G12, G13, G23, E3, nu13, nu23, G_IIc] =
      constants;
    const double    nu21 = nu12 * E2 / E1;
    Eigen::Matrix3d Q;
    Q << E1, nu12 * E2, 0., //
      nu21 * E1, E2, 0.,    //
      0., 0., G12 * (1. - nu12 * nu21);
    return Q / (1. - nu12 * nu21);
  }



  double
  Ply::half_space_modulus() const
  {
    const auto &[E1, E2, nu12, G12, G13, G23, E3, nu13, nu23, G_IIc] =
      constants;
    const Eigen::Matrix3d &C    = stiffness;
    const double           bulk = modulus_of_half_space(
      (3. * C(0, 0) + 3. * C(1, 1) + 2. * C(0, 1) + 4. * G12) / 8.,
      C(2, 2),
      (C(0, 2) + C(1, 2)) / 2.,
      2. / (1. / G13 + 1. / G23));
    const double along  = modulus_of_half_space(C(0, 0), C(2, 2), C(0, 2), G13),
                 across = modulus_of_half_space(C(1, 1), C(2, 2), C(1, 2), G23);
    return 2. / (1. / bulk + 0.5 * (1. / along + 1. / across));
  }
} // namespace PlateImpact
