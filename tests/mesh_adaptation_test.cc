#include "plate_impact/mesh_adaptation.h"
#include "test_plate.h"

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    AdaptivityParameters
    adaptivity(const std::string &strategy, const double minimum_size = 1e-6)
    {
      AdaptivityParameters parameters;
      parameters.strategy          = strategy;
      parameters.size_exponent     = 0.5;
      parameters.minimum_cell_size = minimum_size;
      return parameters;
    }



    ErrorEstimate
    errors(const Triangulation<2>                        &mesh,
           const std::function<double(const Point<2> &)> &xi)
    {
      ErrorEstimate estimate;
      for (const auto &cell : mesh.active_cell_iterators())
        estimate.element_errors.push_back(xi(cell->center()));
      return estimate;
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
                     adaptivity("hanging nodes"));
      for (const double size : sizes)
        EXPECT_NEAR(size, 0.25 / 4., 1e-15);
    }



    TEST(MeshAdaptation, SeveralLevelsAtOnceWhereAskedFor)
    {
      const auto mesh       = unit_square(4);
      const auto parameters = adaptivity("hanging nodes");
      const auto estimate   = errors(*mesh, [](const Point<2> &p) {
        return p.norm() < 0.2 ? 200. : 0.9;
      });
      EXPECT_TRUE(make_mesh_adaptation(parameters)->adapt(*mesh, estimate));
      // sqrt(200) asks for 14.1 times smaller cells: four levels
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
      const auto parameters = adaptivity("hanging nodes");
      const auto adaptation = make_mesh_adaptation(parameters);
      adaptation->adapt(*mesh,
                        errors(*mesh, [](const Point<2> &) { return 50.; }));
      EXPECT_EQ(mesh->n_active_cells(), 4u * 64u);
      adaptation->adapt(*mesh, errors(*mesh, [](const Point<2> &p) {
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
      const auto mesh       = unit_square(3);
      const auto parameters = adaptivity("hanging nodes", 0.1);
      const auto adaptation = make_mesh_adaptation(parameters);
      adaptation->adapt(*mesh,
                        errors(*mesh, [](const Point<2> &) { return 1e9; }));
      EXPECT_NEAR(smallest(*mesh), 1. / 6., 1e-12);
      EXPECT_TRUE(is_smallest(mesh->begin_active(), parameters));
      adaptation->adapt(*mesh,
                        errors(*mesh, [](const Point<2> &) { return 0.; }));
      EXPECT_EQ(mesh->n_active_cells(), 9u);
    }



    TEST(MeshAdaptation, ReportsThatAMeshStaysAsItIs)
    {
      const auto mesh       = unit_square(3);
      const auto adaptation = make_mesh_adaptation(adaptivity("hanging nodes"));
      EXPECT_FALSE(adaptation->adapt(*mesh, errors(*mesh, [](const Point<2> &) {
        return 0.8;
      })));
      EXPECT_EQ(mesh->n_active_cells(), 9u);
    }



    TEST(MeshAdaptation, UniformHalvesEveryCell)
    {
      const auto mesh       = unit_square(3);
      const auto adaptation = make_mesh_adaptation(adaptivity("uniform", 0.1));
      const auto estimate =
        errors(*mesh, [](const Point<2> &p) { return p[0]; });
      EXPECT_TRUE(adaptation->adapt(*mesh, estimate));
      EXPECT_EQ(mesh->n_active_cells(), 36u);
      EXPECT_FALSE(adaptation->adapt(*mesh, estimate));
      EXPECT_EQ(make_mesh_adaptation(adaptivity("none")), nullptr);
    }
  } // namespace
} // namespace PlateImpact
