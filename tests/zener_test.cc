#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    const Contact hertz(std::make_shared<HertzLaw>(1.4e10));



    /// Section of the steel plate of the paper.
    PlateSection
    steel_section(const double thickness)
    {
      PlateParameters plate;
      plate.thickness               = thickness;
      plate.youngs_modulus          = 2.1e11;
      plate.poissons_ratio          = 0.3;
      plate.density                 = 7800.;
      plate.shear_correction_factor = 5. / 6.;
      return PlateSection(plate);
    }



    TEST(ZenerPeak, RigidPlateIsHertzImpact)
    {
      // a plate so thick that nothing is lost into it
      const Impactor     impactor{0.03, 0., 1.};
      const ContactState peak =
        ZenerImpact(hertz, impactor, steel_section(100.)).peak;
      const double alpha = std::pow(1.25 * 0.03 / 1.4e10, 0.4);
      EXPECT_NEAR(peak.indentation / alpha, 1., 1e-4);
      EXPECT_NEAR(peak.force / hertz.force(alpha), 1., 1e-4);
      EXPECT_NEAR(peak.time / (1.4716 * alpha), 1., 3e-3);
    }



    TEST(ZenerPeak, ThinPlateIsTheQuasistaticLimit)
    {
      // the plate gives way at once: F = 8 sqrt(D rho t) v
      const PlateSection section = steel_section(1e-5);
      const Impactor     impactor{0.03, 0., 1.};
      const ContactState peak = ZenerImpact(hertz, impactor, section).peak;
      const double       impedance =
        8. * std::sqrt(section.bending_stiffness(0, 0) * section.mass_per_area);
      EXPECT_NEAR(peak.force / impedance, 1., 2e-3);
    }



    TEST(ZenerPeak, WhatGivesWayInSeriesTakesForce)
    {
      // a spring in series on a plate that does not move: the ball's energy is
      // in both, m v^2 / 2 = 2/5 F alpha + C F^2 / 2
      const Impactor impactor{0.03, 0., 1.};
      for (const double compliance : {-2e-9, 3e-9, 1e-7})
        {
          const Contact      contact = hertz.in_series(compliance);
          const ContactState peak =
            ZenerImpact(contact, impactor, steel_section(100.)).peak;
          EXPECT_NEAR((0.4 * peak.force * peak.indentation +
                       0.5 * compliance * peak.force * peak.force) /
                        0.015,
                      1.,
                      1e-3)
            << compliance;
        }
    }



    TEST(ZenerPeak, SteelCaseOfThePaper)
    {
      // the Kirchhoff plate under a point force of impact_cases.json, 1370.835
      // N; that plate has rotary inertia, which Zener's equation leaves out
      const Contact  contact(std::make_shared<HertzLaw>(14659685863.874344));
      const Impactor impactor{0.03267256359733385, 0., 1.};
      const ContactState peak =
        ZenerImpact(contact, impactor, steel_section(0.008)).peak;
      EXPECT_NEAR(peak.force / 1370.835, 1., 0.03);
    }



    /// Restitution by Zener's equation without dimensions, sigma'' = -(1 +
    /// lambda d/dtau) sigma^{3/2}, by the classical Runge-Kutta method.
    double
    restitution(const double lambda)
    {
      const double dt    = 1e-3;
      const auto   force = [](const double x) {
        return x > 0. ? std::pow(x, 1.5) : 0.;
      };
      double     x = 0., v = 1.;
      const auto x_rate = [&](const double x, const double v) {
        return v - lambda * force(x);
      };
      while (true)
        {
          const double x1 = x_rate(x, v), v1 = -force(x);
          const double x2 = x_rate(x + dt / 2 * x1, v + dt / 2 * v1),
                       v2 = -force(x + dt / 2 * x1);
          const double x3 = x_rate(x + dt / 2 * x2, v + dt / 2 * v2),
                       v3 = -force(x + dt / 2 * x2);
          const double x4 = x_rate(x + dt * x3, v + dt * v3),
                       v4 = -force(x + dt * x3);
          x += dt / 6 * (x1 + 2 * x2 + 2 * x3 + x4);
          v += dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
          if (x <= 0.)
            return -v;
        }
    }



    TEST(ZenerRestitution, DependsOnTheLossFactorAlone)
    {
      const PlateSection section = steel_section(0.008);
      for (const double mass : {1e-4, 1e-3, 0.01, 0.03, 0.1, 0.5})
        for (const double velocity : {0.1, 1., 5., 20.})
          {
            const ZenerImpact impact(hertz, {mass, 0., velocity}, section);
            const double      lambda = *impact.loss_factor();
            EXPECT_NEAR(impact.restitution(),
                        lambda < 4. ? restitution(lambda) : 0.,
                        1e-3)
              << "lambda = " << lambda;
          }
      EXPECT_NEAR(
        ZenerImpact(hertz, {0.03, 0., 1.}, steel_section(100.)).restitution(),
        1.,
        1e-4);
    }



    /// F = 2 alpha.
    class LinearLaw : public ContactLaw
    {
    public:
      double
      force(const double alpha) const override
      {
        return alpha > 0. ? 2. * alpha : 0.;
      }
      double
      stiffness(const double alpha) const override
      {
        return alpha > 0. ? 2. : 0.;
      }
      double
      potential(const double alpha) const override
      {
        return 0.5 * alpha * force(alpha);
      }
    };



    TEST(ZenerHistory, HasThePeakTheEndAndTheRebound)
    {
      const ZenerImpact    impact(hertz, {0.03, 0., 1.}, steel_section(0.008));
      const ContactHistory history = impact.history(1.);
      const ContactState   peak    = impact.peak;
      EXPECT_NEAR(history.peak().force / peak.force, 1., 1e-4);
      EXPECT_NEAR(history.peak().time / peak.time, 1., 0.01);
      ASSERT_TRUE(history.end_of_impact());
      EXPECT_NEAR(-history.states.back().impactor_velocity,
                  impact.restitution(),
                  1e-3);
      EXPECT_NEAR(history.states.back().time,
                  *history.end_of_impact(),
                  0.01 * peak.time);
      // a heavy ball stays in contact with a thin plate
      const ContactHistory pushed =
        ZenerImpact(hertz, {0.5, 0., 1.}, steel_section(0.001)).history(1e-3);
      EXPECT_FALSE(pushed.end_of_impact());
      EXPECT_GE(pushed.states.back().time, 1e-3);
      // in long steps where little changes
      EXPECT_LT(ZenerImpact(hertz, {100., 0., 1.}, steel_section(1e-5))
                  .history(1e-3)
                  .states.size(),
                20000u);
      // momentum: what the ball has lost has moved the plate
      const ContactState &last      = pushed.states.back();
      const double        impedance = 8. *
        std::sqrt(steel_section(0.001).bending_stiffness(0, 0) *
                  steel_section(0.001).mass_per_area);
      EXPECT_NEAR(last.plate_displacement * impedance /
                    (0.5 * (1. - last.impactor_velocity)),
                  1.,
                  1e-3);
    }



    TEST(ZenerRestitution, LossFactorIsOfHertzianContactsOnly)
    {
      EXPECT_FALSE(ZenerImpact(Contact(std::make_shared<LinearLaw>()),
                               {0.01, 0., 1.},
                               steel_section(0.008))
                     .loss_factor());
    }



    TEST(ZenerRestitution, LossFactorIsThePublishedFormula)
    {
      // pi^{3/5}/3^{1/2} (r/t)^2 (v/v_p)^{1/5} (rho/rho_p)^{3/5} (E/(E +
      // E_p))^{2/5}, E the moduli of plane strain, v_p = sqrt(E_p/rho_p)
      // (Zener 1941)
      const double r = 0.003, t = 0.008, v = 2., rho = 2700., rho_p = 7800.,
                   e = 7e10 / (1. - 0.33 * 0.33), e_p = 2.1e11 / (1. - 0.09);
      const double pi       = std::acos(-1.);
      const double expected = std::pow(pi, 0.6) / std::sqrt(3.) *
        std::pow(r / t, 2) * std::pow(v / std::sqrt(e_p / rho_p), 0.2) *
        std::pow(rho / rho_p, 0.6) * std::pow(e / (e + e_p), 0.4);
      const Contact contact(
        std::make_shared<HertzLaw>(hertz_coefficient(r, 1. / e, 1. / e_p)));
      EXPECT_NEAR(*ZenerImpact(contact,
                               {4. / 3. * pi * r * r * r * rho, 0., v},
                               steel_section(t))
                      .loss_factor() /
                    expected,
                  1.,
                  1e-12);
    }
  } // namespace
} // namespace PlateImpact
