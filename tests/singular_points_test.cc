// Where a stress has no bound, how strongly, and what the mesh makes of it.
#include <deal.II/grid/grid_generator.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <complex>

namespace PlateImpact
{
  namespace
  {
    constexpr EdgeSupport clamped = EdgeSupport::clamped,
                          simple  = EdgeSupport::simply_supported,
                          soft    = EdgeSupport::soft_simply_supported,
                          free    = EdgeSupport::free;

    double
    strength(const double      degrees,
             const EdgeSupport one,
             const EdgeSupport other)
    {
      return corner_strength(degrees / 180. * M_PI, {{one, other}}, 0.3);
    }



    /// The determinant of the conditions on both sides of a wedge in plane
    /// stress for Kolosov's functions a z^x and b z^x, by the definition.
    double
    determinant(const double                      x,
                const double                      angle,
                const std::array<EdgeSupport, 2> &supports)
    {
      using Number          = std::complex<double>;
      const double    kappa = (3. - 0.3) / (1. + 0.3);
      const Number    i(0., 1.);
      Eigen::Matrix4d conditions;
      for (const unsigned int side : {0, 1})
        for (const unsigned int column : {0, 1, 2, 3})
          {
            const double theta  = side * angle;
            const Number factor = column % 2 == 0 ? 1. : i,
                         phi =
                           column < 2 ? factor * std::exp(i * x * theta) : 0.,
                         slope = column < 2 ?
              factor * x * std::exp(i * (x - 1.) * theta) :
              0.,
                         psi =
                           column < 2 ? 0. : factor * std::exp(i * x * theta),
                         z = std::exp(i * theta),
                         displacement =
                           kappa * phi - z * std::conj(slope) - std::conj(psi),
                         force = phi + z * std::conj(slope) + std::conj(psi);
            Number values      = force; // free
            if (supports[side] == clamped)
              values = displacement;
            else if (supports[side] == simple)
              values = {(std::conj(z) * displacement).real(),
                        (std::conj(z) * force).real()};
            conditions(2 * side, column)     = values.real();
            conditions(2 * side + 1, column) = values.imag();
          }
      return conditions.determinant();
    }



    TEST(CornerStrength, IsThatOfAWedgeInPlaneStress)
    {
      // of cracks, a clamped edge that is let go, and corners
      EXPECT_NEAR(strength(360., free, free), 0.5, 1e-6);
      EXPECT_NEAR(strength(360., clamped, clamped), 0.5, 1e-6);
      EXPECT_NEAR(strength(180., clamped, free), 0.5, 1e-6);
      EXPECT_NEAR(strength(270., free, free), 0.5445, 1e-4);
      EXPECT_NEAR(strength(270., simple, simple), 1. / 3., 1e-6);
      EXPECT_NEAR(strength(120., simple, simple), 0.5, 1e-6);
      const std::vector<EdgeSupport> all = {clamped, simple, free};
      for (const EdgeSupport one : all)
        for (const EdgeSupport other : all)
          for (const double degrees : {75., 90., 120., 150., 200., 270., 330.})
            {
              const double found = strength(degrees, one, other);
              EXPECT_DOUBLE_EQ(found, strength(degrees, other, one));
              const double angle = degrees / 180. * M_PI;
              // none below it, but where a pair of complex ones is
              double before = determinant(0.02, angle, {{one, other}});
              for (double x = 0.03; x < found - 0.005; x += 0.01)
                {
                  const double here = determinant(x, angle, {{one, other}});
                  EXPECT_GT(here * before, 0.) << degrees << ' ' << x;
                  before = here;
                }
              const bool is_of_deflection =
                std::abs(found - M_PI / angle) < 1e-9 ||
                std::abs(found - 0.5 * M_PI / angle) < 1e-9;
              if (found < 1. && (one == free) + (other == free) != 1 &&
                  !is_of_deflection)
                {
                  EXPECT_NEAR(determinant(found, angle, {{one, other}}),
                              0.,
                              1e-6)
                    << degrees;
                }
            }
    }



    TEST(CornerStrength, OfTheDeflectionWhereItIsTheStronger)
    {
      // w is held on one side only: a membrane's pi / (2 alpha)
      EXPECT_NEAR(strength(330., soft, free), 90. / 330., 1e-9);
    }



    std::vector<SingularPoint>
    points_of(const std::string &scene, const std::vector<std::string> &set)
    {
      return singular_points(
        read_scene(SCENES "/" + scene + ".prm", set).parameters);
    }



    TEST(SingularPoints, FollowFromOutlineAndLoad)
    {
      const std::string main = "sphere-on-steel-plate";
      EXPECT_TRUE(points_of(main, {}).empty());
      EXPECT_TRUE(points_of(main, {"Plate/Support=simply supported"}).empty());
      EXPECT_TRUE(points_of("round-plate", {}).empty());
      EXPECT_TRUE(points_of(main,
                            {"Plate/Support=free, clamped",
                             "Adaptivity/Singular points=none"})
                    .empty());
      const auto corner = points_of(main, {"Plate/Support=free, clamped"});
      ASSERT_EQ(corner.size(), 1u);
      EXPECT_NEAR(corner[0].position[0], 0.1, 1e-12);
      EXPECT_NEAR(corner[0].position[1], 0.1, 1e-12);
      EXPECT_NEAR(corner[0].strength, 0.7583, 1e-4);
      // the whole plate, with the impact off its centre
      EXPECT_EQ(points_of(main,
                          {"Plate/Support=free, clamped",
                           "Plate/Impact point=0.01, 0.02"})
                  .size(),
                4u);

      EXPECT_TRUE(points_of("l-plate", {}).empty()); // the goal is the force
      const auto inner = points_of("l-plate", {"Adaptivity/Goal=energy norm"});
      ASSERT_EQ(inner.size(), 1u);
      EXPECT_NEAR(inner[0].position[0], 0.05, 1e-9);
      EXPECT_NEAR(inner[0].position[1], 0.05, 1e-9);
      EXPECT_NEAR(inner[0].strength, 1. / 3., 1e-6);

      const auto end = points_of("paper-cylinder", {});
      ASSERT_EQ(end.size(), 1u);
      EXPECT_NEAR(end[0].position[0], 0.5 * 0.066667, 1e-9);
      EXPECT_EQ(end[0].strength, 1.);
      const auto load = points_of("paper-sphere", {});
      ASSERT_EQ(load.size(), 1u);
      EXPECT_EQ(load[0].strength, 0.);
    }



    TEST(SingularPoints, NamedOnesMoveWithThePlate)
    {
      const auto mirrored =
        points_of("sphere-on-steel-plate",
                  {"Adaptivity/Singular points=-0.05, 0.02, 0.5; 0, 0, 0.6"});
      ASSERT_EQ(mirrored.size(), 2u);
      EXPECT_NEAR(mirrored[0].position[0], 0.05, 1e-12);
      EXPECT_NEAR(mirrored[0].position[1], 0.02, 1e-12);
      EXPECT_EQ(mirrored[1].strength, 0.6);
      // a round plate turns with the impact to the x axis
      const auto turned = points_of("round-plate",
                                    {"Plate/Impact point=0, 0.02",
                                     "Adaptivity/Singular points=0.01, 0.05, "
                                     "0.5"});
      ASSERT_EQ(turned.size(), 1u);
      EXPECT_NEAR(turned[0].position[0], 0.03, 1e-12);
      EXPECT_NEAR(turned[0].position[1], 0.01, 1e-12);
    }



    TEST(SingularPoints, CellsGrowWithTheDistanceFromThem)
    {
      dealii::Triangulation<2> mesh(
        dealii::Triangulation<2>::limit_level_difference_at_vertices);
      dealii::GridGenerator::subdivided_hyper_cube(mesh, 2);
      AdaptivityParameters adaptivity =
        read_scene(SCENES "/sphere-on-steel-plate.prm", {})
          .parameters.adaptivity;
      adaptivity.maximum_cell_size = 0.5;
      adaptivity.minimum_cell_size = 1e-9;
      std::vector<std::string> warnings;
      const double             ratio    = 8.;
      adaptivity.singular_points.points = {{{{1., 1.}}, 1. / 3.}};
      const ErrorRatios error{ratio, 1., {0.9, 0.9, 0.9, ratio}};
      EXPECT_GT(n_wanted_cells(mesh, error, adaptivity), 10.);
      EXPECT_LT(n_wanted_cells(mesh, error, adaptivity), 60.);
      ASSERT_TRUE(adapt_mesh({mesh, error, adaptivity, 0., warnings}));
      // h / xi'^3 at the point, nine halvings: in the whole cell they would
      // make a quarter of a million
      EXPECT_LT(mesh.n_active_cells(), 120u);
      EXPECT_DOUBLE_EQ(smallest_cell_size(mesh), 0.5 / 512.);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const double distance = cell->center().distance({1., 1.});
          EXPECT_LT(cell_size(cell), 2. * distance);
        }
    }



    TEST_F(Program, CountsAllCellsWhereTheSceneSaysSo)
    {
      const std::string scene = SCENES "/paper-sphere.prm";
      ASSERT_EQ(run(scene, ""), 0) << err;
      const auto counted = last_cycle();
      EXPECT_EQ(counted["discretization_error"],
                counted["discretization_error_of_all_cells"]);
      EXPECT_GT(counted["cells_above_limit"], 0);
      EXPECT_NE(summary()["outcome"], "target reached");
      EXPECT_NE(err.find("eta counts "), std::string::npos) << err;

      ASSERT_EQ(run(scene,
                    "--set 'Adaptivity/Cells at singularities=left out'"),
                0)
        << err;
      const auto left_out = last_cycle();
      EXPECT_EQ(left_out["discretization_error"],
                left_out["discretization_error_of_regular_cells"]);
      EXPECT_LT(left_out["discretization_error"],
                left_out["discretization_error_of_all_cells"]);
    }



    TEST_F(Program, AsksTheSingularCellsForTheSizeThatTheyNeed)
    {
      ASSERT_EQ(run(SCENES "/course/11-re-entrant-corner.prm",
                    "--set 'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      const double smallest = std::stod(
        summary()["inputs"]["Adaptivity/Minimum cell size"].get<std::string>());
      std::istringstream rows(text(results() / "element_errors_cycle_2.csv"));
      std::string        row;
      std::getline(rows, row);
      unsigned int n_singular = 0, n_smallest = 0;
      while (std::getline(rows, row))
        {
          std::istringstream  cells(row);
          std::vector<double> numbers;
          for (std::string cell; std::getline(cells, cell, ',');)
            numbers.push_back(std::stod(cell));
          const double size = numbers[3], error = numbers[4],
                       target = numbers[5],
                       distance =
                         std::hypot(numbers[1] - 0.05, numbers[2] - 0.05);
          if (error < 1.)
            continue;
          if (distance < size)
            {
              // smaller than what is chosen for the load, and to be refined
              ++n_singular;
              EXPECT_LT(size, smallest);
              EXPECT_NEAR(target / size * std::pow(error, 3.), 1., 1e-6);
            }
          else if (0.5 * size < smallest)
            ++n_smallest;
        }
      EXPECT_EQ(n_singular, 3u);
      EXPECT_EQ(last_cycle()["cells_at_minimum_size"], n_smallest);
    }



    TEST_F(Program, RefusesSingularPointsThatAreNone)
    {
      const std::string scene = SCENES "/sphere-on-steel-plate.prm",
                        entry = "--set 'Adaptivity/Singular points=";
      for (const std::string wrong :
           {"0.1, 0", "0, 0, 0.1", "0, 0, 0.5; 1", "here", "0, 0, 5"})
        {
          EXPECT_EQ(run(scene, entry + wrong + "'"), 1);
          EXPECT_NE(err.find("automatic | none | x, y, lambda"),
                    std::string::npos)
            << err;
        }
      EXPECT_EQ(run(scene, entry + "0.2, 0, 0.5'"), 1);
      EXPECT_NE(err.find("0.2 m, 0 m, which is not on the plate"),
                std::string::npos)
        << err;
    }
  } // namespace
} // namespace PlateImpact
