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
  } // namespace
} // namespace PlateImpact
