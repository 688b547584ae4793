#include <deal.II/grid/grid_tools.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/adaptation/quad_mesher.h"
#include "plate_impact/base/exceptions.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    const std::vector<Point<2>> square = {{0., 0.},
                                          {0.3, 0.},
                                          {1., 0.},
                                          {1., 1.},
                                          {0., 1.}};



    /// Of a square with the same size everywhere.
    QuadMesh
    mesh_with_size(
      const double                       size,
      std::vector<std::string>          &warnings,
      const std::vector<MesherSettings> &attempts = default_mesher_settings)
    {
      return mesh_by_gmsh(square,
                          {},
                          *unit_square(1),
                          std::vector<double>(4, size),
                          warnings,
                          attempts);
    }



    double
    area(const QuadMesh &mesh)
    {
      double result = 0.;
      for (const auto &cell : mesh.cells)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Point<2> &a = mesh.vertices[cell[v]],
                           &b = mesh.vertices[cell[(v + 1) % 4]];
            result += 0.5 * (a[0] * b[1] - a[1] * b[0]);
          }
      return result;
    }



    QuadMesh
    mesh_square(
      const double                       size,
      const std::vector<MesherSettings> &attempts = default_mesher_settings,
      const bool                         expects_warning = false)
    {
      std::vector<std::string> warnings;
      const QuadMesh           mesh = mesh_with_size(size, warnings, attempts);
      EXPECT_EQ(warnings.size(), expects_warning ? 1u : 0u);
      EXPECT_NEAR(area(mesh), 1., 1e-12);
      for (const Point<2> &corner : square)
        EXPECT_EQ(std::count(mesh.vertices.begin(),
                             mesh.vertices.end(),
                             corner),
                  1);
      return mesh;
    }



    TEST(QuadMesher, MakesGoodCellsOfTheSizeAskedFor)
    {
      for (const double size : {0.02, 0.1, 0.3})
        {
          const QuadMesh mesh = mesh_square(size);
          EXPECT_GT(mesh.worst_scaled_jacobian(), 0.5) << size;
          EXPECT_GT(mesh.cells.size(), 0.7 / (size * size));
          EXPECT_LT(mesh.cells.size(), 2.5 / (size * size));
        }
    }



    TEST(QuadMesher, GivesTheSameMeshForTheSameSizes)
    {
      const QuadMesh once = mesh_square(0.05), again = mesh_square(0.05);
      EXPECT_EQ(once.vertices, again.vertices);
      EXPECT_EQ(once.cells, again.cells);
    }



    TEST(QuadMesher, SaysNothingOnStandardOutput)
    {
      testing::internal::CaptureStdout();
      testing::internal::CaptureStderr();
      std::vector<std::string> warnings;
      mesh_with_size(0.1, warnings);
      EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }



    const MesherSettings triangles = {"triangles", 6, -1, 0, 1.};



    TEST(QuadMesher, TriesSaferSettingsWhereTrianglesAreLeft)
    {
      const std::vector<MesherSettings> attempts = {triangles,
                                                    default_mesher_settings[1]};
      const QuadMesh                    mesh = mesh_square(0.1, attempts, true);
      std::vector<std::string>          warnings;
      mesh_with_size(0.1, warnings, attempts);
      EXPECT_NE(warnings.front().find("triangles are left"), std::string::npos)
        << warnings.front();
      EXPECT_GT(mesh.worst_scaled_jacobian(), 0.3);
      EXPECT_GT(mesh.cells.size(), 70u);
      EXPECT_LT(mesh.cells.size(), 250u);
    }



    TEST(QuadMesher, RefusesWithASentenceWhereNothingWorks)
    {
      std::vector<std::string> warnings;
      try
        {
          mesh_with_size(0.1, warnings, {triangles, triangles});
          FAIL() << "a mesh of triangles was accepted";
        }
      catch (const ComputationError &error)
        {
          EXPECT_NE(std::string(error.what()).find("triangles are left"),
                    std::string::npos)
            << error.what();
        }
    }



    TEST(QuadMesher, MeasuresTheWorstCorner)
    {
      QuadMesh mesh;
      mesh.vertices = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
      mesh.cells    = {{{0, 1, 2, 3}}};
      EXPECT_NEAR(mesh.worst_scaled_jacobian(), 1., 1e-15);
      mesh.vertices[2] = Point<2>(0.75, 0.5);
      EXPECT_GT(mesh.worst_scaled_jacobian(), 0.);
      mesh.vertices[2] = Point<2>(0.25, 0.25); // a re-entrant corner
      EXPECT_LT(mesh.worst_scaled_jacobian(), 0.);
      mesh.vertices[2] = mesh.vertices[1]; // a side without length
      EXPECT_FALSE(mesh.worst_scaled_jacobian() > 0.);
      mesh.vertices[2] = Point<2>(1., 1.);
      mesh.cells       = {{{0, 3, 2, 1}}}; // clockwise
      EXPECT_LT(mesh.worst_scaled_jacobian(), 0.);
    }



    const double half_side = 0.1, half_length = 0.033;

    /// The quadrant of a rectangular plate with half sides of 0.1 and 0.06 m.
    std::unique_ptr<Triangulation<2>>
    quadrant()
    {
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.01);
      plate.side_lengths    = {{2. * half_side, 0.12}};
      return make_plate_mesh(plate, {{5, 3}});
    }



    AdaptivityParameters
    adaptivity()
    {
      AdaptivityParameters parameters{};
      parameters.strategy          = AdaptationStrategy::remeshing;
      parameters.target_error      = 0.05;
      parameters.size_exponent     = 0.5;
      parameters.minimum_cell_size = 1e-3;
      parameters.maximum_cell_size = 0.02;
      return parameters;
    }



    /// Errors as large as a size field with cells of `fine` at the impact asks
    /// for.
    ErrorRatios
    errors(const Triangulation<2> &mesh, const double fine)
    {
      ErrorRatios error;
      error.overall = 2.;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const double ratio =
            cell_size(cell) / (fine + 0.3 * cell->center().norm());
          error.elements.push_back(ratio * ratio);
        }
      return error;
    }



    bool
    remesh_to(Triangulation<2> &mesh,
              const double      fine,
              const double      contact_half_length = 0.)
    {
      std::vector<std::string> warnings;
      const bool               is_changed = adapt_mesh({mesh,
                                                        errors(mesh, fine),
                                                        adaptivity(),
                                                        contact_half_length,
                                                        warnings});
      EXPECT_TRUE(warnings.empty()) << warnings.front();
      return is_changed;
    }



    unsigned int
    n_vertices_at(const Triangulation<2> &mesh, const Point<2> &point)
    {
      return std::count(mesh.get_vertices().begin(),
                        mesh.get_vertices().end(),
                        point);
    }



    TEST(Remeshing, KeepsTheDomainItsSidesAndTheEndsOfTheContact)
    {
      const auto mesh = quadrant();
      for (const double fine : {0.002, 0.004, 0.01, 0.002})
        {
          ASSERT_TRUE(remesh_to(*mesh, fine, half_length));
          double                               area = 0.;
          std::map<types::boundary_id, double> lengths;
          for (const auto &cell : mesh->active_cell_iterators())
            {
              area += cell->measure();
              for (const unsigned int v : cell->vertex_indices())
                {
                  // counter-clockwise around the corner
                  const unsigned int next[] = {1, 3, 0, 2};
                  const unsigned int last[] = {2, 0, 3, 1};
                  const Tensor<1, 2> a =
                                       cell->vertex(next[v]) - cell->vertex(v),
                                     b =
                                       cell->vertex(last[v]) - cell->vertex(v);
                  EXPECT_GT(a[0] * b[1] - a[1] * b[0],
                            0.15 * a.norm() * b.norm());
                }
              for (const unsigned int f : cell->face_indices())
                if (cell->at_boundary(f))
                  lengths[cell->face(f)->boundary_id()] +=
                    cell->face(f)->measure();
            }
          EXPECT_NEAR(area, 0.006, 1e-15);
          EXPECT_NEAR(lengths[symmetry_x], 0.06, 1e-15);
          EXPECT_NEAR(lengths[edge_x], 0.06, 1e-15);
          EXPECT_NEAR(lengths[symmetry_y], half_side, 1e-15);
          EXPECT_NEAR(lengths[edge_y], half_side, 1e-15);
          EXPECT_EQ(n_vertices_at(*mesh, Point<2>()), 1u);
          EXPECT_EQ(n_vertices_at(*mesh, Point<2>(half_length, 0.)), 1u);
        }
    }



    TEST(Remeshing, FollowsTheTargetSizesWithinTheirLimits)
    {
      const auto mesh = quadrant();
      for (unsigned int cycle = 0; cycle < 3; ++cycle)
        remesh_to(*mesh, 1e-4); // below the minimum
      double smallest = 1., largest = 0.;
      for (const auto &cell : mesh->active_cell_iterators())
        {
          smallest = std::min(smallest, cell_size(cell));
          largest  = std::max(largest, cell_size(cell));
          // nowhere far above the target
          EXPECT_LT(cell_size(cell),
                    2. * std::max(1e-3, 0.3 * cell->center().norm()));
        }
      EXPECT_GT(smallest, 0.5e-3);
      EXPECT_LT(smallest, 1.5e-3);
      EXPECT_LT(largest, 2. * 0.02);
      EXPECT_GT(largest, 0.01);
    }



    TEST(Remeshing, KnowsHowManyCellsItWillMake)
    {
      // every cell to be half as long, as its error has it
      const auto  mesh = quadrant();
      ErrorRatios error;
      error.overall = 4.;
      error.elements.assign(mesh->n_active_cells(), 4.);
      const double expected = n_wanted_cells(*mesh, error, adaptivity());
      std::vector<std::string> warnings;
      ASSERT_TRUE(adapt_mesh({*mesh, error, adaptivity(), 0., warnings}));
      // the longest side of a cell, its size, is above the root of its area
      EXPECT_LT(mesh->n_active_cells() / expected, 1.5);
      EXPECT_GT(mesh->n_active_cells() / expected, 0.8);
    }



    TEST(Remeshing, HasVerticesOfThreeAndOfFiveCells)
    {
      // what the tests of elements and recovery on such meshes rely on
      const auto mesh =
        make_plate_mesh(unit_plate(EdgeSupport::clamped, 0.1), {{6, 6}});
      remesh(*mesh, 0.05, 0.3);
      std::map<unsigned int, unsigned int> n_vertices;
      for (const auto &cells : GridTools::vertex_to_cell_map(*mesh))
        ++n_vertices[cells.size()];
      EXPECT_GT(n_vertices[3], 0u);
      EXPECT_GT(n_vertices[5], 0u);
    }



    TEST(Remeshing, KeepsAMeshThatMeetsItsTarget)
    {
      const auto   mesh     = quadrant();
      unsigned int n_meshes = 0;
      for (bool is_changed = true; is_changed && n_meshes < 10; ++n_meshes)
        {
          ErrorRatios error = errors(*mesh, 0.004);
          error.overall     = 0.8;
          std::vector<std::string> warnings;
          is_changed = adapt_mesh({*mesh, error, adaptivity(), 0., warnings});
        }
      EXPECT_LT(n_meshes, 5u);
    }



    TEST(Remeshing, CellsGrowToTheLargestSizeWhereThereIsNoError)
    {
      const auto mesh = quadrant();
      remesh_to(*mesh, 0.01);
      ErrorRatios error;
      error.elements.assign(mesh->n_active_cells(), 1e-4);
      std::vector<std::string> warnings;
      EXPECT_TRUE(adapt_mesh({*mesh, error, adaptivity(), 0., warnings}));
      // 24 are 0.02 large where sides have an even number of them
      EXPECT_LT(mesh->n_active_cells(), 30u);
      // and stays so
      error.elements.assign(mesh->n_active_cells(), 1e-4);
      EXPECT_FALSE(adapt_mesh({*mesh, error, adaptivity(), 0., warnings}));
    }
  } // namespace
} // namespace PlateImpact
