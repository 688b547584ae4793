#include <deal.II/base/numbers.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Of a singularity; h_new / h is no better known than its fourth power.
    constexpr double least_strength = 0.25;

    /// Cells that touch a singular point may be smaller than the minimum size
    /// by this, which the program has chosen for the load.
    constexpr double share_at_singular_points = 1e-6;



    /// q in h(r) ~ r^q, by which cells around a singular point have equal
    /// errors: that of a cell at a distance r is as h^{p+1} r^{lambda-1-p}.
    double
    grading(const double strength)
    {
      const unsigned int p = 2;
      return std::min(1.,
                      (p + 1. - std::max(strength, least_strength)) / (p + 1.));
    }



    /// The strongest of the singular points that a cell touches, or null.
    const SingularPoint *
    singular_point_of(const Triangulation<2>::cell_iterator &cell,
                      const AdaptivityParameters            &adaptivity)
    {
      const SingularPoint *strongest = nullptr;
      for (const SingularPoint &point : adaptivity.singular_points.points)
        if ((strongest == nullptr || point.strength < strongest->strength) &&
            touches_point(cell, point.position))
          strongest = &point;
      return strongest;
    }
  } // namespace



  std::vector<double>
  target_sizes(const Triangulation<2>     &mesh,
               const ErrorRatios          &error,
               const AdaptivityParameters &adaptivity)
  {
    std::vector<double> sizes(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        // infinite without an error
        sizes[c] = cell_size(cell) /
          std::pow(error.elements[c], size_exponent(cell, adaptivity));
      }
    return sizes;
  }



  double
  size_exponent(const Triangulation<2>::cell_iterator &cell,
                const AdaptivityParameters            &adaptivity)
  {
    const SingularPoint *point = singular_point_of(cell, adaptivity);
    return point == nullptr ?
      adaptivity.size_exponent :
      std::max(adaptivity.size_exponent,
               1. / std::max(point->strength, least_strength));
  }



  double
  size_at(const Point<2>                        &position,
          const double                           size,
          const Triangulation<2>::cell_iterator &cell,
          const AdaptivityParameters            &adaptivity)
  {
    const SingularPoint *point = singular_point_of(cell, adaptivity);
    if (point == nullptr)
      return size;
    const double distance =
      position.distance({point->position[0], point->position[1]});
    return size *
      std::pow(std::max(1., distance / size), grading(point->strength));
  }



  double
  minimum_cell_size(const Triangulation<2>::cell_iterator &cell,
                    const AdaptivityParameters            &adaptivity)
  {
    const SingularPoint *point = adaptivity.minimum_cell_size_is_chosen ?
      singular_point_of(cell, adaptivity) :
      nullptr;
    return adaptivity.minimum_cell_size *
      (point != nullptr && point->strength > 0. ? share_at_singular_points :
                                                  1.);
  }



  double
  allowed_size(const double                           size,
               const Triangulation<2>::cell_iterator &cell,
               const AdaptivityParameters            &adaptivity)
  {
    const double largest = adaptivity.maximum_cell_size;
    return std::clamp(size,
                      std::min(minimum_cell_size(cell, adaptivity), largest),
                      largest);
  }



  double
  n_cells_of_sizes(const Triangulation<2>     &mesh,
                   const std::vector<double>  &sizes,
                   const AdaptivityParameters &adaptivity)
  {
    double n_cells = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const double ratio = cell_size(cell) /
          allowed_size(sizes[cell->active_cell_index()], cell, adaptivity);
        const SingularPoint *point = singular_point_of(cell, adaptivity);
        if (point == nullptr || ratio <= 1.)
          n_cells += ratio * ratio;
        else
          {
            // int dA / h(r)^2 over a quarter of a circle
            const double exponent = 2. - 2. * grading(point->strength);
            n_cells += 1. +
              0.5 * numbers::PI * (std::pow(ratio, exponent) - 1.) / exponent;
          }
      }
    return n_cells;
  }



  bool
  is_smallest(const Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters            &adaptivity)
  {
    return 0.5 * cell_size(cell) <
      minimum_cell_size(cell, adaptivity) * (1. - 1e-9);
  }
} // namespace PlateImpact
