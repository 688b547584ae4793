// The course, prm/course: every scene gives the number that its first lines
// announce, and what its page claims is so.
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace PlateImpact
{
  namespace
  {
    using nlohmann::json;

    class Course : public Program
    {
    protected:
      /// The scene of a lesson.
      static fs::path
      scene(const std::string &number)
      {
        for (const auto &entry : fs::directory_iterator(SCENES "/course"))
          if (entry.path().filename().string().rfind(number, 0) == 0)
            return entry.path();
        throw std::runtime_error("no lesson " + number);
      }

      /// The summary of a lesson's scene, changed.
      json
      outcome_of(const std::string              &number,
                 const std::vector<std::string> &changes = {})
      {
        std::string more;
        for (const std::string &change : changes)
          more += " --set \"" + change + "\"";
        EXPECT_EQ(run(scene(number).string(), more), 0) << err;
        return summary();
      }

      json
      last_of(const std::string              &number,
              const std::vector<std::string> &changes = {})
      {
        return outcome_of(number, changes)["cycles"].back();
      }
    };

    const std::string hanging = "Adaptivity/Strategy=hanging nodes",
                      uniform = "Adaptivity/Strategy=uniform";



    TEST_F(Course, EverySceneGivesTheForceThatItAnnounces)
    {
      unsigned int n_scenes = 0;
      for (const auto &entry : fs::directory_iterator(SCENES "/course"))
        {
          const std::string content = text(entry.path());
          std::smatch       expected;
          ASSERT_TRUE(std::regex_search(content,
                                        expected,
                                        std::regex("# Expect: +([0-9.]+) N")))
            << entry.path();
          ASSERT_EQ(run(entry.path().string()), 0) << err;
          EXPECT_NEAR(last_cycle()["peak_force"].get<double>() /
                        std::stod(expected[1]),
                      1.,
                      5e-4)
            << entry.path();
          ++n_scenes;
        }
      EXPECT_EQ(n_scenes, 14);
    }



    TEST_F(Course, AdaptiveMeshesNeedFewerCellsThanUniformOnes)
    {
      const auto adaptive = last_of("01");
      const auto equal_cells =
        last_of("01", {uniform, "Adaptivity/Maximum cycles=4"});
      EXPECT_LT(adaptive["discretization_error"],
                equal_cells["discretization_error"]);
      EXPECT_LT(3 * adaptive["cells"].get<int>(),
                equal_cells["cells"].get<int>());
    }



    TEST_F(Course, ErrorOfThePeakFollowsTheSquareOfEta)
    {
      const double limit =
        last_of("01", {"Adaptivity/Target error=0.01"})["peak_force"];
      const auto cycles =
        outcome_of("01", {uniform, "Adaptivity/Maximum cycles=4"})["cycles"];
      for (const auto &cycle : cycles)
        {
          const double eta = cycle["discretization_error"],
                       factor =
                         (cycle["peak_force"].get<double>() / limit - 1.) /
            (eta * eta);
          EXPECT_GT(factor, 0.1);
          EXPECT_LT(factor, 0.5);
        }
    }



    TEST_F(Course, EtaDoesNotContainWavesShorterThanTheCells)
    {
      const auto coarse = outcome_of("02")["cycles"];
      const auto fine = last_of("02", {hanging, "Adaptivity/Maximum cycles=8"});
      EXPECT_LE(fine["discretization_error"], 0.1);
      // the force falls by half with every halving of the cells, eta stays
      const double force = fine["peak_force"];
      EXPECT_GT(coarse[0]["peak_force"], 6. * force);
      EXPECT_GT(coarse[1]["peak_force"], 3. * force);
      expect_near(coarse[1]["discretization_error"],
                  coarse[0]["discretization_error"],
                  0.01);
      outcome_of("02");
      EXPECT_NE(err.find("do not resolve the bending waves"), std::string::npos)
        << err;
    }



    TEST_F(Course, JumpsRankTheCellsButSpreadTheErrorTooEvenly)
    {
      // cell by cell on the same 144 equal cells
      std::vector<std::vector<double>> errors;
      for (const std::string indicator : {"SPR", "Kelly"})
        {
          outcome_of("01",
                     {uniform,
                      "Adaptivity/Maximum cycles=3",
                      "Adaptivity/Indicator=" + indicator});
          std::istringstream rows(
            text(results() / "element_errors_cycle_3.csv"));
          std::string row;
          std::getline(rows, row);
          ASSERT_EQ(row.substr(0, 40),
                    "cell,center_x,center_y,size,element_erro");
          errors.emplace_back();
          while (std::getline(rows, row))
            {
              for (unsigned int column = 0; column < 4; ++column)
                row.erase(0, row.find(',') + 1);
              errors.back().push_back(std::stod(row));
            }
          ASSERT_EQ(errors.back().size(), 144u);
        }
      const auto worst = [&](const std::vector<double> &xi) {
        return std::max_element(xi.begin(), xi.end()) - xi.begin();
      };
      const auto share_of_worst = [&](const std::vector<double> &xi) {
        double sum = 0.;
        for (const double value : xi)
          sum += value * value;
        return xi[worst(xi)] * xi[worst(xi)] / sum;
      };
      EXPECT_EQ(worst(errors[0]), worst(errors[1]));
      EXPECT_GT(share_of_worst(errors[0]), 0.9);
      EXPECT_LT(share_of_worst(errors[1]), 0.5);
    }



    TEST_F(Course, HangingNodesAndRemeshingMeetTheSameTarget)
    {
      for (const auto &outcome :
           {outcome_of("03"), outcome_of("03", {hanging})})
        {
          EXPECT_EQ(outcome["outcome"], "target reached");
          const auto &last = outcome["cycles"].back();
          EXPECT_LT(last["cells"], 300);
          // tests/reference/impact_cases.json
          expect_near(last["peak_force"], 1302.445, 3e-4);
        }
    }



    TEST_F(Course, PointLoadDropsByTheSameWithEveryHalvingAndADiscConverges)
    {
      const auto peaks = [&](const std::string &load) {
        std::vector<double> forces;
        for (const char *const size :
             {"0.004", "0.002", "0.001", "0.0005", "0.00025"})
          forces.push_back(
            last_of("04",
                    {"Contact/Load distribution=" + load,
                     std::string("Adaptivity/Minimum cell size=") +
                       size})["peak_force"]);
        return forces;
      };
      const auto point = peaks("point"), disc = peaks("Hertz disc");
      for (std::size_t i = 1; i < point.size(); ++i)
        EXPECT_NEAR(1. - point[i] / point[i - 1], 0.0069, 0.0005);
      EXPECT_LT(std::abs(disc[4] / disc[3] - 1.), 3e-4);
    }



    TEST_F(Course, SerendipityLocksAndMitc9DoesNot)
    {
      // energy of the ball into the springs of plate and contact, both slow;
      // the contact is that of Hertz with the plate's compliance 1/E
      const double D = 2.1e11 * 8e-12 / 12 / 0.91, plate = D / 0.0056 / 0.04,
                   contact =
                     4. / 3. * std::sqrt(0.01) / (0.91 / 2e7 + 1. / 2.1e11);
      const auto energy = [&](const double force) {
        return force * force / 2. / plate +
          0.4 * force * std::pow(force / contact, 2. / 3.);
      };
      double low = 0., high = 1.;
      while (high - low > 1e-12)
        {
          const double force                               = 0.5 * (low + high);
          (energy(force) < 0.5 * 2e-4 * 2e-4 ? low : high) = force;
        }
      // the force has the plate's vibration on it, the displacement hardly
      const auto displacement = [&](const std::string &element) {
        return last_of("05",
                       {"Discretization/Element=" +
                        element})["max_plate_displacement"]
          .get<double>();
      };
      const double theory = low / plate;
      EXPECT_NEAR(displacement("MITC9") / theory, 1., 0.01);
      EXPECT_LT(displacement("serendipity") / theory, 0.85);
    }



    TEST_F(Course, CollocationGainsEnergyOnCoarseSteps)
    {
      const auto collocation = last_of("06");
      EXPECT_GT(collocation["relative_energy_drift"], 1.);
      EXPECT_LT(collocation["final_impactor_velocity"], -1.);
      const auto conserving =
        last_of("06", {"Contact/Integration=energy conserving"});
      EXPECT_LT(conserving["relative_energy_drift"], 1e-10);
      EXPECT_GT(conserving["final_impactor_velocity"], -1.);
      // second order: half of the step, a quarter of the gain
      const double coarse =
                     last_of("06",
                             {"Time/Time step=2e-6"})["relative_energy_drift"],
                   fine =
                     last_of("06",
                             {"Time/Time step=1e-6"})["relative_energy_drift"];
      EXPECT_NEAR(coarse / fine, 4., 0.5);
    }



    TEST_F(Course, ForceGrowsLessThanByHertzWithTheVelocity)
    {
      ASSERT_EQ(execute("sweep '" + scene("07").string() + "' --output '" +
                        results().string() + "'"),
                0)
        << err;
      std::istringstream  table(text(results() / "sweep.csv"));
      std::vector<double> forces;
      std::string         line;
      std::getline(table, line);
      ASSERT_EQ(line.rfind("Impactor/Velocity,peak_force,", 0), 0) << line;
      while (std::getline(table, line))
        forces.push_back(std::stod(line.substr(line.find(',') + 1)));
      ASSERT_EQ(forces.size(), 4);
      for (std::size_t i = 1; i < forces.size(); ++i)
        {
          const double exponent = std::log2(forces[i] / forces[i - 1]);
          EXPECT_GT(exponent, 1.);
          EXPECT_LT(exponent, 1.2);
        }
    }



    TEST_F(Course, SpaceAndTimeAreTheSmallestOfTheErrors)
    {
      // tests/reference/impact_cases.json, P1_clamped_hertz0.5
      const double reference = 1302.445, force = last_of("08")["peak_force"];
      EXPECT_LT(std::abs(force / reference - 1.), 1e-4);
      EXPECT_LT(last_cycle()["time_error"], 1e-4);
      const double disc =
                     last_of("08",
                             {"Contact/Patch radius=0.00025"})["peak_force"],
                   law = last_of("08", {"Contact/Law=Hertz"})["peak_force"];
      EXPECT_GT(std::abs(disc / force - 1.), 5e-3);
      EXPECT_GT(std::abs(law / force - 1.), 1e-2);
    }
  } // namespace
} // namespace PlateImpact
