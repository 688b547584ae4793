// Static deflections and frequencies against series and Ritz solutions of high
// order (tests/reference).
#include "test_plate.h"

#include <Eigen/Eigenvalues>

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
      auto mesh = make_plate_quadrant(plate, {{n, n}});
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
            if (a_over_t > 100.)
              continue; // thin plates: the elements lock, each in its own way
            const PlateParameters plate =
              unit_plate(support_names.at(entry["bc"]), 1. / a_over_t);
            const PlateElement  element(name);
            const auto          mesh = make_plate_quadrant(plate, {{10, 10}});
            PlateDiscretization model(*mesh, element, plate);
            model.assemble();
            const double          D = model.section().bending_stiffness(0, 0);
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
          const double          D = model.section().bending_stiffness(0, 0);
          const Eigen::VectorXd f =
            model.load(make_load_distribution(contact, 0.2));
          const Eigen::VectorXd z = solve_static(model, f);
          EXPECT_NEAR(f.dot(z) * D / entry["patch_wavg"].get<double>(),
                      1.,
                      1e-3)
            << entry["bc"] << ' ' << a_over_t;
        }
    }



    TEST(Frequencies, LowestDoublySymmetricOnes)
    {
      const nlohmann::json cases = reference("plate_frequencies.json")["cases"];
      EXPECT_EQ(cases.size(), 8u);
      for (const auto &entry : cases)
        for (const ElementType name :
             {ElementType::serendipity, ElementType::heterosis})
          {
            const double a_over_t = entry["a_over_t"];
            if (a_over_t > 100.)
              continue;
            const PlateParameters plate =
              unit_plate(support_names.at(entry["bc"]), 1. / a_over_t);
            const PlateElement  element(name);
            const auto          mesh = make_plate_quadrant(plate, {{6, 6}});
            PlateDiscretization model(*mesh, element, plate);
            model.assemble();
            const Eigen::VectorXd eigenvalues =
              Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                dense(model.stiffness()),
                dense(model.mass()),
                Eigen::EigenvaluesOnly)
                .eigenvalues();
            const double D = model.section().bending_stiffness(0, 0);
            for (unsigned int mode = 0; mode < 3; ++mode)
              EXPECT_NEAR(std::sqrt(eigenvalues[mode] * model.section().mass /
                                    D) /
                            entry["Omega"][mode].get<double>(),
                          1.,
                          3e-3)
                << entry["bc"] << ' ' << a_over_t << ' ' << name << ' ' << mode;
          }
    }
  } // namespace
} // namespace PlateImpact
