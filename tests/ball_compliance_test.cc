#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_bodies.h"

#include <gtest/gtest.h>

namespace PlateImpact
{
  namespace
  {
    TEST(BallCompliance, IsThatOfTheSphereUnderACapOfPressure)
    {
      // -C G R with the pressure of Hertz on a spherical cap, as the flat
      // disc up to (a / R)^2
      const auto c = [](const double nu, const double ratio) {
        ImpactorParameters ball = {};
        ball.radius             = 0.01;
        ball.youngs_modulus     = 2. * 8e10 * (1. + nu);
        ball.poissons_ratio     = nu;
        return -ball_compliance(ball, 0.01 * ratio) * 8e10 * 0.01;
      };
      EXPECT_NEAR(c(0.22, 0.02), 0.0809, 0.0809 * 0.01);
      EXPECT_NEAR(c(0.3, 0.02), 0.1081, 0.1081 * 0.01);
      EXPECT_NEAR(c(0.45, 0.02), 0.1156, 0.1156 * 0.01);
      EXPECT_NEAR(c(0.3, 0.05), 0.1194, 0.1194 * 0.015);
      EXPECT_NEAR(c(0.3, 0.1), 0.1279, 0.1279 * 0.03);
    }
  } // namespace
} // namespace PlateImpact
