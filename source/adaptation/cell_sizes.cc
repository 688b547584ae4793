#include <deal.II/base/numbers.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  CellSizing::CellSizing(const Triangulation<2>::cell_iterator &cell,
                         const AdaptivityParameters            &adaptivity)
    : exponent(adaptivity.size_exponent)
    , minimum(adaptivity.minimum_cell_size)
    , maximum(adaptivity.maximum_cell_size)
  {
    for (const SingularPoint &point : adaptivity.singular_points.points)
      if ((singular == nullptr || point.strength < singular->strength) &&
          touches_point(cell, point.position))
        singular = &point;
    if (singular == nullptr)
      return;
    const unsigned int p = 2;
    // h_new / h is no better known than its fourth power
    const double strength = std::max(singular->strength, 0.25);
    exponent              = std::max(exponent, 1. / strength);
    grading               = std::min(1., (p + 1. - strength) / (p + 1.));
    if (adaptivity.minimum_cell_size_is_chosen && singular->strength > 0.)
      minimum *= 1e-6;
  }



  double
  CellSizing::at(const Point<2> &position, const double size) const
  {
    if (singular == nullptr)
      return size;
    const double distance =
      position.distance({singular->position[0], singular->position[1]});
    return size * std::pow(std::max(1., distance / size), grading);
  }



  std::vector<double>
  target_sizes(const Triangulation<2>     &mesh,
               const ErrorRatios          &error,
               const AdaptivityParameters &adaptivity)
  {
    std::vector<double> sizes;
    for (const auto &cell : mesh.active_cell_iterators())
      sizes.push_back(cell_size(cell) /
                      std::pow(error.elements[cell->active_cell_index()],
                               CellSizing(cell, adaptivity).exponent));
    return sizes;
  }



  double
  n_cells_of_sizes(const Triangulation<2>     &mesh,
                   const std::vector<double>  &sizes,
                   const AdaptivityParameters &adaptivity)
  {
    double n_cells = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const CellSizing sizing(cell, adaptivity);
        const double     ratio =
          cell_size(cell) / sizing.allowed(sizes[cell->active_cell_index()]);
        if (sizing.singular == nullptr || ratio <= 1.)
          n_cells += ratio * ratio;
        else
          {
            // int dA / h(r)^2 over a quarter of a circle
            const double exponent = 2. - 2. * sizing.grading;
            n_cells += 1. +
              0.5 * numbers::PI * (std::pow(ratio, exponent) - 1.) / exponent;
          }
      }
    return n_cells;
  }



  bool
  equalize(const Triangulation<2>     &mesh,
           ErrorRatios                &error,
           const AdaptivityParameters &adaptivity)
  {
    double area = 0.; // of squares
    for (const auto &cell : mesh.active_cell_iterators())
      area += cell_size(cell) * cell_size(cell);
    const double n_cells = std::max(
      n_cells_of_sizes(mesh, target_sizes(mesh, error, adaptivity), adaptivity),
      0.5 * mesh.n_active_cells());
    const double equal     = std::sqrt(area / n_cells);
    bool         is_larger = false;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const CellSizing sizing(cell, adaptivity);
        const double     ratio = cell_size(cell) / sizing.allowed(equal);
        double          &one   = error.elements[cell->active_cell_index()];
        one = std::max(one, std::pow(ratio, 1. / sizing.exponent));
        is_larger |= ratio > 1. + 1e-9;
      }
    return is_larger;
  }



  bool
  is_smallest(const Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters            &adaptivity)
  {
    return 0.5 * cell_size(cell) <
      CellSizing(cell, adaptivity).minimum * (1. - 1e-9);
  }
} // namespace PlateImpact
