#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    const HertzLaw hertz(1.4e10);

    // the paper's cylinder
    const double  modulus = 2.1e11 / (2. * 0.91);
    const LineLaw line(0.01, 0.0333335, modulus);

    // in series with the layer of an 8 mm steel plate, and on it
    const SeriesLaw series(1.4e10, -3.3e-10), softer(1.4e10, 3.3e-10);
    const LineLaw   line_on_layer(0.01, 0.0333335, modulus, -0.69);

    const std::vector<const ContactLaw *> laws = {&hertz,
                                                  &line,
                                                  &series,
                                                  &softer,
                                                  &line_on_layer};



    TEST(ContactLaw, HertzForceIsThePowerThreeHalves)
    {
      EXPECT_DOUBLE_EQ(hertz.force(1e-6), 1.4e10 * 1e-9);
      EXPECT_EQ(hertz.force(0.), 0.);
      EXPECT_EQ(hertz.force(-1e-6), 0.);
      EXPECT_EQ(hertz.stiffness(-1e-6), 0.);
      EXPECT_EQ(hertz.potential(-1e-6), 0.);
    }



    TEST(ContactLaw, StiffnessIsTheDerivativeOfForceAndForceThatOfPotential)
    {
      for (const ContactLaw *law : laws)
        for (const double alpha : {1e-9, 1e-6, 1e-3, 1.})
          {
            const double h = 1e-4 * alpha;
            EXPECT_NEAR((law->force(alpha + h) - law->force(alpha - h)) /
                          (2 * h) / law->stiffness(alpha),
                        1.,
                        1e-7)
              << alpha;
            EXPECT_NEAR((law->approach(alpha + h) - law->approach(alpha - h)) /
                          (2 * h) / law->approach_rate(alpha),
                        1.,
                        1e-7)
              << alpha;
            EXPECT_NEAR((law->potential(alpha + h) -
                         law->potential(alpha - h)) /
                          (2 * h * law->approach_rate(alpha)) /
                          law->force(alpha),
                        1.,
                        1e-7)
              << alpha;
          }
    }



    TEST(ContactLaw, ForceNeverDecreases)
    {
      for (const ContactLaw *law : laws)
        {
          double last = 0.;
          EXPECT_EQ(law->force(0.), 0.);
          EXPECT_EQ(law->force(-1.), 0.);
          EXPECT_EQ(law->stiffness(-1.), 0.);
          EXPECT_EQ(law->potential(-1.), 0.);
          for (double alpha = 1e-320; alpha < 1e3; alpha *= 1.7)
            {
              EXPECT_GE(law->force(alpha), last) << alpha;
              EXPECT_GE(law->stiffness(alpha), 0.) << alpha;
              last = law->force(alpha);
            }
        }
    }



    TEST(ContactLaw, IndentationInvertsForce)
    {
      for (const ContactLaw *law : laws)
        {
          for (const double alpha : {1e-30, 1e-12, 1e-6, 1e-1, 10.})
            EXPECT_NEAR(law->indentation(law->force(alpha)) / alpha, 1., 1e-13)
              << alpha;
          EXPECT_EQ(law->indentation(-1.), 0.);
          for (const double alpha : {-1e-6, 1e-30, 1e-12, 1e-6, 1e-1, 10.})
            EXPECT_NEAR(law->indentation_under(law->approach(alpha)) / alpha,
                        1.,
                        1e-13)
              << alpha;
        }
    }



    TEST(ContactLaw, MeanForceTimesDistanceIsTheChangeOfPotential)
    {
      for (const ContactLaw *law : laws)
        for (const double a : {-2e-6, 0., 1e-9, 1e-6, 3e-6})
          for (const double b : {-1e-6, 0., 2e-9, 1.5e-6, 1.03e-6, 2.9e-6})
            if (a != b)
              {
                EXPECT_NEAR(law->mean_force(a, b) *
                              (law->approach(b) - law->approach(a)),
                            law->potential(b) - law->potential(a),
                            1e-14 * (law->potential(a) + law->potential(b)));
              }
    }



    TEST(ContactLaw, MeanForceDoesNotCancelForCloseIndentations)
    {
      for (const ContactLaw *law : laws)
        {
          const double a = 1e-6;
          EXPECT_NEAR(law->mean_force(a, a) / law->force(a), 1., 1e-14);
          EXPECT_NEAR(law->mean_force(a, a * (1. + 1e-12)) / law->force(a),
                      1.,
                      2e-12);
        }
    }



    TEST(ContactLaw, LineLawIsThatOfTheReferenceHistory)
    {
      // eq. 32 with the force per length: 9095.3 N of the reference
      const double F = 9095.3, l = 0.0333335;
      const double a = line_contact_half_width(0.01, F / (2. * l), modulus);
      EXPECT_NEAR(line.indentation(F) * 3.14159265358979 * l * modulus / F,
                  1.886 + std::log(l / a),
                  1e-12);
    }



    TEST(ContactLaw, CoefficientsOfTheTwoLawsOfTheSphere)
    {
      // steel on steel: impact_cases.json gives K of both laws
      const double E = 2.1e11, c = (1. - 0.09) / E;
      EXPECT_NEAR(hertz_coefficient(0.01, c, 1. / E), 14659685863.874344, 1.);
      EXPECT_NEAR(hertz_coefficient(0.01, c, c), 15384615384.615383, 1.);
    }



    TEST(ContactSolver, SolvesTheCollocatedEquation)
    {
      const CollocatedContact collocation;
      for (const double compliance : {1e-20, 1e-12, 1e-8, 1e-4, 1e4})
        for (const double free : {1e-12, 1e-6, 1e-2})
          {
            const double phi =
              solve_contact(collocation, hertz, 0., free, compliance);
            const double alpha = hertz.indentation(phi);
            EXPECT_NEAR((alpha + compliance * phi) / free, 1., 1e-13)
              << compliance << ' ' << free;
          }
    }



    TEST(ContactSolver, SolvesTheEnergyConservingEquation)
    {
      const EnergyConservingContact conserving;
      for (const double compliance : {1e-20, 1e-12, 1e-8, 1e-4, 1e4})
        for (const double begin : {-1e-6, 0., 1e-9, 1e-6, 1e-3})
          for (const double free : {-1e-3, 1e-12, 1e-6, 1e-2})
            {
              const double phi =
                solve_contact(conserving, hertz, begin, free, compliance);
              const double end = free - compliance * phi;
              EXPECT_GE(phi, 0.);
              // where the compliance dominates, round-off of `end` decides
              const double error = std::abs(hertz.mean_force(begin, end) - phi);
              EXPECT_LE(error,
                        1e-13 * phi +
                          hertz.stiffness(std::max(begin, end)) * 1e-14 *
                            (std::abs(free) + std::abs(begin)))
                << compliance << ' ' << begin << ' ' << free;
            }
    }



    TEST(ContactSolver, SolvesStepsOfEveryKind)
    {
      // indentations of both signs and compliances over many orders
      const EnergyConservingContact          conserving;
      const CollocatedContact                collocation;
      std::mt19937                           generator(1);
      std::uniform_real_distribution<double> exponent(0., 6.), sign(-1., 1.);
      const auto                             indentation = [&] {
        return std::copysign(1e-4 * std::pow(10., -exponent(generator)),
                             sign(generator));
      };
      for (unsigned int i = 0; i < 200000; ++i)
        {
          const ContactLaw &law   = *laws[i % laws.size()];
          const double      begin = indentation(), free = indentation(),
                       compliance = 1e-5 * std::pow(10., -exponent(generator));
          for (const ContactIntegration *integration :
               std::initializer_list<const ContactIntegration *>{&conserving,
                                                                 &collocation})
            {
              const double phi =
                solve_contact(*integration, law, begin, free, compliance);
              ASSERT_GE(phi, 0.);
              const double end = law.indentation_under(free - compliance * phi);
              const double bound = 1e-14 *
                (std::abs(free) + std::abs(end) + compliance * phi) /
                law.approach_rate(end);
              // the force at an end moved by round-off on either side
              ASSERT_LE(integration->force(law, begin, end - bound),
                        phi * (1. + 1e-12));
              ASSERT_GE(integration->force(law, begin, end + bound),
                        phi * (1. - 1e-12));
            }
        }
    }



    TEST(ContactSolver, NoContactIsExactlyNoForce)
    {
      const CollocatedContact       collocation;
      const EnergyConservingContact conserving;
      EXPECT_EQ(solve_contact(collocation, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(conserving, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(collocation, hertz, 1e-6, -1e-9, 1e-8), 0.);
    }



    TEST(ContactSolver, RefusesValuesThatAreNotFinite)
    {
      const CollocatedContact collocation;
      EXPECT_THROW(solve_contact(collocation,
                                 hertz,
                                 0.,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 1e-8),
                   ComputationError);
    }



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
      const ExpectedPeak peak =
        zener_peak(hertz, impactor, steel_section(100.));
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
      const ExpectedPeak peak = zener_peak(hertz, impactor, section);
      const double       impedance =
        8. * std::sqrt(section.bending_stiffness(0, 0) * section.mass);
      EXPECT_NEAR(peak.force / impedance, 1., 2e-3);
    }



    TEST(ZenerPeak, SteelCaseOfThePaper)
    {
      // the Kirchhoff plate under a point force of impact_cases.json, 1370.835
      // N; that plate has rotary inertia, which Zener's equation leaves out
      const HertzLaw     law(14659685863.874344);
      const Impactor     impactor{0.03267256359733385, 0., 1.};
      const ExpectedPeak peak = zener_peak(law, impactor, steel_section(0.008));
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
            const Impactor impactor{mass, 0., velocity};
            const double lambda = *zener_loss_factor(hertz, impactor, section);
            EXPECT_NEAR(zener_restitution(hertz, impactor, section),
                        lambda < 4. ? restitution(lambda) : 0.,
                        1e-3)
              << "lambda = " << lambda;
          }
      EXPECT_NEAR(zener_restitution(hertz, {0.03, 0., 1.}, steel_section(100.)),
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
      double
      indentation(const double force) const override
      {
        return force > 0. ? 0.5 * force : 0.;
      }
    };



    TEST(ZenerHistory, HasThePeakTheEndAndTheRebound)
    {
      const PlateSection   section = steel_section(0.008);
      const Impactor       impactor{0.03, 0., 1.};
      const ContactHistory history =
        zener_history(hertz, impactor, section, 1.);
      const ExpectedPeak peak = zener_peak(hertz, impactor, section);
      EXPECT_NEAR(history.peak().force / peak.force, 1., 1e-4);
      EXPECT_NEAR(history.peak().time / peak.time, 1., 0.01);
      ASSERT_TRUE(history.first_contact_end());
      EXPECT_NEAR(-history.states().back().impactor_velocity,
                  zener_restitution(hertz, impactor, section),
                  1e-3);
      EXPECT_NEAR(history.states().back().time,
                  *history.first_contact_end(),
                  0.01 * peak.time);
      // a heavy ball stays in contact with a thin plate
      const ContactHistory pushed =
        zener_history(hertz, {0.5, 0., 1.}, steel_section(0.001), 1e-3);
      EXPECT_FALSE(pushed.first_contact_end());
      EXPECT_GE(pushed.states().back().time, 1e-3);
      // in long steps where little changes
      EXPECT_LT(zener_history(hertz, {100., 0., 1.}, steel_section(1e-5), 1e-3)
                  .states()
                  .size(),
                20000u);
      // momentum: what the ball has lost has moved the plate
      const ContactState &last      = pushed.states().back();
      const double        impedance = 8. *
        std::sqrt(steel_section(0.001).bending_stiffness(0, 0) *
                  steel_section(0.001).mass);
      EXPECT_NEAR(last.plate_displacement * impedance /
                    (0.5 * (1. - last.impactor_velocity)),
                  1.,
                  1e-3);
    }



    TEST(ZenerRestitution, LossFactorIsOfHertzianContactsOnly)
    {
      EXPECT_FALSE(
        zener_loss_factor(LinearLaw(), {0.01, 0., 1.}, steel_section(0.008)));
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
      const HertzLaw law(hertz_coefficient(r, 1. / e, 1. / e_p));
      EXPECT_NEAR(*zener_loss_factor(law,
                                     {4. / 3. * pi * r * r * r * rho, 0., v},
                                     steel_section(t)) /
                    expected,
                  1.,
                  1e-12);
    }
  } // namespace
} // namespace PlateImpact
