#include "plate_impact/adaptation/mesh_adaptation.h"

#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

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
          std::pow(error.elements[c], adaptivity.size_exponent);
      }
    return sizes;
  }



  double
  allowed_size(const double size, const AdaptivityParameters &adaptivity)
  {
    const double largest = adaptivity.maximum_cell_size;
    return std::clamp(size,
                      std::min(adaptivity.minimum_cell_size, largest),
                      largest);
  }



  double
  n_cells_of_sizes(const Triangulation<2>     &mesh,
                   const std::vector<double>  &sizes,
                   const AdaptivityParameters &adaptivity)
  {
    double n_cells = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      n_cells +=
        std::pow(cell_size(cell) /
                   allowed_size(sizes[cell->active_cell_index()], adaptivity),
                 2);
    return n_cells;
  }



  bool
  is_smallest(const Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters            &adaptivity)
  {
    return 0.5 * cell_size(cell) < adaptivity.minimum_cell_size * (1. - 1e-9);
  }



  std::vector<CellId>
  sorted_cells(const Triangulation<2> &mesh)
  {
    std::vector<CellId> cells;
    for (const auto &cell : mesh.active_cell_iterators())
      cells.push_back(cell->id());
    std::sort(cells.begin(), cells.end());
    return cells;
  }



  MeshAdaptation::MeshAdaptation(const AdaptivityParameters &adaptivity,
                                 const double contact_half_length)
    : adaptivity(adaptivity)
    , contact_half_length(contact_half_length)
  {}



  double
  MeshAdaptation::n_wanted_cells(const Triangulation<2> &mesh,
                                 const ErrorRatios      &error) const
  {
    const std::vector<double> sizes = wanted_sizes(mesh, error);
    return sizes.empty() ? mesh.n_active_cells() :
                           n_cells_of_sizes(mesh, sizes, adaptivity);
  }



  std::vector<double>
  MeshAdaptation::wanted_sizes(const Triangulation<2> &,
                               const ErrorRatios &) const
  {
    return {};
  }
} // namespace PlateImpact
