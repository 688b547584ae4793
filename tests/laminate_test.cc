// Laminates, and contact that leaves a dent.
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    class Laminate : public Program
    {
    protected:
      static PlateParameters
      plate_of(const nlohmann::json &given)
      {
        PlateParameters plate =
          unit_plate(EdgeSupport::simply_supported, given["thickness"]);
        plate.side_lengths            = {{given["length"], given["width"]}};
        plate.density                 = given["rho"];
        plate.shear_correction_factor = given["shear_correction"];
        plate.layup.angles = given["plies"].get<std::vector<double>>();
        plate.ply          = {given["E1"],
                              given["E2"],
                              given["nu12"],
                              given["G12"],
                              given["G13"],
                              given["G23"],
                              0.,
                              0.,
                              0.};
        return plate;
      }

      /// The main scene with the plate, the impactor and the time of a case.
      static std::string
      sets_of(const nlohmann::json &given)
      {
        const auto &plate = given["plate"], &ball = given["impactor"];
        std::string layup;
        for (const auto &angle : plate["plies"])
          layup += (layup.empty() ? "" : "/") + angle.dump();
        std::string text;
        const auto  set = [&text](const std::string &path,
                                 const std::string &value) {
          text += "--set \"" + path + "=" + value + "\" ";
        };
        set("Plate/Side lengths",
            plate["length"].dump() + "," + plate["width"].dump());
        set("Plate/Thickness", plate["thickness"].dump());
        set("Plate/Density", plate["rho"].dump());
        set("Plate/Support", "simply supported");
        set("Plate/Layup", layup);
        set("Ply/Longitudinal modulus", plate["E1"].dump());
        set("Ply/Transverse modulus", plate["E2"].dump());
        set("Ply/Poisson's ratio", plate["nu12"].dump());
        set("Ply/In-plane shear modulus", plate["G12"].dump());
        set("Ply/Longitudinal shear modulus", plate["G13"].dump());
        set("Ply/Transverse shear modulus", plate["G23"].dump());
        set("Impactor/Radius", ball["radius"].dump());
        set("Impactor/Young's modulus", ball["E"].dump());
        set("Impactor/Poisson's ratio", ball["nu"].dump());
        set("Impactor/Mass", ball["mass"].dump());
        set("Impactor/Velocity", given["velocity"].dump());
        set("Contact/Law", "Sun");
        set("Contact/Patch radius", given["patch_radius"].dump());
        set("Time/End time", given["end_time"].dump());
        set("Time/Time step", "2e-7");
        set("Adaptivity/Target error", "0.03");
        return text;
      }

      struct Contact
      {
        double begin, end, peak, impulse;
      };

      /// Those of the history.
      std::vector<Contact>
      contacts() const
      {
        std::istringstream   table(text(results() / "contact_history.csv"));
        std::string          line;
        std::vector<Contact> found;
        double               time = 0., force = 0.;
        std::getline(table, line);
        while (std::getline(table, line))
          {
            const double t = std::stod(line),
                         F = std::stod(line.substr(line.find(',') + 1));
            if (F > 0. && force == 0.)
              found.push_back({time, t, 0., 0.});
            if (F > 0. || force > 0.)
              {
                found.back().end  = t;
                found.back().peak = std::max(found.back().peak, F);
                found.back().impulse += 0.5 * (t - time) * (F + force);
              }
            time  = t;
            force = F;
          }
        return found;
      }

      void
      expect_contacts(const nlohmann::json &expected)
      {
        const auto found = contacts();
        ASSERT_EQ(found.size(), expected["contacts"].size());
        for (std::size_t c = 0; c < found.size(); ++c)
          {
            const auto &one = expected["contacts"][c];
            expect_near(found[c].end, one["end"], 3e-3);
            expect_near(found[c].impulse, one["impulse"], c == 0 ? 1e-3 : 5e-3);
            expect_near(found[c].peak,
                        one["peak_force"],
                        c == 0 ? 1e-3 : 1.5e-2);
            if (c > 0)
              expect_near(found[c].begin, one["begin"], 3e-3);
          }
        expect_near(last_cycle()["final_impactor_velocity"],
                    expected["velocity_at_end"],
                    2e-3);
        EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-11);
      }
    };



    TEST_F(Laminate, SectionsAreThoseOfLaminationTheory)
    {
      for (const auto &given : reference("laminate_cases.json"))
        {
          const PlateSection section(plate_of(given["plate"]));
          const auto        &D = section.bending_stiffness;
          expect_near(D(0, 0), given["D"][0], 1e-7);
          expect_near(D(0, 1), given["D"][1], 1e-7);
          expect_near(D(1, 1), given["D"][2], 1e-7);
          expect_near(D(2, 2), given["D"][3], 1e-7);
          expect_near(section.shear_stiffness(1, 1), given["A44"], 1e-7);
          expect_near(section.shear_stiffness(0, 0), given["A55"], 1e-7);
          EXPECT_FALSE(section.is_skew());
          EXPECT_FALSE(section.is_unsymmetric());
        }
    }



    TEST_F(Laminate, PliesOfOneMaterialAreAnIsotropicPlate)
    {
      // whatever their angles
      PlateParameters    plate = unit_plate(EdgeSupport::clamped, 0.1);
      const PlateSection known(plate);
      Eigen::Matrix3d    D;
      D << 1., 0.3, 0., 0.3, 1., 0., 0., 0., 0.35;
      D *= 1e-3 / (12. * (1. - 0.3 * 0.3));
      EXPECT_LT((known.bending_stiffness - D).norm(), 1e-14 * D.norm());
      const double G                = known.shear_modulus;
      plate.ply                     = {1., 1., plate.poissons_ratio, G, G, G};
      plate.layup.angles            = {30., -70., 10., -70., 30.};
      plate.shear_correction_factor = 0.; // by equilibrium
      const PlateSection section(plate);
      EXPECT_NEAR(section.half_space_compliance / known.half_space_compliance,
                  1.,
                  1e-14);
      EXPECT_NEAR(section.poissons_ratio, known.poissons_ratio, 1e-14);
      EXPECT_NEAR(section.shear_modulus / known.shear_modulus, 1., 1e-14);
      for (const LoadShape load : {LoadShape::Hertz_disc, LoadShape::strip})
        {
          const LayerResponse of_plies(section, load), of_plate(known, load);
          const double        radius = of_plate.patch_radius();
          EXPECT_NEAR(of_plies.patch_radius(), radius, 1e-14);
          EXPECT_NEAR(of_plies.sphere_constant(radius),
                      of_plate.sphere_constant(radius),
                      1e-13);
        }
      EXPECT_LT((section.stiffness() - known.stiffness()).norm(),
                1e-14 * known.stiffness().norm());
      EXPECT_FALSE(section.is_skew());
      EXPECT_NEAR(section.mean_bending_stiffness(),
                  known.bending_stiffness(0, 0),
                  1e-15);
      const Resultants r(0.3, -0.2, 0.5, 0.7, -0.1);
      EXPECT_NEAR((section.root_of_compliance() * r).squaredNorm() /
                    (known.root_of_compliance() * r).squaredNorm(),
                  1.,
                  1e-12);
      // sigma = 6 M / t^2 at the outer faces, in the axes of the ply
      plate.layup.angles = {90.};
      const auto stresses =
        PlateSection(plate).stresses(Eigen::Vector3d(0.3, -0.2, 0.5));
      EXPECT_NEAR(stresses(0, 0), 600. * 0.2, 1e-9);
      EXPECT_NEAR(stresses(0, 1), 600. * 0.3, 1e-9);
      EXPECT_NEAR(stresses(0, 2), 600. * 0.5, 1e-9);
    }



    TEST_F(Laminate, AnglesTurnThePlate)
    {
      PlateParameters plate =
        plate_of(reference("laminate_cases.json")[0]["plate"]);
      plate.layup.angles = {45.};
      const PlateSection turned(plate);
      EXPECT_TRUE(turned.is_skew());
      EXPECT_FALSE(turned.is_unsymmetric());
      plate.layup.angles = {0.};
      const PlateSection straight(plate);
      // curvature along the fibres costs the same
      const Eigen::Vector3d along(0.5, 0.5, 1.);
      EXPECT_NEAR(along.dot(turned.bending_stiffness * along) /
                    straight.bending_stiffness(0, 0),
                  1.,
                  1e-12);
      // and waves do not know the axes
      EXPECT_NEAR(turned.mean_bending_stiffness() /
                    straight.mean_bending_stiffness(),
                  1.,
                  0.02);
      EXPECT_NEAR(turned.fastest_wave() / straight.fastest_wave(), 1., 1e-12);
      plate.layup.angles = {0., 90.};
      EXPECT_TRUE(PlateSection(plate).is_unsymmetric());
    }



    TEST_F(Laminate, AgreesWithTheSeries)
    {
      const auto cases = reference("laminate_cases.json");
      ASSERT_EQ(run(main_scene,
                    sets_of(cases[0]) + "--set 'Output/Natural frequencies=1'"),
                0)
        << err;
      expect_contacts(cases[0]["elastic"]);
      expect_near(last_cycle()["natural_frequencies"][0],
                  cases[0]["first_frequency_hz"],
                  1e-4);
      const std::string summary_text = text(results() / "summary.json");
      EXPECT_EQ(summary_text.find("dissipated"), std::string::npos);
      for (const auto &given : cases)
        {
          const double critical = given["yang_sun"]["critical_indentation"];
          ASSERT_EQ(run(main_scene,
                        sets_of(given) +
                          "--set Contact/Unloading=Yang-Sun --set "
                          "'Contact/Critical indentation=" +
                          std::to_string(critical) + "'"),
                    0)
            << err;
          expect_contacts(given["yang_sun"]);
          EXPECT_GT(last_cycle()["dissipated_energy"], 0.);
        }
      // a dent of alpha_m (1 - (alpha_cr / alpha_m)^0.4)
      const double most     = cases[1]["yang_sun"]["max_indentation"],
                   critical = cases[1]["yang_sun"]["critical_indentation"];
      expect_near(last_cycle()["permanent_indentation"],
                  most * (1. - std::pow(critical / most, 0.4)),
                  2e-3);
    }



    TEST_F(Laminate, StaticComplianceIsThatOfTheSeries)
    {
      const auto      given = reference("laminate_cases.json")[0];
      PlateParameters plate = plate_of(given["plate"]);
      const auto      mesh  = make_plate_mesh(plate, {{12, 12}});
      for (const double beyond : {0.02, 0.01, 0.005, 0.0025, 0.00125})
        {
          for (const auto &cell : mesh->active_cell_iterators())
            if (cell->center().norm() < beyond)
              cell->set_refine_flag();
          mesh->execute_coarsening_and_refinement();
        }
      const PlateElement  element(ElementType::MITC9);
      PlateDiscretization model(*mesh, element, plate);
      model.assemble();
      ContactParameters contact;
      contact.load_distribution = LoadShape::Hertz_disc;
      contact.patch_radius      = given["patch_radius"];
      const Eigen::VectorXd load =
        model.load(make_load_distribution(contact, 0.));
      expect_near(load.dot(solve_static(model, load)),
                  given["static_compliance"],
                  1e-3);
    }



    TEST_F(Laminate, WholePlatesAreThatOfTheirQuarter)
    {
      // plies of +-45 degrees that cancel in twice the angle need no whole
      // plate; a little more of one does
      const std::string scene = SCENES "/laminate-sun-chen.prm";
      ASSERT_EQ(run(scene), 0) << err;
      const double quarter = last_cycle()["peak_force"];
      ASSERT_EQ(run(scene,
                    "--set 'Plate/Layup=0.001/90/0/90/0s' --set "
                    "'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      EXPECT_GT(last_cycle()["cells"], 400);
      expect_near(last_cycle()["peak_force"], quarter, 1e-3);
    }



    TEST_F(Laminate, QuasiIsotropicPlatesAreComputedWhole)
    {
      // against every cell halved
      ASSERT_EQ(run(SCENES "/laminate-sun-chen.prm",
                    "--set 'Plate/Layup=[0/45/-45/90]s' --set 'Time/End "
                    "time=1e-4' --set Adaptivity/Verify=true"),
                0)
        << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      const auto last = last_cycle();
      EXPECT_EQ(last["verification"]["cells"], 4 * last["cells"].get<int>());
      EXPECT_NEAR(last["verification"]["peak_force"].get<double>() /
                    last["peak_force"].get<double>(),
                  1.,
                  last["peak_force_error_bar"].get<double>());
      // 4119 cells have 271.242 N +- 0.018 N
      EXPECT_NEAR(last["peak_force"].get<double>() / 271.242,
                  1.,
                  last["peak_force_error_bar"].get<double>() + 7e-5);
    }



    TEST_F(Laminate, MistakesAreToldApart)
    {
      const std::string scene = SCENES "/laminate-sun-chen.prm";
      const std::vector<std::pair<std::string, std::string>> cases = {
        {"Plate/Layup=0/ninety", "is not allowed"},
        {"Plate/Layup=0/90/", "is not allowed"},
        {"Plate/Young's modulus=7e10", "isotropic plate"},
        {"Plate/Poisson's ratio=0.2", "isotropic plate"},
        {"Ply/Poisson's ratio=4", "stiffness of the ply"},
        {"Contact/Law=Hertz", "which no fibre composite has"},
        {"Contact/Local response=layer", "does not fit the law Sun"},
        {"Contact/Unloading=plastic", "elastic | Yang-Sun"},
        {"Contact/Critical indentation=0", "above 0"}};
      for (const auto &[set, words] : cases)
        {
          EXPECT_EQ(run(scene, "--set \"" + set + "\""), 1) << set;
          EXPECT_NE(err.find(words), std::string::npos) << set << '\n' << err;
        }
      EXPECT_EQ(run(main_scene, "--set 'Ply/Transverse modulus=1e10'"), 1);
      EXPECT_NE(err.find("no lay-up"), std::string::npos) << err;
      // that there is none is said, as by a sweep that compares with metal
      EXPECT_EQ(execute("check '" + scene +
                        "' --set Plate/Layup= "
                        "--set 'Contact/Unloading=elastic'"),
                0)
        << err;
    }
  } // namespace
} // namespace PlateImpact
