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

/// Values at the four Gauss points.
using Values = Eigen::Array4d;

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
  std::array<int, 4>    nodes;
  const Material       *material;
  std::array<Values, 4> d_r; // by node
  std::array<Values, 4> d_z;
  std::array<Values, 4> over_r; // N / r
  Values                weight; // 2 pi r dA
  std::array<double, 4> mean_d_r;
  std::array<double, 4> mean_d_z;
  std::array<double, 4> mean_over_r;
  std::array<double, 4> mass;
  Values                s_rr, s_zz, s_tt, s_rz; // deviatoric stress
  Values                strength;               // [Pa]
  double                volume   = 0;
  double                pressure = 0; // mean stress
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
  element.strength         = material.yield_strength;
  element.s_rr = element.s_zz = element.s_tt = element.s_rz = 0;
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
          element.d_r[i][q]    = (z_eta * d_xi[i] - z_xi * d_eta[i]) / jacobian;
          element.d_z[i][q]    = (r_xi * d_eta[i] - r_eta * d_xi[i]) / jacobian;
          element.over_r[i][q] = shape[i] / r;
          element.mean_d_r[i] += element.weight[q] * element.d_r[i][q];
          element.mean_d_z[i] += element.weight[q] * element.d_z[i][q];
          element.mean_over_r[i] += element.weight[q] * element.over_r[i][q];
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

/// Returns the deviatoric stress to the yield surface, which it moves.
inline void
yield(Element &element)
{
  const double shear   = element.material->shear;
  const double slope   = element.material->plastic_modulus;
  const Values squares = 1.5 *
    (element.s_rr.square() + element.s_zz.square() + element.s_tt.square() +
     2 * element.s_rz.square());
  if (!(squares > element.strength.square()).any())
    return;
  const Values mises = squares.sqrt().max(1e-300);
  const Values plastic =
    (mises - element.strength).max(0) / (3 * shear + slope);
  const Values factor = 1 - 3 * shear * plastic / mises;
  element.s_rr *= factor;
  element.s_zz *= factor;
  element.s_tt *= factor;
  element.s_rz *= factor;
  element.strength += slope * plastic;
}

/// Strains the element by `increment` (displacements of its nodes) and returns
/// the forces that it then exerts on its nodes.
inline std::array<Point, 4>
strain(Element &element, const std::array<Point, 4> &increment)
{
  const double shear  = element.material->shear;
  double       volume = 0, gamma = 0;
  Values e_rr = Values::Zero(), e_zz = Values::Zero(), e_tt = Values::Zero();
  for (int i = 0; i < 4; ++i)
    {
      volume +=
        (element.mean_d_r[i] + element.mean_over_r[i]) * increment[i].r +
        element.mean_d_z[i] * increment[i].z;
      gamma += element.mean_d_z[i] * increment[i].r +
        element.mean_d_r[i] * increment[i].z;
      e_rr += element.d_r[i] * increment[i].r;
      e_zz += element.d_z[i] * increment[i].z;
      e_tt += element.over_r[i] * increment[i].r;
    }
  const Values mean = (e_rr + e_zz + e_tt) / 3;
  element.pressure += element.material->bulk * volume;
  element.s_rr += 2 * shear * (e_rr - mean);
  element.s_zz += 2 * shear * (e_zz - mean);
  element.s_tt += 2 * shear * (e_tt - mean);
  element.s_rz += shear * gamma;
  if (element.material->yield_strength > 0)
    yield(element);

  const double         mean_force  = element.volume * element.pressure;
  const double         shear_force = (element.weight * element.s_rz).sum();
  const Values         f_rr        = element.weight * element.s_rr;
  const Values         f_zz        = element.weight * element.s_zz;
  const Values         f_tt        = element.weight * element.s_tt;
  std::array<Point, 4> forces;
  for (int i = 0; i < 4; ++i)
    {
      forces[i].r = -(f_rr * element.d_r[i] + f_tt * element.over_r[i]).sum() -
        mean_force * (element.mean_d_r[i] + element.mean_over_r[i]) -
        shear_force * element.mean_d_z[i];
      forces[i].z = -(f_zz * element.d_z[i]).sum() -
        mean_force * element.mean_d_z[i] - shear_force * element.mean_d_r[i];
    }
  return forces;
}

/// The largest eigenvalue of an elastic element [1/s^2]: that of the mesh is
/// not larger.
inline double
largest_eigenvalue(const Element &element)
{
  Material elastic       = *element.material;
  elastic.yield_strength = 0;
  Eigen::Matrix<double, 8, 8> matrix;
  for (int column = 0; column < 8; ++column)
    {
      Element virgin  = element;
      virgin.material = &elastic;
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
