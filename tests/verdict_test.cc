#include "plate_impact/analysis/warnings.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <array>

namespace PlateImpact
{
  namespace
  {
    /// What a run says of its own result: whether it is converged, and whether
    /// it is inside of the model.
    class RunVerdict : public Program
    {
    protected:
      std::string
      trust(const char *part) const
      {
        return summary()["verdict"][part]["trust"];
      }
    };



    TEST_F(RunVerdict, ConvergenceAndModelAreNotMixed)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      EXPECT_EQ(trust("convergence"), "good");
      // nothing is said of the strength of the steel
      EXPECT_EQ(trust("model"), "doubtful");
      EXPECT_NE(out.find("Model       Within the limits of the model, elastic "
                         "contact assumed\n"),
                std::string::npos)
        << out;
      EXPECT_NE(out.find("Contact     pressure 3.3 GPa, elastic as long as the "
                         "yield strength is above 2.05 GPa\n"),
                std::string::npos)
        << out;
      // nor where only the ball has one
      ASSERT_EQ(run(main_scene, "--set 'Impactor/Yield strength=5e9'"), 0);
      EXPECT_EQ(trust("model"), "doubtful");
      EXPECT_NE(out.find("the yield strength of the plate is above 2.05 GPa"),
                std::string::npos)
        << out;
      // without one of its own a ball does not yield
      ASSERT_EQ(run(main_scene, "--set 'Plate/Yield strength=2.2e9'"), 0)
        << err;
      EXPECT_EQ(trust("model"), "good");
      EXPECT_NE(out.find(
                  "Contact     elastic: pressure 3.3 GPa, first yield at "
                  "3.55 GPa\n"),
                std::string::npos)
        << out;

      // plate, contact and material are far beyond their theories
      ASSERT_EQ(run(SCENES "/extremes/fast-impact.prm"), 0) << err;
      EXPECT_EQ(trust("convergence"), "good");
      EXPECT_EQ(trust("model"), "none");
      EXPECT_NE(out.find("Model       Far outside the limits of the model"),
                std::string::npos)
        << out;
      EXPECT_EQ(study_of("report.html")["summary"]["verdict"],
                summary()["verdict"]);
      EXPECT_NE(text(results() / "report.html")
                  .find("target met. Far outside the limits of the model. "),
                std::string::npos);

      // the bar says more than the target of eta
      ASSERT_EQ(run(SCENES "/drop-weight.prm",
                    "--set Plate/Thickness=0.003 --set 'Adaptivity/Goal=energy "
                    "norm' --set 'Adaptivity/Target error=0.1'"),
                0)
        << err;
      EXPECT_GT(last_cycle()["peak_force_error_bar"].get<double>(), 0.01);
      EXPECT_EQ(trust("convergence"), "doubtful");
    }



    TEST_F(RunVerdict, APlateWithoutShearHasALimitUnderAPoint)
    {
      ASSERT_EQ(run(SCENES "/karas.prm"), 0) << err;
      const std::string said = out + err + text(results() / "report.html");
      for (const std::string wrong : {"does not converge", "count twice"})
        EXPECT_EQ(said.find(wrong), std::string::npos) << wrong;
      ASSERT_EQ(run(SCENES "/paper-sphere.prm"), 0) << err;
      EXPECT_NE(err.find("does not converge"), std::string::npos) << err;
    }



    TEST_F(RunVerdict, YieldIsToldWhateverTheUnloading)
    {
      const std::string acrylic =
        "--set Impactor/Density=1190 --set \"Impactor/Young's modulus=3.2e9\" "
        "--set \"Impactor/Poisson's ratio=0.35\" --set Impactor/Velocity=10 "
        "--set 'Contact/Local response=half-space' --set 'Time/End time=2e-4' "
        "--set Contact/Unloading=";
      for (const std::string law : {"elastic", "Yang-Sun"})
        {
          ASSERT_EQ(run(main_scene, acrylic + law), 0) << err;
          EXPECT_NE(err.find("the contact pressure reaches"), std::string::npos)
            << law << err;
          EXPECT_NE(trust("model"), "good");
        }
    }



    TEST_F(RunVerdict, ForcesThatALayerDoesNotHoldAreRefused)
    {
      for (const std::string set :
           {"'Contact/Patch radius=1e-4'",
            "\"Plate/Young's modulus=2100\" --set Plate/Density=1900"})
        {
          EXPECT_EQ(execute("check " + main_scene + " --set " + set), 1) << out;
          EXPECT_NE(err.find("local response of a layer holds up to"),
                    std::string::npos)
            << err;
        }
    }



    TEST_F(RunVerdict, AdviceOnFoilsHelps)
    {
      const std::string foil = SCENES "/extremes/foil.prm";
      ASSERT_EQ(run(foil), 0) << err;
      EXPECT_NE(err.find("choose Adaptivity/Goal = peak force"),
                std::string::npos)
        << err;
      EXPECT_NE(err.find("bending waves of 6.27 um"), std::string::npos) << err;
      ASSERT_EQ(execute("check " + foil), 0) << err;
      EXPECT_NE(out.find(" 6.27 um as the force rises and 54.1 um of the "),
                std::string::npos)
        << out;
      ASSERT_EQ(run(foil,
                    "--set 'Adaptivity/Goal=peak force' --set "
                    "'Adaptivity/Maximum cycles=8'"),
                0)
        << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      // by the scale of prm/extremes/thin-plate.prm
      expect_near(last_cycle()["peak_force"], 3.7e-7, 0.01);
    }



    /// A history of forces, a microsecond each.
    CycleResult
    with_forces(const std::vector<double> &forces)
    {
      CycleResult result;
      result.history.emplace();
      ContactState state;
      state.impactor_velocity = -1.;
      for (const double force : forces)
        {
          state.force       = force;
          state.indentation = force; // as far as they overlap
          result.history->states.push_back(state);
          state.time += 1e-6;
        }
      return result;
    }



    TEST(Warnings, DeflectionsAfterThePeakLeaveItsErrorKnown)
    {
      const Parameters  parameters = read_scene(main_scene, {}, {}).parameters;
      const ZenerImpact expected   = make_zener_impact(parameters);
      const auto        warnings   = [&](const double at_peak) {
        CycleResult result;
        result.history.emplace();
        for (const auto &[time, force, deflection] :
             {std::array<double, 3>{{0., 0., 0.}},
              {{2e-5, expected.peak.force, at_peak}},
              {{1e-4, 0., 0.3}}})
          {
            ContactState state;
            state.time        = time;
            state.force       = force;
            state.indentation = force > 0. ? expected.peak.indentation : 0.;
            state.plate_displacement = deflection * parameters.plate.thickness;
            result.history->states.push_back(state);
          }
        return impact_warnings({parameters, expected, result});
      };
      const Warnings after = warnings(0.1), before = warnings(0.3);
      EXPECT_TRUE(after.model_error());
      EXPECT_NE(after.model.front().find("after the peak of the force"),
                std::string::npos);
      EXPECT_FALSE(before.model_error());
      EXPECT_EQ(before.model.front().find("after the peak of the force"),
                std::string::npos);
    }



    TEST(Warnings, OfWhatTheProgramHasChosen)
    {
      Parameters      parameters = read_scene(main_scene, {}, {}).parameters;
      TimeParameters &time       = parameters.time;
      const auto      numbers    = [&](const std::vector<double> &forces) {
        std::string       text;
        const ZenerImpact expected = make_zener_impact(parameters);
        const CycleResult result   = with_forces(forces);
        for (const std::string &warning :
             impact_warnings({parameters, expected, result}).numerical)
          text += warning + '\n';
        return text;
      };
      // the contact has ended, and another one has begun within its last step
      time.time_step = 1e-6;
      time.end_time  = 4e-6;
      for (const bool is_chosen : {false, true})
        {
          time.end_is_chosen = is_chosen;
          EXPECT_NE(numbers({0., 9., 0., 5.}).find("another contact is under"),
                    std::string::npos);
          EXPECT_EQ(numbers({0., 9., 0., 5.}).find("has not ended"),
                    std::string::npos);
        }
      // a step that the program has chosen is not told to be chosen
      EXPECT_NE(numbers({0., 9., 5., 0.}).find("or 0"), std::string::npos);
      time.step_is_chosen = true;
      EXPECT_EQ(numbers({0., 9., 5., 0.}).find("or 0"), std::string::npos);
    }
  } // namespace
} // namespace PlateImpact
