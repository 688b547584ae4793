#include "plate_impact/plate/plate_section.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>

namespace PlateImpact
{
  namespace
  {
    /// Of angles that are multiples of 90 degrees what round-off leaves.
    constexpr double negligible = 1e-9;

    constexpr unsigned int n_directions = 180;



    /// Moment per curvature of cylindrical bending in one of all directions,
    /// from moments per curvatures. [N m]
    double
    stiffness_along(const unsigned int direction, const Eigen::Matrix3d &D)
    {
      const double angle = std::acos(-1.) * direction / n_directions,
                   c = std::cos(angle), s = std::sin(angle);
      const Eigen::Vector3d curvature(c * c, s * s, 2. * c * s);
      return curvature.dot(D * curvature);
    }



    /// Whether strains along the axes cause what twists or shears.
    bool
    twists(const Eigen::Matrix3d &stiffness)
    {
      return stiffness.topRightCorner<2, 1>().cwiseAbs().maxCoeff() >
        negligible * stiffness.norm();
    }



    /// The material in the axes of a ply.
    PlyParameters
    ply_of(const PlateParameters &plate)
    {
      if (plate.is_laminate())
        return plate.ply;
      const double E = plate.youngs_modulus, nu = plate.poissons_ratio,
                   G = E / (2. * (1. + nu));
      return {E, E, nu, G, G, G};
    }



    /// Shear forces per shear strains with the energy that equilibrium asks
    /// for: in cylindrical bending along n = (c, s), with the curvatures v =
    /// (c^2, s^2, 2 c s) and the face of a plate of unit thickness at 1/2,
    ///   tau(z) = int_z^{1/2} N Q v z' dz',  N = [c 0 s; 0 s c],
    ///   Q_n^T A^{-1} Q_n = int tau^T G^{-1} tau dz,  Q_n = int tau dz,
    /// A by least squares of the energies of unit forces over all directions.
    /// Of a homogeneous isotropic plate 5/6 G.
    /// @param plane_stiffness  of equally thick plies in the axes of the plate,
    ///                         from the struck face [Pa]
    /// @param shear_moduli     of xz and yz [Pa]
    /// @return A over thickness [Pa]
    Eigen::Matrix2d
    shear_stiffness_of_equilibrium(
      const std::vector<Eigen::Matrix3d> &plane_stiffness,
      const std::vector<Eigen::Matrix2d> &shear_moduli)
    {
      const dealii::QGauss<1> gauss(3); // exact: tau is a parabola in every ply
      const unsigned int      n_around = 24;
      const std::size_t       n_plies  = plane_stiffness.size();
      Eigen::Matrix<double, -1, 3> products(n_around, 3);
      Eigen::VectorXd              energies = Eigen::VectorXd::Zero(n_around);
      for (unsigned int i = 0; i < n_around; ++i)
        {
          const double angle = std::acos(-1.) * i / n_around,
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
              const Eigen::Vector2d slope =
                N * (plane_stiffness[k] * curvature);
              const auto tau = [&](const double z) {
                return (at_far_face + 0.5 * (far * far - z * z) * slope).eval();
              };
              for (unsigned int q = 0; q < gauss.size(); ++q)
                {
                  const Eigen::Vector2d stress =
                    tau(near + gauss.point(q)[0] * t);
                  force += gauss.weight(q) * t * stress;
                  energies(i) += gauss.weight(q) * t *
                    stress.dot(shear_moduli[k].inverse() * stress);
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
  } // namespace



  PlateSection::PlateSection(const PlateParameters &plate)
    : shear_correction_factor(plate.shear_correction_factor > 0. ?
                                plate.shear_correction_factor :
                                5. / 6.)
    , thickness(plate.thickness)
    , is_laminate(plate.is_laminate())
  {
    const double t = thickness;
    mass_per_area  = plate.density * t;
    rotary_inertia = plate.density * t * t * t / 12.;
    set_plies(plate);
    if (!is_laminate)
      {
        // From the ply, which inverts its compliance, they would lose digits
        // near nu = 1/2.
        const double E = plate.youngs_modulus, nu = plate.poissons_ratio;
        half_space_compliance = (1. - nu * nu) / E;
        poissons_ratio        = nu;
        shear_modulus         = E / (2. * (1. + nu));
      }
    if (plate.has_large_deflection)
      stretching = Stretching::large;
    else if (is_unsymmetric())
      stretching = Stretching::linear;
    compliance = stiffness().inverse();
  }



  void
  PlateSection::set_plies(const PlateParameters &plate)
  {
    const Ply ply(ply_of(plate));
    // an isotropic plate is a laminate of one ply
    const auto angles =
      is_laminate ? plate.layup.angles : std::vector<double>{0.};
    const Eigen::Matrix3d Q = ply.plane_stiffness();
    const double          t = thickness / angles.size();

    std::vector<Eigen::Matrix3d> plane_stiffness;
    std::vector<Eigen::Matrix2d> shear_moduli;
    for (std::size_t k = 0; k < angles.size(); ++k)
      {
        const Eigen::Matrix2d turn =
          Eigen::Rotation2Dd(-angles[k] * std::acos(-1.) / 180.)
            .toRotationMatrix();
        const double c = turn(0, 0), s = turn(0, 1);
        // turns strains into those of the axes of the ply; its transpose turns
        // stresses back
        Eigen::Matrix3d T;
        T << c * c, s * s, c * s, //
          s * s, c * c, -c * s,   //
          -2. * c * s, 2. * c * s, c * c - s * s;
        // faces of the ply from the middle surface
        const double near = -0.5 * thickness + k * t, far = near + t;
        plane_stiffness.push_back(T.transpose() * Q * T);
        bending_stiffness +=
          (far * far * far - near * near * near) / 3. * plane_stiffness.back();
        membrane_stiffness += t * plane_stiffness.back();
        coupling_stiffness -=
          (far * far - near * near) / 2. * plane_stiffness.back();
        shear_moduli.push_back(
          turn.transpose() *
          Eigen::Vector2d(ply.constants.longitudinal_shear_modulus,
                          ply.constants.transverse_shear_modulus)
            .asDiagonal() *
          turn);
        shear_stiffness += shear_correction_factor * t * shear_moduli.back();
        plies.push_back({near, far, Q * T});
      }
    if (is_laminate && plate.shear_correction_factor == 0.)
      shear_stiffness = thickness *
        shear_stiffness_of_equilibrium(plane_stiffness, shear_moduli);

    half_space_compliance = 1. / ply.half_space_modulus();
    poissons_ratio        = ply.layer_poissons_ratio();
    shear_modulus   = 0.5 * (1. - poissons_ratio) * ply.half_space_modulus();
    contact_modulus = ply.constants.transverse_modulus;
  }



  double
  PlateSection::mean_bending_stiffness() const
  {
    const Eigen::Matrix3d D = bending_stiffness -
      coupling_stiffness * membrane_stiffness.inverse() * coupling_stiffness;
    if (twists(D))
      {
        // Olsson's formula holds in the axes of an orthotropic plate; this is
        // the mean over directions that it stands for
        double mean = 0.;
        for (unsigned int i = 0; i < n_directions; ++i)
          mean += 1. / std::sqrt(stiffness_along(i, D));
        return n_directions / mean * (n_directions / mean);
      }
    const double along = std::sqrt(D(0, 0)) * std::sqrt(D(1, 1));
    return std::sqrt(0.5 * (1. + (D(0, 1) + 2. * D(2, 2)) / along)) * along;
  }



  double
  PlateSection::fastest_wave() const
  {
    // of infinite frequency: bending and stretching along a direction, coupled
    double largest = 0.;
    for (unsigned int i = 0; i < n_directions; ++i)
      {
        const double bending =
                       stiffness_along(i, bending_stiffness) / rotary_inertia,
                     membrane = stretching == Stretching::none ?
          0. :
          stiffness_along(i, membrane_stiffness) / mass_per_area,
                     coupling = stiffness_along(i, coupling_stiffness) /
          std::sqrt(rotary_inertia * mass_per_area);
        largest = std::max(largest,
                           0.5 * (bending + membrane) +
                             std::hypot(0.5 * (bending - membrane), coupling));
      }
    return std::sqrt(largest);
  }



  bool
  PlateSection::is_skew() const
  {
    return twists(bending_stiffness) ||
      std::abs(shear_stiffness(0, 1)) > negligible * shear_stiffness.norm() ||
      (stretching != Stretching::none &&
       (twists(membrane_stiffness) ||
        coupling_stiffness.topRightCorner<2, 1>().cwiseAbs().maxCoeff() *
            thickness >
          negligible * bending_stiffness.norm()));
  }



  bool
  PlateSection::is_unsymmetric() const
  {
    return coupling_stiffness.norm() * thickness >
      negligible * bending_stiffness.norm();
  }



  Eigen::MatrixXd
  PlateSection::stiffness() const
  {
    Eigen::MatrixXd matrix           = Eigen::MatrixXd::Zero(8, 8);
    matrix.topLeftCorner<3, 3>()     = bending_stiffness;
    matrix.block<2, 2>(3, 3)         = shear_stiffness;
    matrix.topRightCorner<3, 3>()    = coupling_stiffness;
    matrix.bottomLeftCorner<3, 3>()  = coupling_stiffness;
    matrix.bottomRightCorner<3, 3>() = membrane_stiffness;
    return matrix.topLeftCorner(n_resultants(), n_resultants());
  }



  const std::vector<std::pair<std::string, std::string>> &
  PlateSection::stress_names() const
  {
    static const std::vector<std::pair<std::string, std::string>>
      isotropic = {{"von_mises_stress", "von Mises stress at the faces"}},
      of_plies  = {{"fibre_stress", "largest stress along fibres"},
                   {"transverse_stress", "largest stress across fibres"},
                   {"ply_shear_stress", "largest shear stress of plies"}};
    return is_laminate ? of_plies : isotropic;
  }



  Eigen::MatrixXd
  PlateSection::stresses(
    const Eigen::Ref<const Eigen::VectorXd> &resultants) const
  {
    const auto von_mises = [](const Eigen::Vector3d &s) {
      return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] +
                       3. * s[2] * s[2]);
    };
    const unsigned int n       = n_for_stresses();
    Eigen::VectorXd    strains = Eigen::VectorXd::Zero(8);
    strains.head(n) = compliance.topLeftCorner(n, n) * resultants.head(n);
    Eigen::MatrixXd result(plies.size(), stress_names().size());
    for (std::size_t k = 0; k < plies.size(); ++k)
      {
        const auto &[near, far, per_strain] = plies[k];
        const Eigen::Vector3d per_z         = per_strain * strains.head<3>(),
                              middle        = per_strain * strains.tail<3>(),
                              at_near       = middle - near * per_z,
                              at_far        = middle - far * per_z;
        if (is_laminate)
          result.row(k) = at_near.cwiseAbs().cwiseMax(at_far.cwiseAbs());
        else
          result(k, 0) = std::max(von_mises(at_near), von_mises(at_far));
      }
    return result;
  }



  const std::vector<SectionField> resultant_fields = {
    {"moment M_x", "N", "moment_x", {{false, false}}, {}},
    {"moment M_y", "N", "moment_y", {{false, false}}, {}},
    {"moment M_xy", "N", "moment_xy", {{true, true}}, {}},
    {"shear force Q_x", "N/m", "shear_force_x", {{true, false}}, {}},
    {"shear force Q_y", "N/m", "shear_force_y", {{false, true}}, {}},
    {"membrane force N_x", "N/m", "membrane_force_x", {{false, false}}, {}},
    {"membrane force N_y", "N/m", "membrane_force_y", {{false, false}}, {}},
    {"membrane force N_xy", "N/m", "membrane_force_xy", {{true, true}}, {}}};



  std::vector<SectionField>
  section_fields(const PlateSection &section, const Eigen::MatrixXd &resultants)
  {
    std::vector<SectionField> fields = resultant_fields;
    fields.resize(resultants.rows());
    for (std::size_t i = 0; i < fields.size(); ++i)
      fields[i].values = resultants.row(i);

    const auto     &names = section.stress_names();
    Eigen::MatrixXd largest(resultants.cols(), names.size());
    for (Eigen::Index p = 0; p < resultants.cols(); ++p)
      largest.row(p) = section.stresses(resultants.col(p)).colwise().maxCoeff();
    for (std::size_t k = 0; k < names.size(); ++k)
      fields.push_back({names[k].second,
                        "Pa",
                        names[k].first,
                        {{false, false}},
                        largest.col(k)});
    return fields;
  }
} // namespace PlateImpact
