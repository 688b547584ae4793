// Meshes that a command outside of the program marks.
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <fstream>

namespace PlateImpact
{
  namespace
  {
    class OutsideMarking : public Program
    {
    protected:
      /// Runs the main scene with a script in Python that has read the file
      /// into `mesh` and prints an answer.
      int
      run_marked(const std::string &script, const std::string &more = "")
      {
        const auto path = directory / "mark.py";
        std::ofstream(path) << "import json, sys\n"
                               "mesh = json.load(open(sys.argv[1]))\n"
                            << script << '\n';
        return run(main_scene,
                   "--set 'Time/Time step=1e-6' --set 'Adaptivity/Maximum "
                   "cycles=3' --marking \"python3 '" +
                     path.string() + "'\" " + more);
      }

      std::vector<int>
      cells() const
      {
        std::vector<int> result;
        const auto       all = summary();
        for (const auto &cycle : all["cycles"])
          result.push_back(cycle["cells"]);
        return result;
      }
    };



    TEST_F(OutsideMarking, RefinesAndCoarsensTheCellsThatAreNamed)
    {
      // all nine, then the one at the load and, of another, the four parts
      ASSERT_EQ(
        run_marked("n = len(mesh['cells'])\n"
                   "print(json.dumps({'refine': list(range(n))} if n == "
                   "9 else {'refine': [0], 'coarsen': [32, 33, 34, "
                   "35]}))",
                   "--set 'Adaptivity/Target error=1e-3'"),
        0)
        << err;
      EXPECT_EQ(cells(), (std::vector<int>{9, 36, 36}));
    }



    TEST_F(OutsideMarking, IsComparedWithTheStrategiesOfTheProgram)
    {
      const auto path = directory / "mark.py";
      std::ofstream(path)
        << "import json, sys\n"
           "cells = json.load(open(sys.argv[1]))['cells']\n"
           "print(json.dumps({'refine': list(range(len(cells)))}))\n";
      const std::string command = "compare '" + main_scene + "' --output '" +
        results().string() +
        "' --set 'Time/Time step=1e-6' --set Comparison/Elements=MITC9 --set "
        "'Comparison/Strategies=uniform' --set 'Comparison/Maximum cycles=3' "
        "--set 'Comparison/Reference peak force=1353' --marking ";
      ASSERT_EQ(execute(command + "\"python3 '" + path.string() + "'\""), 0)
        << err;
      const auto curves =
        nlohmann::json::parse(text(results() / "comparison.json"))["curves"];
      ASSERT_EQ(curves.size(), 2u);
      EXPECT_EQ(curves[1]["strategy"], "outside marking");
      // all cells refined are the uniform strategy's meshes
      for (const unsigned int mesh : {0, 1, 2})
        for (const std::string key : {"cells", "peak_force"})
          EXPECT_EQ(curves[1]["meshes"][mesh][key],
                    curves[0]["meshes"][mesh][key]);
      EXPECT_NE(
        text(results() / "comparison.csv").find("outside marking,MITC9"),
        std::string::npos);
      ASSERT_EQ(execute(command + "false"), 0) << err;
      EXPECT_NE(err.find("outside marking, MITC9 failed: --marking ends with "
                         "status 1"),
                std::string::npos)
        << err;
    }



    TEST_F(OutsideMarking, MakesTheSizesThatAreWanted)
    {
      for (const auto *const strategy : {"hanging nodes", "remeshing"})
        {
          ASSERT_EQ(run_marked("print(json.dumps({'sizes': [0.01] * "
                               "len(mesh['cells'])}))",
                               std::string(
                                 "--set 'Adaptivity/Target error=1e-3' --set "
                                 "'Adaptivity/Strategy=") +
                                 strategy + "'"),
                    0)
            << err;
          // 3 x 3 cells of 33 mm become 12 x 12 by halving; new ones, of which
          // 10 x 10 would do, scatter
          EXPECT_GE(cells()[1], 100) << strategy;
          EXPECT_LE(cells()[1], 200) << strategy;
        }
    }



    TEST_F(OutsideMarking, RefinesCellsAtSingularPointsByOneLevelAsWell)
    {
      // under a point load the size rule has another exponent
      ASSERT_EQ(run_marked("print(json.dumps({'refine': [0]}))",
                           "--set 'Contact/Load distribution=point' --set "
                           "'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      EXPECT_EQ(cells(), (std::vector<int>{9, 12}));
    }



    TEST_F(OutsideMarking, TellsWhatAMarkingMayWantToKnow)
    {
      ASSERT_EQ(run_marked("print('{\"refine\": [0]}')",
                           "--set 'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      const auto mesh =
        nlohmann::json::parse(text(results() / "marking_cycle_1.json"));
      ASSERT_EQ(mesh["cells"].size(), 9u);
      EXPECT_EQ(mesh["vertices"].size(), 16u);
      const auto &middle = mesh["cells"][4];
      EXPECT_EQ(middle["neighbours"], nlohmann::json({3, 5, 1, 7}));
      EXPECT_EQ(middle["level"], 0);
      EXPECT_EQ(middle["samples"].size(), 4u);
      EXPECT_EQ(middle["samples"][0]["raw"].size(), 5u);
      EXPECT_NEAR(middle["size"].get<double>(), 0.1 / 3., 1e-9);
      const auto first   = summary()["cycles"][0];
      double     largest = 0., sum = 0.;
      for (const auto &cell : mesh["cells"])
        {
          largest = std::max(largest, cell["error_ratio"].get<double>());
          sum += cell["peak_force_error"].get<double>();
        }
      expect_near(largest, first["max_element_error"], 1e-9);
      expect_near(sum, first["peak_force_error_estimate"], 1e-6);
      EXPECT_EQ(mesh["history"]["force"].size(), 81u);
    }



    TEST_F(OutsideMarking, EndsWhereNothingIsMarked)
    {
      ASSERT_EQ(run_marked("print('{}')"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "mesh unchanged");
      EXPECT_EQ(cells().size(), 1u);
    }



    TEST_F(OutsideMarking, WhatComesBackWrongIsToldAndLeavesValidFiles)
    {
      const std::pair<const char *, const char *> wrong[] = {
        {"print('refine 3')", "it is no object in JSON"},
        {"print('[1, 2]')", "it is no object in JSON"},
        {"print('{\"refine\": [9]}')",
         "\"refine\" has 9; allowed: numbers of cells, from 0 to 8"},
        {"print('{\"coarsen\": [0.5]}')", "\"coarsen\" has 0.5"},
        {"print('{\"refine\": \"all\"}')", "\"refine\" has \"all\""},
        {"print('{\"sizes\": [1e-3]}')",
         "\"sizes\" has 1, the mesh has 9 cells"},
        {"print('{\"sizes\": [0] * 9}'.replace('[0] * 9', str([0] * 9)))",
         "\"sizes\" has 0; allowed: lengths above 0 m"},
        {"print('{\"remove\": [1]}')",
         "it has \"remove\"; allowed: refine, coarsen, sizes"},
        {"sys.exit(3)", "--marking ends with status 3"}};
      for (const auto &[script, sentence] : wrong)
        {
          EXPECT_EQ(run_marked(script), 2) << script;
          EXPECT_NE(err.find(sentence), std::string::npos) << script << '\n'
                                                           << err;
          EXPECT_NE(summary()["outcome"].get<std::string>().find("failed"),
                    std::string::npos);
        }
    }



    TEST_F(OutsideMarking, NeedsAStrategyThatGivesSizes)
    {
      EXPECT_EQ(run_marked("print('{}')", "--set Adaptivity/Strategy=uniform"),
                1);
      EXPECT_NE(err.find("--marking needs Adaptivity/Strategy = hanging nodes"),
                std::string::npos)
        << err;
      EXPECT_FALSE(fs::exists(results()));
    }
  } // namespace
} // namespace PlateImpact
