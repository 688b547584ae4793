#include "plate_impact/estimator/stress_recovery.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Eq. 10 in the coordinates of a patch.
    StressRecovery::Terms
    terms(const double x, const double y)
    {
      StressRecovery::Terms P;
      P << 1., x, y, x * x, x * y, y * y, x * x * y, x * y * y;
      return P;
    }



    /// Patches below this share of the largest beside them say nothing of cells
    /// that they are not fitted to. A change of level halves the size; the
    /// cells of a quadrilateral mesh scatter less.
    constexpr double smallest_share = 0.75;



    /// Sign of a resultant (M_x, M_y, M_xy, Q_x, Q_y) in a mirror image.
    double
    parity(const unsigned int resultant,
           const bool         mirrored_x,
           const bool         mirrored_y)
    {
      const bool odd_in_x = resultant == 2 || resultant == 3;
      const bool odd_in_y = resultant == 2 || resultant == 4;
      return ((mirrored_x && odd_in_x) != (mirrored_y && odd_in_y)) ? -1. : 1.;
    }
  } // namespace



  StressRecovery::StressRecovery(
    const Triangulation<2>                      &mesh,
    const std::function<bool(const Point<2> &)> &is_rough)
    : mesh(mesh)
    , sample_points(mesh.n_active_cells() * samples_per_cell)
    , vertices_of_cell(mesh.n_active_cells())
    , is_on_symmetry_x(mesh.n_vertices())
    , is_on_symmetry_y(mesh.n_vertices())
    , uses_neighbours(mesh.n_vertices())
    , patches_of_corners(mesh.n_active_cells())
  {
    const QGauss<2> points(2);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        for (unsigned int g = 0; g < samples_per_cell; ++g)
          sample_points[samples_per_cell * c + g] =
            mapping_of(cell).transform_unit_to_real_cell(cell, points.point(g));
        for (unsigned int v = 0; v < 4; ++v)
          vertices_of_cell[c][v] = cell->vertex_index(v);
      }

    // includes the coarse cell at a hanging vertex
    const auto cells = GridTools::vertex_to_cell_map(mesh);
    cells_at_vertex.resize(cells.size());
    for (unsigned int vertex = 0; vertex < cells.size(); ++vertex)
      for (const auto &cell : cells[vertex])
        cells_at_vertex[vertex].push_back(cell->active_cell_index());

    mark_vertices(is_rough);
    assign_patches();
  }



  void
  StressRecovery::mark_vertices(
    const std::function<bool(const Point<2> &)> &is_rough)
  {
    if (is_rough)
      for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
        uses_neighbours[vertex] = is_rough(mesh.get_vertices()[vertex]);

    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (const auto face = cell->face(f); face->at_boundary())
          {
            const types::boundary_id id = face->boundary_id();
            std::vector<bool> &marks    = id == symmetry_x ? is_on_symmetry_x :
                 id == symmetry_y                          ? is_on_symmetry_y :
                                                             uses_neighbours;
            for (const unsigned int v : face->vertex_indices())
              marks[face->vertex_index(v)] = true;
          }

    // a hanging vertex is none of the coarse cell's own
    for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
      for (const unsigned int cell : cells_at_vertex[vertex])
        {
          const auto &own = vertices_of_cell[cell];
          if (std::find(own.begin(), own.end(), vertex) == own.end())
            uses_neighbours[vertex] = true;
        }
  }



  void
  StressRecovery::assign_patches()
  {
    std::vector<std::vector<unsigned int>> at_vertex(mesh.n_vertices());
    const auto add_patch = [&](const unsigned int vertex) {
      at_vertex[vertex] = {static_cast<unsigned int>(patches.size())};
      patches.push_back(make_patch(vertex));
    };
    for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
      if (!cells_at_vertex[vertex].empty() && !uses_neighbours[vertex])
        add_patch(vertex);

    for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
      if (!cells_at_vertex[vertex].empty() && uses_neighbours[vertex])
        {
          std::set<unsigned int> neighbours;
          for (const unsigned int cell : cells_at_vertex[vertex])
            for (const unsigned int neighbour : vertices_of_cell[cell])
              if (!uses_neighbours[neighbour])
                neighbours.insert(at_vertex[neighbour].front());
          if (neighbours.empty())
            add_patch(vertex);
          else
            at_vertex[vertex].assign(neighbours.begin(), neighbours.end());
        }

    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int v = 0; v < 4; ++v)
        patches_of_corners[cell][v] =
          patches_for(cell, at_vertex[vertices_of_cell[cell][v]]);
  }



  std::vector<unsigned int>
  StressRecovery::patches_for(const unsigned int               cell,
                              const std::vector<unsigned int> &candidates) const
  {
    double largest = 0.;
    for (const unsigned int patch : candidates)
      largest = std::max(largest, patches[patch].size);
    std::vector<unsigned int> result;
    for (const unsigned int patch : candidates)
      {
        const auto &images = patches[patch].images;
        const bool  has_cell =
          std::any_of(images.begin(), images.end(), [=](const Image &image) {
            return image.cell == cell;
          });
        if (has_cell || patches[patch].size > smallest_share * largest)
          result.push_back(patch);
      }
    return result;
  }



  std::vector<StressRecovery::Image>
  StressRecovery::images_around(const unsigned int vertex,
                                const Image       &seen_from) const
  {
    std::vector<Image> images;
    for (const unsigned int cell : cells_at_vertex[vertex])
      for (const bool across_x : {false, true})
        for (const bool across_y : {false, true})
          if ((!across_x || is_on_symmetry_x[vertex]) &&
              (!across_y || is_on_symmetry_y[vertex]))
            images.push_back({cell,
                              seen_from.mirrored_x != across_x,
                              seen_from.mirrored_y != across_y});
    return images;
  }



  std::set<StressRecovery::Image>
  StressRecovery::grown(const std::set<Image> &images) const
  {
    std::set<Image> result = images;
    for (const Image &image : images)
      for (const unsigned int vertex : vertices_of_cell[image.cell])
        for (const Image &neighbour : images_around(vertex, image))
          result.insert(neighbour);
    return result;
  }



  Point<2>
  StressRecovery::sample_point(const Image       &image,
                               const unsigned int point) const
  {
    // the planes of symmetry are x = 0 and y = 0
    Point<2> position = sample_points[samples_per_cell * image.cell + point];
    if (image.mirrored_x)
      position[0] = -position[0];
    if (image.mirrored_y)
      position[1] = -position[1];
    return position;
  }



  bool
  StressRecovery::make_fit(Patch &patch)
  {
    Eigen::MatrixXd   P(patch.images.size() * samples_per_cell, n_terms);
    std::vector<long> positions;
    for (unsigned int i = 0; i < patch.images.size(); ++i)
      for (unsigned int g = 0; g < samples_per_cell; ++g)
        {
          const auto position =
            (sample_point(patch.images[i], g) - patch.centre) / patch.size;
          P.row(samples_per_cell * i + g) = terms(position[0], position[1]);
          for (unsigned int d = 0; d < 2; ++d)
            positions.push_back(std::lround(position[d] / 1e-9));
        }
    const auto [known, is_new] = fits.try_emplace(positions);
    Fit &fit                   = known->second;
    if (is_new)
      {
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
        decomposition.setThreshold(1e-6);
        decomposition.compute(P);
        fit = {std::make_shared<Eigen::MatrixXd>(decomposition.pseudoInverse()),
               decomposition.rank() == n_terms};
      }
    patch.fit = fit.matrix;
    return fit.is_determined;
  }



  StressRecovery::Patch
  StressRecovery::make_patch(const unsigned int vertex)
  {
    Patch patch;
    patch.centre = mesh.get_vertices()[vertex];

    const std::vector<Image> touching =
      images_around(vertex, {0, false, false});
    std::set<Image> images(touching.begin(), touching.end());
    while (true)
      {
        patch.images.assign(images.begin(), images.end());
        patch.size = 0.;
        for (const Image &image : images)
          for (unsigned int g = 0; g < samples_per_cell; ++g)
            patch.size =
              std::max(patch.size,
                       patch.centre.distance(sample_point(image, g)));
        const bool            is_determined = make_fit(patch);
        const std::set<Image> larger        = grown(images);
        if (is_determined || larger.size() == images.size())
          return patch;
        images = larger;
      }
  }



  unsigned int
  StressRecovery::n_cells() const
  {
    return vertices_of_cell.size();
  }



  unsigned int
  StressRecovery::n_patches() const
  {
    return patches.size();
  }



  const std::vector<unsigned int> &
  StressRecovery::patches_at(const unsigned int cell,
                             const unsigned int corner) const
  {
    return patches_of_corners[cell][corner];
  }



  const std::vector<StressRecovery::Image> &
  StressRecovery::images(const unsigned int patch) const
  {
    return patches[patch].images;
  }



  StressRecovery::Terms
  StressRecovery::polynomial(const unsigned int patch,
                             const Point<2>    &point) const
  {
    const auto position = (point - patches[patch].centre) / patches[patch].size;
    return terms(position[0], position[1]);
  }



  void
  StressRecovery::fit(const unsigned int                 patch,
                      const std::vector<RowMajorMatrix> &samples,
                      RowMajorMatrix                    &coefficients) const
  {
    const Eigen::MatrixXd    &fit       = *patches[patch].fit;
    const std::vector<Image> &images    = patches[patch].images;
    const Eigen::Index        n_columns = samples[images.front().cell].cols(),
                       n_fields         = n_columns / n_resultants;
    RowMajorMatrix patch_samples(fit.cols(), n_columns);
    for (unsigned int i = 0; i < images.size(); ++i)
      {
        auto rows =
          patch_samples.middleRows<samples_per_cell>(samples_per_cell * i);
        rows = samples[images[i].cell];
        for (unsigned int k = 0; k < n_resultants; ++k)
          if (parity(k, images[i].mirrored_x, images[i].mirrored_y) < 0.)
            rows.middleCols(n_fields * k, n_fields) *= -1.;
      }
    coefficients.noalias() = fit * patch_samples;
  }
} // namespace PlateImpact
