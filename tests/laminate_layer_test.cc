// Laminates as three-dimensional elasticity has them: what the section answers
// under a contact, and peak forces.
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_section.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    class LaminateLayer : public Program
    {
    protected:
      /// Of tests/reference/laminate3d_cases.json those that are laminates.
      static std::vector<nlohmann::json>
      laminates()
      {
        std::vector<nlohmann::json> cases;
        for (const auto &one : reference("laminate3d_cases.json"))
          if (one["plate"]["ply"].contains("E1"))
            cases.push_back(one);
        return cases;
      }

      static const nlohmann::json &
      entries_of_ply()
      {
        static const nlohmann::json entries = {
          {"Longitudinal modulus", "E1"},
          {"Transverse modulus", "E2"},
          {"Poisson's ratio", "nu12"},
          {"In-plane shear modulus", "G12"},
          {"Longitudinal shear modulus", "G13"},
          {"Transverse shear modulus", "G23"},
          {"Through-thickness modulus", "E3"},
          {"Through-thickness Poisson's ratio", "nu13"},
          {"Transverse Poisson's ratio", "nu23"}};
        return entries;
      }

      /// A case as changes of the main scene, up to past its peak on a plate
      /// from whose edges no wave is back by then.
      static std::string
      changes_of(const nlohmann::json &one)
      {
        std::string changes;
        const auto  set = [&changes](const std::string &entry,
                                    const auto        &value) {
          std::ostringstream text;
          text << " --set \"" << entry << '=' << value << '"';
          changes += text.str();
        };
        const auto &plate = one["plate"], &ball = one["impactor"];
        std::string layup;
        for (const auto &angle : plate["plies_from_struck_face_deg"])
          layup += (layup.empty() ? "" : "/") + angle.dump();
        const double end_time  = 1.5 * one["time_of_peak"].get<double>(),
                     thickness = plate["thickness"],
                     fastest   = std::sqrt(plate["ply"]["E1"].get<double>() /
                                         plate["rho"].get<double>()),
                     side      = std::max(24. * thickness, fastest * end_time);
        set("Plate/Layup", layup);
        set("Plate/Side lengths",
            std::to_string(side) + ", " + std::to_string(side));
        set("Plate/Thickness", thickness);
        set("Plate/Density", plate["rho"]);
        for (const auto &[entry, name] : entries_of_ply().items())
          set("Ply/" + entry, plate["ply"][name.get<std::string>()]);
        set("Impactor/Radius", ball["radius"]);
        set("Impactor/Young's modulus", ball["E"]);
        set("Impactor/Poisson's ratio", ball["nu"]);
        set("Impactor/Density", ball["rho"]);
        set("Impactor/Velocity", one["velocity"]);
        set("Time/End time", end_time);
        set("Time/Time step", 0);
        set("Adaptivity/Goal", "peak force");
        set("Adaptivity/Target peak force error", 5e-4);
        set("Adaptivity/Maximum cycles", 12);
        return changes;
      }

      static PlateSection
      section_of(const nlohmann::json &given)
      {
        PlateParameters plate =
          unit_plate(EdgeSupport::clamped, given["thickness"]);
        plate.density                 = given["rho"];
        plate.shear_correction_factor = 0.;
        plate.layup.angles =
          given["plies_from_struck_face_deg"].get<std::vector<double>>();
        const auto &ply = given["ply"];
        plate.ply       = {ply["E1"],
                           ply["E2"],
                           ply["nu12"],
                           ply["G12"],
                           ply["G13"],
                           ply["G23"],
                           ply["E3"],
                           ply["nu13"],
                           ply["nu23"]};
        return PlateSection(plate);
      }

      static double
      peak(const nlohmann::json &summary)
      {
        return summary["cycles"].back()["peak_force"];
      }
    };



    TEST_F(LaminateLayer, ConstantsAreThoseOfTheRule)
    {
      // computed apart from the program, by whoever fixed the rule
      for (const auto &one : laminates())
        {
          const PlateSection  section = section_of(one["plate"]);
          const LayerResponse layer(section, LoadShape::Hertz_disc);
          const auto         &rule   = one["cure"];
          const double        radius = layer.patch_radius();
          expect_near(1. / section.half_space_compliance, rule["E_star"], 1e-9);
          expect_near(section.poissons_ratio, rule["nu_eff"], 1e-9);
          expect_near(radius, rule["c_over_h"], 1e-9);
          // here their quadratures are coarser
          expect_near(layer.sphere_constant(radius), rule["Lambda"], 1e-4);
          const double scale = section.shear_stiffness.norm();
          for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
              EXPECT_NEAR(section.shear_stiffness(i, j),
                          rule["shear_stiffness"][i][j].get<double>(),
                          2e-3 * scale)
                << one["name"];
          EXPECT_EQ(section.is_skew(),
                    std::abs(rule["D"][0][2].get<double>()) > 1e-6)
            << one["name"];
        }
    }



    TEST_F(LaminateLayer, ZerosAreThoseOfAPlyAlikeAcrossItsFibres)
    {
      const auto         one     = laminates().front();
      auto               changed = one["plate"];
      const PlateSection given   = section_of(changed);
      for (const std::string constant : {"E3", "nu13", "nu23"})
        changed["ply"][constant] = 0;
      EXPECT_DOUBLE_EQ(section_of(changed).half_space_compliance,
                       given.half_space_compliance);
    }



    TEST_F(LaminateLayer, IsotropicPliesHaveTheForceOfThePlate)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      const auto  plate = summary();
      std::string plies =
        "--set Plate/Layup=20/-50/20 --set 'Ply/Poisson'\\''s ratio=0.3'";
      for (const std::string modulus : {"Longitudinal", "Transverse"})
        plies += " --set 'Ply/" + modulus + " modulus=2.1e11'";
      for (const std::string modulus :
           {"In-plane", "Longitudinal", "Transverse"})
        plies += " --set 'Ply/" + modulus + " shear modulus=80769230769.23077'";
      ASSERT_EQ(run(main_scene, plies), 0) << err;
      EXPECT_EQ(last_cycle()["cells"], plate["cycles"].back()["cells"]);
      expect_near(last_cycle()["peak_force"], peak(plate), 1e-8);
    }



    TEST_F(LaminateLayer, OtherPatchesBallsAndUnloadings)
    {
      const std::string of_case = changes_of(laminates().front()),
                        one = of_case + " --set 'Contact/Finite ball=false'";
      ASSERT_EQ(run(main_scene, one), 0) << err;
      const double force = peak(summary());
      // h = 2.69 mm and c = 1.59 mm
      for (const std::string radius : {"0.001", "0.0025"})
        {
          ASSERT_EQ(run(main_scene,
                        one + " --set 'Contact/Patch radius=" + radius + "'"),
                    0)
            << err;
          EXPECT_NEAR(peak(summary()) / force, 1., 5e-3) << radius;
        }
      // stiffer by -C / (G R) of a steel ball, small beside the plies'
      ASSERT_EQ(run(main_scene, of_case + " --set 'Contact/Finite ball=true'"),
                0)
        << err;
      EXPECT_GT(peak(summary()), force);
      EXPECT_LT(peak(summary()), 1.005 * force);
      // the curve of loading is the same
      ASSERT_EQ(run(main_scene,
                    one +
                      " --set Contact/Unloading=Yang-Sun --set "
                      "'Contact/Critical indentation=2e-5' --set "
                      "'Time/End time=0'"),
                0)
        << err;
      EXPECT_EQ(summary()["local_response"], "layer");
      EXPECT_NEAR(peak(summary()) / force, 1., 1e-3);
      EXPECT_GT(last_cycle()["dissipated_energy"], 0.);
      EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9);
    }



    TEST_F(LaminateLayer, PlatesOfAnyOutlineStruckAnywhere)
    {
      // before a wave is back from an edge all of them are the same
      const std::string one = changes_of(laminates().front());
      const auto        set = [](const std::string &entry) {
        return " --set '" + entry + "'";
      };
      ASSERT_EQ(run(main_scene, one), 0) << err;
      const double force = peak(summary());
      for (const std::string &other :
           {set("Plate/Outline=circle"),
            set("Plate/Outline=circle") + set("Plate/Impact point=0.01, 0.02"),
            set("Plate/Impact point=0.02, 0.01")})
        {
          ASSERT_EQ(run(main_scene, one + other), 0) << err;
          EXPECT_NEAR(peak(summary()) / force, 1., 1e-3) << other;
        }
      ASSERT_EQ(run(SCENES "/l-plate.prm",
                    set("Plate/Layup=[0/45/-45/90]s") +
                      set("Plate/Density=1536") + set("Time/End time=2e-5") +
                      set("Adaptivity/Strategy=none")),
                0)
        << err;
      EXPECT_EQ(summary()["local_response"], "layer");
    }



    TEST_F(LaminateLayer, SweptLawsHaveTheShearThatIsTheirs)
    {
      const std::string scene = SCENES "/laminate-quasi-isotropic.prm";
      const std::string on_one_mesh =
        "--set Adaptivity/Strategy=none --set Plate/Layup=0/90s";
      ASSERT_EQ(sweep(scene,
                      on_one_mesh +
                        " --set 'Sweep/Entry 1=Contact/Law' --set "
                        "'Sweep/Values 1=Sun, Hertz'"),
                0)
        << err;
      const std::vector<Row> swept = rows();
      ASSERT_EQ(swept.size(), 2u);
      for (const Row &row : swept)
        {
          ASSERT_EQ(run(scene,
                        on_one_mesh +
                          " --set Contact/Law=" + row.at("Contact/Law")),
                    0)
            << err;
          EXPECT_NEAR(std::stod(row.at("peak_force")) / peak(summary()),
                      1.,
                      1e-6);
        }
    }



    TEST_F(LaminateLayer, SaysWhetherItDelaminates)
    {
      const std::string scene     = SCENES "/laminate-quasi-isotropic.prm",
                        toughness = "--set 'Ply/Mode II toughness=";
      ASSERT_EQ(run(scene), 0) << err;
      // 24 plies of IM7/8552, 788 J/m^2; waves are not back from an edge at the
      // peak
      const double D = PlateSection(read_scene(scene, {}, {}).parameters.plate)
                         .mean_bending_stiffness();
      const double threshold = last_cycle()["delamination_threshold"];
      expect_near(threshold,
                  1.213 * std::acos(-1.) * std::sqrt(32. / 3. * D * 788.),
                  1e-12);
      expect_near(last_cycle()["peak_force_over_delamination_threshold"],
                  last_cycle()["peak_force"].get<double>() / threshold,
                  1e-12);
      EXPECT_NE(out.find("Damage      no delamination expected"),
                std::string::npos)
        << out;
      EXPECT_NE(
        text(results() / "report.html").find("no delamination expected"),
        std::string::npos);
      // as the root of the toughness
      ASSERT_EQ(run(scene, toughness + "7.88'"), 0) << err;
      expect_near(last_cycle()["delamination_threshold"],
                  0.1 * threshold,
                  1e-12);
      EXPECT_NE(out.find("Damage      delamination expected"),
                std::string::npos)
        << out;
      // the force is that of a plate which stays whole
      EXPECT_EQ(summary()["verdict"]["model"]["trust"], "doubtful");
      EXPECT_NE(err.find("times the delamination threshold"), std::string::npos)
        << err;
      // what is not known of the force is not known of the damage: its errors,
      // and whether it still grows
      ASSERT_EQ(run(scene, "--set 'Time/End time=1.5e-5'"), 0) << err;
      EXPECT_NE(out.find("delamination cannot be judged"), std::string::npos)
        << out;
      ASSERT_EQ(run(SCENES "/laminate-sun-chen.prm", toughness + "6.9'"), 0);
      EXPECT_NE(out.find("delamination is possible"), std::string::npos) << out;
      // a heavy ball pushes the plate until waves have come back many times
      ASSERT_EQ(run(scene,
                    "--set Impactor/Mass=5 --set Impactor/Velocity=0.2 --set "
                    "Adaptivity/Strategy=none"),
                0)
        << err;
      expect_near(last_cycle()["delamination_threshold"],
                  threshold / 1.213,
                  1e-9);
      ASSERT_EQ(run(scene, toughness + "0' --set Adaptivity/Strategy=none"), 0);
      EXPECT_FALSE(summary()["verdict"].contains("damage"));
      EXPECT_EQ(out.find("Damage"), std::string::npos) << out;
    }
  } // namespace
} // namespace PlateImpact
