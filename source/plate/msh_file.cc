#include "plate_impact/plate/msh_file.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <type_traits>
#include <unordered_map>

namespace PlateImpact
{
  namespace
  {
    using Count = std::uint64_t;

    constexpr int line_type = 1, quadrilateral_type = 3; // of Gmsh


    /// Nodes of an element of a type that a mesh of quadrilaterals may have.
    unsigned int
    n_nodes_of(const int type)
    {
      if (type == line_type)
        return 2;
      if (type == quadrilateral_type)
        return 4;
      if (type == 15) // a point
        return 1;
      std::map<int, std::string> others = {{2, " (Triangle)"},
                                           {9, " (Triangle of 6 nodes)"},
                                           {10, " (Quadrilateral of 9 nodes)"},
                                           {16, " (Quadrilateral of 8 nodes)"}};
      throw InputError(
        {"holds elements of the type " + std::to_string(type) + others[type] +
         "; expected quadrilaterals of four nodes alone (in Gmsh: "
         "Mesh.RecombineAll = 1, Mesh.SubdivisionAlgorithm = 1, "
         "Mesh.ElementOrder = 1)"});
    }



    [[noreturn]] void
    refuse_format(const std::string &found)
    {
      throw InputError(
        {"is " + found +
         "; expected version 4.1 or 2.2 of Gmsh's format, as text and of one "
         "part (in Gmsh: Mesh.MshFileVersion = 4.1, Mesh.Binary = 0, "
         "Mesh.SaveParametric = 0)"});
    }



    class MshReader
    {
    public:
      explicit MshReader(const std::string &path)
        : in(path)
      {}

      MshFile
      read()
      {
        if (!in.is_open())
          throw InputError(
            {"cannot be read; expected rectangle, circle or a mesh of Gmsh"});
        // the first word tells other files apart; then from the beginning
        in >> section;
        if (section != "$MeshFormat" && section != "$Comments" &&
            section != "$PhysicalNames")
          throw InputError(
            {"is no mesh of Gmsh, which begins with $MeshFormat"});
        in.seekg(0);
        while (in >> section)
          if (section[0] == '$')
            read_section();
        name_edges();
        if (file.cells.empty())
          throw InputError(
            {"holds no quadrilaterals; expected a mesh of a plane"});
        return std::move(file);
      }

    private:
      static constexpr std::size_t most_cells = 250000;

      /// An edge is a physical group of curves.
      void
      name_edges()
      {
        for (auto &[group, edge] : edge_of_group)
          {
            const std::string &name =
              names.try_emplace(group, std::to_string(group)).first->second;
            if (printable(name) != name ||
                name.find_first_of(",:#\"") != std::string::npos)
              throw InputError({"has a physical group '" + name +
                                "', which no scene can name; expected no "
                                "comma, colon, # or control character in it"});
            edge = file.edges.size();
            file.edges.push_back(name);
          }
        for (const auto &[tags, group] : lines)
          {
            if (vertices.count(tags[0]) == 0 || vertices.count(tags[1]) == 0)
              continue;
            const unsigned int a = vertices[tags[0]], b = vertices[tags[1]];
            const unsigned int edge  = edge_of_group[group],
                               known = file.edge_of_side
                                         .insert({std::minmax({a, b}), edge})
                                         .first->second;
            if (known != edge)
              throw InputError({fmt::format(
                "has a side at ({:.4g}, {:.4g}) in two physical groups, '{}' "
                "and '{}'; expected one",
                file.vertices[std::min(a, b)][0],
                file.vertices[std::min(a, b)][1],
                file.edges[known],
                file.edges[edge])});
          }
      }

      void
      read_section()
      {
        const std::map<std::string, std::function<void()>> known = {
          {"$MeshFormat", [this] { read_format(); }},
          {"$PhysicalNames", [this] { read_names(); }},
          {"$Nodes", [this] { read_nodes(); }},
          {"$Elements", [this] { read_elements(); }},
          {"$ParametricNodes",
           [] { refuse_format("a mesh with the parameters of nodes"); }},
          {"$PartitionedEntities",
           [] { refuse_format("a mesh of several parts"); }}};
        const auto read = known.find(section);
        if (read != known.end())
          read->second();
        else if (section == "$Entities")
          read_curves(); // and nothing of what follows, surfaces
        const std::string end   = "$End" + section.substr(1);
        std::string       found = word();
        if (read != known.end() && found != end)
          refuse("expected " + end + ", not '" + found + "'");
        while (found != end)
          found = word();
      }

      void
      read_format()
      {
        version = next<double>();
        if (!(version >= 2. && version < 3.) && version != 4.1)
          refuse_format(fmt::format("of version {}", version));
        if (next<int>() != 0)
          refuse_format("a binary file");
        next<int>(); // bytes of a number
      }

      void
      read_names()
      {
        for (Count n = next<Count>(); n > 0; --n)
          {
            const int   dimension = next<int>();
            const int   group     = next<int>();
            std::string line;
            std::getline(in, line);
            const std::size_t begin = line.find('"'), end = line.rfind('"');
            if (begin == end)
              refuse("expected a name in quotes");
            if (dimension == 1)
              names[std::labs(group)] = line.substr(begin + 1, end - begin - 1);
          }
      }

      /// The groups that curves are in, of version 4; with a negative number,
      /// here as elsewhere, against their direction.
      void
      read_curves()
      {
        // of points, curves, surfaces and volumes
        const auto  n        = next<Count>(4);
        const Count n_points = n[0], n_curves = n[1];
        for (Count i = 0; i < n_points + n_curves; ++i)
          {
            const bool is_curve = i >= n_points;
            const int  entity   = next<int>();
            // the place of a point, the box around a curve
            next<double>(is_curve ? 6 : 3);
            for (const int group : next<int>(next<Count>()))
              if (is_curve)
                {
                  groups_of_curve[entity].push_back(std::labs(group));
                  edge_of_group[std::labs(group)];
                }
            if (is_curve)
              next<int>(next<Count>()); // its ends
          }
      }

      void
      read_nodes()
      {
        if (version == 0.)
          refuse("expected $MeshFormat before it");
        if (version < 4.)
          for (Count n = next<Count>(); n > 0; --n)
            add_node(next<Count>());
        else
          // blocks, their nodes, the least and the largest number
          for (Count n = next<Count>(4)[0]; n > 0; --n)
            {
              next<int>(2); // dimension and entity
              if (next<int>() != 0)
                refuse_format("a mesh with the parameters of nodes");
              // first all numbers, then all coordinates
              for (const Count tag : next<Count>(next<Count>()))
                add_node(tag);
            }
      }

      void
      add_node(const Count tag)
      {
        const auto point = next<double>(3);
        if (!nodes.insert({tag, {point[0], point[1], point[2]}}).second)
          refuse(fmt::format("the node {} comes twice", tag));
      }

      void
      read_elements()
      {
        if (version < 4.)
          for (Count n = next<Count>(); n > 0; --n)
            {
              next<Count>(); // its number
              const int                 type = next<int>();
              const auto                tags = next<int>(next<Count>());
              std::vector<unsigned int> groups;
              if (!tags.empty() && tags[0] != 0)
                groups.push_back(std::labs(tags[0]));
              add_element(type, groups);
            }
        else
          // the same of elements
          for (Count blocks = next<Count>(4)[0]; blocks > 0; --blocks)
            {
              next<int>(); // dimension
              const int entity = next<int>(), type = next<int>();
              for (Count n = next<Count>(); n > 0; --n)
                {
                  next<Count>(); // its number
                  add_element(type, groups_of_curve[entity]);
                }
            }
      }

      void
      add_element(const int type, const std::vector<unsigned int> &groups)
      {
        const auto tags = next<Count>(n_nodes_of(type));
        for (const Count tag : tags)
          if (nodes.count(tag) == 0)
            refuse(fmt::format("an element has the node {}, which is not among "
                               "the nodes of the file",
                               tag));
        if (type == quadrilateral_type)
          add_cell(tags);
        if (type == line_type)
          for (const unsigned int group : groups)
            {
              edge_of_group[group];
              lines.push_back({{{tags[0], tags[1]}}, group});
            }
      }

      void
      add_cell(const std::vector<Count> &tags)
      {
        dealii::CellData<2> &cell = file.cells.emplace_back();
        for (unsigned int v = 0; v < 4; ++v)
          {
            // around the cell there, by rows here
            const Count tag = tags[v ^ (v / 2)];
            const auto [vertex, is_new] =
              vertices.try_emplace(tag, vertices.size());
            if (is_new)
              file.vertices.push_back(nodes[tag]);
            cell.vertices[v] = vertex->second;
          }
        if (file.cells.size() > most_cells)
          throw InputError(
            {fmt::format("has more than {} cells; expected at most that many",
                         most_cells)});
      }

      std::string
      word()
      {
        std::string found;
        if (!(in >> found))
          throw InputError({"is damaged: it ends within " + section});
        return found;
      }

      template <typename Number>
      Number
      next()
      {
        const std::string found  = word();
        Number            number = 0;
        if (!to_number(found, number))
          refuse(std::string("expected a ") +
                 (std::is_integral_v<Number> ? "whole " : "") +
                 "number, not '" + found + "'");
        return number;
      }

      template <typename Number>
      std::vector<Number>
      next(const Count n)
      {
        std::vector<Number> numbers;
        while (numbers.size() < n)
          numbers.push_back(next<Number>());
        return numbers;
      }

      /// With the line that has been read last.
      [[noreturn]] void
      refuse(const std::string &what)
      {
        in.clear();
        std::string before(in.tellg(), ' ');
        in.seekg(0);
        in.read(before.data(), before.size());
        throw InputError(
          {fmt::format("is damaged in line {}, in {}: {}",
                       1 + std::count(before.begin(), before.end(), '\n'),
                       section,
                       what)});
      }

      std::ifstream                            in;
      std::string                              section; ///< with its `$`
      MshFile                                  file;
      double                                   version = 0.;
      std::map<unsigned int, std::string>      names;
      std::map<unsigned int, unsigned int>     edge_of_group;
      std::map<int, std::vector<unsigned int>> groups_of_curve;
      // by the numbers of nodes in the file
      std::unordered_map<Count, dealii::Point<3>>                nodes;
      std::unordered_map<Count, unsigned int>                    vertices;
      std::vector<std::pair<std::array<Count, 2>, unsigned int>> lines;
    };
  } // namespace



  MshFile
  read_msh_file(const std::string &path)
  {
    return MshReader(path).read();
  }
} // namespace PlateImpact
