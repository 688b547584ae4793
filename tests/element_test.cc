#include <deal.II/grid/grid_tools.h>

#include "plate_impact/plate/load_distribution.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    class PlateElementTest : public testing::TestWithParam<ElementType>
    {
    protected:
      const PlateElement element{GetParam()};

      PlateDiscretization
      free_model(const Triangulation<2> &mesh,
                 const double            thickness = 0.1) const
      {
        return PlateDiscretization(mesh,
                                   element,
                                   unit_plate(EdgeSupport::free, thickness),
                                   1.);
      }

      /// Largest strain error over the points where the element evaluates
      /// strains, for a field with constant strains.
      double
      strain_error(const PlateDiscretization &model,
                   const Field               &field,
                   const Resultants          &expected) const
      {
        const Eigen::VectorXd z     = interpolate(model, field);
        double                error = 0.;
        for (unsigned int c = 0; c < model.mesh().n_active_cells(); ++c)
          {
            const Eigen::VectorXd values = model.cell_values(c, z);
            for (const CellOperator *B : {&model.shape(c).at_quadrature.linear,
                                          &model.shape(c).at_samples.linear})
              {
                const Eigen::VectorXd strains = *B * values;
                for (Eigen::Index q = 0; q < strains.size(); q += 5)
                  error = std::max(
                    error,
                    (strains.segment<5>(q) - expected).cwiseAbs().maxCoeff());
              }
          }
        return error;
      }
    };

    INSTANTIATE_TEST_SUITE_P(
      All,
      PlateElementTest,
      testing::ValuesIn(all_elements()),
      [](const testing::TestParamInfo<ElementType> &info) {
        std::string name = word_for(info.param);
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
      });



    /// A mesh with hanging nodes and cells that are parallelograms.
    std::unique_ptr<Triangulation<2>>
    sheared_mesh()
    {
      auto mesh = unit_square(3);
      refine_randomly(*mesh, 2);
      GridTools::transform(
        [](const Point<2> &p) {
          return Point<2>(p[0] + 0.4 * p[1], 0.2 * p[0] + 0.8 * p[1]);
        },
        *mesh);
      return mesh;
    }



    /// A mesh with hanging nodes and general quadrilaterals.
    std::unique_ptr<Triangulation<2>>
    distorted_mesh()
    {
      auto mesh = unit_square(3);
      distort(*mesh, 0.25);
      refine_randomly(*mesh, 2);
      return mesh;
    }



    const Field      twist_and_bending([](const Point<2> &p) {
      // w = x^2 - x y + y^2/2, theta = grad w
      const double x = p[0], y = p[1];
      return Field::Values{{x * x - x * y + 0.5 * y * y, 2 * x - y, y - x}};
    });
    const Resultants twist_and_bending_strains =
      (Resultants() << 2., 1., -2., 0., 0.).finished();

    const Field      shear([](const Point<2> &p) {
      return Field::Values{{3. * p[0] - 2. * p[1], 1., -1.}};
    });
    const Resultants shear_strains =
      (Resultants() << 0., 0., 0., 2., -1.).finished();



    TEST_P(PlateElementTest, ConstantCurvatureIsExactOnParallelograms)
    {
      const auto mesh = sheared_mesh();
      EXPECT_LT(strain_error(free_model(*mesh),
                             twist_and_bending,
                             twist_and_bending_strains),
                1e-12);
    }



    TEST_P(PlateElementTest, ConstantShearIsExactOnGeneralQuadrilaterals)
    {
      const auto mesh = distorted_mesh();
      EXPECT_LT(strain_error(free_model(*mesh), shear, shear_strains), 1e-12);
    }



    TEST_P(PlateElementTest, ConstantCurvatureOnGeneralQuadrilaterals)
    {
      // Only nine nodes hold every quadratic there (Arnold, Boffi & Falk 2002,
      // doi:10.1090/S0025-5718-02-01439-4); the others lose an order.
      const auto   mesh  = distorted_mesh();
      const double error = strain_error(free_model(*mesh),
                                        twist_and_bending,
                                        twist_and_bending_strains);
      if (GetParam() == ElementType::Lagrange ||
          GetParam() == ElementType::MITC9)
        EXPECT_LT(error, 1e-12);
      else
        EXPECT_GT(error, 1e-3);
    }



    TEST_P(PlateElementTest, EnergyOfConstantStrainsIsThatOfTheSection)
    {
      const auto          mesh  = sheared_mesh();
      PlateDiscretization model = free_model(*mesh);
      const PlateSection  section(unit_plate(EdgeSupport::free, 0.1));
      model.assemble();
      const double area = GridTools::volume(*mesh);
      for (const auto &[field, strains] :
           {std::make_pair(&twist_and_bending, twist_and_bending_strains),
            std::make_pair(&shear, shear_strains)})
        {
          const Eigen::VectorXd z     = interpolate(model, *field);
          const Eigen::Vector3d k     = strains.head<3>();
          const double          exact = area *
            (k.dot(section.bending_stiffness * k) +
             section.mean_shear_stiffness() * strains.tail<2>().squaredNorm());
          EXPECT_NEAR(z.dot(multiply(model.stiffness(), z)) / exact, 1., 1e-12);
        }
    }



    TEST_P(PlateElementTest, MassIsThatOfTheRigidBody)
    {
      const auto          mesh  = distorted_mesh();
      PlateDiscretization model = free_model(*mesh);
      model.assemble();
      const Eigen::VectorXd lift =
        interpolate(model, Field([](const Point<2> &) {
                      return Field::Values{{1., 0., 0.}};
                    }));
      EXPECT_NEAR(lift.dot(multiply(model.mass(), lift)), 0.1, 1e-13);
      const Eigen::VectorXd tilt =
        interpolate(model, Field([](const Point<2> &) {
                      return Field::Values{{0., 1., 0.}};
                    }));
      EXPECT_NEAR(tilt.dot(multiply(model.mass(), tilt)), 1e-3 / 12., 1e-15);
    }



    TEST_P(PlateElementTest, MassHasThatOfEdgesInAnyDirection)
    {
      // a round edge that holds the rotation along it couples both components
      PlateParameters plate    = unit_plate(EdgeSupport::simply_supported, 0.5);
      plate.outline.shape      = PlateOutline::circle;
      const auto          mesh = make_plate_mesh(plate, {{2, 2}});
      PlateDiscretization model(*mesh, element, plate, 1.);
      model.assemble();
      const Eigen::VectorXd z =
        Eigen::VectorXd::LinSpaced(model.n_unknowns(), -1., 2.).array().sin();
      double of_cells = 0.;
      for (unsigned int c = 0; c < mesh->n_active_cells(); ++c)
        {
          const Eigen::VectorXd values = model.cell_values(c, z);
          of_cells +=
            values.dot(element.mass(model.shape(c), model.section) * values);
        }
      expect_near(z.dot(multiply(model.mass(), z)), of_cells, 1e-12);
    }



    TEST_P(PlateElementTest, FreePlateHasThreeRigidModes)
    {
      for (const unsigned int n : {1, 3})
        {
          const auto          mesh  = unit_square(n);
          PlateDiscretization model = free_model(*mesh);
          model.assemble();
          const Eigen::VectorXd eigenvalues =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
              dense(model.stiffness()),
              Eigen::EigenvaluesOnly)
              .eigenvalues();
          const int n_zero =
            (eigenvalues.array() < 1e-12 * eigenvalues.maxCoeff()).count();
          // the spurious mode of nine nodes with 2x2 shear survives the
          // assembly of a uniform mesh
          EXPECT_EQ(n_zero, GetParam() == ElementType::Lagrange ? 4 : 3) << n;
        }
    }



    TEST_P(PlateElementTest, HangingNodesKeepFieldsContinuous)
    {
      // values on both sides of every point of the skeleton agree
      const auto mesh = unit_square(2);
      refine_randomly(*mesh, 3);
      const PlateDiscretization model = free_model(*mesh);
      const Eigen::VectorXd     z = Eigen::VectorXd::Random(model.n_unknowns());
      const FE_Q<2>             scalar(2);
      std::map<std::pair<long, long>, double> seen;
      unsigned int                            n_compared = 0;
      for (const auto &cell : mesh->active_cell_iterators())
        {
          const Eigen::VectorXd values =
            model.cell_values(cell->active_cell_index(), z);
          for (unsigned int i = 0; i <= 8; ++i)
            for (const Point<2> unit : {Point<2>(i / 8., 0.),
                                        Point<2>(i / 8., 1.),
                                        Point<2>(0., i / 8.),
                                        Point<2>(1., i / 8.)})
              {
                double w = 0.;
                for (unsigned int node = 0; node < 9; ++node)
                  w += scalar.shape_value(node, unit) *
                    values(element.finite_element
                             .component_to_system_index(deflection, node),
                           0);
                const double   h = cell->extent_in_direction(0);
                const Point<2> p = cell->vertex(0) + h * (unit - Point<2>());
                const auto [entry, is_new] = seen.insert(
                  {{std::lround(p[0] * 4096), std::lround(p[1] * 4096)}, w});
                n_compared += !is_new;
                EXPECT_NEAR(entry->second, w, 1e-13);
              }
        }
      EXPECT_GT(n_compared, 100u);
    }



    TEST(LoadDistribution, WeightsAndSecondMomentsAreThoseOfTheDisc)
    {
      ContactParameters contact;
      contact.patch_radius = 0.3;
      for (const auto &[name, moment] :
           {std::make_pair(LoadShape::Hertz_disc, 0.4),
            std::make_pair(LoadShape::uniform_disc, 0.5)})
        {
          contact.load_distribution = name;
          double total = 0., second = 0., x2 = 0.;
          for (const LoadPoint &p : make_load_distribution(contact, 0.2))
            {
              total += p.weight;
              second += p.weight * p.point.square();
              x2 += p.weight * p.point[0] * p.point[0];
              EXPECT_LE(p.point.norm(), 0.3);
            }
          EXPECT_NEAR(total, 1., 1e-13);
          EXPECT_NEAR(second, moment * 0.09, 1e-13);
          EXPECT_NEAR(x2, 0.5 * moment * 0.09, 1e-13);
        }
    }



    TEST(LoadDistribution, WeightsAndSecondMomentsAreThoseOfTheStrip)
    {
      ContactParameters contact;
      contact.patch_radius = 0.1;
      for (const auto &[name, moment] :
           {std::make_pair(LoadShape::line, 0.),
            std::make_pair(LoadShape::strip, 0.25)})
        {
          contact.load_distribution = name;
          double total = 0., x2 = 0., y2 = 0.;
          for (const LoadPoint &p : make_load_distribution(contact, 0.6))
            {
              total += p.weight;
              x2 += p.weight * p.point[0] * p.point[0];
              y2 += p.weight * p.point[1] * p.point[1];
            }
          EXPECT_NEAR(total, 1., 1e-13);
          EXPECT_NEAR(x2, 0.09 / 3., 1e-13);
          EXPECT_NEAR(y2, moment * 0.01, 1e-13);
        }
    }



    TEST(LoadDistribution, EveryCellGetsItsShare)
    {
      // On fewer points than cells, a line is a row of point loads.
      ContactParameters contact;
      contact.patch_radius           = 1e-6;
      const double       half_length = 0.3;
      const unsigned int n_cells     = 1000;
      for (const LoadShape shape : {LoadShape::line, LoadShape::strip})
        {
          contact.load_distribution = shape;
          std::vector<double> shares(n_cells, 0.);
          for (const LoadPoint &p :
               make_load_distribution(contact,
                                      2. * half_length,
                                      half_length / n_cells))
            shares.at(p.point[0] / half_length * n_cells) += p.weight;
          for (const double share : shares)
            EXPECT_NEAR(share, 1. / n_cells, 1e-9);
        }

      // rings of one cell, by area
      contact.load_distribution   = LoadShape::uniform_disc;
      const unsigned int  n_rings = 40;
      std::vector<double> shares(n_rings, 0.);
      for (const LoadPoint &p :
           make_load_distribution(contact, 0., contact.patch_radius / n_rings))
        shares.at(p.point.norm() / contact.patch_radius * n_rings) += p.weight;
      for (unsigned int i = 0; i < n_rings; ++i)
        EXPECT_NEAR(shares[i] / ((2. * i + 1.) / (n_rings * n_rings)), 1., 0.2)
          << i;
    }



    TEST(LoadDistribution, WorkDoesNotDependOnTheMesh)
    {
      // on any mesh the load does the work of its moments on a quadratic
      ContactParameters contact;
      contact.load_distribution = LoadShape::Hertz_disc;
      contact.patch_radius      = 0.3;
      const PlateElement element(ElementType::Lagrange);
      for (const unsigned int n_refinements : {0, 1, 2})
        {
          auto mesh = unit_square(3);
          distort(*mesh, 0.2);
          refine_randomly(*mesh, n_refinements);
          const PlateDiscretization model(*mesh,
                                          element,
                                          unit_plate(EdgeSupport::free, 0.1),
                                          1.);
          const Eigen::VectorXd     z =
            interpolate(model, Field([](const Point<2> &p) {
                          return Field::Values{{1. + p.square(), 0., 0.}};
                        }));
          EXPECT_NEAR(model.load(make_load_distribution(contact, 0.2)).dot(z),
                      1. + 0.4 * 0.09,
                      1e-12);
        }
    }
  } // namespace
} // namespace PlateImpact
