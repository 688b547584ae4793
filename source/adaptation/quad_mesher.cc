#include "plate_impact/adaptation/quad_mesher.h"

#include "plate_impact/adaptation/gmsh_session.h"
#include "plate_impact/base/exceptions.h"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <unordered_map>

namespace PlateImpact
{
  namespace
  {
    /// Gmsh compares lengths with absolute tolerances: domains are scaled to a
    /// longest side of one.
    double
    longest_extent(const std::vector<PlanePoint> &corners)
    {
      double extent = 0.;
      for (const PlanePoint &a : corners)
        for (const PlanePoint &b : corners)
          extent =
            std::max({extent, std::abs(a[0] - b[0]), std::abs(a[1] - b[1])});
      return extent;
    }



    /// @return the tags of the sides, each from a corner to the next
    std::vector<int>
    add_domain(const std::vector<PlanePoint> &corners,
               const std::vector<PlanePoint> &inside,
               const double                   scale)
    {
      std::vector<int> points, sides;
      for (const PlanePoint &corner : corners)
        points.push_back(
          gmsh::model::geo::addPoint(corner[0] / scale, corner[1] / scale, 0.));
      for (unsigned int i = 0; i < points.size(); ++i)
        sides.push_back(
          gmsh::model::geo::addLine(points[i],
                                    points[(i + 1) % points.size()]));
      const int surface = gmsh::model::geo::addPlaneSurface(
        {gmsh::model::geo::addCurveLoop(sides)});
      std::vector<int> embedded;
      for (const PlanePoint &point : inside)
        embedded.push_back(
          gmsh::model::geo::addPoint(point[0] / scale, point[1] / scale, 0.));
      gmsh::model::geo::synchronize();
      if (!embedded.empty())
        gmsh::model::mesh::embed(0, embedded, 2, surface);
      return sides;
    }



    void
    set_sizes(const SizeField &sizes, const double scale, const double factor)
    {
      std::vector<double> data;
      data.reserve(16 * sizes.patches.size());
      for (const SizeField::Patch &patch : sizes.patches)
        {
          for (const unsigned int d : {0, 1})
            for (const PlanePoint &corner : patch.corners)
              data.push_back(corner[d] / scale);
          data.insert(data.end(), 4, 0.);
          for (const double size : patch.sizes)
            data.push_back(factor * size / scale);
        }
      // a list of scalar quadrangles
      const int view = gmsh::view::add("target sizes");
      gmsh::view::addListData(view, "SQ", sizes.patches.size(), data);
      const int field = gmsh::model::mesh::field::add("PostView");
      gmsh::model::mesh::field::setNumber(field, "ViewTag", view);
      gmsh::model::mesh::field::setAsBackgroundMesh(field);
    }



    void
    set_options(const MesherSettings &settings)
    {
      const std::vector<std::pair<std::string, double>> options = {
        {"Geometry.Tolerance", 1e-12},
        {"Mesh.MeshSizeExtendFromBoundary", 0},
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeFromCurvature", 0},
        {"Mesh.Algorithm", settings.algorithm},
        {"Mesh.RecombineAll", settings.recombination >= 0},
        {"Mesh.RecombinationAlgorithm", std::max(0, settings.recombination)},
        {"Mesh.SubdivisionAlgorithm", settings.subdivision}};
      for (const auto &[name, value] : options)
        gmsh::option::setNumber(name, value);
    }



    /// Puts the vertices of a straight side exactly on it, and its ends on the
    /// corners.
    void
    snap(const int                                            side,
         const PlanePoint                                    &begin,
         const PlanePoint                                    &end,
         const std::unordered_map<std::size_t, unsigned int> &index_of_tag,
         std::vector<PlanePoint>                             &vertices)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      coordinates, parameters;
      gmsh::model::mesh::getNodes(tags,
                                  coordinates,
                                  parameters,
                                  1,
                                  side,
                                  /*includeBoundary=*/false);
      for (const std::size_t tag : tags)
        for (const unsigned int d : {0, 1})
          if (begin[d] == end[d])
            vertices[index_of_tag.at(tag)][d] = begin[d];
      const auto distance = [&](const PlanePoint &vertex) {
        return std::hypot(vertex[0] - begin[0], vertex[1] - begin[1]);
      };
      *std::min_element(vertices.begin(),
                        vertices.end(),
                        [&](const PlanePoint &a, const PlanePoint &b) {
                          return distance(a) < distance(b);
                        }) = begin;
    }



    /// The mesh that Gmsh holds.
    QuadMesh
    read_mesh(const std::vector<PlanePoint> &corners,
              const std::vector<int>        &sides,
              const double                   scale)
    {
      QuadMesh                                      mesh;
      std::unordered_map<std::size_t, unsigned int> index_of_tag;
      std::vector<std::size_t>                      tags;
      std::vector<double>                           coordinates, parameters;
      gmsh::model::mesh::getNodes(tags, coordinates, parameters);
      for (unsigned int i = 0; i < tags.size(); ++i)
        {
          index_of_tag[tags[i]] = mesh.vertices.size();
          mesh.vertices.push_back(
            {{scale * coordinates[3 * i], scale * coordinates[3 * i + 1]}});
        }
      for (unsigned int i = 0; i < sides.size(); ++i)
        snap(sides[i],
             corners[i],
             corners[(i + 1) % corners.size()],
             index_of_tag,
             mesh.vertices);

      constexpr int            quadrangle = 3; // Gmsh's number of the type
      std::vector<std::size_t> cell_tags, nodes;
      gmsh::model::mesh::getElementsByType(quadrangle, cell_tags, nodes);
      for (unsigned int c = 0; c < cell_tags.size(); ++c)
        {
          mesh.cells.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            mesh.cells.back()[v] = index_of_tag.at(nodes[4 * c + v]);
        }
      return mesh;
    }



    unsigned int
    n_triangles()
    {
      constexpr int            triangle = 2; // Gmsh's number of the type
      std::vector<std::size_t> tags, nodes;
      gmsh::model::mesh::getElementsByType(triangle, tags, nodes);
      return tags.size();
    }



    /// One attempt.
    /// @throws std::string, as Gmsh does, saying why there is no mesh
    QuadMesh
    attempt(const std::vector<PlanePoint> &corners,
            const std::vector<PlanePoint> &inside,
            const SizeField               &sizes,
            const MesherSettings          &settings)
    {
      const GmshSession session;
      const double      scale = longest_extent(corners);
      set_options(settings);
      const std::vector<int> sides = add_domain(corners, inside, scale);
      set_sizes(sizes, scale, settings.size_factor);
      gmsh::model::mesh::generate(2);
      if (const unsigned int n = n_triangles())
        throw std::string(std::to_string(n) + " triangles are left");
      const QuadMesh mesh = read_mesh(corners, sides, scale);
      if (mesh.cells.empty())
        throw std::string("there are no cells");
      if (const double worst = mesh.worst_scaled_jacobian();
          !(worst >= QuadMesher::least_quality))
        throw std::string("the worst scaled Jacobian is " +
                          std::to_string(worst));
      return mesh;
    }
  } // namespace



  double
  QuadMesh::worst_scaled_jacobian() const
  {
    double worst = 1.;
    for (const auto &cell : cells)
      for (unsigned int v = 0; v < 4; ++v)
        {
          const PlanePoint &corner = vertices[cell[v]],
                           &next   = vertices[cell[(v + 1) % 4]],
                           &last   = vertices[cell[(v + 3) % 4]];
          const double a[]         = {next[0] - corner[0], next[1] - corner[1]},
                       b[]         = {last[0] - corner[0], last[1] - corner[1]};
          const double lengths =
            std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
          const double area = a[0] * b[1] - a[1] * b[0];
          worst = std::min(worst, lengths > 0. ? area / lengths : 0.);
        }
    return worst;
  }



  std::vector<MesherSettings>
  QuadMesher::default_settings()
  {
    // full-quad recombination halves the edges of a twice coarser mesh;
    // cutting triangles halves theirs
    return {{"Blossom recombination", 6, 3, 0, 1.},
            {"triangles cut into quadrilaterals", 5, -1, 1, 2.}};
  }



  QuadMesher::QuadMesher(const std::vector<MesherSettings> &attempts)
    : attempts(attempts)
  {}



  QuadMesh
  QuadMesher::mesh(const std::vector<PlanePoint> &corners,
                   const SizeField               &sizes,
                   std::vector<std::string>      &warnings,
                   const std::vector<PlanePoint> &inside) const
  {
    std::string failures;
    for (const MesherSettings &settings : attempts)
      {
        std::string failure;
        try
          {
            const QuadMesh mesh = attempt(corners, inside, sizes, settings);
            if (!failures.empty())
              warnings.push_back("Gmsh made no mesh at first (" + failures +
                                 "); the mesh is one of " + settings.name);
            return mesh;
          }
        // Gmsh 4.8 throws strings, later versions exceptions
        catch (const std::string &error)
          {
            failure = error;
          }
        catch (const std::bad_alloc &)
          {
            throw;
          }
        catch (const std::exception &error)
          {
            failure = error.what();
          }
        failures +=
          (failures.empty() ? "" : "; ") + settings.name + ": " + failure;
      }
    throw ComputationError(
      "Gmsh made no mesh of quadrilaterals (" + failures +
      "); try another Discretization/Initial cells or Adaptivity/Strategy = "
      "hanging nodes");
  }
} // namespace PlateImpact
