// Stiff and extreme scenes, prm/extremes: finite, energy and momentum kept, the
// numbers and warnings that each announces in its first lines.
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <regex>

namespace PlateImpact
{
  namespace
  {
    std::vector<std::string>
    extreme_scenes()
    {
      std::vector<std::string> names;
      for (const auto &entry : fs::directory_iterator(SCENES "/extremes"))
        names.push_back(entry.path().stem().string());
      std::sort(names.begin(), names.end());
      return names;
    }



    class Extremes :
      public Program,
      public testing::WithParamInterface<std::string>
    {
    protected:
      static std::string
      path_of(const std::string &name)
      {
        return SCENES "/extremes/" + name + ".prm";
      }

      /// The rest of the line of a scene that begins with `# key:`.
      static std::string
      announced(const std::string &name, const std::string &key)
      {
        const std::string scene = text(path_of(name));
        std::smatch       match;
        if (!std::regex_search(scene,
                               match,
                               std::regex("# " + key + ": +(.*)")))
          throw std::runtime_error(name + " does not say what it " + key);
        return match[1];
      }

      /// Integral of the force over the history, by the trapezoidal rule.
      /// [N s]
      double
      integral_of_force() const
      {
        std::istringstream history(text(results() / "contact_history.csv"));
        std::string        line;
        std::getline(history, line);
        double integral = 0., last_time = 0., last_force = 0.;
        while (std::getline(history, line))
          {
            const double time  = std::stod(line),
                         force = std::stod(line.substr(line.find(',') + 1));
            integral += 0.5 * (force + last_force) * (time - last_time);
            last_time  = time;
            last_force = force;
          }
        return integral;
      }
    };



    TEST_P(Extremes, AreFiniteKeepEnergyAndWarn)
    {
      ASSERT_EQ(run(path_of(GetParam())), 0) << err;
      const auto last = last_cycle();
      for (const auto &[key, value] : last.items())
        EXPECT_TRUE(!value.is_number() || std::isfinite(value.get<double>()))
          << key;
      EXPECT_LT(last["relative_energy_drift"], 1e-9);
      expect_near(last["peak_force"],
                  std::stod(announced(GetParam(), "Expect")),
                  2e-3);
      // steps that do not resolve the contact leave no integral of the force
      const bool is_coarse = err.find("coarsely") != std::string::npos;
      if (!is_coarse)
        expect_near(integral_of_force(), last["impulse"], 5e-3);

      const auto         warnings = summary()["warnings"];
      std::istringstream words(announced(GetParam(), "Warns"));
      unsigned int       n_expected = 0;
      for (std::string word; std::getline(words >> std::ws, word, ';');)
        if (word != "nothing.")
          {
            if (word.back() == '.')
              word.pop_back();
            EXPECT_NE(err.find(word), std::string::npos) << word << '\n' << err;
            ++n_expected;
          }
      EXPECT_EQ(warnings.size(), n_expected) << err;
    }

    INSTANTIATE_TEST_SUITE_P(All,
                             Extremes,
                             testing::ValuesIn(extreme_scenes()),
                             [](const testing::TestParamInfo<std::string> &i) {
                               return std::regex_replace(i.param,
                                                         std::regex("-"),
                                                         "_");
                             });



    class ExtremesTogether : public Extremes
    {};

    TEST_F(ExtremesTogether, UnitsDoNotMatter)
    {
      // lengths in mm and km at the same mass and time: forces scale with
      // length
      const auto peak = [&](const std::string &scene, const std::string &more) {
        EXPECT_EQ(run(scene, more), 0) << err;
        return last_cycle()["peak_force"].get<double>();
      };
      const double newton = peak(main_scene, "");
      EXPECT_NEAR(peak(path_of("millimetres"), "") / newton, 1e3, 1e-6);
      EXPECT_NEAR(peak(path_of("kilometres"), "") / newton, 1e-3, 1e-12);
    }



    TEST_F(ExtremesTogether, ThinPlatesAreSimilar)
    {
      // Kirchhoff: forces scale with the square of the thickness
      ASSERT_EQ(run(path_of("thin-plate")), 0) << err;
      const double thin = last_cycle()["peak_force"];
      ASSERT_EQ(run(path_of("sheet")), 0) << err;
      expect_near(last_cycle()["peak_force"], 0.01 * thin, 1e-3);
    }



    TEST_F(ExtremesTogether, CollocationGainsEnergyWhereTheStepIsCoarse)
    {
      ASSERT_EQ(run(path_of("step-of-20-contacts"),
                    "--set Contact/Integration=collocation"),
                0)
        << err;
      EXPECT_LT(last_cycle()["final_impactor_velocity"], -2.);
    }
  } // namespace
} // namespace PlateImpact
