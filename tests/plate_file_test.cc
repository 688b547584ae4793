// Plates from files of Gmsh.
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    class PlateFromFile : public Program
    {
    protected:
      /// Writes a file and returns its path.
      std::string
      write(const std::string &text, const std::string &name = "plate.msh")
      {
        const auto path = directory / name;
        std::ofstream(path) << text;
        return path.string();
      }

      std::string
      set_file(const std::string &text)
      {
        return "--set 'Plate/Outline=" + write(text) + "' ";
      }
    };



    /// A square of 0.2 m with its edges numbered.
    void
    make_square(Triangulation<2> &mesh, const unsigned int n = 4)
    {
      GridGenerator::subdivided_hyper_rectangle(mesh,
                                                {n, n},
                                                Point<2>(-0.1, -0.1),
                                                Point<2>(0.1, 0.1),
                                                true);
    }


    /// With the impact at a point, in the coordinates of the file.
    PlateGeometry
    at(const std::shared_ptr<const PlateFile> &file, const Point<2> &point)
    {
      PlateParameters plate;
      plate.outline.shape            = PlateOutline::file;
      plate.file                     = file;
      const Tensor<1, 2> from_centre = point - file->centre;
      plate.impact_point             = {{from_centre[0], from_centre[1]}};
      return geometry_of(plate);
    }


    const std::string to_the_end =
      "--set Plate/Thickness=0.004 --set 'Time/End time=3e-4' --set "
      "'Adaptivity/Target error=0.03' ";


    TEST_F(PlateFromFile, TurnedAndShiftedIsTheSamePlate)
    {
      // edges in no direction of the axes, hard supports that meet at corners
      // and an edge that is held otherwise
      const std::string point = "0.03, 0.02";
      const auto        straight =
        last_with(to_the_end + "--set 'Plate/Impact point=" + point +
                  "' --set 'Plate/Support=simply supported, clamped'");

      Triangulation<2> mesh;
      make_square(mesh);
      const double angle = 0.5, c = std::cos(angle), s = std::sin(angle);
      GridTools::rotate(angle, mesh);
      GridTools::shift(Tensor<1, 2>({3., -1.}), mesh);
      const auto turned = last_with(
        to_the_end +
        set_file(msh(mesh, {{0, "a"}, {1, "b"}, {2, "c"}, {3, "d"}})) +
        "--set 'Plate/Support=a: simply supported, b: simply supported, c: "
        "clamped, d: clamped' --set 'Plate/Impact point=" +
        std::to_string(0.03 * c - 0.02 * s) + ',' +
        std::to_string(0.03 * s + 0.02 * c) + "'");
      expect_near(turned["peak_force"], straight["peak_force"], 3e-4);
      expect_near(turned["impulse"], straight["impulse"], 1e-3);
      expect_near(turned["final_impactor_velocity"],
                  straight["final_impactor_velocity"],
                  3e-3);
      EXPECT_EQ(turned["number_of_contacts"], straight["number_of_contacts"]);
    }



    // One edge holds along itself, its neighbour across: one direction where
    // they are square to each other, and two, which is all, where they are not.
    TEST_F(PlateFromFile, CornersHoldTheDirectionsOfBothEdges)
    {
      for (const double degrees : {90., 60.})
        {
          const double     angle = degrees * numbers::PI / 180.;
          Triangulation<2> square;
          make_square(square);
          GridTools::transform(
            [angle](const Point<2> &p) {
              return Point<2>(p[0] + p[1] * std::cos(angle),
                              p[1] * std::sin(angle));
            },
            square);
          GridTools::rotate(0.3, square);
          const std::string path = write(
            msh(square, {{0, "left"}, {1, "right"}, {2, "low"}, {3, "high"}}));
          const PlateParameters plate =
            read_scene(main_scene,
                       {"Plate/Outline=" + path,
                        "Plate/Support=left: simply supported, low: simply "
                        "supported, right: free, high: free",
                        "Plate/In-plane support=left: held along, low: held "
                        "across, right: sliding, high: sliding",
                        "Plate/Deflection=large"})
              .parameters.plate;
          const auto         mesh = make_plate_mesh(plate, {{4, 4}});
          const PlateElement element(ElementType::MITC9, Stretching::large);
          const PlateDiscretization model(*mesh, element, plate);
          const Eigen::VectorXd     shifted =
            interpolate(model, FieldOf<5>([](const Point<2> &) {
                          return FieldOf<5>::Values{{0., 0., 0., 1., 0.5}};
                        }));
          // the corner of both edges: the first vertex of the square
          const Point<2> corner   = square.get_vertices()[0];
          bool           is_found = false;
          for (const auto &cell : mesh->active_cell_iterators())
            for (const unsigned int v : cell->vertex_indices())
              if (cell->vertex(v).distance(corner) < 1e-9)
                {
                  is_found = true;
                  const Eigen::VectorXd values =
                    model.cell_values(cell->active_cell_index(), shifted);
                  const auto  &fe = element.finite_element;
                  const double u  = values[fe.component_to_system_index(3, v)],
                               w  = values[fe.component_to_system_index(4, v)];
                  if (degrees == 60.)
                    EXPECT_LT(std::hypot(u, w), 1e-12);
                  else
                    EXPECT_GT(std::hypot(u, w), 0.1);
                }
          EXPECT_TRUE(is_found);
        }
    }



    TEST_F(PlateFromFile, ChordsBecomeTheArcsThatTheyAre)
    {
      const std::string sets = to_the_end +
        "--set 'Plate/Support=simply supported' "
        "--set 'Output/Natural frequencies=1' ";
      const auto       known = last_with(sets + "--set Plate/Outline=circle");
      Triangulation<2> mesh;
      GridGenerator::hyper_ball_balanced(mesh, Point<2>(), 0.1);
      mesh.refine_global(1);
      const std::string file = set_file(msh(mesh, {}));
      const auto plate = read_plate_file((directory / "plate.msh").string());
      ASSERT_EQ(plate->arcs.size(), 1u);
      expect_near(plate->area, 0.01 * numbers::PI, 1e-3);
      expect_near(at(plate, {0.03, 0.04}).distance_to_edge, 0.05, 1e-3);
      EXPECT_LT(at(plate, {0.08, 0.08}).distance_to_edge, 0.);
      const auto last = last_with(sets + file);
      for (const std::string key :
           {"peak_force", "impulse", "final_impactor_velocity"})
        expect_near(last[key], known[key], 2e-3);
      // 3 % higher on a polygon of 16 sides
      expect_near(last["natural_frequencies"][0],
                  known["natural_frequencies"][0],
                  1e-3);
    }



    TEST_F(PlateFromFile, HolesAndFilletsAreArcs)
    {
      Triangulation<2> mesh;
      GridGenerator::plate_with_a_hole(mesh,
                                       0.02,
                                       0.05,
                                       0.02,
                                       0.02,
                                       0.02,
                                       0.02,
                                       Point<2>(),
                                       0,
                                       1,
                                       1,
                                       2,
                                       false);
      mesh.refine_global(1);
      std::map<types::boundary_id, std::string> names;
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const bool is_hole = face->center().norm() < 0.025;
            face->set_boundary_id(is_hole ? 1 : 0);
          }
      const auto plate =
        read_plate_file(write(msh(mesh, {{0, "rim"}, {1, "hole"}})));
      ASSERT_EQ(plate->arcs.size(), 1u);
      EXPECT_NEAR(plate->arcs[0].radius, 0.02, 1e-12);
      for (const auto &face : plate->mesh.active_face_iterators())
        {
          if (!face->at_boundary())
            continue;
          const std::string &edge =
            plate->edges[face->boundary_id() - edge_named];
          EXPECT_EQ(face->manifold_id() == 0, edge == "hole");
        }
      expect_near(plate->area,
                  plate->extent[0] * plate->extent[1] -
                    numbers::PI * 0.02 * 0.02,
                  1e-5);
      EXPECT_LT(at(plate, {0., 0.}).distance_to_edge, 0.);
      EXPECT_NEAR(at(plate, {0.03, 0.}).distance_to_edge, 0.01, 1e-4);
      EXPECT_NEAR(at(plate, {0.03, 0.}).distance_along[0], 0.01, 1e-4);
    }



    TEST_F(PlateFromFile, IsRefinedAlongItsArcs)
    {
      // whatever the time, with the files of the whole plate
      ASSERT_EQ(run(SCENES "/drilled-plate.prm",
                    "--set 'Adaptivity/Maximum cycles=1' --set 'Time/End "
                    "time=1e-5' --set 'Output/Field samples=1'"),
                0)
        << err;
      EXPECT_TRUE(fs::exists(results() / "fields_0.vtu"));
      EXPECT_GT(last_cycle()["peak_force"], 0.);
    }



    TEST_F(PlateFromFile, SweptFilesAreFoundBesideTheScene)
    {
      Triangulation<2> mesh;
      make_square(mesh);
      write(msh(mesh, {}), "square.msh");
      const std::string scene =
        write_scene("subsection Adaptivity\n"
                    "  set Strategy = none\n"
                    "end\n"
                    "subsection Sweep\n"
                    "  set Entry 1  = Plate/Outline\n"
                    "  set Values 1 = square.msh, circle\n"
                    "end\n");
      ASSERT_EQ(sweep(scene, "--set 'Time/End time=5e-5'"), 0) << err;
      const auto points = rows();
      ASSERT_EQ(points.size(), 2u);
      // before edges are felt
      for (const auto &point : points)
        expect_near(std::stod(point.at("peak_force")), 1398.8, 0.05);
    }



    TEST_F(PlateFromFile, Scenes)
    {
      // found beside the scene, from wherever the program is called
      ASSERT_EQ(run(SCENES "/drilled-plate.prm"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      // before edges are felt, that of any plate so thin
      expect_near(last_cycle()["peak_force"], 856.99, 1e-3);
      EXPECT_EQ(last_cycle()["number_of_contacts"], 1);

      ASSERT_EQ(run(SCENES "/l-plate.prm"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      const double force = last_cycle()["peak_force"],
                   bar   = last_cycle()["peak_force_error_bar"];
      // of 8960 equal cells, good to 5e-5
      EXPECT_NEAR(force / 1203.00, 1., bar + 5e-5);

      // what it has written is a scene
      const std::string again =
        (fs::temp_directory_path() / ("again-" + std::to_string(getpid())))
          .string();
      ASSERT_EQ(execute("run '" + (results() / "scene.prm").string() +
                        "' --output '" + again + "' --quiet"),
                0)
        << err;
      fs::remove_all(again);
    }



    TEST_F(PlateFromFile, CornersOfSeveralCellsHoldBothRotations)
    {
      // as those of one cell, at which deal.II sees both normals: five cells at
      // the middle vertex of a bent edge
      PlateParameters plate  = unit_plate(EdgeSupport::simply_supported, 0.1);
      const auto      n_held = [&plate](const unsigned int n) {
        Triangulation<2> mesh;
        GridGenerator::hyper_L(mesh, 0., 1.);
        mesh.refine_global(n);
        for (const auto &face : mesh.active_face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(edge_named);
        auto file           = std::make_shared<PlateFile>();
        file->edges         = {"rim"};
        plate.file          = file;
        plate.outline.shape = PlateOutline::file;
        const PlateElement        element(ElementType::MITC9);
        const PlateDiscretization model(mesh, element, plate, 1.);
        return model.dof_handler().n_dofs() - model.n_unknowns();
      };
      // on the edge of n vertices and midsides: deflection and one rotation, at
      // the six corners both
      for (const unsigned int n : {1, 2, 3})
        EXPECT_EQ(n_held(n), 2 * 8 * (2u << n) + 6) << n;
    }



    TEST_F(PlateFromFile, CompareDoesNotRemeshIt)
    {
      ASSERT_EQ(execute(
                  "compare '" SCENES "/l-plate.prm' --output '" +
                  results().string() +
                  "' --set 'Comparison/Strategies=uniform, remeshing' --set "
                  "Comparison/Elements=MITC9 --set "
                  "'Comparison/Reference peak force=1197' --set "
                  "'Comparison/Maximum cycles=2' --set 'Time/End "
                  "time=1e-5'"),
                0)
        << err;
      EXPECT_NE((out + err).find("rectangles only"), std::string::npos)
        << out << err;
    }



    TEST_F(PlateFromFile, UniformRefinementKeepsToTheSmallestOfAllCells)
    {
      ASSERT_EQ(run(SCENES "/drilled-plate.prm",
                    "--set Adaptivity/Strategy=uniform --set "
                    "'Adaptivity/Goal=energy norm' --set 'Adaptivity/Minimum "
                    "cell size=0.008'"),
                0)
        << err;
      // half of the smallest would be below
      EXPECT_EQ(summary()["cycles"].size(), 1u);
      EXPECT_GE(last_cycle()["min_cell_size"].get<double>(), 0.008);
    }



    TEST_F(PlateFromFile, RefusesScenesThatDoNotFitIt)
    {
      Triangulation<2> mesh;
      make_square(mesh);
      const std::string file =
        set_file(msh(mesh, {{0, "left"}, {1, "right"}, {2, "low"}}));
      const std::vector<std::pair<std::string, std::string>> cases = {
        {file + "--set 'Plate/Support=left: clamped, right: free'",
         "names no support for the edge 'low'"},
        {file + "--set 'Plate/Support=left: clamped, right: free, low: free'",
         "belong to no physical group"},
        {file + "--set 'Plate/Support=lift: clamped'", "an edge 'lift'"},
        {file + "--set 'Plate/Support=left: clamped, left: free'", "twice"},
        {file + "--set 'Plate/Support=clamped, free'", "two supports"},
        {file + "--set 'Plate/Support=left: clumped'", "is not allowed"},
        {file + "--set 'Plate/Impact point=0.11, 0'", "outside of the plate"},
        {file + "--set Adaptivity/Strategy=remeshing", "rectangles only"},
        {file + "--set Contact/Patch\\ radius=0.2", "beyond the plate"},
        {file + "--set 'Plate/Side lengths=200, 200'", "other units"},
        {"--set Plate/Outline=nowhere.msh", "cannot be read"},
        {"--set Plate/Outline=ring", "is not allowed"},
        {"--set 'Plate/Support=left: clamped'", "only an outline from a file"}};
      for (const auto &[sets, words] : cases)
        {
          EXPECT_EQ(run(main_scene, sets), 1) << sets;
          EXPECT_NE(err.find(words), std::string::npos) << sets << '\n' << err;
        }
    }
  } // namespace
} // namespace PlateImpact
