#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// The first side length is the diameter. A few cells, refined until there
    /// are as many as asked for; those at the edge are curved.
    class CircularPlate : public PlateGeometry
    {
    public:
      using PlateGeometry::PlateGeometry;

      double
      side_length(const unsigned int) const override
      {
        return plate.side_lengths[0];
      }

      double
      area() const override
      {
        return 0.25 * numbers::PI * side_length(0) * side_length(1);
      }

      double
      distance_to_edge() const override
      {
        return 0.5 * side_length(0) -
          std::hypot(plate.impact_point[0], plate.impact_point[1]);
      }

      double
      distance_to_edge(const unsigned int axis) const override
      {
        const double radius = 0.5 * side_length(0),
                     across = plate.impact_point[1 - axis];
        return std::sqrt(std::max(0., radius * radius - across * across)) -
          std::abs(plate.impact_point[axis]);
      }

      std::map<types::boundary_id, std::string>
      edges() const override
      {
        return {{edge_round, ""}};
      }

      void
      make_mesh(Triangulation<2>  &mesh,
                const CellNumbers &n_cells) const override
      {
        const double radius = 0.5 * side_length(0);
        if (is_symmetric(0) && is_symmetric(1))
          GridGenerator::quarter_hyper_ball(mesh, Point<2>(), radius);
        else if (is_symmetric(0) || is_symmetric(1))
          {
            // x > 0, or turned to y > 0
            GridGenerator::half_hyper_ball(mesh, Point<2>(), radius);
            if (is_symmetric(1))
              GridTools::rotate(0.5 * numbers::PI, mesh);
          }
        else
          GridGenerator::hyper_ball_balanced(mesh, Point<2>(), radius);
        const Point<2> centre(-plate.impact_point[0], -plate.impact_point[1]);
        GridTools::shift(centre, mesh);
        mesh.reset_all_manifolds();
        for (const auto &face : mesh.active_face_iterators())
          if (face->at_boundary())
            set_ids(face);
        mesh.set_manifold(0, SphericalManifold<2>(centre));
        while (mesh.n_active_cells() < n_cells[0] * n_cells[1])
          mesh.refine_global();
      }

    private:
      void
      set_ids(const Triangulation<2>::face_iterator &face) const
      {
        const double tolerance = 1e-10 * side_length(0);
        face->set_boundary_id(edge_round);
        for (const unsigned int d : {0, 1})
          if (is_symmetric(d) && std::abs(face->vertex(0)[d]) < tolerance &&
              std::abs(face->vertex(1)[d]) < tolerance)
            {
              face->set_boundary_id(d == 0 ? symmetry_x : symmetry_y);
              // on the plane, whatever the rotation has rounded
              for (const unsigned int v : {0, 1})
                face->vertex(v)[d] = 0.;
            }
        if (face->boundary_id() == edge_round)
          face->set_manifold_id(0);
      }
    };
  } // namespace



  std::unique_ptr<const PlateGeometry>
  make_circular_plate(const PlateParameters &plate)
  {
    return std::make_unique<CircularPlate>(plate);
  }
} // namespace PlateImpact
