#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// The whole plate of a file, whose cells are the first mesh.
    class PlateFromFile : public PlateGeometry
    {
    public:
      explicit PlateFromFile(const PlateParameters &plate)
        : PlateGeometry(plate)
        , file(*plate.file)
        , impact(file.centre +
                 Point<2>(plate.impact_point[0], plate.impact_point[1]))
      {}

      double
      side_length(const unsigned int d) const override
      {
        return file.extent[d];
      }

      double
      area() const override
      {
        return file.area;
      }

      double
      distance_to_edge() const override
      {
        return file.distance_to_edge(impact);
      }

      double
      distance_to_edge(const unsigned int axis) const override
      {
        return file.distance_to_edge(impact, axis);
      }

      bool
      is_symmetric(const unsigned int) const override
      {
        return false; // whatever it is, its mesh is whole
      }

      std::map<types::boundary_id, std::string>
      edges() const override
      {
        std::map<types::boundary_id, std::string> edges;
        for (unsigned int edge = 0; edge < file.edges.size(); ++edge)
          edges[edge_named + edge] = file.edges[edge];
        return edges;
      }

      void
      make_mesh(Triangulation<2> &mesh, const CellNumbers &) const override
      {
        mesh.copy_triangulation(file.mesh);
        GridTools::shift(Point<2>() - impact, mesh);
        for (unsigned int arc = 0; arc < file.arcs.size(); ++arc)
          mesh.set_manifold(arc,
                            SphericalManifold<2>(
                              Point<2>(file.arcs[arc].centre - impact)));
      }

      double
      n_initial_cells(const CellNumbers &) const override
      {
        return file.mesh.n_active_cells();
      }

    private:
      const PlateFile &file;
      const Point<2>   impact; ///< in coordinates of the file
    };
  } // namespace



  std::unique_ptr<const PlateGeometry>
  make_plate_from_file(const PlateParameters &plate)
  {
    return std::make_unique<PlateFromFile>(plate);
  }
} // namespace PlateImpact
