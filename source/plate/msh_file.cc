#include "plate_impact/plate/msh_file.h"

#include "plate_impact/base/exceptions.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <type_traits>
#include <unordered_map>

namespace PlateImpact
{
  void
  refuse_file(const std::string &sentence)
  {
    throw InputError({sentence});
  }



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
      static const std::map<int, std::string> others = {
        {2, " (Triangle)"},
        {9, " (Triangle of 6 nodes)"},
        {10, " (Quadrilateral of 9 nodes)"},
        {16, " (Quadrilateral of 8 nodes)"}};
      const auto other = others.find(type);
      refuse_file("holds elements of the type " + std::to_string(type) +
                  (other != others.end() ? other->second : "") +
                  "; expected quadrilaterals of four nodes alone (in Gmsh: "
                  "Mesh.RecombineAll = 1, Mesh.SubdivisionAlgorithm = 1, "
                  "Mesh.ElementOrder = 1)");
    }



    [[noreturn]] void
    refuse_format(const std::string &found)
    {
      refuse_file("is " + found +
                  "; expected version 4.1 or 2.2 of Gmsh's format, as text and "
                  "of one part (in Gmsh: Mesh.MshFileVersion = 4.1, "
                  "Mesh.Binary = 0, Mesh.SaveParametric = 0)");
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
          refuse_file(
            "cannot be read; expected rectangle, circle or a mesh of Gmsh");
        // the first word tells other files apart; then from the beginning
        in >> section;
        if (section != "$MeshFormat" && section != "$Comments" &&
            section != "$PhysicalNames")
          refuse_file("is no mesh of Gmsh, which begins with $MeshFormat");
        in.seekg(0);
        while (in >> section)
          if (section[0] == '$')
            {
              const std::string end     = "$End" + section.substr(1);
              const bool        is_read = read_section();
              std::string       found   = word();
              if (is_read && found != end)
                refuse("expected " + end + ", not '" + found + "'");
              while (found != end)
                found = word();
            }
        for (auto &[group, name] : file.groups)
          name = names.count(group) > 0 ? names[group] : std::to_string(group);
        if (file.cells.empty())
          refuse_file("holds no quadrilaterals; expected a mesh of a plane");
        return std::move(file);
      }

    private:
      static constexpr std::size_t most_cells = 250000;

      /// @return whether the section is one that a plate needs
      bool
      read_section()
      {
        if (section == "$MeshFormat")
          read_format();
        else if (section == "$PhysicalNames")
          read_names();
        else if (section == "$ParametricNodes")
          refuse_format("a mesh with the parameters of nodes");
        else if (section == "$PartitionedEntities")
          refuse_format("a mesh of several parts");
        else if (section != "$Entities" && section != "$Nodes" &&
                 section != "$Elements")
          return false;
        else if (version == 0.)
          refuse("expected $MeshFormat before it");
        else if (section == "$Entities")
          {
            read_curves();
            return false; // of what follows, surfaces, nothing is needed
          }
        else if (section == "$Nodes")
          read_nodes();
        else
          read_elements();
        return true;
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
        const Count n_points = next<Count>(), n_curves = next<Count>();
        next<Count>(); // surfaces
        next<Count>(); // volumes
        for (Count n = 0; n < n_points + n_curves; ++n)
          {
            const bool is_curve = n >= n_points;
            const int  entity   = next<int>();
            // the place of a point, the box around a curve
            for (unsigned int i = 0; i < (is_curve ? 6 : 3); ++i)
              next<double>();
            for (Count n_groups = next<Count>(); n_groups > 0; --n_groups)
              if (const int group = next<int>(); is_curve)
                groups_of_curve[entity].push_back(std::labs(group));
            if (is_curve)
              for (Count n_ends = next<Count>(); n_ends > 0; --n_ends)
                next<int>();
          }
        for (const auto &[curve, groups] : groups_of_curve)
          for (const unsigned int group : groups)
            file.groups[group];
      }

      void
      read_nodes()
      {
        if (version < 4.)
          for (Count n = next<Count>(); n > 0; --n)
            add_node(next<Count>());
        else
          for (Count n_blocks = blocks(); n_blocks > 0; --n_blocks)
            {
              next<int>(); // dimension
              next<int>(); // entity
              if (next<int>() != 0)
                refuse_format("a mesh with the parameters of nodes");
              // first all numbers, then all coordinates
              const Count        n = next<Count>();
              std::vector<Count> tags;
              while (tags.size() < n)
                tags.push_back(next<Count>());
              for (const Count tag : tags)
                add_node(tag);
            }
      }

      void
      add_node(const Count tag)
      {
        dealii::Point<3> point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = next<double>();
        if (!number_of_node.insert({tag, file.nodes.size()}).second)
          refuse(fmt::format("the node {} comes twice", tag));
        file.nodes.push_back(point);
      }

      void
      read_elements()
      {
        if (version < 4.)
          for (Count n = next<Count>(); n > 0; --n)
            {
              next<Count>(); // its number
              const int                 type   = next<int>();
              const int                 n_tags = next<int>();
              std::vector<unsigned int> groups; // the first tag
              for (int t = 0; t < n_tags; ++t)
                if (const int tag = next<int>(); t == 0 && tag != 0)
                  groups.assign(1, std::labs(tag));
              add_element(type, groups);
            }
        else
          for (Count n_blocks = blocks(); n_blocks > 0; --n_blocks)
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
        std::array<unsigned int, 4> nodes;
        const unsigned int          n_nodes = n_nodes_of(type);
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            const Count tag   = next<Count>();
            const auto  found = number_of_node.find(tag);
            if (found == number_of_node.end())
              refuse(fmt::format("an element has the node {}, which is not "
                                 "among the nodes of the file",
                                 tag));
            nodes[i] = found->second;
          }
        if (type == quadrilateral_type)
          {
            // around the cell there, by rows here
            dealii::CellData<2> cell;
            cell.vertices = {nodes[0], nodes[1], nodes[3], nodes[2]};
            file.cells.push_back(cell);
          }
        if (file.cells.size() > most_cells)
          refuse_file(fmt::format("has more than {} cells; expected at most "
                                  "that many",
                                  most_cells));
        if (type == line_type)
          for (const unsigned int group : groups)
            {
              file.groups[group];
              file.sides.push_back({{{nodes[0], nodes[1]}}, group});
            }
      }

      /// How many blocks a section of version 4 has.
      Count
      blocks()
      {
        const auto n = next<Count>();
        // how many there are in them, and the least and the largest number
        for (unsigned int i = 0; i < 3; ++i)
          next<Count>();
        return n;
      }

      std::string
      word()
      {
        std::string found;
        if (!(in >> found))
          refuse_file("is damaged: it ends within " + section);
        return found;
      }

      template <typename Number>
      Number
      next()
      {
        const std::string found  = word();
        const char *const begin  = found.data() + (found[0] == '+' ? 1 : 0),
                          *end   = found.data() + found.size();
        Number number            = 0;
        const auto [last, error] = std::from_chars(begin, end, number);
        if (error != std::errc() || last != end)
          refuse(std::string("expected a ") +
                 (std::is_integral_v<Number> ? "whole " : "") +
                 "number, not '" + found + "'");
        return number;
      }

      /// With the line that has been read last.
      [[noreturn]] void
      refuse(const std::string &what)
      {
        in.clear();
        const std::streamoff end = in.tellg();
        in.seekg(0);
        unsigned int line = 1;
        for (std::streamoff at = 0; at < end; ++at)
          line += in.get() == '\n' ? 1 : 0;
        refuse_file(
          fmt::format("is damaged in line {}, in {}: {}", line, section, what));
      }

      std::ifstream                            in;
      std::string                              section; ///< with its `$`
      MshFile                                  file;
      double                                   version = 0.;
      std::unordered_map<Count, unsigned int>  number_of_node;
      std::map<unsigned int, std::string>      names;
      std::map<int, std::vector<unsigned int>> groups_of_curve;
    };
  } // namespace



  MshFile
  read_msh_file(const std::string &path)
  {
    return MshReader(path).read();
  }
} // namespace PlateImpact
