#include "plate_impact/plate/plate_file_reader.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/gmsh_session.h"
#include "plate_impact/plate/plate_file_boundary.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>

namespace PlateImpact
{
  namespace
  {
    constexpr int line_type = 1, quadrilateral_type = 3; // of Gmsh


    /// What Gmsh knows of the file that is open.
    class OpenFile
    {
    public:
      /// Vertices and cells, with the vertices' coordinates of the file.
      void
      read_cells(PlateFile &plate)
      {
        std::vector<int>                      types;
        std::vector<std::vector<std::size_t>> tags, nodes;
        gmsh::model::mesh::getElements(types, tags, nodes, 2);
        for (const int type : types)
          if (type != quadrilateral_type)
            refuse_file(
              "holds elements of the type " + name_of(type) +
              "; expected quadrilaterals of four nodes alone (in Gmsh: "
              "Mesh.RecombineAll = 1, Mesh.SubdivisionAlgorithm = 1, "
              "Mesh.ElementOrder = 1)");
        if (types.empty())
          refuse_file("holds no quadrilaterals; expected a mesh of a plane");
        if (tags[0].size() > most_cells)
          refuse_file(fmt::format("has {} cells; expected at most {}",
                                  tags[0].size(),
                                  most_cells));
        read_nodes();
        plate.cells.resize(tags[0].size());
        for (std::size_t i = 0; i < nodes[0].size(); ++i)
          plate.cells[i / 4][i % 4] = vertex(nodes[0][i], plate.vertices);
      }

      void
      refuse_unless_flat(const PlateFile &plate) const
      {
        if (!(highest - lowest <=
              1e-6 * std::max(plate.extent[0], plate.extent[1])))
          refuse_file("does not lie in a plane of constant z; expected a flat "
                      "plate along x and y");
      }

      /// The group of each side that has one; fills in the names of groups.
      std::map<VertexPair, unsigned int>
      read_groups(PlateFile &plate)
      {
        std::map<VertexPair, unsigned int> group_of_side;
        gmsh::vectorpair                   groups;
        gmsh::model::getPhysicalGroups(groups, 1);
        for (const auto &[dimension, tag] : groups)
          {
            std::string name;
            gmsh::model::getPhysicalName(dimension, tag, name);
            if (name.find_first_of(",:#\"") != std::string::npos)
              refuse_file(
                "has a physical group '" + name +
                "', which no scene can name; expected no comma, colon or "
                "# in it");
            const unsigned int edge = plate.edges.size();
            plate.edges.push_back(name.empty() ? std::to_string(tag) : name);
            std::vector<int> curves;
            gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, curves);
            for (const int curve : curves)
              add_sides(curve, edge, plate, group_of_side);
          }
        return group_of_side;
      }

    private:
      static constexpr std::size_t most_cells = 250000;

      static std::string
      name_of(const int type)
      {
        std::string         name;
        int                 dimension, order, n_nodes, n_primary;
        std::vector<double> local;
        gmsh::model::mesh::getElementProperties(type,
                                                name,
                                                dimension,
                                                order,
                                                n_nodes,
                                                local,
                                                n_primary);
        return name;
      }

      void
      read_nodes()
      {
        std::vector<std::size_t> tags;
        std::vector<double>      coordinates, parametric;
        gmsh::model::mesh::getNodes(tags, coordinates, parametric);
        for (std::size_t i = 0; i < tags.size(); ++i)
          nodes[tags[i]] = {{coordinates[3 * i],
                             coordinates[3 * i + 1],
                             coordinates[3 * i + 2]}};
      }

      /// The number of a node among the vertices of cells.
      unsigned int
      vertex(const std::size_t node, std::vector<PlanePoint> &vertices)
      {
        const auto [number, is_new] =
          vertex_of_node.insert({node, vertices.size()});
        if (is_new)
          {
            const auto &[x, y, z] = nodes.at(node);
            lowest                = std::min(lowest, z);
            highest               = std::max(highest, z);
            if (!(std::isfinite(x) && std::isfinite(y)))
              refuse_file("has a vertex whose coordinates are no numbers");
            vertices.push_back({{x, y}});
          }
        return number->second;
      }

      void
      add_sides(const int                           curve,
                const unsigned int                  edge,
                const PlateFile                    &plate,
                std::map<VertexPair, unsigned int> &group_of_side) const
      {
        std::vector<int>                      types;
        std::vector<std::vector<std::size_t>> tags, ends;
        gmsh::model::mesh::getElements(types, tags, ends, 1, curve);
        for (std::size_t t = 0; t < types.size(); ++t)
          for (std::size_t i = 0; types[t] == line_type && i < ends[t].size();
               i += 2)
            {
              const auto a = vertex_of_node.find(ends[t][i]),
                         b = vertex_of_node.find(ends[t][i + 1]);
              if (a == vertex_of_node.end() || b == vertex_of_node.end())
                continue;
              const auto [side, is_new] =
                group_of_side.insert({sorted(a->second, b->second), edge});
              if (!is_new && side->second != edge)
                refuse_file(
                  "has a side at " + place(plate.vertices[a->second]) +
                  " in two physical groups, '" + plate.edges[side->second] +
                  "' and '" + plate.edges[edge] + "'; expected one");
            }
      }

      std::map<std::size_t, std::array<double, 3>> nodes;
      std::map<std::size_t, unsigned int>          vertex_of_node;
      double lowest  = std::numeric_limits<double>::max(),
             highest = std::numeric_limits<double>::lowest(); // z
    };



    /// Twice the area of a triangle, positive counterclockwise.
    double
    cross(const PlanePoint &a, const PlanePoint &b, const PlanePoint &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }



    void
    orient_cells(PlateFile &plate)
    {
      for (auto &cell : plate.cells)
        {
          const auto corner = [&](const unsigned int v) -> const PlanePoint & {
            return plate.vertices[cell[v % 4]];
          };
          if (cross(corner(0), corner(1), corner(2)) +
                cross(corner(0), corner(2), corner(3)) <
              0.)
            std::reverse(cell.begin(), cell.end());
          for (unsigned int v = 0; v < 4; ++v)
            if (!(cross(corner(v), corner(v + 1), corner(v + 3)) > 1e-6 *
                    distance(corner(v), corner(v + 1)) *
                    distance(corner(v), corner(v + 3))))
              refuse_file(
                "has a cell at " + place(corner(v)) +
                " with a corner of 180 degrees or more; expected convex "
                "quadrilaterals");
        }
    }



    /// Vertices in one place that are not one are a crack.
    void
    refuse_cracks(const PlateFile &plate)
    {
      std::vector<unsigned int> order(plate.vertices.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return plate.vertices[a] < plate.vertices[b];
      });
      const double tolerance =
        1e-9 * std::max(plate.extent[0], plate.extent[1]);
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j)
          {
            const PlanePoint &a = plate.vertices[order[i]],
                             &b = plate.vertices[order[j]];
            if (b[0] - a[0] > tolerance)
              break;
            if (std::abs(b[1] - a[1]) <= tolerance)
              refuse_file("has two vertices in one place, " + place(a) +
                          ", as along a crack; expected cells that share their "
                          "vertices (in Gmsh: Coherence)");
          }
    }



    void
    refuse_loose_parts(const PlateFile &plate)
    {
      std::vector<unsigned int> parent(plate.vertices.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&parent](unsigned int v) {
        while (parent[v] != v)
          v = parent[v] = parent[parent[v]];
        return v;
      };
      for (const auto &cell : plate.cells)
        for (const unsigned int v : cell)
          parent[root(v)] = root(cell[0]);
      for (unsigned int v = 0; v < parent.size(); ++v)
        if (root(v) != root(0))
          refuse_file("has parts that do not touch, at " +
                      place(plate.vertices[0]) + " and " +
                      place(plate.vertices[v]) + "; expected one plate");
    }



    void
    read(PlateFile &plate)
    {
      const GmshSession session;
      gmsh::open(plate.path);
      OpenFile file;
      file.read_cells(plate);
      const auto box = box_around(plate.vertices);
      plate.extent   = {{box[1][0] - box[0][0], box[1][1] - box[0][1]}};
      file.refuse_unless_flat(plate);
      const auto groups = file.read_groups(plate);
      orient_cells(plate);
      refuse_cracks(plate);
      refuse_loose_parts(plate);
      find_boundary(plate, groups);
    }
  } // namespace



  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path)
  {
    std::ifstream in(path);
    std::string   first_word;
    if (!in.is_open())
      refuse_file(
        "cannot be read; expected rectangle, circle or a mesh of Gmsh");
    in >> first_word;
    if (first_word != "$MeshFormat" && first_word != "$Comments" &&
        first_word != "$PhysicalNames")
      refuse_file("is no mesh of Gmsh, which begins with $MeshFormat");
    auto plate  = std::make_shared<PlateFile>();
    plate->path = path;
    std::string failure;
    try
      {
        read(*plate);
        return plate;
      }
    // Gmsh 4.8 throws strings, later versions exceptions
    catch (const std::string &error)
      {
        failure = error;
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::bad_alloc &)
      {
        throw;
      }
    catch (const std::exception &error)
      {
        failure = error.what();
      }
    refuse_file("cannot be read as a mesh of Gmsh: " + failure);
  }
} // namespace PlateImpact
