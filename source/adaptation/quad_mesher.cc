#include "plate_impact/adaptation/quad_mesher.h"

#include <deal.II/base/bounding_box.h>

#include "plate_impact/base/exceptions.h"

#include <cmath>
#include <new>
#include <unordered_map>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Gmsh's numbers of types of elements.
    constexpr int triangle = 2, quadrangle = 3;

    /// Of the scaled Jacobian.
    constexpr double least_quality = 0.15;



    void
    add_domain(const std::vector<Point<2>> &corners,
               const std::vector<Point<2>> &inside,
               const double                 scale)
    {
      std::vector<int> points, sides, embedded;
      const auto       add = [=](const Point<2> &p) {
        return gmsh::model::geo::addPoint(p[0] / scale, p[1] / scale, 0.);
      };
      for (const Point<2> &corner : corners)
        points.push_back(add(corner));
      for (unsigned int i = 0; i < points.size(); ++i)
        sides.push_back(
          gmsh::model::geo::addLine(points[i],
                                    points[(i + 1) % points.size()]));
      const int surface = gmsh::model::geo::addPlaneSurface(
        {gmsh::model::geo::addCurveLoop(sides)});
      for (const Point<2> &point : inside)
        embedded.push_back(add(point));
      gmsh::model::geo::synchronize();
      if (!embedded.empty())
        gmsh::model::mesh::embed(0, embedded, 2, surface);
    }



    void
    set_sizes(const Triangulation<2>    &mesh,
              const std::vector<double> &sizes,
              const double               scale,
              const double               factor)
    {
      std::vector<double> data;
      data.reserve(16 * mesh.n_active_cells());
      const std::array<unsigned int, 4> around = {{0, 1, 3, 2}};
      for (const auto &cell : mesh.active_cell_iterators())
        {
          for (const unsigned int d : {0, 1})
            for (const unsigned int v : around)
              data.push_back(cell->vertex(v)[d] / scale);
          data.insert(data.end(), 4, 0.);
          for (const unsigned int v : around)
            data.push_back(factor * sizes[cell->vertex_index(v)] / scale);
        }
      // a list of scalar quadrangles
      const int view = gmsh::view::add("target sizes");
      gmsh::view::addListData(view, "SQ", mesh.n_active_cells(), data);
      const int field = gmsh::model::mesh::field::add("PostView");
      gmsh::model::mesh::field::setNumber(field, "ViewTag", view);
      gmsh::model::mesh::field::setAsBackgroundMesh(field);
    }



    /// Nodes of all elements of a type, by Gmsh's number for it.
    std::vector<std::size_t>
    nodes_of_elements(const int type)
    {
      std::vector<std::size_t> tags, nodes;
      gmsh::model::mesh::getElementsByType(type, tags, nodes);
      return nodes;
    }



    /// The mesh that Gmsh holds. Coordinates that are a corner's but for
    /// round-off are exactly that.
    QuadMesh
    read_mesh(const std::vector<Point<2>> &corners, const double scale)
    {
      QuadMesh                                      mesh;
      std::unordered_map<std::size_t, unsigned int> index_of_tag;
      std::vector<std::size_t>                      tags;
      std::vector<double>                           coordinates, parameters;
      gmsh::model::mesh::getNodes(tags, coordinates, parameters);
      for (unsigned int i = 0; i < tags.size(); ++i)
        {
          index_of_tag[tags[i]] = i;
          Point<2> vertex;
          for (const unsigned int d : {0, 1})
            {
              vertex[d] = scale * coordinates[3 * i + d];
              for (const Point<2> &corner : corners)
                if (std::abs(vertex[d] - corner[d]) < 1e-10 * scale)
                  vertex[d] = corner[d];
            }
          mesh.vertices.push_back(vertex);
        }
      const std::vector<std::size_t> nodes = nodes_of_elements(quadrangle);
      mesh.cells.resize(nodes.size() / 4);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        mesh.cells[i / 4][i % 4] = index_of_tag.at(nodes[i]);
      return mesh;
    }



    /// One attempt.
    /// @throws std::string, as Gmsh does, saying why there is no mesh
    QuadMesh
    attempt(const std::vector<Point<2>> &corners,
            const std::vector<Point<2>> &inside,
            const Triangulation<2>      &old_mesh,
            const std::vector<double>   &sizes,
            const MesherSettings        &settings)
    {
      const std::pair<const char *, double> options[] = {
        {"Geometry.Tolerance", 1e-12},
        {"Mesh.MeshSizeExtendFromBoundary", 0},
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeFromCurvature", 0},
        {"Mesh.Algorithm", settings.algorithm},
        {"Mesh.RecombineAll", settings.recombination >= 0},
        {"Mesh.RecombinationAlgorithm", std::max(0, settings.recombination)},
        {"Mesh.SubdivisionAlgorithm", settings.subdivision}};
      const GmshSession session;
      for (const auto &[name, value] : options)
        gmsh::option::setNumber(name, value);
      // Gmsh compares lengths with absolute tolerances
      const BoundingBox<2> box(corners);
      const double scale = std::max(box.side_length(0), box.side_length(1));
      add_domain(corners, inside, scale);
      set_sizes(old_mesh, sizes, scale, settings.size_factor);
      gmsh::model::mesh::generate(2);
      if (const auto n = nodes_of_elements(triangle).size() / 3)
        throw std::string(std::to_string(n) + " triangles are left");
      const QuadMesh mesh = read_mesh(corners, scale);
      if (mesh.cells.empty())
        throw std::string("there are no cells");
      if (const double worst = mesh.worst_scaled_jacobian();
          !(worst >= least_quality))
        throw std::string("the worst scaled Jacobian is " +
                          std::to_string(worst));
      return mesh;
    }
  } // namespace



  QuadMesh
  mesh_by_gmsh(const std::vector<Point<2>>       &corners,
               const std::vector<Point<2>>       &inside,
               const Triangulation<2>            &old_mesh,
               const std::vector<double>         &sizes,
               std::vector<std::string>          &warnings,
               const std::vector<MesherSettings> &attempts)
  {
    std::string failures;
    for (const MesherSettings &settings : attempts)
      {
        const auto note = [&](const std::string &failure) {
          failures +=
            (failures.empty() ? "" : "; ") + settings.name + ": " + failure;
        };
        try
          {
            const QuadMesh mesh =
              attempt(corners, inside, old_mesh, sizes, settings);
            if (!failures.empty())
              warnings.push_back("Gmsh made no mesh at first (" + failures +
                                 "); the mesh is one of " + settings.name);
            return mesh;
          }
        // Gmsh 4.8 throws strings, later versions exceptions
        catch (const std::string &error)
          {
            note(error);
          }
        catch (const std::bad_alloc &)
          {
            throw;
          }
        catch (const std::exception &error)
          {
            note(error.what());
          }
      }
    throw ComputationError(
      "Gmsh made no mesh of quadrilaterals (" + failures +
      "); try another Discretization/Initial cells or Adaptivity/Strategy = "
      "hanging nodes");
  }
} // namespace PlateImpact
