#include "plate_impact/estimator/energy_norm_estimator.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    class KellyEstimatorRun : public Program
    {};



    TEST(KellyEstimator, MapsCurvedCellsAsTheyAre)
    {
      PlateParameters plate = unit_plate(EdgeSupport::free, 0.1);
      plate.outline.shape   = PlateOutline::circle;
      plate.side_lengths    = {{2., 2.}};
      const auto mesh       = make_plate_mesh(plate, {{8, 8}});
      unset_symmetry(*mesh);
      const PlateElement        element(ElementType::MITC9);
      const PlateDiscretization model(*mesh, element, plate, 1.);
      // a deflection that is linear but at the middle: what jumps is there
      const Eigen::MatrixXd field =
        interpolate(model, Field([](const Point<2> &p) {
                      return Field::Values{
                        {p.norm() < 1e-9 ? 1. : p[0] + 2. * p[1], p[0], p[1]}};
                    }));
      const Eigen::VectorXd jumps = jumps_of_cells(model, field);
      EXPECT_GT(jumps.norm(), 0.);
      for (const auto &cell : mesh->active_cell_iterators())
        if (cell->center().norm() > 0.6)
          {
            EXPECT_NEAR(jumps[cell->active_cell_index()],
                        0.,
                        2e-6 * jumps.norm());
          }
    }



    TEST(KellyEstimator, SharesOutTheErrorByTheJumps)
    {
      const auto                mesh = unit_square(4);
      const PlateElement        element(ElementType::MITC9);
      const PlateDiscretization model(*mesh,
                                      element,
                                      unit_plate(EdgeSupport::free, 0.1),
                                      1.);
      // the slope of the deflection jumps across x = 1/2 only
      const Eigen::MatrixXd kink =
        interpolate(model, Field([](const Point<2> &p) {
                      return Field::Values{{std::abs(p[0] - 0.5), p[1], p[0]}};
                    }));
      const StressRecovery recovery(*mesh);
      EnergyNormEstimator  estimator(model,
                                    recovery,
                                    {},
                                    false,
                                    0,
                                    ErrorIndicator::Kelly);
      estimator.add_samples({1., 2.},
                            kink, // the amount does not matter
                            Eigen::RowVector2d(1., 3.));
      const ErrorEstimate estimate = estimator.estimate();
      ASSERT_GT(estimate.eta, 0.);
      for (const auto &cell : mesh->active_cell_iterators())
        {
          const double error =
            estimate.element_errors[cell->active_cell_index()] / estimate.eta;
          // eight of sixteen cells share eta evenly; at t = 0 the plate is at
          // rest, which takes half of the first of two seconds
          if (std::abs(cell->center()[0] - 0.5) < 0.25)
            EXPECT_NEAR(error, std::sqrt(1. / 8.) * 0.75, 1e-6);
          else
            EXPECT_NEAR(error, 0., 1e-6);
        }
    }



    TEST(KellyEstimator, IsZeroInAFieldWithoutJumps)
    {
      auto mesh = unit_square(3);
      refine_randomly(*mesh, 2);
      const PlateElement        element(ElementType::MITC9);
      const PlateDiscretization model(*mesh,
                                      element,
                                      unit_plate(EdgeSupport::free, 0.1),
                                      1.);
      const Eigen::MatrixXd     jumps =
        jumps_of_cells(model, Eigen::MatrixXd::Zero(model.n_unknowns(), 1));
      EXPECT_EQ(jumps.rows(), Eigen::Index(mesh->n_active_cells()));
      EXPECT_TRUE(jumps.isZero(0.));
    }



    TEST_F(KellyEstimatorRun, LeadsToTheTargetAsWell)
    {
      ASSERT_EQ(run(main_scene,
                    "--set Adaptivity/Indicator=Kelly --set "
                    "'Adaptivity/Maximum cycles=10'"),
                0)
        << err;
      EXPECT_LE(last_cycle()["discretization_error"], 0.05);
      expect_near(last_cycle()["peak_force"], elastic_peak, 2e-3);
    }
  } // namespace
} // namespace PlateImpact
