// The error of the peak force by the mesh, against finer meshes.
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace PlateImpact
{
  namespace
  {
    /// What a mesh may leave of a force of 100 N.
    std::optional<double>
    bar(const PeakForceError            &estimate,
        const std::optional<PeakOnMesh> &before,
        const bool                       resolves_load)
    {
      return peak_force_error_by_mesh(estimate, 100., before, resolves_load);
    }



    TEST(PeakForceBar, OfAFirstMeshNeedsALoadThatIsResolved)
    {
      const PeakForceError some{Eigen::Vector2d(0.004, -0.006), {}},
        much{Eigen::Vector2d(0.04, -0.02), {}};
      EXPECT_NEAR(bar(some, {}, true).value(), safety_of_bar * 0.01, 1e-15);
      EXPECT_FALSE(bar(some, {}, false));
      EXPECT_FALSE(bar(much, {}, true));
      EXPECT_TRUE(bar(much, PeakOnMesh{100., {}}, true));
      record("factor of safety", bar(some, {}, true).value() / 0.01);
      const double of_serendipity =
        PlateElement(ElementType::serendipity).error_over_recovered();
      EXPECT_GT(of_serendipity, 1.);
      record("factor of safety with serendipity",
             safety_of_bar * of_serendipity);
    }



    TEST(PeakForceBar, IsNoLessThanAChangeThatShowsTheMeshBeforeToBeBlind)
    {
      const PeakForceError estimate{Eigen::Vector2d(0.001, -0.001), {}};
      const auto           change = [&](const PeakOnMesh &before) {
        return bar(estimate, before, false).value();
      };
      EXPECT_NEAR(change({110., 0.03}), 0.1, 1e-12);
      EXPECT_NEAR(change({110., {}}), 0.1, 1e-12);
      EXPECT_NEAR(change({102., 0.03}), safety_of_bar * 0.002, 1e-12);

      // where the load is resolved, late peaks only
      PeakForceError late  = estimate;
      late.on_softer_plate = PeakForceError::Change{0.002, 0., 1.};
      const double alone   = 0.002 * safety_on_softer_plate;
      EXPECT_NEAR(bar(estimate, PeakOnMesh{110., 0.03}, true).value(),
                  safety_of_bar * 0.002,
                  1e-12);
      EXPECT_NEAR(bar(late, PeakOnMesh{110., 0.03}, true).value(), 0.1, 1e-12);
      EXPECT_NEAR(bar(late, PeakOnMesh{102., 0.03}, true).value(),
                  alone,
                  1e-12);
      EXPECT_NEAR(bar(late, PeakOnMesh{110., {}}, true).value(), alone, 1e-12);
    }



    TEST(PeakForceBar, OfALatePeakIsThatOfTheSofterPlate)
    {
      const PeakForceError estimate{Eigen::Vector2d(0.3, -0.4),
                                    PeakForceError::Change{-0.01, 0.03, 4.}};
      EXPECT_EQ(estimate.estimate(), 0.01);
      EXPECT_NEAR(bar(estimate, {}, true).value(),
                  std::hypot(0.01 * safety_on_softer_plate,
                             0.5 * 0.03 * safety_around_peak),
                  1e-15);
      record("factor of safety", safety_on_softer_plate);
      record("factor around the peak", safety_around_peak);
      // and errors of mesh and step have either sign
      EXPECT_NEAR((PeakForceBar{0.03, 0.04, 0.01, true}.total()), 0.06, 1e-15);
      EXPECT_NEAR((PeakForceBar{0.03, 0.04, 0.01, false}.total()), 0.08, 1e-15);
    }



    /// What a mesh misses of the energy of its second mode, by recovery and, as
    /// squares of frequencies fall with it, by a mesh of cells a fifth as long:
    /// their ratio, for all cells and for those that the estimate counts.
    struct MissedEnergy
    {
      double of_all_cells, of_estimate;
    };

    MissedEnergy
    missed_energy(const EdgeSupport  support,
                  const ElementType  type,
                  const unsigned int n_cells = 8)
    {
      const PlateParameters plate = unit_plate(support, 0.06);
      const auto            fine  = make_plate_mesh(plate, {{40, 40}}),
                 mesh = make_plate_mesh(plate, {{n_cells, n_cells}});
      const PlateElement  of_fine(ElementType::MITC9), element(type);
      PlateDiscretization finer(*fine, of_fine, plate),
        discretization(*mesh, element, plate);
      finer.assemble();
      discretization.assemble();
      EffectiveStiffness matrices(finer, SolverType::CHOLMOD);
      const double       square =
        std::pow(2. * M_PI * natural_frequencies(matrices, 2)[1], 2);
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        Eigen::MatrixXd(as_eigen(discretization.stiffness())),
        Eigen::MatrixXd(as_eigen(discretization.mass())));
      // of unit length, as the motions that errors are made of
      const Eigen::VectorXd mode = modes.eigenvectors().col(1).normalized();
      const double          energy =
        mode.dot(as_eigen(discretization.stiffness()) * mode);
      const double missed = (modes.eigenvalues()[1] / square - 1.) * energy;

      const StressRecovery recovery(*mesh);
      double               of_all_cells = 0.;
      visit_energies(discretization,
                     recovery,
                     mode,
                     [&](const auto &, const auto &, const auto &e, auto &) {
                       of_all_cells += discretization.n_parts * e.squaredNorm();
                     });
      const FullSystem system(
        std::make_shared<EffectiveStiffness>(discretization,
                                             SolverType::CHOLMOD),
        mode);
      const DualWeightedErrors errors = dual_weighted_errors(discretization,
                                                             recovery,
                                                             system,
                                                             {mode, mode, 1.});
      return {of_all_cells / missed, errors.missed.energies(0, 0) / missed};
    }



    TEST(PeakForceBar, CountsNoLayerAtEdgesThatElementsDoNotMiss)
    {
      const auto soft = EdgeSupport::soft_simply_supported;
      // as where there is no layer
      const MissedEnergy hard =
        missed_energy(EdgeSupport::simply_supported, ElementType::serendipity);
      EXPECT_NEAR(hard.of_all_cells, hard.of_estimate, 1e-9);
      for (const ElementType type : {ElementType::serendipity,
                                     ElementType::heterosis,
                                     ElementType::Lagrange})
        {
          const MissedEnergy missed = missed_energy(soft, type);
          EXPECT_GT(missed.of_all_cells, 2.) << type;
          EXPECT_LT(missed.of_estimate, 0.5 * missed.of_all_cells) << type;
          EXPECT_GT(missed.of_estimate, 0.5) << type;
        }
      // where they are most of the plate, they count
      for (const unsigned int n_cells : {1, 2})
        {
          const MissedEnergy few =
            missed_energy(soft, ElementType::serendipity, n_cells);
          EXPECT_NEAR(few.of_estimate / few.of_all_cells, 1., 1e-9);
        }
      // others miss the layer indeed
      const MissedEnergy mixed = missed_energy(soft, ElementType::MITC9),
                         full =
                           missed_energy(soft, ElementType::serendipity_full);
      EXPECT_NEAR(mixed.of_all_cells, mixed.of_estimate, 1e-9);
      EXPECT_NEAR(full.of_all_cells, full.of_estimate, 1e-9);
      EXPECT_NEAR(full.of_estimate, 1., 0.1);
      EXPECT_GT(mixed.of_estimate, 0.5);
      EXPECT_LT(mixed.of_estimate, 1.);
      record("serendipity",
             missed_energy(soft, ElementType::serendipity).of_all_cells);
      record("MITC9", mixed.of_all_cells);
      record("full", full.of_all_cells);
      record("hard", hard.of_all_cells);
    }



    TEST(PeakForceBar, RipplesAreComparedOverTheNeighbourhoodOfThePeak)
    {
      const auto history = [](const double step, const double ripple) {
        ContactHistory result;
        for (unsigned int n = 0; n * step < 130.; ++n)
          {
            ContactState state;
            state.time  = n * step;
            state.force = 50. - 1e-2 * std::pow(state.time - 100., 2) +
              ripple * std::cos(state.time - 100.);
            result.states.push_back(state);
          }
        return result;
      };
      const ContactHistory fine = history(0.125, 1.);
      EXPECT_TRUE(fine.peak_is_on_ripples());
      EXPECT_FALSE(history(0.125, 0.).peak_is_on_ripples());
      // the root of the mean square of a cosine
      EXPECT_NEAR(fine.difference_around(100., history(0.125, 1.5)),
                  0.5 / std::sqrt(2.),
                  0.02);
      EXPECT_NEAR(history(0.25, 1.5).difference_around(100., fine),
                  0.5 / std::sqrt(2.),
                  0.02);
      EXPECT_EQ(history(0.5, 1.).difference_around(100., fine), 0.);
      EXPECT_EQ(fine.difference_around(300., fine), 0.);
    }



    class PeakForceEstimate : public Program
    {};

    TEST_F(PeakForceEstimate, IsTheErrorOfTheMesh)
    {
      // on the square plate of the main scene, whose cells are refined in
      // pairs, the estimate is 0.7 of the error on the fourth mesh
      ASSERT_EQ(run(main_scene,
                    "--set 'Adaptivity/Strategy=fixed fraction' --set "
                    "'Adaptivity/Maximum cycles=9' --set 'Adaptivity/Target "
                    "error=1e-3' --set 'Plate/Side lengths=0.2, 0.19'"),
                0)
        << err;
      const auto   cycles = summary()["cycles"];
      const double exact  = cycles.back()["peak_force"];
      ASSERT_LT(cycles.back()["peak_force_error_space"], 2e-4);
      for (unsigned int c = 0; c < 4; ++c)
        {
          const double error =
            cycles[c]["peak_force"].get<double>() / exact - 1.;
          EXPECT_GT(error, 1e-4);
          const double ratio =
            cycles[c]["peak_force_error_estimate"].get<double>() / error;
          EXPECT_GT(ratio, 0.8) << c;
          EXPECT_LT(ratio, 2.2) << c;
          // cells of six times the patch do not see the load
          EXPECT_EQ(cycles[c].contains("peak_force_error_bar"), c > 0);
          if (c > 0)
            {
              EXPECT_LT(std::abs(error), cycles[c]["peak_force_error_bar"])
                << c;
            }
        }
    }



    TEST_F(PeakForceEstimate, MakesMeshesForIt)
    {
      const std::string goal =
        " --set 'Adaptivity/Goal=peak force' --set 'Adaptivity/Maximum "
        "cycles=12' --set 'Adaptivity/Target peak force error=";
      ASSERT_EQ(run(main_scene, goal + "3e-5'"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      const double exact = last_cycle()["peak_force"];
      for (const std::string strategy :
           {"hanging nodes", "remeshing", "fixed fraction"})
        {
          ASSERT_EQ(run(main_scene,
                        goal + "1e-3' --set 'Adaptivity/Strategy=" + strategy +
                          "'"),
                    0)
            << err;
          EXPECT_EQ(err, "");
          EXPECT_EQ(summary()["outcome"], "target reached") << strategy;
          EXPECT_NE(out.find(" N +- "), std::string::npos) << out;
          const auto last = last_cycle();
          EXPECT_LE(last["peak_force_error_bar"], 1e-3);
          expect_near(last["peak_force"],
                      exact,
                      last["peak_force_error_bar"].get<double>() + 3e-5);
          // the energy norm takes 105
          EXPECT_LT(last["cells"], 100) << strategy;
          EXPECT_GT(last["discretization_error"], 0.03) << strategy;
        }
      // a mesh that cannot have it says so
      ASSERT_EQ(run(main_scene, goal + "1e-4' --set Adaptivity/Strategy=none"),
                0);
      EXPECT_NE(err.find("peak force error, 0.01 %, is not met; choose "
                         "smaller cells"),
                std::string::npos)
        << err;
    }



    TEST_F(PeakForceEstimate, FirstMeshesThatAreBlindHaveNoBar)
    {
      ASSERT_EQ(run(SCENES "/compare-thin-plate.prm",
                    "--set Adaptivity/Strategy=none"),
                0)
        << err;
      EXPECT_TRUE(last_cycle().contains("peak_force_error_estimate"));
      EXPECT_FALSE(last_cycle().contains("peak_force_error_bar"));
      EXPECT_EQ(out.find(" N +- "), std::string::npos) << out;
      // and where the force has changed by more than the bar before, it counts
      ASSERT_EQ(run(SCENES "/compare-thin-plate.prm",
                    "--set 'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      const auto   cycles = summary()["cycles"];
      const double change = std::abs(cycles[0]["peak_force"].get<double>() /
                                       cycles[1]["peak_force"].get<double>() -
                                     1.);
      EXPECT_GT(change, 0.1);
      EXPECT_GE(cycles[1]["peak_force_error_space"], change * (1. - 1e-12));
    }
  } // namespace
} // namespace PlateImpact
