#include "plate_impact/adaptation/mesh_adaptation.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    AdaptivityParameters
    adaptivity(const AdaptationStrategy strategy,
               const double             minimum_size = 1e-6)
    {
      AdaptivityParameters parameters{};
      parameters.strategy                 = strategy;
      parameters.size_exponent            = 0.5;
      parameters.minimum_cell_size        = minimum_size;
      parameters.maximum_cell_size        = 0.5;
      parameters.maximum_cells            = 100000;
      parameters.target_error             = 0.05;
      parameters.refined_share_of_error   = 0.7;
      parameters.coarsened_share_of_error = 0.01;
      parameters.refined_share_of_cells   = 0.3;
      parameters.coarsened_share_of_cells = 0.03;
      return parameters;
    }



    ErrorRatios
    errors(const Triangulation<2>                        &mesh,
           const std::function<double(const Point<2> &)> &xi)
    {
      ErrorRatios error;
      for (const auto &cell : mesh.active_cell_iterators())
        error.elements.push_back(xi(cell->center()));
      return error;
    }



    /// One adaptation, without warnings.
    /// @return whether the mesh has changed
    bool
    adapt(const AdaptivityParameters &parameters,
          Triangulation<2>           &mesh,
          const ErrorRatios          &error,
          const double                contact_half_length = 0.)
    {
      std::vector<std::string> warnings;
      const bool               is_changed =
        adapt_mesh({mesh, error, parameters, contact_half_length, warnings});
      EXPECT_TRUE(warnings.empty()) << warnings.front();
      return is_changed;
    }



    double
    smallest(const Triangulation<2> &mesh)
    {
      double size = 1e9;
      for (const auto &cell : mesh.active_cell_iterators())
        size = std::min(size, cell_size(cell));
      return size;
    }



    TEST(MeshAdaptation, TargetSizeFollowsThePowerOfTheError)
    {
      const auto mesh = unit_square(4);
      const auto sizes =
        target_sizes(*mesh,
                     errors(*mesh, [](const Point<2> &) { return 16.; }),
                     adaptivity(AdaptationStrategy::hanging_nodes));
      for (const double size : sizes)
        EXPECT_NEAR(size, 0.25 / 4., 1e-15);
    }



    TEST(MeshAdaptation, EqualizedCellsAreNoLargerThanEqualOnes)
    {
      const auto mesh          = unit_square(4);
      const auto hanging_nodes = adaptivity(AdaptationStrategy::hanging_nodes);
      // cells half and twice as large are asked for: 4 and 1/4 for one, so
      // that 34 equal cells are as many
      ErrorRatios estimate =
        errors(*mesh, [](const Point<2> &p) { return p[0] < 0.5 ? 4. : 0.25; });
      EXPECT_TRUE(equalize(*mesh, estimate, hanging_nodes));
      for (const double size : target_sizes(*mesh, estimate, hanging_nodes))
        EXPECT_LE(size, 1. / std::sqrt(34.) + 1e-12);
      EXPECT_EQ(*std::max_element(estimate.elements.begin(),
                                  estimate.elements.end()),
                4.);

      // few cells are wanted, but there are many, of two sizes: the larger ones
      // may have up to sqrt(2) times the size of equal ones
      for (const double share_of_large : {0.25, 0.75})
        {
          const auto uneven = unit_square(4);
          for (const auto &cell : uneven->active_cell_iterators())
            if (cell->center()[0] > share_of_large)
              cell->set_refine_flag();
          uneven->execute_coarsening_and_refinement();
          ErrorRatios little =
            errors(*uneven, [](const Point<2> &) { return 0.01; });
          EXPECT_EQ(equalize(*uneven, little, hanging_nodes),
                    share_of_large < 0.5);
        }
    }



    TEST(MeshAdaptation, SeveralLevelsAtOnceWhereAskedFor)
    {
      const auto mesh       = unit_square(4);
      const auto parameters = adaptivity(AdaptationStrategy::hanging_nodes);
      const auto estimate   = errors(*mesh, [](const Point<2> &p) {
        return p.norm() < 0.2 ? 200. : 0.9;
      });
      EXPECT_TRUE(adapt(parameters, *mesh, estimate));
      // sqrt(200) makes cells 14.1 times smaller: four levels
      EXPECT_NEAR(smallest(*mesh), 0.25 / 16., 1e-12);
      for (const auto &cell : mesh->active_cell_iterators())
        if (cell->center()[0] < 0.25 && cell->center()[1] < 0.25)
          {
            EXPECT_EQ(cell->level(), 4);
          }
      // no neighbours more than a level apart
      for (const auto &cell : mesh->active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f))
            {
              EXPECT_LE(std::abs(cell->level() - cell->neighbor(f)->level()),
                        1);
            }
    }



    TEST(MeshAdaptation, CoarsensBackWhereTheErrorAllows)
    {
      const auto mesh       = unit_square(2);
      const auto parameters = adaptivity(AdaptationStrategy::hanging_nodes);
      adapt(parameters, *mesh, errors(*mesh, [](const Point<2> &) {
              return 50.;
            }));
      EXPECT_EQ(mesh->n_active_cells(), 4u * 64u);
      adapt(parameters, *mesh, errors(*mesh, [](const Point<2> &p) {
              return p[0] > 0.5 ? 1e-4 : 0.9;
            }));
      EXPECT_LT(mesh->n_active_cells(), 200u);
      // and keeps what is right
      unsigned int n_left = 0;
      for (const auto &cell : mesh->active_cell_iterators())
        n_left += cell->center()[0] < 0.5;
      EXPECT_EQ(n_left, 128u);
    }



    TEST(MeshAdaptation, NeverBelowTheMinimumSizeNorAboveTheInitialOne)
    {
      const auto mesh = unit_square(3);
      auto parameters = adaptivity(AdaptationStrategy::hanging_nodes, 0.1);
      parameters.maximum_cell_size = 1. / 3.;
      adapt(parameters, *mesh, errors(*mesh, [](const Point<2> &) {
              return 1e9;
            }));
      EXPECT_NEAR(smallest(*mesh), 1. / 6., 1e-12);
      EXPECT_TRUE(is_smallest(mesh->begin_active(), parameters));
      adapt(parameters, *mesh, errors(*mesh, [](const Point<2> &) {
              return 0.;
            }));
      EXPECT_EQ(mesh->n_active_cells(), 9u);
    }



    TEST(MeshAdaptation, CellsReturnToTheInitialSizeOnceTheErrorAllowsIt)
    {
      const auto mesh       = unit_square(3);
      auto       parameters = adaptivity(AdaptationStrategy::hanging_nodes);
      parameters.maximum_cell_size = 1. / 3.;
      mesh->refine_global(1);
      const auto everywhere = [&mesh](const double xi) {
        return errors(*mesh, [xi](const Point<2> &) { return xi; });
      };
      // coarsened, the error of a cell grows by 2^3
      EXPECT_FALSE(adapt(parameters, *mesh, everywhere(0.13)));
      EXPECT_TRUE(adapt(parameters, *mesh, everywhere(0.12)));
      EXPECT_EQ(mesh->n_active_cells(), 9u);
    }



    TEST(MeshAdaptation, CellsAboveTheMaximumSizeAreRefinedWhateverTheirError)
    {
      const auto mesh       = unit_square(2);
      auto       parameters = adaptivity(AdaptationStrategy::hanging_nodes);
      parameters.maximum_cell_size = 0.2;
      EXPECT_TRUE(adapt(parameters, *mesh, errors(*mesh, [](const Point<2> &) {
                          return 1e-3;
                        })));
      EXPECT_EQ(mesh->n_active_cells(), 64u);
    }



    TEST(MeshAdaptation, ReportsThatAMeshStaysAsItIs)
    {
      const auto mesh = unit_square(3);
      EXPECT_FALSE(adapt(adaptivity(AdaptationStrategy::hanging_nodes),
                         *mesh,
                         errors(*mesh, [](const Point<2> &) { return 0.8; })));
      EXPECT_EQ(mesh->n_active_cells(), 9u);
    }



    TEST(MeshAdaptation, FixedFractionMarksTheShareOfTheSquaredError)
    {
      const auto mesh       = unit_square(10);
      auto       parameters = adaptivity(AdaptationStrategy::fixed_fraction);
      parameters.refined_share_of_error = 0.5;
      // four cells hold 4/5 of the squared error, three of them more than half
      const auto estimate = errors(*mesh, [](const Point<2> &p) {
        return p[0] < 0.2 && p[1] < 0.2 ? 1. + 0.1 * p[0] + 0.01 * p[1] :
                                          std::sqrt(1. / 96.);
      });
      EXPECT_TRUE(adapt(parameters, *mesh, estimate));
      EXPECT_EQ(mesh->n_active_cells(), 100u + 3u * 2u);
    }



    TEST(MeshAdaptation, FixedNumberMarksTheShareOfTheCells)
    {
      const auto mesh       = unit_square(10);
      auto       parameters = adaptivity(AdaptationStrategy::fixed_number);
      const auto estimate =
        errors(*mesh, [](const Point<2> &p) { return p[0] + 0.01 * p[1]; });
      EXPECT_TRUE(adapt(parameters, *mesh, estimate));
      EXPECT_EQ(mesh->n_active_cells(), 100u + 3u * 30u);
      for (const auto &cell : mesh->active_cell_iterators())
        EXPECT_EQ(cell->level(), cell->center()[0] > 0.7 ? 1 : 0);
    }



    TEST(MeshAdaptation, RoundOffRanksNoCellThatMirrorsAnother)
    {
      const auto mesh       = unit_square(10);
      auto       parameters = adaptivity(AdaptationStrategy::fixed_number);
      parameters.refined_share_of_cells = 0.01;
      // the first two of a hundred, which mirror each other
      const auto estimate = errors(*mesh, [](const Point<2> &p) {
        const double round_off = p[0] > p[1] ? 1e-12 : 0.;
        return 1. / (0.01 + std::abs(p[0] + p[1] - 0.2)) *
          (p[0] == p[1] ? 0.1 : 1. + round_off);
      });
      EXPECT_TRUE(adapt(parameters, *mesh, estimate));
      EXPECT_EQ(mesh->n_active_cells(), 100u + 3u * 2u);
    }



    TEST(MeshAdaptation, RanksLeaveOutCellsThatMayNotBeRefined)
    {
      for (const AdaptationStrategy strategy :
           {AdaptationStrategy::fixed_fraction,
            AdaptationStrategy::fixed_number})
        {
          // cells soon at the minimum size have most of the error
          const auto mesh       = unit_square(4);
          const auto parameters = adaptivity(strategy, 0.1);
          const auto estimate   = [&mesh] {
            return errors(*mesh, [](const Point<2> &p) {
              return p.norm() < 0.1 ? 1e6 : 10. - p.norm();
            });
          };
          EXPECT_TRUE(adapt(parameters, *mesh, estimate()));
          const unsigned int n_cells = mesh->n_active_cells();
          EXPECT_NEAR(smallest(*mesh), 0.125, 1e-12);
          EXPECT_TRUE(adapt(parameters, *mesh, estimate()));
          EXPECT_GT(mesh->n_active_cells(), n_cells);
          EXPECT_NEAR(smallest(*mesh), 0.125, 1e-12);
        }
    }



    TEST(MeshAdaptation, GradedCellsGrowWithTheDistanceFromTheContact)
    {
      for (const double half_length : {0., 0.3})
        {
          const auto mesh       = unit_square(4);
          const auto parameters = adaptivity(AdaptationStrategy::graded, 0.01);
          const ErrorRatios none;
          for (const double theta : {1., 0.5, 0.25})
            {
              EXPECT_TRUE(adapt(parameters, *mesh, none, half_length));
              EXPECT_NEAR(smallest(*mesh), 1. / 64., 1e-12);
              for (const auto &cell : mesh->active_cell_iterators())
                {
                  const Point<2> centre = cell->center();
                  const double   r      = centre.distance(
                    Point<2>(std::min(centre[0], half_length), 0.));
                  EXPECT_TRUE(cell_size(cell) <= theta * r ||
                              is_smallest(cell, parameters));
                  // no smaller than it must be, but for neighbours
                  EXPECT_GT(cell_size(cell), 0.1 * theta * r);
                }
            }
        }
    }



    TEST(MeshAdaptation, GradedKeepsToTheMaximumOfCells)
    {
      // a million cells of the smallest size lie along the line
      const auto mesh          = unit_square(4);
      auto       parameters    = adaptivity(AdaptationStrategy::graded);
      parameters.maximum_cells = 500;
      const ErrorRatios none;
      EXPECT_TRUE(adapt(parameters, *mesh, none, 0.5));
      EXPECT_LE(mesh->n_active_cells(), 500u);
      EXPECT_GT(mesh->n_active_cells(), 200u);
      EXPECT_FALSE(adapt(parameters, *mesh, none, 0.5));
    }



    TEST(MeshAdaptation, UniformHalvesEveryCell)
    {
      const auto mesh       = unit_square(3);
      const auto parameters = adaptivity(AdaptationStrategy::uniform, 0.1);
      const auto estimate =
        errors(*mesh, [](const Point<2> &p) { return p[0]; });
      EXPECT_TRUE(adapt(parameters, *mesh, estimate));
      EXPECT_EQ(mesh->n_active_cells(), 36u);
      EXPECT_FALSE(adapt(parameters, *mesh, estimate));
      EXPECT_FALSE(
        adapt(adaptivity(AdaptationStrategy::none), *mesh, estimate));
    }



    TEST(MeshAdaptation, UniformHalvesNoCellBelowTheMinimumSize)
    {
      const auto mesh = unit_square(3);
      mesh->begin_active()->set_refine_flag();
      mesh->execute_coarsening_and_refinement();
      const ErrorRatios error =
        errors(*mesh, [](const Point<2> &) { return 2.; });
      // the large cells could be halved, the four small ones not
      EXPECT_FALSE(
        adapt(adaptivity(AdaptationStrategy::uniform, 0.1), *mesh, error));
      EXPECT_EQ(mesh->n_active_cells(), 12u);
      EXPECT_TRUE(
        adapt(adaptivity(AdaptationStrategy::uniform, 0.05), *mesh, error));
      EXPECT_EQ(mesh->n_active_cells(), 48u);
    }



    TEST(MeshAdaptation, StrategiesThatHalveCellsPromiseNoMoreThanThereAre)
    {
      const auto mesh = unit_square(3);
      for (const AdaptationStrategy strategy :
           {AdaptationStrategy::uniform,
            AdaptationStrategy::none,
            AdaptationStrategy::fixed_number})
        EXPECT_EQ(n_wanted_cells(*mesh, {}, adaptivity(strategy)), 9.);
    }
  } // namespace
} // namespace PlateImpact
