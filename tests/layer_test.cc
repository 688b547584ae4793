// The local response of a layer: the compliance in series with Hertz's law, the
// functional that load and reading use, and peak forces of three-dimensional
// elastodynamics.
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_section.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace PlateImpact
{
  namespace
  {
    LayerResponse
    layer(const double    poissons_ratio,
          const double    shear_correction,
          const LoadShape load)
    {
      PlateParameters plate         = unit_plate(EdgeSupport::clamped, 1.);
      plate.poissons_ratio          = poissons_ratio;
      plate.shear_correction_factor = shear_correction;
      return LayerResponse(PlateSection(plate), load);
    }



    TEST(LayerResponse, ComplianceIsThatOfTheStruckFaceOfALayer)
    {
      // tests/layer/local_compliance.py computes them in two other ways
      const std::vector<std::pair<double, double>> values = {{0.1, -0.421656},
                                                             {0.2, -0.300653},
                                                             {0.25, -0.254395},
                                                             {0.3, -0.213315},
                                                             {0.35, -0.176066},
                                                             {0.4, -0.141838},
                                                             {0.45, -0.110111}};
      for (const auto &[nu, Lambda] : values)
        {
          const auto   response = layer(nu, 5. / 6., LoadShape::Hertz_disc);
          const double radius   = response.patch_radius();
          EXPECT_NEAR(radius, std::sqrt(nu / (1. - nu)), 1e-14);
          EXPECT_NEAR(response.rotation_factor(radius), 0., 1e-15);
          EXPECT_NEAR(response.sphere_constant(radius), Lambda, 1e-6);
          if (nu == 0.3)
            record("nu 0.3", response.sphere_constant(radius));
        }
      const double pi      = std::acos(-1.);
      const auto   mindlin = layer(0.3, pi * pi / 12., LoadShape::Hertz_disc);
      EXPECT_NEAR(mindlin.patch_radius(), 0.668914, 1e-6);
      EXPECT_NEAR(mindlin.sphere_constant(mindlin.patch_radius()),
                  -0.208983,
                  1e-6);
      const auto uniform = layer(0.3, 5. / 6., LoadShape::uniform_disc);
      EXPECT_NEAR(uniform.sphere_constant(uniform.patch_radius()),
                  -0.212552,
                  1e-6);
    }



    TEST(LayerResponse, OtherRadiiTakeTheRotationsIn)
    {
      struct Case
      {
        LoadShape load;
        double    nu, kappa, radius, beta, Lambda;
      };
      // tests/layer/local_compliance.py; a uniform pressure leaves a tail that
      // falls off slowly
      for (const Case &one :
           {Case{LoadShape::Hertz_disc, 0.3, 5. / 6., 0.3, 0.033857, -0.362820},
            Case{LoadShape::Hertz_disc, 0.3, 5. / 6., 1., -0.057143, -0.117662},
            Case{LoadShape::Hertz_disc, 0., 5. / 6., 0.2, -0.004, -0.574736},
            Case{LoadShape::Hertz_disc, 0.3, 1., 0.2, 0.015048, -0.410228},
            Case{LoadShape::uniform_disc,
                 0.3,
                 5. / 6.,
                 0.3,
                 0.031607,
                 -0.341447}})
        {
          const auto response = layer(one.nu, one.kappa, one.load);
          EXPECT_NEAR(response.rotation_factor(one.radius), one.beta, 1e-6);
          EXPECT_NEAR(response.sphere_constant(one.radius),
                      one.Lambda,
                      one.load == LoadShape::uniform_disc ? 1e-4 : 2e-6);
        }
      // where no radius makes plate and layer alike
      EXPECT_EQ(layer(0.1, 1., LoadShape::Hertz_disc).patch_radius(), 0.);
    }



    TEST(LayerResponse, LineConstantIsThatOfALongContact)
    {
      const std::vector<std::pair<double, double>> values = {{0.2, 0.140967},
                                                             {0.3, 0.350289},
                                                             {0.33, 0.420819}};
      for (const auto &[nu, Lambda] : values)
        {
          const auto response = layer(nu, 5. / 6., LoadShape::strip);
          EXPECT_NEAR(response.line_constant(response.patch_radius()),
                      Lambda,
                      1e-6);
        }
    }



    class Layer : public Program
    {
    protected:
      /// A case of tests/reference/layer3d_cases.json as changes of the main
      /// scene; its plate is endless up to the end, its ball a half-space.
      static std::string
      changes_of(const nlohmann::json &one)
      {
        const auto &plate = one["plate"], &ball = one["impactor"];
        const auto  set = [](const std::string &entry, const auto &value) {
          std::ostringstream text;
          text << " --set \"" << entry << '=' << value << '"';
          return text.str();
        };
        return set("Plate/Side lengths", "0.6, 0.6") +
          set("Plate/Thickness", plate["thickness"]) +
          set("Plate/Young's modulus", plate["E"]) +
          set("Plate/Poisson's ratio", plate["nu"]) +
          set("Plate/Density", plate["rho"]) +
          set("Impactor/Radius", ball["radius"]) +
          set("Impactor/Young's modulus", ball["E"]) +
          set("Impactor/Poisson's ratio", ball["nu"]) +
          set("Impactor/Density", ball["rho"]) +
          set("Impactor/Velocity", one["velocity"]) +
          set("Time/End time", one["end_time"]) + set("Time/Time step", 0) +
          set("Contact/Law", "Hertz") + set("Contact/Local response", "layer") +
          set("Contact/Finite ball", "false") +
          set("Discretization/Initial cells", "6, 6") +
          set("Adaptivity/Maximum cycles", 4) +
          set("Adaptivity/Target error", 0.1);
      }
    };



    TEST_F(Layer, ForcesAreThoseOfThreeDimensionalElasticity)
    {
      std::ifstream file(TEST_DATA "/reference/layer3d_cases.json");
      const auto    cases = nlohmann::json::parse(file);
      ASSERT_EQ(cases.size(), 8u);
      for (const auto &one : cases)
        {
          ASSERT_EQ(run(main_scene, changes_of(one)), 0) << err;
          const auto last = last_cycle();
          const auto name = one["name"].get<std::string>();
          expect_near(last["peak_force"], one["peak_force"], 2e-3);
          expect_near(last["contact_radius_over_thickness"],
                      one["contact_radius_over_thickness"],
                      0.01);
          EXPECT_LT(last["relative_energy_drift"], 1e-9) << name;
          if (!one["contact_end"].is_null())
            {
              expect_near(last["first_contact_end"], one["contact_end"], 5e-3);
            }
          if (!one["restitution"].is_null())
            {
              EXPECT_NEAR(-last["final_impactor_velocity"].get<double>() /
                            one["velocity"].get<double>(),
                          one["restitution"].get<double>(),
                          3e-3)
                << name;
            }
        }
    }



    TEST_F(Layer, PeakDependsOnThePatchRadiusNoMore)
    {
      const std::string changes =
        " --set Contact/Law=Hertz --set 'Contact/Local response=layer' --set "
        "'Contact/Patch radius=";
      std::vector<double> forces;
      for (const std::string radius : {"0", "0.0016", "0.0032", "0.008"})
        {
          ASSERT_EQ(run(main_scene, changes + radius + "'"), 0) << err;
          EXPECT_EQ(summary()["local_response"], "layer");
          forces.push_back(last_cycle()["peak_force"]);
          expect_near(forces.back(), forces.front(), 1e-3);
        }
    }



    TEST_F(Layer, ContactAsWideAsThePlateIsThickIsRefused)
    {
      EXPECT_EQ(run(main_scene,
                    " --set Contact/Law=Hertz --set 'Contact/Local "
                    "response=layer' --set Plate/Thickness=0.0005 --set "
                    "Impactor/Radius=0.05 --set Impactor/Velocity=20 --set "
                    "Adaptivity/Strategy=none"),
                2);
      EXPECT_NE(err.find("beyond the limit of the local response of a layer"),
                std::string::npos)
        << err;
    }



    TEST_F(Layer, PatchesThatItDoesNotFitAreTold)
    {
      const std::string on_one_mesh = "--set Adaptivity/Strategy=none ";
      ASSERT_EQ(run(main_scene,
                    on_one_mesh + "--set 'Contact/Patch radius=0.016'"),
                0)
        << err;
      EXPECT_NE(err.find("Contact/Patch radius = 0.016 m is 2 thicknesses"),
                std::string::npos)
        << err;
      // plate theory gives way under it without limit
      EXPECT_EQ(run(main_scene, "--set 'Contact/Patch radius=8e-6'"), 1);
      EXPECT_NE(err.find("expected 0, a larger radius"), std::string::npos)
        << err;
    }



    TEST_F(Layer, RunSaysWhichLocalResponseItHas)
    {
      const std::string on_one_mesh = "--set Adaptivity/Strategy=none ";
      ASSERT_EQ(run(main_scene, on_one_mesh), 0) << err;
      EXPECT_NE(out.find("Response    local, of a layer"), std::string::npos)
        << out;
      const auto last = last_cycle();
      // Hertz: p = 3 F / (2 pi a^2)
      const double radius =
        0.008 * last["contact_radius_over_thickness"].get<double>();
      expect_near(last["contact_pressure"],
                  1.5 * last["peak_force"].get<double>() /
                    (std::acos(-1.) * radius * radius),
                  1e-9);
      EXPECT_EQ(study_of("report.html")["words"]["localResponse"],
                "layer, as in three-dimensional elasticity");

      ASSERT_EQ(run(main_scene, on_one_mesh + "--set Contact/Law=Sun"), 0);
      EXPECT_NE(out.find("local, of a half-space"), std::string::npos);
      EXPECT_NE(out.find("the law Sun allows no other"), std::string::npos)
        << out;
      ASSERT_EQ(run(main_scene,
                    on_one_mesh + "--set 'Contact/Load distribution=point'"),
                0);
      EXPECT_NE(out.find("a point load allows no other"), std::string::npos)
        << out;
      ASSERT_EQ(run(main_scene,
                    on_one_mesh + "--set 'Contact/Local response=half-space'"),
                0);
      EXPECT_EQ(out.find("no other"), std::string::npos) << out;
    }



    TEST_F(Layer, ErrorOfAHalfSpaceHasThatOfTheBall)
    {
      const std::string rubber = SCENES "/extremes/rubber.prm";
      ASSERT_EQ(run(rubber), 0) << err;
      const double of_ball = last_cycle()["peak_force"];
      ASSERT_EQ(run(rubber, "--set 'Contact/Local response=half-space'"), 0)
        << err;
      const double change =
        of_ball / last_cycle()["peak_force"].get<double>() - 1.;
      EXPECT_GT(change, 0.05);
      double     told  = 0.;
      const auto parts = summary()["verdict"]["model"]["errors"];
      for (const auto &part : parts)
        if (part["of"] == "ball taken for a half-space")
          told = part["relative"];
      EXPECT_NEAR(told / change, 1., 0.2);
    }



    TEST_F(Layer, LineContactOnALayer)
    {
      ASSERT_EQ(run(SCENES "/paper-cylinder.prm",
                    " --set 'Contact/Load distribution=strip' --set "
                    "'Contact/Local response=layer' --set "
                    "'Contact/Integration=energy conserving'"),
                0)
        << err;
      const auto last = last_cycle();
      // the paper's law, with the contact's length where thickness and radius
      // belong, is softer
      EXPECT_GT(last["peak_force"], 9300.);
      EXPECT_LT(last["relative_energy_drift"], 1e-9);
    }
  } // namespace
} // namespace PlateImpact
