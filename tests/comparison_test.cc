// plate-impact compare: what it writes, its limits, and the scenes of
// comparisons.
#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>

namespace PlateImpact
{
  namespace
  {
    class Compare : public Program
    {
    protected:
      int
      compare(const std::string &scene, const std::string &more = "")
      {
        return execute("compare '" + scene + "' --output '" +
                       results().string() + "' " + more);
      }

      nlohmann::json
      comparison() const
      {
        return nlohmann::json::parse(text(results() / "comparison.json"));
      }

      /// Rows of comparison.csv without the header, each split at commas.
      std::vector<std::vector<std::string>>
      rows() const
      {
        std::istringstream lines(text(results() / "comparison.csv"));
        std::vector<std::vector<std::string>> result;
        std::string                           line, cell;
        std::getline(lines, line);
        EXPECT_EQ(line,
                  "strategy,element,cycle,cells,degrees_of_freedom,"
                  "discretization_error,peak_force,peak_force_error,"
                  "peak_force_error_bar,contact_end_error,seconds,cumulative_"
                  "seconds,cells_at_minimum_size");
        while (std::getline(lines, line))
          {
            result.emplace_back();
            std::istringstream cells(line);
            while (std::getline(cells, cell, ','))
              result.back().push_back(cell);
            EXPECT_EQ(result.back().size(), 13u) << line;
          }
        return result;
      }
    };

    const std::string coarse =
      "--set 'Time/Time step=1e-6' --set 'Adaptivity/Target error=0.2' ";



    TEST_F(Compare, WritesARowPerMeshAndWhatItIsComparedWith)
    {
      ASSERT_EQ(compare(main_scene,
                        coarse +
                          "--set 'Comparison/Strategies=graded, hanging nodes, "
                          "remeshing' --set 'Comparison/Elements=serendipity, "
                          "MITC9' --set 'Comparison/Maximum cycles=3'"),
                0)
        << err;
      const auto json = comparison();
      EXPECT_EQ(json["reference"]["origin"], "computed");
      const double reference   = json["reference"]["peak_force"],
                   uncertainty = json["reference"]["uncertainty"];
      expect_near(reference, elastic_peak, 2e-3);
      EXPECT_LT(uncertainty, 1e-3);
      // the step is coarse, and its error no part of that of the mesh
      const double of_the_step = json["reference"]["time_step_error"];
      EXPECT_GT(of_the_step, 10. * uncertainty);
      EXPECT_NE(out.find("Time step   the same on all meshes, with an error "
                         "of "),
                std::string::npos)
        << out;

      const auto table = rows();
      ASSERT_EQ(table.size(), 3u * 2u * 3u);
      double so_far = 0., last_error = 1.;
      for (const auto &row : table)
        {
          const bool is_first = row[2] == "1";
          so_far              = (is_first ? 0. : so_far) + std::stod(row[10]);
          EXPECT_NEAR(std::stod(row[11]), so_far, 1e-6);
          EXPECT_NEAR(std::stod(row[7]),
                      std::abs(std::stod(row[6]) / reference - 1.),
                      1e-9);
          EXPECT_LT(std::stod(row[9]), 0.05);
          // the initial mesh is the same for all
          EXPECT_EQ(row[3] == "9", is_first);
          last_error = std::stod(row[7]);
          if (row[2] == "3")
            {
              EXPECT_LT(last_error, 5e-3) << row[0] << ' ' << row[1];
            }
        }
      for (const auto &row : json["thresholds"])
        {
          double seconds = 0.;
          for (const auto &reached : row["reached"])
            {
              EXPECT_GE(reached["cumulative_seconds"], seconds);
              seconds = reached["cumulative_seconds"];
            }
          if (row["quantity"] == "peak force error")
            {
              EXPECT_EQ(row["comparable"].get<bool>(),
                        row["threshold"].get<double>() > uncertainty);
            }
        }
      const std::string page = text(results() / "comparison.html");
      EXPECT_EQ(study_of("comparison.html")["comparison"], json);
      EXPECT_EQ(page.find("src=\"http"), std::string::npos);
      for (const auto &row : json["thresholds"])
        if (row["comparable"] && !row["reached"].empty())
          {
            const std::string words = row["in_words"];
            const auto       &first = row["reached"][0];
            for (const std::string &part :
                 {first["strategy"].get<std::string>(),
                  first["cells"].dump() + " cells after "})
              EXPECT_NE(words.find(part), std::string::npos) << words;
            EXPECT_NE(out.find(words.substr(0, 30)), std::string::npos) << out;
          }
      EXPECT_NE(out.find("6 of 6  remeshing, MITC9, about "), std::string::npos)
        << out;
      std::istringstream lines(out.substr(0, out.find("\nResults")));
      for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    }



    TEST_F(Compare, EndsCurvesWithTheBudget)
    {
      ASSERT_EQ(compare(main_scene,
                        coarse +
                          "--quiet --set 'Comparison/Strategies=uniform' "
                          "--set Comparison/Elements=MITC9 --set "
                          "'Comparison/Time budget=1e-3'"),
                0)
        << err;
      EXPECT_EQ(out, "");
      EXPECT_EQ(rows().size(), 1u);
      EXPECT_EQ(comparison()["curves"][0]["end"], "time budget");
    }



    TEST_F(Compare, MeshesMadeForTheForceTakeFewerCells)
    {
      ASSERT_EQ(compare(main_scene,
                        "--set 'Comparison/Strategies=hanging nodes, hanging "
                        "nodes by force, remeshing by force' --set "
                        "Comparison/Elements=MITC9 --set 'Comparison/Maximum "
                        "cycles=3'"),
                0)
        << err;
      std::map<std::string, double> most_cells;
      for (const auto &row : rows())
        {
          const double error = std::stod(row[7]);
          most_cells[row[0]] = std::stod(row[3]);
          if (!row[8].empty())
            {
              EXPECT_LT(error, std::stod(row[8]) + 1e-4) << row[0];
            }
          if (row[0] != "hanging nodes")
            {
              EXPECT_LT(error, 2e-3) << row[0] << row[2];
            }
        }
      EXPECT_LT(most_cells.at("hanging nodes by force"),
                most_cells.at("hanging nodes"));
      EXPECT_EQ(most_cells.size(), 3u);
      // eta over the time to the peak is not that over the whole
      const auto results = comparison();
      for (const auto &row : results["thresholds"])
        if (row["quantity"] == "eta")
          {
            for (const auto &reached : row["reached"])
              EXPECT_EQ(reached["strategy"], "hanging nodes");
          }
    }



    TEST_F(Compare, TakesAGivenReference)
    {
      ASSERT_EQ(compare(main_scene,
                        coarse +
                          "--set Comparison/Strategies=uniform --set "
                          "Comparison/Elements=MITC9 --set "
                          "'Comparison/Reference peak force=1000' --set "
                          "'Comparison/Maximum cycles=2'"),
                0)
        << err;
      EXPECT_EQ(comparison()["reference"]["origin"], "given");
      for (const auto &row : rows())
        {
          EXPECT_NEAR(std::stod(row[7]), std::stod(row[6]) / 1000. - 1., 1e-9);
          EXPECT_EQ(row[9], ""); // nothing is known of the contact's end
        }
    }



    TEST_F(Compare, DoesNotCountAnErrorThatIsSmallByChance)
    {
      const std::string uniform =
        "--set Comparison/Strategies=uniform --set Comparison/Elements=MITC9 "
        "--set 'Comparison/Maximum cycles=2' --set "
        "'Comparison/Reference peak force=";
      ASSERT_EQ(compare(main_scene, coarse + uniform + "1000'"), 0) << err;
      // the second mesh has no error at all against its own force
      const auto table = rows();
      ASSERT_EQ(compare(main_scene, coarse + uniform + table[1][6] + "'"), 0)
        << err;
      EXPECT_LT(std::stod(rows()[1][7]), 1e-9);
      const double bar = std::stod(rows()[1][8]);
      EXPECT_GT(bar, 1e-3);
      const auto results = comparison();
      for (const auto &row : results["thresholds"])
        if (row["quantity"] == "peak force error")
          {
            EXPECT_EQ(row["reached"].empty(),
                      row["threshold"].get<double>() < bar)
              << row;
          }
    }



    TEST_F(Compare, InterruptedLeavesValidFiles)
    {
      const std::string directory = results().string();
      const pid_t       program   = fork();
      if (program == 0)
        {
          execl(PROGRAM,
                PROGRAM,
                "compare",
                main_scene.c_str(),
                "--quiet",
                "--output",
                directory.c_str(),
                "--set",
                "Comparison/Strategies=hanging nodes, uniform",
                "--set",
                "Comparison/Maximum cycles=1000",
                "--set",
                "Comparison/Time budget=1e6",
                nullptr);
          _exit(127);
        }
      // in the middle of it: with two meshes done, of more than can ever be
      int                status      = 0;
      const unsigned int long_enough = 12000;
      const auto         n_lines     = [&] {
        const std::string table = text(results() / "comparison.csv");
        return std::count(table.begin(), table.end(), '\n');
      };
      unsigned int n_waits = 0;
      for (; n_lines() < 3 && n_waits < long_enough; ++n_waits)
        {
          ASSERT_EQ(waitpid(program, &status, WNOHANG), 0) << "ended early";
          usleep(10000);
        }
      kill(program, n_waits < long_enough ? SIGINT : SIGKILL);
      ASSERT_EQ(waitpid(program, &status, 0), program);
      ASSERT_LT(n_waits, long_enough) << "no mesh in two minutes";
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
      EXPECT_GE(rows().size(), 2u);
      for (const auto &row : rows())
        EXPECT_GT(std::stod(row[6]), 1000.);
      if (fs::exists(results() / "comparison.json"))
        {
          EXPECT_TRUE(comparison().contains("reference"));
        }
    }



    TEST_F(Compare, RefusesWhatCannotBeCompared)
    {
      EXPECT_EQ(compare(main_scene, "--set Impactor/Shape=none"), 1);
      EXPECT_NE(err.find("has no force to compare"), std::string::npos) << err;
      EXPECT_EQ(compare(main_scene, "--set Comparison/Strategies=none"), 1);
      EXPECT_NE(err.find("fixed fraction"), std::string::npos) << err;
      EXPECT_EQ(compare(main_scene, "--set 'Comparison/Elements=MITC9, MITC9'"),
                1);
      EXPECT_NE(err.find("names MITC9 twice"), std::string::npos) << err;
      EXPECT_FALSE(fs::exists(results()));
    }



    /// Peak force of the reference, and the cells and error of the best
    /// strategy and element on the scene.
    void
    expect_comparison(const std::string &scene_name,
                      const double       peak_force,
                      const double       error,
                      const unsigned int most_cells)
    {
      const Scene        scene = read_scene(SCENES "/" + scene_name + ".prm",
                                     {"Comparison/Time budget=1000"});
      StrategyComparison comparison{scene};
      const Reference   &reference = comparison.compute_reference();
      EXPECT_NEAR(reference.peak_force / peak_force, 1., 3e-4);
      EXPECT_LT(reference.uncertainty, error);
      const ComparisonCurve &curve =
        comparison.compute_curve({AdaptationStrategy::hanging_nodes,
                                  AdaptationGoal::energy_norm},
                                 ElementType::MITC9);
      bool is_reached = false;
      for (const ComparedMesh &mesh : curve.meshes)
        is_reached = is_reached ||
          (mesh.peak_force_error < error && mesh.cells <= most_cells);
      EXPECT_TRUE(is_reached);
    }



    /// A state that all nine-node elements hold on squares.
    std::vector<Snapshot>
    quadratic_states(const PlateDiscretization &model, const double amplitude)
    {
      const Eigen::VectorXd state =
        amplitude *
        interpolate(model, Field([](const dealii::Point<2> &p) {
                      return Field::Values{
                        {p[0] * p[0] - p[0] * p[1], 2. * p[0] + p[1], p[1]}};
                    }));
      return {{1., state}, {3., 2. * state}};
    }



    TEST(ReferenceError, ComparesFieldsOnUnrelatedMeshes)
    {
      const PlateElement    element(ElementType::MITC9);
      const PlateParameters plate     = unit_plate(EdgeSupport::free, 0.1);
      const auto            fine_mesh = unit_square(7), mesh = unit_square(3);
      refine_randomly(*mesh, 2);
      const PlateDiscretization fine(*fine_mesh, element, plate, 1.),
        model(*mesh, element, plate, 1.);
      const ReferenceError error(fine, quadratic_states(fine, 1.));
      EXPECT_LT(error.of(model, quadratic_states(model, 1.)), 1e-10);
      EXPECT_NEAR(error.of(model, quadratic_states(model, 0.75)), 0.25, 1e-10);
    }



    TEST(ComparisonScenes, Cylinder)
    {
      expect_comparison("compare-cylinder", 9095.4, 1e-3, 200);
    }



    /// Cells and eta of the meshes of a strategy with the best element.
    std::vector<ComparedMesh>
    meshes_of(StrategyComparison &comparison, const AdaptationStrategy strategy)
    {
      return comparison
        .compute_curve({strategy, AdaptationGoal::energy_norm},
                       ElementType::MITC9)
        .meshes;
    }



    TEST(ComparisonScenes, AdaptedCellsAreFewerDownToTheLastEta)
    {
      const Scene        scene = read_scene(SCENES "/compare-sphere.prm",
                                     {"Comparison/Time budget=1000"});
      StrategyComparison comparison{scene};
      comparison.compute_reference();
      const auto adapted =
        meshes_of(comparison, AdaptationStrategy::hanging_nodes);
      const auto equal = meshes_of(comparison, AdaptationStrategy::uniform);
      EXPECT_LT(adapted.back().error->eta, 0.0025);
      for (const ComparedMesh &mesh : adapted)
        for (const ComparedMesh &of_equal : equal)
          if (of_equal.error->eta <= mesh.error->eta)
            {
              EXPECT_LE(mesh.cells, of_equal.cells) << mesh.error->eta;
            }
      // at a minimum that the scene gives, a curve ends where it gains nothing
      const Scene        limited = read_scene(SCENES "/compare-sphere.prm",
                                       {"Comparison/Time budget=1000",
                                               "Adaptivity/Minimum cell size=1.3e-3"});
      StrategyComparison coarse{limited};
      coarse.compute_reference();
      coarse.compute_curve({AdaptationStrategy::hanging_nodes,
                            AdaptationGoal::energy_norm},
                           ElementType::MITC9);
      const ComparisonCurve &curve = coarse.curves.back();
      EXPECT_EQ(curve.end, "minimum cell size");
      EXPECT_GT(curve.meshes.back().cells_at_minimum_size, 0u);
      EXPECT_LT(curve.meshes.size(), 10u);
      // made for the force, meshes gain more of it whatever eta does
      coarse.compute_curve({AdaptationStrategy::fixed_fraction,
                            AdaptationGoal::peak_force},
                           ElementType::MITC9);
      const auto &by_force = coarse.curves.back().meshes;
      for (std::size_t i = 2; i < by_force.size(); ++i)
        EXPECT_LT(by_force[i].peak_force_bar->total(),
                  by_force[i - 1].peak_force_bar->total());
    }



    TEST(ComparisonScenes, Sphere)
    {
      expect_comparison("compare-sphere", 1398.80, 1e-3, 300);
    }
  } // namespace
} // namespace PlateImpact
