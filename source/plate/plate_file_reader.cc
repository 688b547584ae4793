#include "plate_impact/plate/plate_file_reader.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/msh_file.h"
#include "plate_impact/plate/plate_file_boundary.h"
#include "plate_impact/plate/plate_file_overlaps.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>

namespace PlateImpact
{
  namespace
  {
    bool
    can_be_named(const std::string &edge)
    {
      return std::none_of(edge.begin(), edge.end(), [](const unsigned char c) {
        return c < ' ' || std::string(",:#\"\x7f").find(c) != std::string::npos;
      });
    }



    /// The vertices of a plate among the nodes of its file.
    class Vertices
    {
    public:
      Vertices(const MshFile &file, PlateFile &plate)
        : file(file)
        , plate(plate)
      {}

      /// Vertices and cells, with the vertices' coordinates of the file.
      void
      read_cells()
      {
        for (const auto &nodes : file.cells)
          {
            plate.cells.emplace_back();
            for (unsigned int v = 0; v < 4; ++v)
              plate.cells.back()[v] = vertex(nodes[v]);
          }
        const auto box = box_around(plate.vertices);
        plate.extent   = {{box[1][0] - box[0][0], box[1][1] - box[0][1]}};
        if (!(highest - lowest <=
              1e-6 * std::max(plate.extent[0], plate.extent[1])))
          refuse_file("does not lie in a plane of constant z; expected a flat "
                      "plate along x and y");
      }

      /// The edge of each side that is in a group; fills in the names of edges.
      std::map<VertexPair, unsigned int>
      read_edges()
      {
        std::map<unsigned int, unsigned int> edge_of_group;
        for (const auto &[group, name] : file.groups)
          {
            if (!can_be_named(name))
              refuse_file("has a physical group '" + name +
                          "', which no scene can name; expected no comma, "
                          "colon, # or control character in it");
            edge_of_group[group] = plate.edges.size();
            plate.edges.push_back(name);
          }
        std::map<VertexPair, unsigned int> edge_of_side;
        for (const MshFile::Side &side : file.sides)
          add_side(side, edge_of_group.at(side.group), edge_of_side);
        return edge_of_side;
      }

    private:
      /// The number of a node among the vertices of cells.
      unsigned int
      vertex(const MshFile::Node node)
      {
        const auto [number, is_new] =
          vertex_of_node.insert({node, plate.vertices.size()});
        if (is_new)
          {
            const auto &[x, y, z] = file.nodes.at(node);
            lowest                = std::min(lowest, z);
            highest               = std::max(highest, z);
            if (!(std::isfinite(x) && std::isfinite(y)))
              refuse_file("has a vertex whose coordinates are no numbers");
            plate.vertices.push_back({{x, y}});
          }
        return number->second;
      }

      void
      add_side(const MshFile::Side                &side,
               const unsigned int                  edge,
               std::map<VertexPair, unsigned int> &edge_of_side) const
      {
        const auto a = vertex_of_node.find(side.nodes[0]),
                   b = vertex_of_node.find(side.nodes[1]);
        if (a == vertex_of_node.end() || b == vertex_of_node.end())
          return;
        const auto [known, is_new] =
          edge_of_side.insert({sorted(a->second, b->second), edge});
        if (!is_new && known->second != edge)
          refuse_file("has a side at " + place(plate.vertices[a->second]) +
                      " in two physical groups, '" +
                      plate.edges[known->second] + "' and '" +
                      plate.edges[edge] + "'; expected one");
      }

      const MshFile                        &file;
      PlateFile                            &plate;
      std::map<MshFile::Node, unsigned int> vertex_of_node;
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
    auto plate         = std::make_shared<PlateFile>();
    plate->path        = path;
    const MshFile file = read_msh_file(path);
    Vertices      vertices(file, *plate);
    vertices.read_cells();
    const auto edges = vertices.read_edges();
    orient_cells(*plate);
    refuse_cracks(*plate);
    refuse_loose_parts(*plate);
    refuse_overlaps(*plate);
    find_boundary(*plate, edges);
    return plate;
  }
} // namespace PlateImpact
