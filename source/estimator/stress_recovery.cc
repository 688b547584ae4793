#include "plate_impact/estimator/stress_recovery.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Patches below this share of the largest beside them say nothing of cells
    /// that they are not fitted to: polynomials of small cells go astray in a
    /// large one. A change of level halves the size; the cells of a
    /// quadrilateral mesh scatter less.
    constexpr double smallest_share = 0.75;



    /// Whether a resultant (M_x, M_y, M_xy, Q_x, Q_y, N_x, N_y, N_xy) changes
    /// its sign in a mirror image: M_xy and N_xy are odd across both planes,
    /// Q_x across x = 0, Q_y across y = 0, the others even.
    bool
    changes_sign(const unsigned int           resultant,
                 const StressRecovery::Image &image)
    {
      const bool is_twist = resultant == 2 || resultant == 7,
                 odd_in_x = is_twist || resultant == 3,
                 odd_in_y = is_twist || resultant == 4;
      return (image.mirrored_x && odd_in_x) != (image.mirrored_y && odd_in_y);
    }
  } // namespace



  class StressRecovery::PatchFinder
  {
  public:
    PatchFinder(const Triangulation<2> &mesh,
                const IsRough          &is_rough,
                StressRecovery         &result)
      : mesh(mesh)
      , patches(result.patches)
      , patches_at(result.patches_at)
      , sample_points(mesh.n_active_cells() * samples_per_cell)
      , cells_at_vertex(mesh.n_vertices())
      , vertices_of_cell(mesh.n_active_cells())
      , is_on_symmetry_x(mesh.n_vertices())
      , is_on_symmetry_y(mesh.n_vertices())
      , uses_neighbours(mesh.n_vertices())
    {
      const QGauss<2> points(2);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          for (unsigned int g = 0; g < samples_per_cell; ++g)
            sample_points[samples_per_cell * c + g] =
              mapping_of(cell).transform_unit_to_real_cell(cell,
                                                           points.point(g));
          for (unsigned int v = 0; v < 4; ++v)
            vertices_of_cell[c][v] = cell->vertex_index(v);
        }
      mark_vertices(is_rough);
      assign_patches();
    }

  private:
    Point<2>
    sample_point(const Image &image, const unsigned int point) const
    {
      // the planes of symmetry are x = 0 and y = 0
      const Point<2> &position =
        sample_points[samples_per_cell * image.cell + point];
      return {image.mirrored_x ? -position[0] : position[0],
              image.mirrored_y ? -position[1] : position[1]};
    }

    void
    mark_vertices(const IsRough &is_rough)
    {
      // includes the coarse cell at a hanging vertex
      const auto cells = GridTools::vertex_to_cell_map(mesh);
      for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
        {
          uses_neighbours[vertex] =
            is_rough && is_rough(mesh.get_vertices()[vertex]);
          for (const auto &cell : cells[vertex])
            {
              const unsigned int c = cell->active_cell_index();
              cells_at_vertex[vertex].push_back(c);
              // a hanging vertex is none of the coarse cell's own
              const auto &own = vertices_of_cell[c];
              if (std::find(own.begin(), own.end(), vertex) == own.end())
                uses_neighbours[vertex] = true;
            }
        }
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (const auto face = cell->face(f); face->at_boundary())
            {
              const types::boundary_id id = face->boundary_id();
              std::vector<bool> &marks = id == symmetry_x ? is_on_symmetry_x :
                id == symmetry_y                          ? is_on_symmetry_y :
                                                            uses_neighbours;
              for (const unsigned int v : face->vertex_indices())
                marks[face->vertex_index(v)] = true;
            }
    }

    /// Those of the cells at a vertex, as an image of it sees them.
    void
    add_images(const unsigned int vertex,
               const Image       &seen_from,
               std::set<Image>   &images) const
    {
      for (const unsigned int cell : cells_at_vertex[vertex])
        for (const bool across_x : {false, true})
          for (const bool across_y : {false, true})
            if ((!across_x || is_on_symmetry_x[vertex]) &&
                (!across_y || is_on_symmetry_y[vertex]))
              images.insert({cell,
                             seen_from.mirrored_x != across_x,
                             seen_from.mirrored_y != across_y});
    }

    /// @return whether the samples determine all terms
    bool
    make_fit(Patch &patch)
    {
      Eigen::MatrixXd   P(patch.images.size() * samples_per_cell, n_terms);
      std::vector<long> positions;
      for (unsigned int row = 0; row < P.rows(); ++row)
        {
          const Point<2> point =
            sample_point(patch.images[row / samples_per_cell],
                         row % samples_per_cell);
          const auto position = (point - patch.centre) / patch.size;
          P.row(row)          = patch.polynomial(point);
          for (unsigned int d = 0; d < 2; ++d)
            positions.push_back(std::lround(position[d] / 1e-9));
        }
      const auto [known, is_new] = fits.try_emplace(positions);
      auto &[fit, is_determined] = known->second;
      if (is_new)
        {
          // By an orthogonal decomposition, not eq. 14, which is close to
          // singular. Its rank decides: 2x2 points in two cells side by side
          // are eight and determine six terms.
          Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
          decomposition.setThreshold(1e-6);
          decomposition.compute(P);
          fit =
            std::make_shared<Eigen::MatrixXd>(decomposition.pseudoInverse());
          is_determined = decomposition.rank() == n_terms;
        }
      patch.fit = fit;
      return is_determined;
    }

    Patch
    make_patch(const unsigned int vertex)
    {
      Patch patch;
      patch.centre = mesh.get_vertices()[vertex];
      std::set<Image> images;
      add_images(vertex, {0, false, false}, images);
      while (true)
        {
          patch.images.assign(images.begin(), images.end());
          patch.size = 0.;
          for (const Image &image : patch.images)
            for (unsigned int g = 0; g < samples_per_cell; ++g)
              patch.size =
                std::max(patch.size,
                         patch.centre.distance(sample_point(image, g)));
          const bool is_determined = make_fit(patch);
          for (const Image &image : patch.images)
            for (const unsigned int around : vertices_of_cell[image.cell])
              add_images(around, image, images);
          if (is_determined || images.size() == patch.images.size())
            return patch;
        }
    }

    /// Without those that are smaller than others and not fitted to the cell.
    std::vector<unsigned int>
    patches_for(const unsigned int               cell,
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

    void
    assign_patches()
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

      for (unsigned int cell = 0; cell < vertices_of_cell.size(); ++cell)
        for (unsigned int v = 0; v < 4; ++v)
          patches_at[cell][v] =
            patches_for(cell, at_vertex[vertices_of_cell[cell][v]]);
    }

    const Triangulation<2>               &mesh;
    decltype(StressRecovery::patches)    &patches;
    decltype(StressRecovery::patches_at) &patches_at;

    std::vector<Point<2>>                    sample_points;
    std::vector<std::vector<unsigned int>>   cells_at_vertex;
    std::vector<std::array<unsigned int, 4>> vertices_of_cell;
    std::vector<bool> is_on_symmetry_x, is_on_symmetry_y, uses_neighbours;

    /// Fits and whether their samples determine them, by positions of samples
    /// in units of the patch.
    std::map<std::vector<long>,
             std::pair<std::shared_ptr<const Eigen::MatrixXd>, bool>>
      fits;
  };



  StressRecovery::StressRecovery(const Triangulation<2> &mesh,
                                 const IsRough          &is_rough)
    : patches_at(mesh.n_active_cells())
  {
    PatchFinder(mesh, is_rough, *this);
  }



  RowMajorMatrix
  StressRecovery::Patch::coefficients(
    const std::vector<RowMajorMatrix> &samples,
    const unsigned int                 n_resultants) const
  {
    const Eigen::Index n_columns = samples[images.front().cell].cols(),
                       n_fields  = n_columns / n_resultants;
    RowMajorMatrix patch_samples(fit->cols(), n_columns);
    for (unsigned int i = 0; i < images.size(); ++i)
      {
        auto rows =
          patch_samples.middleRows<samples_per_cell>(samples_per_cell * i);
        rows = samples[images[i].cell];
        for (unsigned int k = 0; k < n_resultants; ++k)
          if (changes_sign(k, images[i]))
            rows.middleCols(n_fields * k, n_fields) *= -1.;
      }
    return *fit * patch_samples;
  }
} // namespace PlateImpact
