#ifndef tests_calculix_element_h
#define tests_calculix_element_h

// A quadrilateral of four nodes, axisymmetric, elastic-plastic. 2 x 2 Gauss
// points; the volumetric strain is replaced by its mean over the element, so
// that it does not lock in plastic flow (B-bar; Hughes 1980,
// doi:10.1002/nme.1620150914), and the shear strain as well, so that it does
// not lock in bending. Small strains, on the initial places. Material: von
// Mises with linear isotropic hardening, radial return (Simo & Hughes 1998,
// Computational Inelasticity, box 3.1).

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

constexpr double pi = 3.14159265358979323846;

struct Point
{
  double r = 0;
  double z = 0;
};

struct Material
{
  double bulk            = 0; // [Pa]
  double shear           = 0; // [Pa]
  double density         = 0; // [kg/m^3]
  double yield_strength  = 0; // [Pa], 0: elastic
  double plastic_modulus = 0; // slope of the yield strength [Pa]
};

/// Shape function derivatives at the Gauss points of a quadrilateral, and the
/// state of its material.
struct Element
{
  std::array<int, 4>                   nodes;
  const Material                      *material;
  std::array<std::array<double, 4>, 4> d_r;    // [Gauss point][node]
  std::array<std::array<double, 4>, 4> d_z;    // [Gauss point][node]
  std::array<std::array<double, 4>, 4> over_r; // N / r
  std::array<double, 4>                weight; // 2 pi r dA
  std::array<double, 4>                mean_d_r;
  std::array<double, 4>                mean_d_z;
  std::array<double, 4>                mean_over_r;
  std::array<double, 4>                mass;
  std::array<std::array<double, 4>, 4> deviator{}; // rr, zz, tt, rz
  std::array<double, 4>                strength;   // [Pa]
  double                               volume   = 0;
  double                               pressure = 0; // mean stress
};

inline Element
make_element(const std::array<int, 4> &quad,
             const std::vector<Point> &nodes,
             const Material           &material)
{
  constexpr double g       = 0.57735026918962576;
  constexpr double xi[4]   = {-1, 1, 1, -1};
  constexpr double eta[4]  = {-1, -1, 1, 1};
  Element          element = {};
  element.nodes            = quad;
  element.material         = &material;
  element.strength.fill(material.yield_strength);
  for (int q = 0; q < 4; ++q)
    {
      double shape[4], d_xi[4], d_eta[4];
      double r = 0, r_xi = 0, r_eta = 0, z_xi = 0, z_eta = 0;
      for (int i = 0; i < 4; ++i)
        {
          const double along  = 1 + xi[i] * g * xi[q];
          const double across = 1 + eta[i] * g * eta[q];
          const Point &node   = nodes[quad[i]];
          shape[i]            = along * across / 4;
          d_xi[i]             = xi[i] * across / 4;
          d_eta[i]            = eta[i] * along / 4;
          r += shape[i] * node.r;
          r_xi += d_xi[i] * node.r;
          r_eta += d_eta[i] * node.r;
          z_xi += d_xi[i] * node.z;
          z_eta += d_eta[i] * node.z;
        }
      const double jacobian = r_xi * z_eta - r_eta * z_xi;
      if (!(jacobian > 0))
        throw std::runtime_error("an element is turned inside out");
      element.weight[q] = 2 * pi * r * jacobian;
      element.volume += element.weight[q];
      for (int i = 0; i < 4; ++i)
        {
          element.d_r[q][i]    = (z_eta * d_xi[i] - z_xi * d_eta[i]) / jacobian;
          element.d_z[q][i]    = (r_xi * d_eta[i] - r_eta * d_xi[i]) / jacobian;
          element.over_r[q][i] = shape[i] / r;
          element.mean_d_r[i] += element.weight[q] * element.d_r[q][i];
          element.mean_d_z[i] += element.weight[q] * element.d_z[q][i];
          element.mean_over_r[i] += element.weight[q] * element.over_r[q][i];
          element.mass[i] += material.density * element.weight[q] * shape[i];
        }
    }
  for (int i = 0; i < 4; ++i)
    {
      element.mean_d_r[i] /= element.volume;
      element.mean_d_z[i] /= element.volume;
      element.mean_over_r[i] /= element.volume;
    }
  return element;
}

/// Returns the deviatoric stress (rr, zz, tt, rz) to the yield surface, which
/// it moves.
inline void
yield(const Material &material, std::array<double, 4> &s, double &strength)
{
  const double square =
    s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * s[3] * s[3];
  if (1.5 * square <= strength * strength)
    return;
  const double mises = std::sqrt(1.5 * square);
  const double plastic =
    (mises - strength) / (3 * material.shear + material.plastic_modulus);
  for (double &component : s)
    component *= 1 - 3 * material.shear * plastic / mises;
  strength += material.plastic_modulus * plastic;
}

/// Strains the element by `increment` (displacements of its nodes) and
/// returns the forces that it then exerts on its nodes.
inline std::array<Point, 4>
strain(Element &element, const std::array<Point, 4> &increment)
{
  const auto &mean_d_r = element.mean_d_r, &mean_d_z = element.mean_d_z,
             &mean_over_r = element.mean_over_r;
  const double shear      = element.material->shear;
  double       volume = 0, gamma = 0;
  for (int i = 0; i < 4; ++i)
    {
      volume += (mean_d_r[i] + mean_over_r[i]) * increment[i].r +
        mean_d_z[i] * increment[i].z;
      gamma += mean_d_z[i] * increment[i].r + mean_d_r[i] * increment[i].z;
    }
  element.pressure += element.material->bulk * volume;

  std::array<Point, 4> forces;
  double               shear_force = 0;
  for (int q = 0; q < 4; ++q)
    {
      const auto &d_r = element.d_r[q], &d_z = element.d_z[q],
                 &over_r = element.over_r[q];
      double e_rr = 0, e_zz = 0, e_tt = 0;
      for (int i = 0; i < 4; ++i)
        {
          e_rr += d_r[i] * increment[i].r;
          e_zz += d_z[i] * increment[i].z;
          e_tt += over_r[i] * increment[i].r;
        }
      const double mean = (e_rr + e_zz + e_tt) / 3;
      auto        &s    = element.deviator[q];
      s[0] += 2 * shear * (e_rr - mean);
      s[1] += 2 * shear * (e_zz - mean);
      s[2] += 2 * shear * (e_tt - mean);
      s[3] += shear * gamma;
      if (element.strength[q] > 0)
        yield(*element.material, s, element.strength[q]);
      const double weight = element.weight[q];
      for (int i = 0; i < 4; ++i)
        {
          forces[i].r -= weight * (s[0] * d_r[i] + s[2] * over_r[i]);
          forces[i].z -= weight * s[1] * d_z[i];
        }
      shear_force += weight * s[3];
    }
  const double mean_force = element.volume * element.pressure;
  for (int i = 0; i < 4; ++i)
    {
      forces[i].r -=
        mean_force * (mean_d_r[i] + mean_over_r[i]) + shear_force * mean_d_z[i];
      forces[i].z -= mean_force * mean_d_z[i] + shear_force * mean_d_r[i];
    }
  return forces;
}

/// The largest eigenvalue of an elastic element [1/s^2]: that of the mesh is
/// not larger.
inline double
largest_eigenvalue(const Element &element)
{
  Eigen::Matrix<double, 8, 8> matrix;
  for (int column = 0; column < 8; ++column)
    {
      Element virgin = element;
      virgin.strength.fill(0);
      std::array<Point, 4> unit;
      (column % 2 == 0 ? unit[column / 2].r : unit[column / 2].z) = 1;
      const auto forces = strain(virgin, unit);
      for (int i = 0; i < 4; ++i)
        {
          const double scale =
            std::sqrt(element.mass[i] * element.mass[column / 2]);
          matrix(2 * i, column)     = -forces[i].r / scale;
          matrix(2 * i + 1, column) = -forces[i].z / scale;
        }
    }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 8, 8>>(
           matrix,
           Eigen::EigenvaluesOnly)
    .eigenvalues()
    .maxCoeff();
}

#endif
