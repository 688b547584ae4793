#include "plate_impact/estimator/stress_recovery.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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
  } // namespace



  /// Marks the vertices of a mesh and makes the patches around them.
  struct StressRecovery::PatchMaker
  {
    PatchMaker(const Triangulation<2> &mesh, const IsRough &is_rough)
      : mesh(mesh)
      , cells_at_vertex(GridTools::vertex_to_cell_map(mesh))
      , is_on_symmetry_x(mesh.n_vertices())
      , is_on_symmetry_y(mesh.n_vertices())
    {
      for (const Point<2> &vertex : mesh.get_vertices())
        uses_neighbours.push_back(is_rough(vertex));
      const QGauss<2> points(2);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          for (const Point<2> &point : points.get_points())
            sample_points.push_back(
              mapping_of(cell).transform_unit_to_real_cell(cell, point));
          cells.push_back(cell);
          for (const auto &face : cell->face_iterators())
            if (face->has_children())
              // the vertex that hangs on it
              uses_neighbours[face->child(0)->vertex_index(1)] = true;
            else if (face->at_boundary())
              {
                const types::boundary_id id = face->boundary_id();
                std::vector<bool> &marks = id == symmetry_x ? is_on_symmetry_x :
                  id == symmetry_y                          ? is_on_symmetry_y :
                                                              uses_neighbours;
                for (const unsigned int v : face->vertex_indices())
                  marks[face->vertex_index(v)] = true;
              }
        }
    }

    /// Of a vertex, from the cells at it and, until their samples determine all
    /// terms, from those around them.
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
          if (make_fit(patch))
            return patch;
          for (const Image &image : patch.images)
            for (const unsigned int v : cells[image.cell]->vertex_indices())
              add_images(cells[image.cell]->vertex_index(v), image, images);
          if (images.size() == patch.images.size())
            return patch;
        }
    }

    /// Those of the cells at a vertex, as an image of it sees them.
    void
    add_images(const unsigned int vertex,
               const Image       &seen_from,
               std::set<Image>   &images) const
    {
      for (const auto &cell : cells_at_vertex[vertex])
        for (const bool across_x : {false, true})
          for (const bool across_y : {false, true})
            if ((!across_x || is_on_symmetry_x[vertex]) &&
                (!across_y || is_on_symmetry_y[vertex]))
              images.insert({cell->active_cell_index(),
                             seen_from.mirrored_x != across_x,
                             seen_from.mirrored_y != across_y});
    }

    /// Sets the size of a patch as well.
    /// @return whether the samples determine all terms
    bool
    make_fit(Patch &patch)
    {
      std::vector<Point<2>> points;
      for (const auto &[cell, mirrored_x, mirrored_y] : patch.images)
        for (unsigned int g = 0; g < samples_per_cell; ++g)
          {
            // the planes of symmetry are x = 0 and y = 0
            const Point<2> &p = sample_points[samples_per_cell * cell + g];
            points.emplace_back(mirrored_x ? -p[0] : p[0],
                                mirrored_y ? -p[1] : p[1]);
          }
      patch.size = 0.;
      for (const Point<2> &point : points)
        patch.size = std::max(patch.size, patch.centre.distance(point));
      std::vector<long> positions;
      for (const Point<2> &point : points)
        for (unsigned int d = 0; d < 2; ++d)
          positions.push_back(
            std::lround((point - patch.centre)[d] / patch.size / 1e-9));
      const auto [known, is_new] = fits.try_emplace(positions);
      auto &[fit, is_determined] = known->second;
      if (is_new)
        {
          Eigen::MatrixXd P(points.size(), n_terms);
          for (std::size_t row = 0; row < points.size(); ++row)
            P.row(row) = patch.polynomial(points[row]);
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

    const Triangulation<2> &mesh;

    /// With the coarse cell at a hanging vertex.
    const std::vector<std::set<Triangulation<2>::active_cell_iterator>>
      cells_at_vertex;

    std::vector<Triangulation<2>::active_cell_iterator> cells;
    std::vector<Point<2>>                               sample_points;
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
    PatchMaker maker(mesh, is_rough);

    std::vector<std::vector<unsigned int>> at_vertex(mesh.n_vertices());
    const auto add_patch = [&](const unsigned int vertex) {
      at_vertex[vertex] = {static_cast<unsigned int>(patches.size())};
      patches.push_back(maker.make_patch(vertex));
    };
    for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
      if (mesh.vertex_used(vertex) && !maker.uses_neighbours[vertex])
        add_patch(vertex);

    for (unsigned int vertex = 0; vertex < mesh.n_vertices(); ++vertex)
      if (mesh.vertex_used(vertex) && maker.uses_neighbours[vertex])
        {
          std::set<unsigned int> neighbours;
          for (const auto &cell : maker.cells_at_vertex[vertex])
            for (const unsigned int v : cell->vertex_indices())
              if (!maker.uses_neighbours[cell->vertex_index(v)])
                neighbours.insert(at_vertex[cell->vertex_index(v)].front());
          at_vertex[vertex].assign(neighbours.begin(), neighbours.end());
          if (neighbours.empty())
            add_patch(vertex);
        }

    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          const unsigned int c          = cell->active_cell_index();
          const auto        &candidates = at_vertex[cell->vertex_index(v)];
          double             largest    = 0.;
          for (const unsigned int patch : candidates)
            largest = std::max(largest, patches[patch].size);
          for (const unsigned int patch : candidates)
            {
              const auto &[centre, size, images, fit] = patches[patch];
              if (size > smallest_share * largest ||
                  std::any_of(images.begin(),
                              images.end(),
                              [c](const Image &image) {
                                return image.cell == c;
                              }))
                patches_at[c][v].push_back(patch);
            }
        }
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
          {
            const auto [across_x, across_y] = resultant_fields[k].is_odd;
            if ((images[i].mirrored_x && across_x) !=
                (images[i].mirrored_y && across_y))
              rows.middleCols(n_fields * k, n_fields) *= -1.;
          }
      }
    return *fit * patch_samples;
  }



  RowMajorMatrix
  RecoveredField::evaluate(const Cell                  &cell,
                           const std::vector<Point<2>> &unit_points)
  {
    const unsigned int    n_points = unit_points.size();
    std::vector<Point<2>> points;
    for (const Point<2> &unit_point : unit_points)
      points.push_back(
        mapping_of(cell).transform_unit_to_real_cell(cell, unit_point));
    RowMajorMatrix  values(n_points, 0);
    Eigen::VectorXd blend(n_points);
    Eigen::MatrixXd weights(n_points, StressRecovery::n_terms);
    for (unsigned int v = 0; v < 4; ++v)
      {
        for (unsigned int q = 0; q < n_points; ++q)
          blend[q] =
            GeometryInfo<2>::d_linear_shape_function(unit_points[q], v);
        if (blend.isZero(0.))
          continue;
        const auto &patches = recovery.patches_at[cell->active_cell_index()][v];
        for (const unsigned int patch : patches)
          {
            if (coefficients[patch].size() == 0)
              fit(patch);
            for (unsigned int q = 0; q < n_points; ++q)
              weights.row(q) = blend[q] / patches.size() *
                recovery.patches[patch].polynomial(points[q]);
            if (values.cols() == 0)
              values.setZero(n_points, coefficients[patch].cols());
            values.noalias() += weights * coefficients[patch];
          }
      }
    return values;
  }



  RowMajorMatrix
  resultants_at(const PlateDiscretization               &discretization,
                const unsigned int                       cell,
                const Eigen::MatrixXd                   &factor,
                const CellStrains                       &strains,
                const Eigen::Ref<const Eigen::MatrixXd> &fields)
  {
    const Eigen::Index m = factor.rows(), n = fields.cols(),
                       n_rows = strains.linear.rows();
    const Eigen::MatrixXd nodal_values =
      discretization.cell_values(cell, fields);
    // the rows of a point are a column for the factor
    const auto scaled = [&](const Eigen::MatrixXd &values) -> Eigen::MatrixXd {
      return factor * values.reshaped(m, values.size() / m);
    };
    RowMajorMatrix             result(n_rows / m, m * n);
    Eigen::Map<RowMajorMatrix> by_row(result.data(), n_rows, n);
    if (discretization.is_nonlinear())
      by_row = scaled(discretization.element.evaluate(strains, nodal_values))
                 .reshaped(n_rows, n);
    else
      by_row.noalias() =
        scaled(strains.linear).reshaped(n_rows, nodal_values.rows()) *
        nodal_values;
    return result;
  }



  std::vector<Eigen::MatrixXd>
  recovered_resultants(const PlateDiscretization               &discretization,
                       const StressRecovery                    &recovery,
                       const Eigen::Ref<const Eigen::MatrixXd> &states,
                       const std::vector<Point<2>>             &unit_points)
  {
    RecoveredField               field(discretization,
                         recovery,
                         discretization.section.stiffness(),
                         states);
    const Eigen::Index           m = discretization.section.n_resultants();
    const Eigen::Index           n_states = states.cols();
    const Eigen::Index           n_points = unit_points.size();
    std::vector<Eigen::MatrixXd> result(
      n_states,
      Eigen::MatrixXd(m, n_points * discretization.mesh().n_active_cells()));
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const RowMajorMatrix values = field.evaluate(cell, unit_points);
        field.finish(cell);
        for (Eigen::Index state = 0; state < n_states; ++state)
          result[state].middleCols(n_points * cell->active_cell_index(),
                                   n_points) =
            values(Eigen::all, Eigen::seqN(state, m, n_states)).transpose();
      }
    return result;
  }
} // namespace PlateImpact
