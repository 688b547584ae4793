#pragma once

#include "plate_impact/base/parameters.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// A ply in three dimensions and in its own axes: 1 along the fibres, 2
  /// across them, 3 through the thickness.
  class Ply
  {
  public:
    /// Those of E_3, nu_13 and nu_23 that are 0 become those of a ply that is
    /// the same in all directions across its fibres: E_2, nu_12 and E_2 / (2
    /// G_23) - 1.
    explicit Ply(const PlyParameters &given);

    const PlyParameters constants;

    /// Whether every strain costs energy.
    bool
    is_elastic() const;

    /// Q of plane stress, of e_1, e_2 and gamma_12. [Pa]
    Eigen::Matrix3d
    plane_stiffness() const;

    /// E* that many turned plies have together as a half-space under a sphere,
    /// where the contact is one to four plies wide:
    ///   1 / E* = (1 / E_bulk + 1 / E_face) / 2,
    /// E_bulk of the mean of all directions, E_face of the struck ply alone,
    /// both from the closed form of a half-space that is transversely isotropic
    /// across its surface (Turner, Int. J. Solids Struct. 16, 1980, p. 409).
    /// Half and half is empirical (doc/theory.md). E / (1 - nu^2) where the ply
    /// is isotropic. [Pa]
    double
    half_space_modulus() const;

    /// nu of the isotropic layer that squeezed through its thickness widens as
    /// much as turned plies: nu / (1 - nu) = (C_13 + C_23) / (2 C_33).
    double
    layer_poissons_ratio() const
    {
      const double widening =
        (stiffness(0, 2) + stiffness(1, 2)) / (2. * stiffness(2, 2));
      return widening / (1. + widening);
    }

  private:
    const Eigen::Matrix3d stiffness; ///< C_ij of the normal strains
  };



  /// Shear forces per shear strains with the energy that equilibrium asks for:
  /// in cylindrical bending along n = (c, s), with the curvatures v = (c^2,
  /// s^2, 2 c s) and the face of a plate of unit thickness at 1/2,
  ///   tau(z) = int_z^{1/2} N Q v z' dz',  N = [c 0 s; 0 s c],
  ///   Q_n^T A^{-1} Q_n = int tau^T G^{-1} tau dz,  Q_n = int tau dz,
  /// A by least squares of the energies of unit forces over all directions. Of
  /// a homogeneous isotropic plate 5/6 G.
  /// @param plane_stiffness  of equally thick plies in the axes of the plate,
  ///                         from the struck face [Pa]
  /// @param shear_moduli     of xz and yz [Pa]
  /// @return A over thickness [Pa]
  Eigen::Matrix2d
  shear_stiffness_of_equilibrium(
    const std::vector<Eigen::Matrix3d> &plane_stiffness,
    const std::vector<Eigen::Matrix2d> &shear_moduli);
} // namespace PlateImpact
