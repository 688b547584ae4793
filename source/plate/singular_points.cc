// Corners of the outline and of the load, at which the stress has no bound.
#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/physics/vector_relations.h>

#include "plate_impact/plate/plate_geometry.h"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    using Exponent = std::complex<double>;

    /// Zero at the exponents of a wedge in plane stress. A side on rollers,
    /// simply supported, is a line in which a wedge of twice the angle mirrors
    /// with opposite signs.
    Exponent
    characteristic(const Exponent             x,
                   const double               angle,
                   std::array<EdgeSupport, 2> sides,
                   const double               poissons_ratio)
    {
      // on all others rotations are free
      for (EdgeSupport &side : sides)
        if (side != EdgeSupport::clamped &&
            side != EdgeSupport::simply_supported)
          side = EdgeSupport::free;
      // in the order of EdgeSupport: clamped, simply supported, free
      std::sort(sides.begin(), sides.end());
      const bool     is_alike = sides[0] == sides[1];
      const double   kappa    = (3. - poissons_ratio) / (1. + poissons_ratio);
      const Exponent square   = std::pow(std::sin(x * angle), 2),
                     twice    = std::sin(2. * x * angle),
                     sine     = x * std::sin(angle);
      switch (sides[0])
        {
          case EdgeSupport::clamped:
            if (is_alike)
              return square - std::pow(sine / kappa, 2);
            if (sides[1] == EdgeSupport::simply_supported)
              return twice + x / kappa * std::sin(2. * angle);
            return square -
              (std::pow(1. + kappa, 2) / 4. - sine * sine) / kappa;
          case EdgeSupport::simply_supported:
            return is_alike ? square - std::pow(std::sin(angle), 2) :
                              twice - x * std::sin(2. * angle);
          default:
            return square - sine * sine;
        }
    }



    /// A vertex of a mesh, in the making.
    struct Corner
    {
      double                   angle = 0.; ///< of all cells [rad]
      std::vector<EdgeSupport> held_by;    ///< planes of symmetry have none
    };



    std::map<unsigned int, Corner>
    corners_of(const Triangulation<2> &mesh, const PlateParameters &plate)
    {
      const auto supports = geometry_of(plate).by_edge(plate.supports);
      std::map<unsigned int, Corner> corners;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            Corner                     &corner = corners[cell->vertex_index(v)];
            std::array<Tensor<1, 2>, 2> tangents; // away from the vertex
            for (const unsigned int d : {0, 1})
              {
                const auto side = cell->face(d == 0 ? 2 + v / 2 : v % 2);
                // the numbers of neighbours differ in one bit
                const Point<2> next = cell->vertex(v ^ (1 << d));
                tangents[d] =
                  side->get_manifold().get_tangent_vector(cell->vertex(v),
                                                          next);
                if (const auto support = supports.find(side->boundary_id());
                    support != supports.end())
                  corner.held_by.push_back(support->second);
              }
            corner.angle +=
              Physics::VectorRelations::angle(tangents[0], tangents[1]);
          }
      return corners;
    }



    void
    add_corners(const Parameters           &parameters,
                std::vector<SingularPoint> &points)
    {
      const PlateParameters &plate = parameters.plate;
      const double nu = plate.is_laminate() ? 0.3 : plate.poissons_ratio;
      const auto   mesh =
        make_plate_mesh(plate, parameters.discretization.initial_cells);
      for (auto &[index, corner] : corners_of(*mesh, plate))
        {
          auto &[angle, held_by] = corner;
          if (held_by.empty() || held_by.size() > 2)
            continue;
          // the other side of a plane of symmetry is like this one
          if (held_by.size() == 1)
            {
              angle *= 2.;
              held_by.push_back(held_by[0]);
            }
          const double smooth = 10. / 180. * numbers::PI;
          if (held_by[0] == held_by[1] &&
              std::abs(angle - numbers::PI) < smooth)
            continue;
          if (const double strength =
                corner_strength(angle, {{held_by[0], held_by[1]}}, nu);
              strength < 1. - 1e-6)
            {
              const Point<2> &position = mesh->get_vertices()[index];
              points.push_back({{{position[0], position[1]}}, strength});
            }
        }
    }
  } // namespace



  double
  corner_strength(const double                      angle,
                  const std::array<EdgeSupport, 2> &supports,
                  const double                      poissons_ratio)
  {
    const bool is_alike =
      (supports[0] == EdgeSupport::free) == (supports[1] == EdgeSupport::free);
    double strength = std::min(1., numbers::PI / angle * (is_alike ? 1. : 0.5));
    const auto function = [&](const Exponent x) {
      const auto at = [&](const Exponent y) {
        return characteristic(y, angle, supports, poissons_ratio);
      };
      const double change = 1e-6;
      return std::pair(at(x),
                       (at(x + change) - at(x - change)) / (2. * change));
    };
    // a rotation of the whole wedge has the exponent 0
    const double least   = 1e-3;
    const int    n_steps = 200; // at a crack zeros are double
    for (double real = 0.02; real < 1.; real += 0.04)
      for (const double imaginary : {0., 0.15, 0.35})
        // not a number where Newton's method comes to none
        if (const double zero =
              boost::math::tools::complex_newton(function,
                                                 Exponent(real, imaginary),
                                                 n_steps)
                .real();
            zero > least)
          strength = std::min(strength, zero);
    return strength;
  }



  std::vector<SingularPoint>
  singular_points(const Parameters &parameters)
  {
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    if (!adaptivity.is_adaptive())
      return {};
    if (!adaptivity.singular_points.are_found_automatically)
      return adaptivity.singular_points.points;
    // Contributions to the peak force tell of the corner too early, while they
    // are still those of the waves: it made meshes twice as large.
    if (adaptivity.goal != AdaptationGoal::energy_norm)
      return {};
    std::vector<SingularPoint> points;
    add_corners(parameters, points);
    // Shear forces grow with log r at the end of a line load, and with 1 / r at
    // a point load
    if (parameters.contact.load_is_line())
      {
        const double end = 0.5 * parameters.impactor.length;
        points.push_back({{{end, 0.}}, 1.});
        if (!geometry_of(parameters.plate).is_symmetric[0])
          points.push_back({{{-end, 0.}}, 1.});
      }
    if (parameters.contact.load_is_singular())
      points.push_back({{{0., 0.}}, 0.});
    return points;
  }
} // namespace PlateImpact
