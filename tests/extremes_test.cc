// Stiff and extreme scenes, each on one mesh: finite, energy and momentum kept.
#include "plate_impact/contact_law.h"
#include "plate_impact/impactor.h"
#include "plate_impact/plate_section.h"
#include "plate_impact/scene.h"
#include "plate_impact/time_stepper.h"
#include "plate_impact/zener.h"
#include "test_plate.h"

namespace PlateImpact
{
  namespace
  {
    struct Extreme
    {
      std::string              name;
      std::vector<std::string> overrides;
      double                   steps_per_contact; ///< 0: keep the scene's step
    };

    std::ostream &
    operator<<(std::ostream &out, const Extreme &extreme)
    {
      return out << extreme.name;
    }



    /// The steel case with entries changed, on 6 x 6 cells, over two contacts'
    /// time of Zener's equation.
    Parameters
    parameters_of(const Extreme &extreme)
    {
      std::vector<std::string> overrides = {"Discretization/Initial cells=6,6",
                                            "Discretization/Element=MITC9",
                                            "Time/End time=1e-5",
                                            "Time/Time step=1e-9"};
      overrides.insert(overrides.end(),
                       extreme.overrides.begin(),
                       extreme.overrides.end());
      const std::string scene =
        std::string(TEST_DATA) + "/reference/scene-interface.prm";
      Parameters parameters = read_scene(scene, overrides).parameters;
      if (extreme.steps_per_contact > 0.)
        {
          const double contact_time = 2. *
            zener_peak(*make_contact_law(parameters),
                       make_impactor(parameters.impactor),
                       PlateSection(parameters.plate))
              .time;
          parameters.time.time_step = contact_time / extreme.steps_per_contact;
          parameters.time.end_time =
            std::max(2. * contact_time, 5. * parameters.time.time_step);
        }
      return parameters;
    }



    class Extremes : public testing::TestWithParam<Extreme>
    {};

    TEST_P(Extremes, StayFiniteAndKeepEnergyAndMomentum)
    {
      const Parameters parameters = parameters_of(GetParam());
      const auto       mesh =
        make_plate_quadrant(parameters.plate,
                            parameters.discretization.initial_cells);
      const ContactHistory history =
        impact(parameters,
               *mesh,
               make_load_patch(parameters.contact, parameters.impactor.length));
      EXPECT_GT(history.peak().force, 0.);
      EXPECT_GE(history.n_contacts(), 1u);
      EXPECT_LT(history.relative_energy_drift(), 1e-9);

      // the impulse by the forces of the history, where they resolve it
      if (GetParam().steps_per_contact >= 200.)
        {
          double integral = 0.;
          for (std::size_t n = 1; n < history.states().size(); ++n)
            integral += 0.5 *
              (history.states()[n].force + history.states()[n - 1].force) *
              (history.states()[n].time - history.states()[n - 1].time);
          const Impactor impactor = make_impactor(parameters.impactor);
          const double   impulse  = impactor.mass *
            (impactor.velocity - history.states().back().impactor_velocity);
          // the velocity of a heavy impactor hardly changes: round-off
          EXPECT_NEAR(integral,
                      impulse,
                      0.01 * integral +
                        1e-15 * impactor.mass * impactor.velocity);
        }
    }

    const std::vector<std::string> cylinder = {
      "Impactor/Shape=cylinder",
      "Contact/Law=line",
      "Contact/Load distribution=line"};

    INSTANTIATE_TEST_SUITE_P(
      All,
      Extremes,
      testing::Values(
        Extreme{"thick_plate", {"Plate/Thickness=0.04"}, 500.},
        Extreme{"thin_plate_1e3", {"Plate/Thickness=2e-4"}, 500.},
        Extreme{"thin_plate_1e5", {"Plate/Thickness=2e-6"}, 500.},
        Extreme{"thin_plate_1e6", {"Plate/Thickness=2e-7"}, 500.},
        Extreme{"light_impactor", {"Impactor/Mass=2.5e-6"}, 500.},
        Extreme{"heavy_impactor", {"Impactor/Mass=2.5e6"}, 500.},
        Extreme{"slow_impact", {"Impactor/Velocity=1e-6"}, 500.},
        Extreme{"fast_impact", {"Impactor/Velocity=1e3"}, 500.},
        Extreme{"rubber", {"Impactor/Young's modulus=1e7"}, 500.},
        Extreme{"hard_impactor", {"Impactor/Young's modulus=2.1e13"}, 500.},
        Extreme{"fine_steps", {}, 1e4},
        Extreme{"step_of_half_a_contact", {}, 2.},
        Extreme{"step_of_a_contact", {}, 1.},
        Extreme{"step_of_20_contacts", {}, 0.05},
        Extreme{"small_patch", {"Contact/Patch radius=8e-6"}, 500.},
        Extreme{"large_patch", {"Contact/Patch radius=0.05"}, 500.},
        Extreme{"long_plate", {"Plate/Side lengths=2,0.1"}, 500.},
        Extreme{"cylinder", cylinder, 500.},
        Extreme{"cylinder_with_steps_of_a_contact", cylinder, 1.},
        Extreme{"cylinder_with_steps_of_20_contacts", cylinder, 0.05}),
      [](const testing::TestParamInfo<Extreme> &info) {
        return info.param.name;
      });



    TEST(Extremes, UnitsDoNotMatter)
    {
      // lengths in millimetres or kilometres, stresses and densities
      // accordingly, at the same mass and time: forces scale with length
      const auto peak_of = [](const double s) {
        const auto text = [](const double value) {
          std::ostringstream out;
          out.precision(17);
          out << value;
          return out.str();
        };
        std::vector<std::string> overrides = {
          "Plate/Side lengths=" + text(0.2 * s) + "," + text(0.2 * s),
          "Plate/Thickness=" + text(0.008 * s),
          "Impactor/Radius=" + text(0.01 * s),
          "Impactor/Velocity=" + text(s),
          "Contact/Patch radius=" + text(0.0005 * s)};
        for (const std::string body : {"Plate", "Impactor"})
          {
            overrides.push_back(body + "/Young's modulus=" + text(2.1e11 / s));
            overrides.push_back(body + "/Density=" + text(7800. / (s * s * s)));
          }
        const Parameters parameters = parameters_of({"", overrides, 500.});
        const auto       mesh =
          make_plate_quadrant(parameters.plate,
                              parameters.discretization.initial_cells);
        const double peak =
          impact(parameters, *mesh, make_load_patch(parameters.contact, 0.))
            .peak()
            .force;
        return peak / s;
      };
      const double metres = peak_of(1.);
      EXPECT_NEAR(peak_of(1e3) / metres, 1., 1e-9);
      EXPECT_NEAR(peak_of(1e-3) / metres, 1., 1e-9);
    }
  } // namespace
} // namespace PlateImpact
