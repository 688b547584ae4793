#pragma once

#include "plate_impact/base/parameters.h"

#include <Eigen/Cholesky>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// Stress resultants M_x, M_y, M_xy [N] and Q_x, Q_y [N/m], or the strains
  /// conjugate to them: curvatures [1/m] and transverse shear strains. Of
  /// plates that stretch the membrane forces N_x, N_y, N_xy [N/m] and the
  /// strains of the middle surface follow.
  using Resultants = Eigen::Matrix<double, 5, 1>;

  /// What a plate needs displacements in its plane for.
  enum class Stretching
  {
    none,
    linear, ///< a lay-up that is not symmetric
    large   ///< slopes whose squares count
  };

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


  /// The section of a Reissner-Mindlin plate, homogeneous and isotropic or a
  /// laminate (classical lamination theory with first-order shear, Reddy,
  /// Mechanics of Laminated Composite Plates and Shells, 2nd ed., secs. 2.4 and
  /// 3.4), and the isotropic layer that answers a contact as it does. The only
  /// place of the material. A symmetric section that deflects little needs none
  /// of the paper's in-plane unknowns; as stresses are linear through each ply,
  /// resultants give the energies of its through-thickness Gauss points.
  struct PlateSection
  {
    explicit PlateSection(const PlateParameters &plate);

    /// Moments per curvature: of an isotropic plate D = E t^3 / (12 (1 -
    /// nu^2)) times the plane stress matrix. [N m]
    Eigen::Matrix3d bending_stiffness = Eigen::Matrix3d::Zero();

    /// Shear forces per shear strains: kappa times the integral of the shear
    /// moduli, or what equilibrium asks for. [N/m]
    Eigen::Matrix2d shear_stiffness = Eigen::Matrix2d::Zero();

    /// Membrane forces per strain of the middle surface. [N/m]
    Eigen::Matrix3d membrane_stiffness = Eigen::Matrix3d::Zero();

    /// Membrane forces per curvature, none of a symmetric section: a fibre at z
    /// from the middle to the far face is strained by -z times it. [N]
    Eigen::Matrix3d coupling_stiffness = Eigen::Matrix3d::Zero();

    /// rho t. [kg/m^2]
    double mass_per_area;

    /// rho t^3 / 12. [kg]
    double rotary_inertia;

    /// Of the law Sun: E, of a laminate E_2 (Yang & Sun, NASA CR-165460,
    /// 1981). [Pa]
    double contact_modulus;

    /// Of a half-space of the same in Hertz's law: (1 - nu^2) / E, of a
    /// laminate 1 / E* (Ply). [1/Pa]
    double half_space_compliance;

    /// nu of the isotropic layer that answers a contact as this plate.
    double poissons_ratio;

    /// G of that layer, (1 - nu) E* / 2. [Pa]
    double shear_modulus;

    Stretching stretching = Stretching::none;

    /// kappa of the scene; 5/6 where it leaves that to equilibrium.
    double shear_correction_factor;

    /// D of the isotropic plate that resists a point load as this one:
    /// sqrt(D_11 D_22 (1 + eta) / 2), eta = (D_12 + 2 D_66) / sqrt(D_11 D_22)
    /// (Olsson, AIAA J. 30, 1992, p. 1587). [N m]
    /// With D_16 or D_26 the mean over directions of D^{-1/2}, to the power -2.
    /// Of a section that is not symmetric with the middle surface relaxed, D -
    /// B A^-1 B.
    double
    mean_bending_stiffness() const;

    /// Of all directions. [N/m]
    double
    mean_shear_stiffness() const
    {
      return std::sqrt(shear_stiffness(0, 0)) *
        std::sqrt(shear_stiffness(1, 1));
    }

    /// Speed of the fastest wave, at infinite frequency: of bending, and where
    /// the plate stretches of both together. [m/s]
    double
    fastest_wave() const;

    /// Whether the plate mirrors in no line: it twists when bent or stretched.
    bool
    is_skew() const;

    /// Whether bending stretches the middle surface.
    bool
    is_unsymmetric() const;

    /// 5, or 8 of plates that stretch.
    unsigned int
    n_resultants() const
    {
      return stretching == Stretching::none ? 5 : 8;
    }

    /// Resultants per strains; its bending part is bending_stiffness.
    Eigen::MatrixXd
    stiffness() const;

    /// R, upper triangular: of resultants s, |R s|^2 = s^T D^-1 s is the square
    /// of the energy norm in Table 1 of the paper per area, twice their strain
    /// energy. [J/m^2]
    Eigen::MatrixXd
    root_of_compliance() const
    {
      return compliance.llt().matrixU();
    }

    /// The first resultants of which stresses() needs.
    unsigned int
    n_for_stresses() const
    {
      return stretching == Stretching::none ? 3 : 8;
    }

    /// Names in files of the stresses at the faces, and in words: the paper's
    /// effective stress, von Mises; of a ply those along and across its fibres,
    /// and its shear stress.
    const std::vector<std::pair<std::string, std::string>> &
    stress_names() const;

    /// Their magnitudes, the larger of both faces: a row a ply, a column a
    /// name. No transverse shear. [Pa]
    /// @param resultants  n_for_stresses() or more
    Eigen::MatrixXd
    stresses(const Eigen::Ref<const Eigen::VectorXd> &resultants) const;

  private:
    void
    set_plies(const PlateParameters &plate);

    /// A ply between two z from the middle [m], and its stresses per strain.
    struct PlyStresses
    {
      double          near, far;
      Eigen::Matrix3d stress_per_strain;
    };

    double                   thickness;
    Eigen::MatrixXd          compliance; ///< strains per resultants
    bool                     is_laminate;
    std::vector<PlyStresses> plies; ///< one of a plate that is no laminate
  };


  /// A resultant of the section, or a stress that it causes, at some points.
  struct SectionField
  {
    std::string         name, unit; ///< "moment M_x", "N"
    std::string         name_in_file;
    std::array<bool, 2> is_odd; ///< changes its sign across x = 0, y = 0
    Eigen::VectorXd     values;
  };

  /// In the order of Resultants, without values.
  extern const std::vector<SectionField> resultant_fields;

  /// The resultants, and the largest stresses of the section under them: von
  /// Mises at the faces, or the three of the plies.
  /// @param resultants  n_resultants() in the order of Resultants, a column per
  ///                    point
  std::vector<SectionField>
  section_fields(const PlateSection    &section,
                 const Eigen::MatrixXd &resultants);
} // namespace PlateImpact
