#include "plate_impact/plate/msh_file.h"

#include "plate_impact/base/plate_file.h"
#include "plate_impact/plate/msh_stream.h"

#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    using Count = std::uint64_t;
    using Node  = MshFile::Node;

    constexpr int line_type = 1, quadrilateral_type = 3; // of Gmsh


    /// Nodes of an element of a type that a mesh of quadrilaterals may have
    /// beside them.
    unsigned int
    n_nodes_of(const int type)
    {
      static const std::map<int, unsigned int> n_nodes = {
        {15, 1}, // point
        {line_type, 2},
        {8, 3}, // line of second order
        {quadrilateral_type, 4},
        {4, 4}, // solids
        {5, 8},
        {6, 6},
        {7, 5}};
      static const std::map<int, std::string> names = {{2, "Triangle 3"},
                                                       {9, "Triangle 6"},
                                                       {10, "Quadrilateral 9"},
                                                       {16, "Quadrilateral 8"}};
      const auto                              found = n_nodes.find(type);
      if (found != n_nodes.end())
        return found->second;
      const auto name = names.find(type);
      refuse_file("holds elements of the type " +
                  (name != names.end() ? name->second : std::to_string(type)) +
                  "; expected quadrilaterals of four nodes alone (in Gmsh: "
                  "Mesh.RecombineAll = 1, Mesh.SubdivisionAlgorithm = 1, "
                  "Mesh.ElementOrder = 1)");
    }



    /// The number of a physical group, which is negative for curves against
    /// their direction.
    unsigned int
    group_number(const int tag)
    {
      return tag < 0 ? 0u - static_cast<unsigned int>(tag) : tag;
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
        while (in.next_section())
          if (read_section())
            in.end_section();
          else
            in.skip_section();
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
        const std::string &name = in.section();
        if (name == "$MeshFormat")
          read_format();
        else if (name == "$PhysicalNames")
          read_names();
        else if (version == 0.)
          in.refuse("expected $MeshFormat before it");
        else if (name == "$Entities")
          version < 4. ? read_entities_of_version_3() :
                         read_entities(/*partitioned=*/false);
        else if (name == "$PartitionedEntities")
          read_entities(/*partitioned=*/true);
        else if (name == "$Nodes" || name == "$ParametricNodes")
          version < 4. ? read_nodes() : read_blocks_of_nodes();
        else if (name == "$Elements")
          version < 3.   ? read_elements_of_version_2() :
            version < 4. ? read_elements_of_version_3() :
                           read_blocks_of_elements();
        else
          return false;
        return true;
      }

      void
      read_format()
      {
        version         = in.text<double>();
        const int type  = in.text<int>();
        const int bytes = in.text<int>();
        if (!(version >= 2. && version <= 4.1))
          refuse_file(fmt::format("is of version {} of Gmsh's format; expected "
                                  "2 to 4.1",
                                  version));
        is_version_4_1 = version > 4.05;
        in.is_binary   = type == 1;
        if (!in.is_binary)
          return;
        in.rest_of_line();
        constexpr int one = 1, swapped_one = 1 << 24;
        const int     found = in.next<int>();
        if (bytes != 8 || (found != one && found != swapped_one))
          in.refuse("expected numbers of 8 bytes and a one");
        in.is_swapped = found == swapped_one;
      }

      void
      read_names()
      {
        for (Count n = in.text<Count>(); n > 0; --n)
          {
            const int         dimension = in.text<int>();
            const int         group     = in.text<int>();
            const std::string line      = in.rest_of_line();
            const std::size_t begin = line.find('"'), end = line.rfind('"');
            if (begin == end)
              in.refuse("expected a name in quotes");
            if (dimension == 1)
              names[group_number(group)] =
                line.substr(begin + 1, end - begin - 1);
          }
      }

      void
      read_entities(const bool partitioned)
      {
        if (partitioned)
          {
            in.next<Count>();
            for (Count n = 2 * in.next<Count>(); n > 0; --n)
              in.next<int>(); // ghosts
          }
        std::array<Count, 4> sizes;
        for (Count &size : sizes)
          size = in.next<Count>();
        for (unsigned int dimension = 0; dimension < sizes.size(); ++dimension)
          for (Count n = sizes[dimension]; n > 0; --n)
            {
              const int entity = in.next<int>();
              if (partitioned)
                {
                  in.next<int>(); // what it is a part of
                  in.next<int>();
                  next_list();
                }
              // the corners of a box, and of points themselves
              skip_numbers(dimension == 0 && is_version_4_1 ? 3 : 6);
              add_groups(dimension, entity, next_list());
              if (dimension > 0)
                next_list(); // what bounds it
            }
      }

      void
      read_entities_of_version_3()
      {
        const bool was_binary = in.is_binary;
        in.is_binary          = false;
        std::array<Count, 4> sizes;
        for (Count &size : sizes)
          size = in.next<Count>();
        for (unsigned int dimension = 0; dimension < sizes.size(); ++dimension)
          for (Count n = sizes[dimension]; n > 0; --n)
            {
              const int entity = in.next<int>();
              if (dimension > 0)
                next_list();
              add_groups(dimension, entity, next_list());
            }
        in.is_binary = was_binary;
      }

      void
      add_groups(const unsigned int      dimension,
                 const int               entity,
                 const std::vector<int> &groups)
      {
        if (dimension != 1)
          return;
        for (const int group : groups)
          {
            groups_of_curve[entity].push_back(group_number(group));
            file.groups[group_number(group)];
          }
      }

      void
      read_nodes()
      {
        const bool is_parametric = in.section() == "$ParametricNodes";
        for (Count n = text_count(); n > 0; --n)
          {
            const Node node = in.next<int>();
            add_node(node);
            // of what dimension its entity is, and which one
            if (is_parametric && version < 3.)
              {
                const int dimension = in.next<int>();
                in.next<int>();
                skip_parameters(dimension);
              }
            else if (version >= 3. && in.next<int>() != 0)
              skip_parameters(in.next<int>());
          }
      }

      void
      read_blocks_of_nodes()
      {
        Count n_blocks = blocks();
        for (; n_blocks > 0; --n_blocks)
          {
            const int dimension     = dimension_and_entity()[0];
            const int is_parametric = in.next<int>();
            Count     n             = in.next<Count>();
            // of version 4.1 all numbers, then all coordinates
            std::vector<Node> nodes;
            for (; is_version_4_1 && nodes.size() < n;)
              nodes.push_back(tag());
            for (Count i = 0; i < n; ++i)
              {
                add_node(is_version_4_1 ? nodes[i] : tag());
                if (is_parametric != 0)
                  skip_parameters(dimension);
              }
          }
      }

      void
      add_node(const Node node)
      {
        std::array<double, 3> point;
        for (double &x : point)
          x = in.next<double>();
        if (!file.nodes.insert({node, point}).second)
          in.refuse(fmt::format("the node {} comes twice", node));
      }

      void
      skip_parameters(const int dimension)
      {
        if (dimension < 0 || dimension > 3)
          in.refuse(
            fmt::format("expected a dimension from 0 to 3, not {}", dimension));
        skip_numbers(dimension);
      }

      void
      skip_numbers(const unsigned int n)
      {
        for (unsigned int i = 0; i < n; ++i)
          in.next<double>();
      }

      void
      read_elements_of_version_2()
      {
        for (Count n = text_count(); n > 0;)
          {
            // of a text every element has its own type and number of tags
            if (!in.is_binary)
              in.next<int>();
            const int  type    = in.next<int>();
            const int  n_alike = in.is_binary ? in.next<int>() : 1;
            const int  n_tags  = in.next<int>();
            const auto n_here  = static_cast<Count>(n_alike);
            if (n_alike < 1 || n_here > n)
              in.refuse(fmt::format("expected at most {} elements, not {}",
                                    n,
                                    n_alike));
            for (Count i = 0; i < n_here; ++i)
              {
                if (in.is_binary)
                  in.next<int>();
                unsigned int group = 0; // the first tag
                for (int t = 0; t < n_tags; ++t)
                  if (const int tag = in.next<int>(); t == 0)
                    group = group_number(tag);
                std::vector<unsigned int> groups;
                if (group != 0)
                  groups = {group};
                add_element(type, groups);
              }
            n -= n_here;
          }
      }

      void
      read_elements_of_version_3()
      {
        for (Count n = text_count(); n > 0; --n)
          {
            in.next<int>();
            const int type    = in.next<int>();
            const int entity  = in.next<int>();
            const int n_nodes = in.next<int>();
            if (n_nodes != static_cast<int>(n_nodes_of(type)))
              in.refuse(fmt::format("an element of the type {} has {} nodes",
                                    type,
                                    n_nodes));
            add_element(type, groups_of(type, entity));
          }
      }

      void
      read_blocks_of_elements()
      {
        for (Count n_blocks = blocks(); n_blocks > 0; --n_blocks)
          {
            const int  entity = dimension_and_entity()[1];
            const int  type   = in.next<int>();
            const auto groups = groups_of(type, entity);
            for (Count n = in.next<Count>(); n > 0; --n)
              {
                tag();
                add_element(type, groups);
              }
          }
      }

      std::vector<unsigned int>
      groups_of(const int type, const int entity) const
      {
        const auto found = groups_of_curve.find(entity);
        return type == line_type && found != groups_of_curve.end() ?
          found->second :
          std::vector<unsigned int>();
      }

      void
      add_element(const int type, const std::vector<unsigned int> &groups)
      {
        std::array<Node, 8> nodes;
        const unsigned int  n_nodes = n_nodes_of(type);
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            nodes[i] = tag();
            if (file.nodes.count(nodes[i]) == 0)
              in.refuse(fmt::format("an element has the node {}, which is not "
                                    "among the nodes of the file",
                                    nodes[i]));
          }
        if (type == quadrilateral_type)
          file.cells.push_back({{nodes[0], nodes[1], nodes[2], nodes[3]}});
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

      /// The number of nodes or elements before version 4.
      Count
      text_count()
      {
        const auto n = in.text<Count>();
        if (in.is_binary)
          in.rest_of_line();
        return n;
      }

      /// How many blocks a section of version 4 has.
      Count
      blocks()
      {
        const auto n = in.next<Count>();
        // how many there are in them, and the least and the largest number
        for (unsigned int i = 0; i < (is_version_4_1 ? 3 : 1); ++i)
          in.next<Count>();
        return n;
      }

      std::array<int, 2>
      dimension_and_entity()
      {
        const int first = in.next<int>(), second = in.next<int>();
        return is_version_4_1 ? std::array<int, 2>{{first, second}} :
                                std::array<int, 2>{{second, first}};
      }

      std::vector<int>
      next_list()
      {
        std::vector<int> list;
        for (Count n = in.next<Count>(); n > 0; --n)
          list.push_back(in.next<int>());
        return list;
      }

      /// The number of a node or an element.
      Node
      tag()
      {
        return is_version_4_1 ? in.next<Node>() :
                                static_cast<Node>(in.next<int>());
      }

      MshStream                                in;
      MshFile                                  file;
      double                                   version        = 0.;
      bool                                     is_version_4_1 = false;
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
