// The program against what others computed: doc/validation.md.
#include "program_fixture.h"
#include "test_plate.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    class Validation : public Program
    {};

    const double pi = std::acos(-1.);

    struct KarasImpact
    {
      double peak_force, contact_end; // [N, s]
    };



    /// A sphere on the centre of a simply supported thin plate: the deflection
    /// as a double sine series, in which every mode is stepped exactly under
    /// the mean force of a step, and F = k alpha^{3/2} (Karas,
    /// Ing.-Arch. 10, 1939, 237-250).
    /// @param rotary_inertia  of the plate (Rayleigh), which Karas leaves out
    /// @param k               [N/m^{3/2}]
    KarasImpact
    karas(const PlateParameters &plate,
          const bool             rotary_inertia,
          const double           k,
          const double           mass,
          const double           velocity)
    {
      constexpr int n = 150; // odd numbers of half waves
      const double  h = plate.thickness, a = plate.side_lengths[0],
                   b = plate.side_lengths[1], dt = 1e-7;
      const double D = plate.youngs_modulus * std::pow(h, 3) /
        (12. * (1. - std::pow(plate.poissons_ratio, 2)));
      const double   rho_h    = plate.density * h;
      const double   of_modes = 4. / (rho_h * a * b);
      Eigen::ArrayXd wave_number_2(n * n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          wave_number_2[n * i + j] = pi * pi *
            (std::pow((2 * i + 1) / a, 2) + std::pow((2 * j + 1) / b, 2));
      const Eigen::ArrayXd mass_factor = 1. +
        (rotary_inertia ? h * h / 12. : 0.) * wave_number_2,
                           omega =
                             wave_number_2 * (D / rho_h / mass_factor).sqrt();
      const Eigen::ArrayXd cosine = (omega * dt).cos(),
                           sine   = (omega * dt).sin(),
                           gain   = 2. * (0.5 * omega * dt).sin().square() /
        omega.square() / mass_factor;
      Eigen::ArrayXd q = Eigen::ArrayXd::Zero(n * n), q_rate = q;
      // both bodies under half of the force at the end of a step
      const double compliance =
        0.5 * (of_modes * gain.sum() + 0.5 * dt * dt / mass);
      double      position = 0., speed = velocity, force = 0., alpha = 0.;
      KarasImpact result = {0., 0.};
      for (double time = 0.; result.contact_end == 0.; time += dt)
        {
          const Eigen::ArrayXd free = q * cosine + q_rate / omega * sine;
          const double         approach =
            position + speed * dt - of_modes * free.sum() - compliance * force;
          const double before = alpha;
          // alpha + C k alpha^{3/2} = approach
          alpha = std::max(alpha, approach);
          for (unsigned int i = 0; i < 50 && approach > 0.; ++i)
            alpha -=
              (alpha + compliance * k * std::pow(alpha, 1.5) - approach) /
              (1. + 1.5 * compliance * k * std::sqrt(alpha));
          if (approach <= 0.)
            {
              alpha              = approach;
              result.contact_end = time + dt * before / (before - alpha);
            }
          const double next = approach > 0. ? k * std::pow(alpha, 1.5) : 0.,
                       mean = 0.5 * (force + next);
          q_rate            = q_rate * cosine - q * omega * sine +
            mean * sine / omega / mass_factor;
          q = free + mean * gain;
          position += speed * dt - 0.5 * mean / mass * dt * dt;
          speed -= mean / mass * dt;
          force             = next;
          result.peak_force = std::max(result.peak_force, force);
        }
      return result;
    }



    TEST_F(Validation, SeriesOfKaras)
    {
      PlateParameters steel = {};
      steel.side_lengths    = {{0.2, 0.2}};
      steel.thickness       = 0.008;
      steel.youngs_modulus  = 2.1e11;
      steel.poissons_ratio  = 0.3;
      steel.density         = 7800.;
      const double k =
        4. / 3. * std::sqrt(0.01) / ((1. - 0.09) / 2.1e11 + 1. / 2.1e11);
      for (const bool rotary_inertia : {false, true})
        {
          const KarasImpact series =
            karas(steel, rotary_inertia, k, 0.0326725636, 1.);
          const std::string name = rotary_inertia ? "Rayleigh" : "Karas";
          record(name + " peak force", series.peak_force);
          record(name + " contact end", series.contact_end);
          if (!rotary_inertia)
            continue;
          ASSERT_EQ(run(SCENES "/karas.prm"), 0) << err;
          expect_near(last_cycle()["peak_force"], series.peak_force, 2e-4);
          expect_near(last_cycle()["first_contact_end"],
                      series.contact_end,
                      2e-4);
        }
    }



    TEST_F(Validation, SmallBallOnAThickPlateIsHertzsImpact)
    {
      const double E = 2.1e11, nu = 0.3, rho = 7800., R = 0.002, v = 1.;
      // both bodies of one material (McLaskey & Glaser, doi:10.1121/1.3466847)
      const double delta = (1. - nu * nu) / (pi * E);
      const double time  = 4.53 *
        std::pow(4. * rho * pi * 2. * delta / 3., 0.4) * R * std::pow(v, -0.2);
      const double force = 1.917 * std::pow(rho, 0.6) *
        std::pow(2. * delta, -0.4) * R * R * std::pow(v, 1.2);
      record("contact time", time);
      record("peak force", force);
      ASSERT_EQ(run(main_scene,
                    "--set Impactor/Radius=0.002 --set Plate/Thickness=0.05 "
                    "--set 'Plate/Side lengths=1, 1' --set 'Time/End time=0' "
                    "--set 'Time/Time step=0' --set 'Contact/Finite "
                    "ball=false'"),
                0)
        << err;
      // the numbers of the formulas are rounded to three and four digits
      expect_near(last_cycle()["peak_force"], force, 1e-3);
      expect_near(last_cycle()["first_contact_end"], time, 3e-3);
    }



    TEST_F(Validation, RestitutionFollowsZener)
    {
      ASSERT_EQ(sweep(SCENES "/zener-restitution.prm"), 0) << err;
      EXPECT_EQ(rows().size(), 8u);
      for (const Row &row : rows())
        {
          EXPECT_NEAR(std::stod(row.at("restitution_over_zener")), 1., 0.04);
          EXPECT_NEAR(std::stod(row.at("peak_force_over_zener")), 1., 0.01);
        }
    }



    TEST_F(Validation, BallsHeavierThanThePlateStrikeOnce)
    {
      const double plate = 0.2 * 0.2 * 0.008 * 7800.;
      ASSERT_EQ(sweep(SCENES "/mass-ratio.prm"), 0) << err;
      EXPECT_EQ(rows().size(), 14u);
      for (const Row &row : rows())
        {
          const double ratio       = std::stod(row.at("Impactor/Mass")) / plate;
          const bool   swings_back = ratio > 0.15 && ratio < 0.85;
          EXPECT_EQ(row.at("number_of_contacts"), swings_back ? "2" : "1")
            << ratio;
        }
    }



    /// The discretization errors of the paper's Tables 2 and 3 as they come out
    /// with its nine cells, full integration of the shear, patches of interior
    /// vertices and 150 us; computed apart from the program.
    TEST_F(Validation, NineCellsOfThePaper)
    {
      const auto expect = [&](const std::string         &scene,
                              const std::vector<double> &errors) {
        ASSERT_EQ(sweep(scene), 0) << err;
        const auto points = rows();
        ASSERT_EQ(points.size(), errors.size());
        for (unsigned int i = 0; i < errors.size(); ++i)
          EXPECT_NEAR(std::stod(points[i].at("discretization_error")),
                      errors[i],
                      1e-3);
      };
      expect(SCENES "/paper-table-2.prm", {0.406, 0.420, 0.437});
      expect(SCENES "/paper-table-3.prm", {0.406, 0.381, 0.370});
    }



    TEST_F(Validation, VelocityStudyOfThePaper)
    {
      const std::string scene = SCENES "/paper-velocity-study.prm";
      ASSERT_EQ(sweep(scene), 0) << err;
      std::vector<double> eta;
      for (const Row &row : rows())
        eta.push_back(std::stod(row.at("discretization_error")));
      ASSERT_EQ(eta.size(), 3u);
      EXPECT_LT(eta[0], eta[1]);
      EXPECT_LT(eta[1], eta[2]);
      EXPECT_TRUE(fs::exists(results() / "contact_history_point_3.csv"));
      EXPECT_TRUE(fs::exists(results() / "sweep.html"));

      ASSERT_EQ(sweep(scene, "--set 'Adaptivity/Strategy=hanging nodes'"), 0)
        << err;
      // high-order reference: P3_Al_1mps, P3_Al_5mps
      EXPECT_NEAR(std::stod(rows()[0].at("peak_force")) / 445.2319, 1., 3e-4);
      EXPECT_NEAR(std::stod(rows()[2].at("peak_force")) / 2762.535, 1., 3e-4);
    }



    TEST_F(Validation, MassStudyOfThePaper)
    {
      const std::string scene = SCENES "/paper-mass-study.prm";
      ASSERT_EQ(sweep(scene), 0) << err;
      std::vector<double> eta;
      for (const Row &row : rows())
        eta.push_back(std::stod(row.at("discretization_error")));
      ASSERT_EQ(eta.size(), 3u);
      EXPECT_GT(eta[0], eta[1]);
      EXPECT_GT(eta[1], eta[2]);

      ASSERT_EQ(sweep(scene, "--set 'Adaptivity/Strategy=hanging nodes'"), 0)
        << err;
      // high-order reference: P4_mass0.037_steelE
      EXPECT_NEAR(std::stod(rows()[1].at("peak_force")) / 768.8869, 1., 3e-4);
    }
  } // namespace
} // namespace PlateImpact
