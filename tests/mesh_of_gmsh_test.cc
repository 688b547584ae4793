// Files of Gmsh in several versions of the format, damaged, and what lies
// beside them.
#include "plate_impact/adaptation/quad_mesher.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace PlateImpact
{
  namespace
  {
    const std::vector<std::string> meshes = {SCENES "/l-plate.msh",
                                             SCENES "/drilled-plate.msh"};


    class MeshOfGmsh : public Program
    {
    protected:
      std::string
      write(const std::string &content)
      {
        const auto path = directory / "plate.msh";
        std::ofstream(path, std::ios::binary) << content;
        return path.string();
      }

      /// A mesh in another version of the format.
      std::string
      written_by_gmsh(const std::string &mesh,
                      const double       version,
                      const bool         is_binary     = false,
                      const bool         is_parametric = false)
      {
        const auto        path = directory / "again.msh";
        const GmshSession session;
        gmsh::open(mesh);
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", is_binary);
        gmsh::option::setNumber("Mesh.SaveParametric", is_parametric);
        gmsh::write(path.string());
        return text(path);
      }

      /// The sentence that a file is refused with.
      std::string
      refusal(const std::string &text)
      {
        try
          {
            read_plate_file(write(text));
          }
        catch (const InputError &error)
          {
            return error.what();
          }
        return "";
      }
    };



    /// Text with one number replaced, one line cut, or bits of a few bytes
    /// flipped; reproducible.
    std::string
    damaged(std::string text, std::mt19937 &generator)
    {
      const auto below = [&generator](const std::size_t n) {
        return generator() % n;
      };
      const auto kind = below(3);
      const auto at   = below(text.size());
      if (kind == 0)
        {
          const std::vector<std::string> numbers = {"0",
                                                    "1",
                                                    "-1",
                                                    "3",
                                                    "28",
                                                    "99",
                                                    "0.01",
                                                    "1e308",
                                                    "1e-300",
                                                    "nan",
                                                    "2147483647",
                                                    "2147483648",
                                                    "18446744073709551615",
                                                    "99999999999999999999"};
          const auto begin = text.find_first_of("0123456789-.", at);
          const auto end   = text.find_first_of(" \n", begin);
          if (begin != std::string::npos)
            text.replace(begin, end - begin, numbers[below(numbers.size())]);
        }
      else if (kind == 1)
        {
          const auto begin = text.find('\n', at);
          const auto end   = text.find('\n', begin + 1);
          if (begin != std::string::npos && end != std::string::npos)
            text.erase(begin, end - begin);
        }
      else
        for (auto n = 1 + below(3); n > 0; --n)
          text[below(text.size())] ^= 1 << below(8);
      return text;
    }



    /// Every cell has an inside, and its middle is in no other.
    bool
    is_plate(const PlateFile &plate)
    {
      for (const auto &one : plate.mesh.active_cell_iterators())
        {
          unsigned int n_cells = 0;
          for (const auto &cell : plate.mesh.active_cell_iterators())
            {
              bool is_inside = true;
              for (const auto &[a, b] :
                   {std::pair(0, 1), {1, 3}, {3, 2}, {2, 0}})
                is_inside = is_inside &&
                  dealii::cross_product_2d(cell->vertex(b) - cell->vertex(a)) *
                      (one->center() - cell->vertex(a)) <
                    0.;
              n_cells += is_inside ? 1 : 0;
            }
          if (n_cells != 1)
            return false;
        }
      return std::isfinite(plate.area) && plate.area > 0.;
    }



    /// How many sides every edge has.
    std::map<std::string, unsigned int>
    sides_of_edges(const PlateFile &plate)
    {
      std::map<std::string, unsigned int> n;
      for (const auto &face : plate.mesh.active_face_iterators())
        if (face->at_boundary())
          ++n[plate.edges[face->boundary_id() - edge_named]];
      return n;
    }



    TEST_F(MeshOfGmsh, IsRefusedOrAPlateWhenDamaged)
    {
      std::mt19937 generator(31);
      unsigned int n_refused = 0, n_plates = 0;
      for (const std::string &mesh : meshes)
        for (const double version : {4.1, 2.2})
          {
            const std::string whole = written_by_gmsh(mesh, version);
            for (unsigned int n = 0; n < 200; ++n)
              {
                const auto file = write(damaged(whole, generator));
                try
                  {
                    EXPECT_TRUE(is_plate(*read_plate_file(file)))
                      << "mutation " << n << " of " << mesh << ", version "
                      << version;
                    ++n_plates;
                  }
                catch (const InputError &error)
                  {
                    EXPECT_EQ(std::string(error.what()).find('\n'),
                              std::string::npos)
                      << error.what();
                    ++n_refused;
                  }
              }
          }
      EXPECT_GT(n_plates, 50u);
      EXPECT_GT(n_refused, 300u);
    }



    TEST_F(MeshOfGmsh, IsTheSamePlateInBothVersionsOfTheFormat)
    {
      for (const std::string &mesh : meshes)
        {
          const auto known = read_plate_file(mesh),
                     plate = read_plate_file(write(written_by_gmsh(mesh, 2.2)));
          EXPECT_EQ(plate->mesh.n_active_cells(), known->mesh.n_active_cells());
          EXPECT_EQ(plate->mesh.n_vertices(), known->mesh.n_vertices());
          EXPECT_EQ(plate->arcs.size(), known->arcs.size());
          EXPECT_EQ(plate->edges, known->edges);
          EXPECT_NEAR(plate->area / known->area, 1., 1e-12);
          EXPECT_EQ(sides_of_edges(*plate), sides_of_edges(*known));
        }
    }



    TEST_F(MeshOfGmsh, IsRefusedWhereItIsNoPlate)
    {
      const std::string nodes =
        "$Nodes\n11\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 1 0 0\n"
        "7 2 1 0\n8 3 0 0\n9 4 0 0\n10 4 1 0\n11 3 1 0\n$EndNodes\n";
      const auto elements = [](const std::string &lines) {
        return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n@$Elements\n" + lines +
          "$EndElements\n";
      };
      const std::string square = "1 3 2 1 1 1 2 3 4\n";
      const std::vector<std::pair<std::string, std::string>> cases = {
        {"nothing", "is no mesh of Gmsh"},
        {elements("1\n1 2 2 1 1 1 2 3\n"), "Triangle"},
        {elements("1\n1 1 2 1 1 1 2\n"), "no quadrilaterals"},
        {elements("1\n1 3 2 1 1 1 2 4 3\n"), "convex"},
        {elements("2\n" + square + "2 3 2 1 1 6 5 7 3\n"), "crack"},
        {elements("2\n" + square + "2 3 2 1 1 8 9 10 11\n"), "do not touch"},
        {elements("3\n" + square + "2 3 2 1 1 2 5 7 3\n3 1 2 7 7 2 3\n"),
         "'7' that is no edge"}};
      for (const auto &[content, words] : cases)
        {
          std::string file = content;
          if (const auto at = file.find('@'); at != std::string::npos)
            file.replace(at, 1, nodes);
          EXPECT_NE(refusal(file).find(words), std::string::npos)
            << words << ": " << refusal(file);
        }
      EXPECT_EQ(refusal(text(meshes.front())), "");
    }



    TEST_F(MeshOfGmsh, OtherKindsAreRefusedWithWhatToSave)
    {
      const std::string &mesh = meshes.front();
      for (const auto &[content, words] :
           {std::pair(written_by_gmsh(mesh, 1.), "no mesh of Gmsh"),
            {written_by_gmsh(mesh, 3.), "of version 3"},
            {written_by_gmsh(mesh, 4.), "of version 4"},
            {written_by_gmsh(mesh, 2.2, true), "a binary file"},
            {written_by_gmsh(mesh, 4.1, true), "a binary file"},
            {written_by_gmsh(mesh, 2.2, false, true), "parameters of nodes"},
            {written_by_gmsh(mesh, 4.1, false, true), "parameters of nodes"}})
        EXPECT_NE(refusal(content).find(words), std::string::npos)
          << words << ": " << refusal(content);
      EXPECT_NE(refusal(written_by_gmsh(mesh, 4.1, true))
                  .find("Mesh.MshFileVersion = 4.1, Mesh.Binary = 0"),
                std::string::npos);
    }



    TEST_F(MeshOfGmsh, IsRefusedWithTheLineThatIsDamaged)
    {
      std::string       mesh = text(SCENES "/l-plate.msh");
      const std::string line = "55 33 39 45 27";
      mesh.replace(mesh.find(line), line.size(), "55 33 39 45 2147483648");
      const std::string set = "--set 'Plate/Outline=" + write(mesh) + "'";
      EXPECT_EQ(execute("check '" SCENES "/l-plate.prm' " + set), 1);
      EXPECT_EQ(err,
                "plate-impact: --set: Plate/Outline = " + write(mesh) +
                  " is damaged in line 201, in $Elements: an element has the "
                  "node 2147483648, which is not among the nodes of the "
                  "file\n");
      EXPECT_EQ(run(SCENES "/l-plate.prm", set), 1);
      EXPECT_FALSE(fs::exists(results()));
      // cut off anywhere
      for (std::size_t n = 0; n + 13 < mesh.size(); n += 97)
        EXPECT_THROW(read_plate_file(write(mesh.substr(0, n))), InputError);
    }



    TEST_F(MeshOfGmsh, HasNoCellsOnEachOther)
    {
      const std::string nodes =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n"
        "3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 0 2 0\n8 1 2 0\n9 2 2 0\n"
        "$EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 5 4\n2 3 2 1 1 ";
      for (const std::string second :
           {"1 3 9 4", "1 2 5 4", "2 6 8 4", "1 2 9 4", "1 3 6 4"})
        {
          const std::string file = write(nodes + second + "\n$EndElements\n");
          try
            {
              read_plate_file(file);
              ADD_FAILURE() << second;
            }
          catch (const InputError &error)
            {
              EXPECT_NE(std::string(error.what()).find("overlapping cells"),
                        std::string::npos)
                << error.what();
            }
        }
      EXPECT_NO_THROW(
        read_plate_file(write(nodes + "2 3 6 5\n$EndElements\n")));
    }



    TEST_F(MeshOfGmsh, OptionsBesideItAreNotRead)
    {
      const auto        touched = directory / "touched";
      const std::string command =
        "SystemCall \"touch '" + touched.string() + "'\";\n";
      write(text(SCENES "/drilled-plate.msh"));
      // beside the mesh, at home and where the program runs
      for (const std::string name : {"plate.msh.opt",
                                     "plate.opt",
                                     ".gmshrc",
                                     ".gmsh-options",
                                     ".gmsh-errors"})
        std::ofstream(directory / name) << command;
      const std::string from_home =
        "cd '" + directory.string() + "' && HOME='" + directory.string() + "' ";
      EXPECT_EQ(execute("check '" SCENES
                        "/drilled-plate.prm' --set Plate/Outline=plate.msh",
                        from_home),
                0)
        << err;
      EXPECT_EQ(execute("run '" + main_scene +
                          "' --output results --set Adaptivity/"
                          "Strategy=remeshing",
                        from_home),
                0)
        << err;
      EXPECT_FALSE(fs::exists(touched));
    }
  } // namespace
} // namespace PlateImpact
