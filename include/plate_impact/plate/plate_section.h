#ifndef plate_impact_plate_plate_section_h
#define plate_impact_plate_plate_section_h

#include "plate_impact/base/parameters.h"

#include <Eigen/Core>

namespace PlateImpact
{
  /// Stress resultants M_x, M_y, M_xy [N] and Q_x, Q_y [N/m], or the
  /// generalized strains conjugate to them: curvatures [1/m] and transverse
  /// shear strains.
  using Resultants = Eigen::Matrix<double, 5, 1>;

  /// The homogeneous isotropic section of a Reissner-Mindlin plate: what its
  /// strains cost and what it weighs. The only place of the material. A
  /// flat plate under transverse load has no membrane response, so the paper's
  /// in-plane unknowns are left out; stresses are linear through the thickness,
  /// so that resultants give the energies of its through-thickness Gauss
  /// points.
  struct PlateSection
  {
    explicit PlateSection(const PlateParameters &plate);

    /// Moments per curvature, D = E t^3 / (12 (1 - nu^2)) times the plane
    /// stress matrix. [N m]
    Eigen::Matrix3d bending_stiffness;

    /// Shear force per shear strain, kappa G t. [N/m]
    double shear_stiffness;

    /// rho t. [kg/m^2]
    double mass;

    /// rho t^3 / 12. [kg]
    double rotary_inertia;

    /// Twice the strain energy density of resultants, sigma^T D^-1 sigma, of
    /// the norms in Table 1 of the paper. [J/m^2]
    double
    energy_density(const Resultants &resultants) const;

    /// Resultants per strains; its bending part is bending_stiffness.
    Eigen::Matrix<double, 5, 5>
    stiffness() const;

    /// R, upper triangular, with energy_density(s) = |R s|^2.
    Eigen::Matrix<double, 5, 5>
    root_of_compliance() const;

    /// Von Mises stress at the faces of the plate, the paper's effective
    /// stress: sigma = 6 M / t^2, no transverse shear. [Pa]
    double
    surface_von_mises_stress(double m_x, double m_y, double m_xy) const;

  private:
    double          thickness;
    Eigen::Matrix3d bending_compliance;
  };
} // namespace PlateImpact

#endif
