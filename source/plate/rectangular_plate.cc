#include <deal.II/grid/grid_generator.h>

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Rectangular cells, equal in size for an impact at the centre; the impact
    /// is a vertex, unless a single cell lies across an axis.
    class RectangularPlate : public PlateGeometry
    {
    public:
      using PlateGeometry::PlateGeometry;

      double
      side_length(const unsigned int d) const override
      {
        return plate.side_lengths[d];
      }

      double
      area() const override
      {
        return side_length(0) * side_length(1);
      }

      double
      distance_to_edge() const override
      {
        return std::min(distance_to_edge(0), distance_to_edge(1));
      }

      double
      distance_to_edge(const unsigned int axis) const override
      {
        return 0.5 * side_length(axis) - std::abs(plate.impact_point[axis]);
      }

      std::map<types::boundary_id, std::string>
      edges() const override
      {
        return {{edge_x, ""}, {edge_y, ""}};
      }

      double
      initial_cell_size(const CellNumbers &n_cells) const override
      {
        double longest = 0.;
        for (unsigned int d = 0; d < 2; ++d)
          for (const double length : cell_lengths(d, n_cells[d]))
            longest = std::max(longest, length);
        return longest;
      }

      void
      make_mesh(Triangulation<2>  &mesh,
                const CellNumbers &n_cells) const override
      {
        const Point<2> corner(begin(0), begin(1)), opposite(end(0), end(1));
        // `colorize` numbers the sides as PlateBoundary does
        if (corner == Point<2>())
          GridGenerator::subdivided_hyper_rectangle(mesh,
                                                    {n_cells[0], n_cells[1]},
                                                    corner,
                                                    opposite,
                                                    /*colorize=*/true);
        else
          GridGenerator::subdivided_hyper_rectangle(
            mesh,
            {cell_lengths(0, n_cells[0]), cell_lengths(1, n_cells[1])},
            corner,
            opposite,
            /*colorize=*/true);
        for (const auto &face : mesh.active_face_iterators())
          {
            if (!is_symmetric(0) && face->at_boundary() &&
                face->boundary_id() == symmetry_x)
              face->set_boundary_id(edge_x);
            if (!is_symmetric(1) && face->at_boundary() &&
                face->boundary_id() == symmetry_y)
              face->set_boundary_id(edge_y);
          }
      }

    private:
      /// Of n cells along an axis.
      std::vector<double>
      cell_lengths(const unsigned int d, const unsigned int n) const
      {
        if (is_symmetric(d) || n == 1)
          return std::vector<double>(n, (end(d) - begin(d)) / n);
        const long before =
          std::clamp<long>(std::lround(-begin(d) / side_length(d) * n),
                           1,
                           n - 1);
        std::vector<double> lengths(before, -begin(d) / before);
        lengths.resize(n, end(d) / (n - before));
        return lengths;
      }
    };
  } // namespace



  std::unique_ptr<const PlateGeometry>
  make_rectangular_plate(const PlateParameters &plate)
  {
    return std::make_unique<RectangularPlate>(plate);
  }
} // namespace PlateImpact
