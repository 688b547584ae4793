// Thin plates: which elements lock, on which meshes.
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    enum class MeshKind
    {
      squares,
      distorted,
      hanging_nodes
    };

    /// 8 x 8 cells on the quadrant of a unit plate: squares, with vertices
    /// moved at random by a quarter of the cell, or with three levels of
    /// hanging nodes.
    std::unique_ptr<Triangulation<2>>
    make_mesh(const PlateParameters &plate, const MeshKind kind)
    {
      auto mesh = make_plate_mesh(plate, {{8, 8}});
      if (kind == MeshKind::distorted)
        distort(*mesh, 0.25);
      if (kind == MeshKind::hanging_nodes)
        for (unsigned int level = 0; level < 3; ++level)
          {
            for (const auto &cell : mesh->active_cell_iterators())
              if (cell->center().norm() < 0.25 * std::pow(0.5, level))
                cell->set_refine_flag();
            mesh->execute_coarsening_and_refinement();
          }
      return mesh;
    }



    /// Centre deflection of a clamped plate under uniform load over the exact
    /// one.
    double
    deflection_ratio(const ElementType element_name,
                     const double      a_over_t,
                     const MeshKind    kind)
    {
      // tests/reference/static_plates.json; from 1e4 the thin plate's
      const double          exact = a_over_t < 50. ? 0.0015046256680685685 :
                 a_over_t < 500.                   ? 0.0012678585618577946 :
                 a_over_t < 5e3                    ? 0.0012653445941869725 :
                                                     0.00126531908748307;
      const PlateParameters plate =
        unit_plate(EdgeSupport::clamped, 1. / a_over_t);
      const PlateElement  element(element_name);
      const auto          mesh = make_mesh(plate, kind);
      PlateDiscretization model(*mesh, element, plate);
      model.assemble();
      const Eigen::VectorXd z =
        solve_static(model,
                     4. * model.load(pressure_load(*mesh, [](const Point<2> &) {
                       return 1.;
                     })));
      return model.load({{Point<2>(), 1.}}).dot(z) *
        model.section.bending_stiffness(0, 0) / exact;
    }



    constexpr auto all_meshes = {MeshKind::squares,
                                 MeshKind::distorted,
                                 MeshKind::hanging_nodes};



    std::string
    name_of(const MeshKind kind)
    {
      switch (kind)
        {
          case MeshKind::squares:
            return "squares";
          case MeshKind::distorted:
            return "distorted";
          default:
            return "hanging nodes";
        }
    }



    TEST(Locking, MixedInterpolationIsFreeOfIt)
    {
      for (const MeshKind kind : all_meshes)
        for (const double a_over_t : {10., 1e2, 1e3, 1e4, 1e5, 1e6})
          EXPECT_NEAR(deflection_ratio(ElementType::MITC9, a_over_t, kind),
                      1.,
                      0.003)
            << int(kind) << ' ' << a_over_t;
    }



    TEST(Locking, ElementOfThePaperLocks)
    {
      // what doc/theory.md says of the others, so that it stays true
      for (const MeshKind kind : all_meshes)
        EXPECT_LT(deflection_ratio(ElementType::serendipity, 1e5, kind), 0.5)
          << int(kind);
      // with 3x3 points for the shear before that with 2x2
      for (const MeshKind kind : all_meshes)
        EXPECT_LT(deflection_ratio(ElementType::serendipity_full, 1e3, kind),
                  deflection_ratio(ElementType::serendipity, 1e3, kind) - 0.01)
          << int(kind);
      EXPECT_NEAR(deflection_ratio(ElementType::heterosis,
                                   1e5,
                                   MeshKind::squares),
                  1.,
                  0.01);
      EXPECT_LT(deflection_ratio(ElementType::heterosis,
                                 1e5,
                                 MeshKind::distorted),
                0.97);
    }



    TEST(Locking, Table)
    {
      // a thinner plate is no less stiff; what round-off adds grows with the
      // square of the ratio, and is 1.6 % at most for seventeen ratios
      // around 1e6
      const auto round_off = [](const int exponent) {
        return exponent < 6 ? 1e-3 : 0.016;
      };
      for (const MeshKind kind : all_meshes)
        for (const ElementType name : all_elements())
          {
            double thicker = std::numeric_limits<double>::infinity();
            for (const int exponent : {1, 2, 3, 4, 5, 6})
              {
                const double ratio =
                  deflection_ratio(name, std::pow(10., exponent), kind);
                record(fmt::format("{}/{}/1e{}",
                                   name_of(kind),
                                   word_for(name),
                                   exponent),
                       ratio);
                EXPECT_GT(ratio, 0.);
                EXPECT_LT(ratio, 1. + round_off(exponent));
                EXPECT_LT(ratio, thicker + round_off(exponent))
                  << name_of(kind) << ' ' << name << ' ' << exponent;
                thicker = ratio;
              }
          }
    }



    /// Orders of the energy norm of the error between 4, 8, 16 and 32 cells a
    /// side, half of those of the strain energy: simply supported plate under a
    /// smooth load, squares or vertices moved at random on every mesh anew.
    std::array<double, 3>
    orders_of_convergence(const double a_over_t, const bool is_distorted)
    {
      const PlateParameters plate =
        unit_plate(EdgeSupport::simply_supported, 1. / a_over_t);
      const PlateElement element(ElementType::MITC9);
      const PlateSection section(plate);
      const double       pi = numbers::PI;
      // Navier: w = w_0 cos cos, load cos(pi x) cos(pi y), on the whole plate
      const double exact = 1. / 4. *
        (1. / (4. * pi * pi * pi * pi * section.bending_stiffness(0, 0)) +
         1. / (2. * pi * pi * section.mean_shear_stiffness()));
      std::array<double, 4> errors;
      for (unsigned int n = 0; n < 4; ++n)
        {
          const unsigned int cells = 4u << n;
          const auto         mesh  = make_plate_mesh(plate, {{cells, cells}});
          if (is_distorted)
            distort(*mesh, 0.25);
          PlateDiscretization model(*mesh, element, plate);
          model.assemble();
          const Eigen::VectorXd load =
            4. * model.load(pressure_load(*mesh, [pi](const Point<2> &p) {
              return std::cos(pi * p[0]) * std::cos(pi * p[1]);
            }));
          errors[n] = std::sqrt(
            std::abs(load.dot(solve_static(model, load)) / exact - 1.));
        }
      std::array<double, 3> orders;
      for (unsigned int n = 0; n < 3; ++n)
        orders[n] = std::log2(errors[n] / errors[n + 1]);
      return orders;
    }



    TEST(Locking, OrderOfConvergence)
    {
      for (const MeshKind kind : {MeshKind::squares, MeshKind::distorted})
        for (const int exponent : {1, 2, 3})
          {
            const auto orders =
              orders_of_convergence(std::pow(10., exponent),
                                    kind == MeshKind::distorted);
            for (unsigned int n = 0; n < orders.size(); ++n)
              record(
                fmt::format("{}/1e{}/{}", name_of(kind), exponent, 4u << n),
                orders[n]);
            EXPECT_GT(orders[1], 1.8);
          }
    }
  } // namespace
} // namespace PlateImpact
