#include "plate_impact/plate/plate_geometry.h"

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;


  bool
  PlateGeometry::is_symmetric(const unsigned int d) const
  {
    return !plate.is_skew && plate.impact_point[d] == 0.;
  }



  double
  PlateGeometry::n_parts() const
  {
    return (is_symmetric(0) ? 2. : 1.) * (is_symmetric(1) ? 2. : 1.);
  }



  template <typename Support>
  std::map<types::boundary_id, Support>
  PlateGeometry::by_edge(const std::vector<OnEdge<Support>> &written) const
  {
    std::map<types::boundary_id, Support> result;
    const bool  is_named = !written.front().edge.empty();
    std::size_t n_edges  = 0;
    for (const auto &[id, name] : edges())
      {
        // one word is for all edges, or the first for the first of two
        const OnEdge<Support> *one =
          &written[std::min(n_edges++, written.size() - 1)];
        for (const OnEdge<Support> &named : written)
          if (is_named && named.edge == name)
            one = &named;
        result[id] = one->support;
      }
    return result;
  }



  SupportOfEdge
  PlateGeometry::supports() const
  {
    return by_edge(plate.supports);
  }



  InPlaneSupportOfEdge
  PlateGeometry::in_plane_supports() const
  {
    return by_edge(plate.in_plane_supports);
  }



  double
  PlateGeometry::begin(const unsigned int d) const
  {
    return is_symmetric(d) ? 0. : -0.5 * side_length(d) - plate.impact_point[d];
  }



  double
  PlateGeometry::end(const unsigned int d) const
  {
    return 0.5 * side_length(d) - plate.impact_point[d];
  }



  double
  PlateGeometry::n_initial_cells(const CellNumbers &n_cells) const
  {
    return static_cast<double>(n_cells[0]) * n_cells[1];
  }



  double
  PlateGeometry::initial_cell_size(const CellNumbers &n_cells) const
  {
    Triangulation<2> mesh;
    make_mesh(mesh, n_cells);
    double longest = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      longest = std::max(longest, cell_size(cell));
    return longest;
  }



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



    struct OutlineRow
    {
      PlateOutline choice;
      std::string  word; ///< empty: a file's name stands for it
      std::unique_ptr<const PlateGeometry> (*make)(const PlateParameters &);
    };

    const std::vector<OutlineRow> outlines = {
      {PlateOutline::rectangle,
       "rectangle",
       make_as<const PlateGeometry, RectangularPlate>},
      {PlateOutline::circle,
       "circle",
       make_as<const PlateGeometry, CircularPlate>},
      {PlateOutline::file, "", make_as<const PlateGeometry, PlateFromFile>}};
  } // namespace



  template <>
  const std::vector<Word<PlateOutline>> Choices<PlateOutline>::words = [] {
    auto words = words_of(outlines);
    words.pop_back(); // of files
    return words;
  }();



  std::unique_ptr<const PlateGeometry>
  geometry_of(const PlateParameters &plate)
  {
    return row_of(plate.outline.shape, outlines).make(plate);
  }



  std::unique_ptr<Triangulation<2>>
  make_plate_mesh(const PlateParameters             &plate,
                  const std::array<unsigned int, 2> &n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    geometry_of(plate)->make_mesh(*mesh, n_cells);
    return mesh;
  }



  double
  initial_cell_size(const Parameters &parameters)
  {
    return geometry_of(parameters.plate)
      ->initial_cell_size(parameters.discretization.initial_cells);
  }
} // namespace PlateImpact
