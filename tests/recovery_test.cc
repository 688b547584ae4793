#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    using ResultantField = std::function<Resultants(const Point<2> &)>;

    /// Largest errors of the recovery of a field over corners, midsides and
    /// inner points of the cells, relative to the largest value anywhere.
    std::vector<double>
    recovery_errors(const Triangulation<2> &mesh, const ResultantField &field)
    {
      const MappingQ1<2>          mapping;
      const QGauss<2>             gauss(2);
      std::vector<RowMajorMatrix> samples(mesh.n_active_cells(),
                                          RowMajorMatrix(4, 5));
      for (const auto &cell : mesh.active_cell_iterators())
        for (unsigned int g = 0; g < 4; ++g)
          samples[cell->active_cell_index()].row(g) =
            field(mapping.transform_unit_to_real_cell(cell, gauss.point(g)));

      const StressRecovery recovery(mesh);
      RecoveredField       recovered(recovery, 5, [&](const unsigned int cell) {
        return samples[cell];
      });
      std::vector<Point<2>> unit_points;
      for (const double x : {0., 0.3, 0.5, 1.})
        for (const double y : {0., 0.5, 0.8, 1.})
          unit_points.emplace_back(x, y);
      std::vector<double> errors(mesh.n_active_cells());
      double              largest = 0.;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          std::vector<Point<2>> points;
          for (const Point<2> &unit : unit_points)
            points.push_back(mapping.transform_unit_to_real_cell(cell, unit));
          const RowMajorMatrix values = recovered.evaluate(cell, unit_points);
          recovered.finish(cell);
          for (unsigned int q = 0; q < points.size(); ++q)
            {
              const Resultants exact = field(points[q]);
              double          &error = errors[cell->active_cell_index()];
              error                  = std::max(
                error,
                (values.row(q).transpose() - exact).cwiseAbs().maxCoeff());
              largest = std::max(largest, exact.cwiseAbs().maxCoeff());
            }
        }
      for (double &error : errors)
        error /= largest;
      return errors;
    }



    double
    recovery_error(const Triangulation<2> &mesh, const ResultantField &field)
    {
      const std::vector<double> errors = recovery_errors(mesh, field);
      return *std::max_element(errors.begin(), errors.end());
    }



    /// The whole basis of eq. 10 in every resultant, in units of a length.
    ResultantField
    full_basis(const double length)
    {
      return [length](const Point<2> &p) {
        const double x = p[0] / length, y = p[1] / length;
        Resultants   r;
        for (unsigned int k = 0; k < 5; ++k)
          r[k] = 1. + (k - 2.) * x + 2. * y + x * x - (1. + k) * x * y +
            0.5 * y * y + 3. * x * x * y - k * x * y * y;
        return r;
      };
    }



    /// Those of its terms that have the symmetries of the quadrant.
    ResultantField
    symmetric_basis(const double length)
    {
      return [length](const Point<2> &p) {
        const double x = p[0] / length, y = p[1] / length;
        return (Resultants() << 1. + 2. * x * x - y * y,
                -2. + x * x + 3. * y * y,
                4. * x * y,
                x - 2. * x * y * y,
                -y + 3. * x * x * y)
          .finished();
      };
    }



    std::unique_ptr<Triangulation<2>>
    scaled(std::unique_ptr<Triangulation<2>> mesh, const double length)
    {
      GridTools::scale(length, *mesh);
      return mesh;
    }



    TEST(StressRecovery, IsExactForItsBasisAtInteriorEdgeAndCornerNodes)
    {
      for (const double length : {1e-6, 1., 1e6})
        EXPECT_LT(recovery_error(*scaled(unit_square(4), length),
                                 full_basis(length)),
                  1e-10);
    }



    TEST(StressRecovery, IsExactForItsBasisAtHangingNodes)
    {
      for (const double length : {1e-6, 1., 1e6})
        {
          auto mesh = unit_square(3);
          refine_randomly(*mesh, 3);
          EXPECT_LT(recovery_error(*scaled(std::move(mesh), length),
                                   full_basis(length)),
                    1e-9);
        }
    }



    TEST(StressRecovery, LargeCellsAtAnEdgeTakeNoPolynomialsOfSmallOnesBeside)
    {
      // a row of cells of each size from y = 0 on, all up to the edge x = 1
      auto mesh = unit_square(4);
      for (unsigned int n = 0; n < 3; ++n)
        {
          const double row = std::pow(0.5, n + 2);
          for (const auto &cell : mesh->active_cell_iterators())
            if (cell->center()[1] < row)
              cell->set_refine_flag();
          mesh->execute_coarsening_and_refinement();
        }
      const std::vector<double> errors =
        recovery_errors(*mesh, [](const Point<2> &p) {
          return Resultants::Constant(1. / (0.1 + p[1])).eval();
        });
      const auto error_at = [&](const Point<2> &p) {
        return errors[GridTools::find_active_cell_around_point(*mesh, p)
                        ->active_cell_index()];
      };
      // the field is the same along the rows
      for (const double y : {0.3, 0.2, 0.1})
        EXPECT_LT(error_at({0.99, y}), 2. * error_at({0.6, y})) << y;
    }



    TEST(StressRecovery, IsExactForItsBasisOnDistortedCells)
    {
      auto mesh = unit_square(4);
      distort(*mesh, 0.25);
      refine_randomly(*mesh, 1);
      EXPECT_LT(recovery_error(*mesh, full_basis(1.)), 1e-9);
    }



    TEST(StressRecovery, IsExactForItsBasisOnUnstructuredMeshes)
    {
      for (const double length : {1e-6, 1., 1e6})
        for (const double fine : {0.02, 0.1, 0.3})
          {
            auto mesh = unit_square(6);
            remesh(*mesh, fine, 0.3);
            unset_symmetry(*mesh);
            EXPECT_LT(recovery_error(*scaled(std::move(mesh), length),
                                     full_basis(length)),
                      1e-9)
              << length << ' ' << fine;
          }
    }



    TEST(StressRecovery, IsExactAtPlanesOfSymmetryOfUnstructuredMeshes)
    {
      for (const double fine : {0.02, 0.1, 0.3})
        {
          const auto mesh =
            make_plate_mesh(unit_plate(EdgeSupport::clamped, 0.1), {{6, 6}});
          remesh(*mesh, fine, 0.3);
          EXPECT_LT(recovery_error(*mesh, symmetric_basis(1.)), 1e-9) << fine;
        }
    }



    TEST(StressRecovery, IsExactOnTheSymmetryPlanesOfTheSmallestMeshes)
    {
      // no patch of these meshes has eight independent samples of its own
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.1);
      for (const double length : {1e-6, 1., 1e6})
        for (const unsigned int n : {1, 2, 3})
          {
            plate.side_lengths = {{2. * length, 2. * length}};
            EXPECT_LT(recovery_error(*make_plate_mesh(plate, {{n, n}}),
                                     symmetric_basis(length)),
                      1e-10)
              << length << ' ' << n;
          }
    }



    TEST(StressRecovery, IsExactOnOneRowOfCells)
    {
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.1);
      plate.side_lengths    = {{2., 0.4}};
      EXPECT_LT(recovery_error(*make_plate_mesh(plate, {{5, 1}}),
                               symmetric_basis(1.)),
                1e-10);
    }



    /// Estimates of a state that the named elements hold.
    void
    expect_no_error(const Triangulation<2>         &mesh,
                    const std::vector<ElementType> &elements)
    {
      const Field field([](const Point<2> &p) {
        const double x = p[0], y = p[1];
        return Field::Values{{x * x - 3. * x * y, 2. * x + y, 1. - x + 2. * y}};
      });
      for (const ElementType name : elements)
        {
          const PlateElement        element(name);
          const PlateDiscretization model(mesh,
                                          element,
                                          unit_plate(EdgeSupport::free, 0.1),
                                          1.);
          MeshEstimator             estimator(model);
          estimator.add_samples({1.}, interpolate(model, field));
          const ErrorEstimate estimate = estimator.estimate();
          EXPECT_LT(estimate.eta, 1e-10) << name;
          for (const double error : estimate.element_errors)
            EXPECT_LT(error, 1e-10) << name;
        }
    }



    TEST(EnergyNormEstimator, IsZeroForAFieldThatTheElementsHold)
    {
      const auto mesh = unit_square(3);
      refine_randomly(*mesh, 3);
      expect_no_error(*mesh, all_elements());
    }



    TEST(EnergyNormEstimator, IsZeroForThatFieldOnUnstructuredMeshes)
    {
      const auto mesh = unit_square(6);
      remesh(*mesh, 0.05, 0.3);
      unset_symmetry(*mesh);
      // eight nodes hold no quadratic deflection on general quadrilaterals
      expect_no_error(*mesh, {ElementType::Lagrange, ElementType::MITC9});
    }



    TEST(EnergyNormEstimator, IsZeroWhileThePlateIsAtRest)
    {
      const auto                mesh = unit_square(2);
      const PlateElement        element(ElementType::heterosis);
      const PlateDiscretization model(*mesh,
                                      element,
                                      unit_plate(EdgeSupport::clamped, 0.1),
                                      1.);
      MeshEstimator             estimator(model);
      estimator.add_samples({1.}, Eigen::VectorXd::Zero(model.n_unknowns()));
      EXPECT_EQ(estimator.estimate().eta, 0.);
      for (const double error : estimator.estimate().element_errors)
        EXPECT_EQ(error, 0.);
    }



    TEST(EnergyNormEstimator, ElementsAreRelativeToTheNormOfTheCellsThatCount)
    {
      // most of the energy and of the error is in the first cell
      const auto                mesh = unit_square(4);
      const PlateElement        element(ElementType::MITC9);
      const PlateDiscretization model(*mesh,
                                      element,
                                      unit_plate(EdgeSupport::free, 0.1),
                                      1.);
      MeshEstimator             estimator(model, /*singular_cells=*/{0});
      estimator.add_samples({1.},
                            interpolate(model, Field([](const Point<2> &p) {
                                          return Field::Values{
                                            {std::exp(-8. * p.norm_square()),
                                             std::sin(9. * p[0]) / 9.,
                                             0.}};
                                        })));
      const ErrorEstimate estimate = estimator.estimate();
      ASSERT_EQ(estimate.n_singular_cells, 1u);
      EXPECT_GT(estimate.eta_of_all_cells, 1.2 * estimate.eta);
      double sum = 0.;
      for (std::size_t cell = 1; cell < estimate.element_errors.size(); ++cell)
        sum += std::pow(estimate.element_errors[cell], 2);
      // the plate is at rest at t = 0, which halves the mean over time
      EXPECT_NEAR(std::sqrt(sum), 0.5 * estimate.eta, 1e-12);

      // cells at their limit together make the target
      const ErrorRatios ratios = estimate.ratios(0.05);
      EXPECT_NEAR(ratios.element_limit * std::sqrt(15.), 0.05, 1e-15);
      EXPECT_NEAR(ratios.elements[0] * ratios.element_limit,
                  estimate.element_errors[0],
                  1e-15);
      EXPECT_NEAR(ratios.overall, estimate.eta / 0.05, 1e-15);
    }



    TEST(EnergyNormEstimator, IntegratesOverTimeByTheTrapezoidalRule)
    {
      // twice the field has twice both norms: eta stays, whatever the times,
      // and the buffer of samples is passed
      const auto                mesh = unit_square(3);
      const PlateElement        element(ElementType::heterosis);
      const PlateDiscretization model(*mesh,
                                      element,
                                      unit_plate(EdgeSupport::free, 0.1),
                                      1.);
      const Eigen::VectorXd     z = interpolate(
        model,
        Field([](const Point<2> &p) {
          return Field::Values{{std::sin(3. * p[0]), p[1] * p[1] * p[1], 0.}};
        }));
      MeshEstimator once(model), often(model);
      once.add_samples({2.}, z);
      for (unsigned int n = 1; n <= 40; ++n)
        often.add_samples({0.1 * n}, (n + 1) * z);
      EXPECT_NEAR(often.estimate().eta / once.estimate().eta, 1., 1e-12);
      // eta_i is constant but at t = 0, where it is 0: half an interval is lost
      EXPECT_NEAR(once.estimate().element_errors[4] /
                    often.estimate().element_errors[4],
                  0.5 / (1. - 0.5 / 40.),
                  1e-12);
    }
  } // namespace
} // namespace PlateImpact
