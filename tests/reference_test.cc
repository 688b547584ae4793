// Static deflections and frequencies against series and Ritz solutions of high
// order (tests/reference).
#include "plate_impact/base/exceptions.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "plate_impact/transient/plate_model.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    const std::map<std::string, EdgeSupport> support_names =
      {{"SSH", EdgeSupport::simply_supported}, {"C", EdgeSupport::clamped}};



    /// The quadrant of a square plate of side 1 with n x n cells, halved
    /// n_graded times towards the impact point.
    std::unique_ptr<Triangulation<2>>
    graded_quadrant(const PlateParameters &plate,
                    const unsigned int     n,
                    const unsigned int     n_graded)
    {
      auto mesh = make_plate_mesh(plate, {{n, n}});
      for (unsigned int i = 0; i < n_graded; ++i)
        {
          const double radius = 0.25 * std::pow(0.5, i);
          for (const auto &cell : mesh->active_cell_iterators())
            if (cell->center().norm() < radius)
              cell->set_refine_flag();
          mesh->execute_coarsening_and_refinement();
        }
      return mesh;
    }



    TEST(StaticPlate, UniformLoad)
    {
      const nlohmann::json cases = reference("static_plates.json")["cases"];
      EXPECT_EQ(cases.size(), 8u);
      for (const auto &entry : cases)
        for (const ElementType name : all_elements())
          {
            const double a_over_t = entry["a_over_t"];
            // thin plates: the elements lock, each in its own way
            if (a_over_t > 100. ||
                (a_over_t > 20. && name == ElementType::serendipity_full))
              continue;
            const PlateParameters plate =
              unit_plate(support_names.at(entry["bc"]), 1. / a_over_t);
            const PlateElement  element(name);
            const auto          mesh = make_plate_mesh(plate, {{10, 10}});
            PlateDiscretization model(*mesh, element, plate);
            model.assemble();
            const double          D = model.section.bending_stiffness(0, 0);
            const Eigen::VectorXd f = 4. *
              model.load(
                pressure_load(*mesh, [](const Point<2> &) { return 1.; }));
            const Eigen::VectorXd z = solve_static(model, f);
            const double          w = model.load({{Point<2>(), 1.}}).dot(z);
            EXPECT_NEAR(w * D / entry["unif_w"].get<double>(), 1., 2e-3)
              << entry["bc"] << ' ' << a_over_t << ' ' << name;
            EXPECT_NEAR(0.5 * z.dot(f) * D / entry["unif_U"].get<double>(),
                        1.,
                        2e-3)
              << entry["bc"] << ' ' << a_over_t << ' ' << name;
          }
    }



    TEST(StaticPlate, HertzPatch)
    {
      ContactParameters contact;
      contact.load_distribution  = LoadShape::Hertz_disc;
      contact.patch_radius       = 0.0025;
      const nlohmann::json cases = reference("static_plates.json")["cases"];
      EXPECT_EQ(cases.size(), 8u);
      for (const auto &entry : cases)
        {
          const double a_over_t = entry["a_over_t"];
          if (a_over_t > 100.)
            continue;
          const PlateParameters plate =
            unit_plate(support_names.at(entry["bc"]), 1. / a_over_t);
          const PlateElement  element(ElementType::heterosis);
          const auto          mesh = graded_quadrant(plate, 6, 7);
          PlateDiscretization model(*mesh, element, plate);
          model.assemble();
          const double          D = model.section.bending_stiffness(0, 0);
          const Eigen::VectorXd f =
            model.load(make_load_distribution(contact, 0.2));
          const Eigen::VectorXd z = solve_static(model, f);
          EXPECT_NEAR(f.dot(z) * D / entry["patch_wavg"].get<double>(),
                      1.,
                      1e-3)
            << entry["bc"] << ' ' << a_over_t;
        }
    }



    /// Omega = omega a^2 (rho t / D)^{1/2} of a plate of side 1.
    std::vector<double>
    scaled_frequencies(const PlateParameters &plate,
                       const ElementType      element,
                       const unsigned int     n_cells,
                       const unsigned int     n)
    {
      PlateModel   struck(plate,
                        {element, {{n_cells, n_cells}}, SolverType::CHOLMOD},
                        make_plate_mesh(plate, {{n_cells, n_cells}}));
      const double D = struck.discretization().section.bending_stiffness(0, 0);
      std::vector<double> result;
      for (const double frequency : struck.natural_frequencies(n))
        result.push_back(
          2. * numbers::PI * frequency *
          std::sqrt(struck.discretization().section.mass_per_area / D));
      return result;
    }



    TEST(Frequencies, LowestDoublySymmetricOnes)
    {
      const nlohmann::json cases = reference("plate_frequencies.json")["cases"];
      EXPECT_EQ(cases.size(), 8u);
      for (const auto &entry : cases)
        for (const ElementType element : all_elements())
          {
            // those with reduced integration lock, or have modes too many
            const double a_over_t = entry["a_over_t"];
            if ((a_over_t > 100. && element != ElementType::MITC9) ||
                (a_over_t > 20. && element == ElementType::serendipity_full))
              continue;
            const PlateParameters plate =
              unit_plate(support_names.at(entry["bc"]), 1. / a_over_t);
            const std::vector<double> Omega =
              scaled_frequencies(plate, element, 8, 6);
            ASSERT_EQ(Omega.size(), 6u);
            for (unsigned int mode = 0; mode < 6; ++mode)
              EXPECT_NEAR(Omega[mode] / entry["Omega"][mode].get<double>(),
                          1.,
                          5e-3)
                << entry["bc"] << ' ' << a_over_t << ' ' << element << ' '
                << mode;
          }
    }



    TEST(Frequencies, AgreeWithADenseSolverOnAFreePlate)
    {
      PlateParameters plate = unit_plate(EdgeSupport::free, 0.05);
      plate.side_lengths    = {{1., 0.7}};
      const PlateElement  element(ElementType::MITC9);
      const auto          mesh = make_plate_mesh(plate, {{4, 3}});
      PlateDiscretization model(*mesh, element, plate);
      model.assemble();
      const Eigen::VectorXd eigenvalues =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
          dense(model.stiffness()),
          dense(model.mass()),
          Eigen::EigenvaluesOnly)
          .eigenvalues();
      EffectiveStiffness matrices(model, SolverType::CHOLMOD);
      const auto         frequencies = natural_frequencies(matrices, 5);
      ASSERT_EQ(frequencies.size(), 5u);
      // the first one is that of the rigid body
      for (unsigned int mode = 0; mode < 5; ++mode)
        EXPECT_NEAR(2. * numbers::PI * frequencies[mode] /
                      std::sqrt(eigenvalues[mode + 1]),
                    1.,
                    1e-7);
    }



    TEST(Frequencies, OfFreeFoilsAreThoseOfThinPlates)
    {
      // round-off takes more from the motions as rigid bodies the thinner a
      // plate is
      PlateParameters plate = unit_plate(EdgeSupport::free, 0.003);
      plate.side_lengths    = {{1., 0.4}};
      plate.impact_point    = {{0.1, 0.05}};
      const auto thin = scaled_frequencies(plate, ElementType::MITC9, 24, 3);
      for (const double thickness : {6e-4, 3e-4})
        {
          plate.thickness = thickness;
          const auto foil =
            scaled_frequencies(plate, ElementType::MITC9, 24, 3);
          ASSERT_EQ(foil.size(), 3u);
          for (unsigned int mode = 0; mode < 3; ++mode)
            EXPECT_NEAR(foil[mode] / thin[mode], 1., 2e-3) << thickness;
        }
    }



    TEST(Frequencies, AreFewerOnMeshesOfFewUnknowns)
    {
      for (const EdgeSupport support :
           {EdgeSupport::clamped, EdgeSupport::free})
        {
          const auto few = scaled_frequencies(unit_plate(support, 0.05),
                                              ElementType::serendipity,
                                              1,
                                              100);
          ASSERT_FALSE(few.empty());
          EXPECT_LT(few.size(), 10u);
          EXPECT_GT(few.front(), 0.);
        }
    }



    TEST(Frequencies, FillTheWholeSpaceOfSmallMeshes)
    {
      for (const EdgeSupport support :
           {EdgeSupport::clamped, EdgeSupport::free})
        for (const ElementType element : all_elements())
          for (const unsigned int n_cells : {1, 2, 3})
            for (const unsigned int n : {1, 7, 40})
              {
                // a free plate of Lagrange elements has its spurious mode
                if (support == EdgeSupport::free &&
                    element == ElementType::Lagrange)
                  continue;
                EXPECT_NO_THROW(scaled_frequencies(unit_plate(support, 0.05),
                                                   element,
                                                   n_cells,
                                                   n))
                  << element << ' ' << n_cells << ' ' << n;
              }
    }



    TEST(Frequencies, AreNotWhatRoundOffLeaves)
    {
      // by the beam, (1.875 / (L/2))^2 (E I / rho A)^{1/2} / 2 pi and more
      for (const double length : {1., 10., 2000.})
        {
          PlateParameters plate = unit_plate(EdgeSupport::free, 0.05);
          plate.side_lengths    = {{0.2, length}};
          PlateModel   struck(plate,
                            {ElementType::MITC9, {{8, 8}}, SolverType::CHOLMOD},
                            make_plate_mesh(plate, {{8, 8}}));
          const double beam = std::pow(4.730 / length, 2) *
            std::sqrt(plate.youngs_modulus / plate.density / 12.) *
            plate.thickness / (2. * numbers::PI);
          try
            {
              const auto frequencies = struck.natural_frequencies(2);
              ASSERT_EQ(frequencies.size(), 2u);
              EXPECT_NEAR(frequencies[0] / beam, 1., 0.05) << length;
            }
          catch (const ComputationError &)
            {
              EXPECT_GT(length, 10.);
            }
        }
    }
  } // namespace
} // namespace PlateImpact
