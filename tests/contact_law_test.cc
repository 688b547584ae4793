#include "contacts.h"
#include "plate_impact/contact/contact_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    TEST(ContactLaw, HertzForceIsThePowerThreeHalves)
    {
      EXPECT_DOUBLE_EQ(hertz_law->force(1e-6), 1.4e10 * 1e-9);
      EXPECT_EQ(hertz_law->force(0.), 0.);
      EXPECT_EQ(hertz_law->force(-1e-6), 0.);
      EXPECT_EQ(hertz_law->stiffness(-1e-6), 0.);
      EXPECT_EQ(hertz_law->potential(-1e-6), 0.);
    }



    TEST(ContactLaw, StiffnessIsTheDerivativeOfForceAndForceThatOfPotential)
    {
      for (const auto &law : laws)
        for (const double alpha : {1e-9, 1e-6, 1e-3, 1.})
          {
            const double h = 1e-4 * alpha;
            EXPECT_NEAR((law->force(alpha + h) - law->force(alpha - h)) /
                          (2 * h) / law->stiffness(alpha),
                        1.,
                        1e-7)
              << alpha;
            EXPECT_NEAR((law->potential(alpha + h) -
                         law->potential(alpha - h)) /
                          (2 * h) / law->force(alpha),
                        1.,
                        1e-7)
              << alpha;
          }
    }



    TEST(ContactLaw, ForceAndStiffnessNeverDecrease)
    {
      for (const auto &law : laws)
        {
          double last = 0., last_stiffness = 0.;
          EXPECT_EQ(law->force(0.), 0.);
          EXPECT_EQ(law->force(-1.), 0.);
          EXPECT_EQ(law->stiffness(-1.), 0.);
          EXPECT_EQ(law->potential(-1.), 0.);
          for (double alpha = 1e-320; alpha < 1e3; alpha *= 1.7)
            {
              EXPECT_GE(law->force(alpha), last) << alpha;
              EXPECT_GE(law->stiffness(alpha), 0.98 * last_stiffness) << alpha;
              last           = law->force(alpha);
              last_stiffness = law->stiffness(alpha);
            }
        }
    }



    TEST(ContactLaw, IndentationInvertsForce)
    {
      for (const auto &law : laws)
        {
          for (const double alpha : {1e-30, 1e-12, 1e-6, 1e-1, 10.})
            EXPECT_NEAR(law->indentation(law->force(alpha)) / alpha, 1., 1e-13)
              << alpha;
          EXPECT_EQ(law->indentation(-1.), 0.);
        }
    }



    TEST(ContactLaw, MeansTimesDistanceAreChanges)
    {
      for (const auto &law : laws)
        for (const double a : {-2e-6, 0., 1e-9, 1e-6, 3e-6})
          for (const double b : {-1e-6, 0., 2e-9, 1.5e-6, 1.03e-6, 2.9e-6})
            if (a != b)
              {
                EXPECT_NEAR(law->mean_force(a, b) * (b - a),
                            law->potential(b) - law->potential(a),
                            1e-14 * (law->potential(a) + law->potential(b)));
                EXPECT_NEAR(law->mean_stiffness(a, b) * (b - a),
                            law->force(b) - law->force(a),
                            1e-14 * (law->force(a) + law->force(b)));
              }
    }



    TEST(ContactLaw, MeansDoNotCancelForCloseIndentations)
    {
      for (const auto &law : laws)
        for (const double a : {1e-6, 1e-4})
          {
            EXPECT_NEAR(law->mean_force(a, a) / law->force(a), 1., 1e-14);
            const double beside = a * (1. + 1e-12);
            EXPECT_NEAR(law->mean_force(a, beside) / law->force(a), 1., 2e-12);
            EXPECT_NEAR(law->mean_stiffness(a, beside) / law->stiffness(a),
                        1.,
                        2e-12);
          }
    }



    TEST(ContactLaw, YieldingBeginsAtThePressureOfGreen)
    {
      // Hertz's largest pressure 2 E* / pi (alpha / r)^{1/2} is C Y there
      const double pressure =
        2. * modulus / std::acos(-1.) * std::sqrt(first_yield / 0.01);
      EXPECT_NEAR(pressure / (1.295 * std::exp(0.736 * 0.3) * 3.55e8),
                  1.,
                  1e-12);
      EXPECT_EQ(yielding_law->force(0.5 * first_yield),
                HertzLaw(1.5e10).force(0.5 * first_yield));
      EXPECT_LT(yielding_law->force(20. * first_yield),
                0.8 * HertzLaw(1.5e10).force(20. * first_yield));
    }



    TEST(ContactLaw, LineLawIsThatOfTheReferenceHistory)
    {
      // eq. 32 with the force per length: 9095.3 N of the reference
      const double F = 9095.3, l = 0.0333335;
      const double a =
        std::sqrt(4. * F / (2. * l) * 0.01 / (3.14159265358979 * modulus));
      EXPECT_NEAR(line_law->indentation(F) * 3.14159265358979 * l * modulus / F,
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
  } // namespace
} // namespace PlateImpact
