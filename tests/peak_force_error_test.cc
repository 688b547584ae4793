// The error of the peak force: what displacements weigh in it, and the estimate
// of the mesh's against finer meshes.
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/yielding_law.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/transient/peak_force_dual.h"
#include "plate_impact/transient/plate_model.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace PlateImpact
{
  namespace
  {
    TimeParameters
    twenty_seconds()
    {
      TimeParameters time = {};
      time.end_time       = 20.;
      time.time_step      = 0.02;
      time.newmark_beta   = 0.25;
      time.newmark_gamma  = 0.5;
      return time;
    }



    PlateParameters
    plate_of_modulus(const double factor)
    {
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.1);
      plate.youngs_modulus *= factor;
      return plate;
    }



    /// A unit plate, its system and its response.
    struct Responding
    {
      Responding(const double modulus, const ContactIntegration &integration)
        : mesh(unit_square(4))
        , element(ElementType::MITC9)
        , model(*mesh, element, plate_of_modulus(modulus), 1.)
        , system(std::make_shared<EffectiveStiffness>(assembled(model),
                                                      SolverType::CHOLMOD),
                 model.load({{dealii::Point<2>(0.5, 0.5), 1.}}))
        , response(NewmarkScheme(twenty_seconds()), system, integration)
      {}

      static PlateDiscretization &
      assembled(PlateDiscretization &model)
      {
        model.assemble();
        return model;
      }

      const std::unique_ptr<dealii::Triangulation<2>> mesh;
      const PlateElement                              element;
      PlateDiscretization                             model;
      FullSystem                                      system;
      const PlateResponse                             response;
    };



    TEST(PeakForceDual, WeightsPredictTheChangeOfThePeak)
    {
      const NewmarkScheme scheme(twenty_seconds());
      const auto          law = std::make_shared<HertzLaw>(10.);
      const auto yielding_law = std::make_shared<YieldingLaw>(10., 0.01, 0.5);
      const Contact hertz(law), series(law, -0.01),
        soft(std::make_shared<HertzLaw>(0.1)),
        yielding(yielding_law,
                 0.,
                 std::make_shared<PlasticUnloading>(yielding_law));
      for (const auto choice :
           {ForceIntegration::energy_conserving, ForceIntegration::collocation})
        for (const Contact *contact : {&hertz, &soft, &series, &yielding})
          for (const double mass : {0.01, 1., 100.})
            {
              const ContactIntegration integration = choice;
              const Responding         plate(1., integration),
                stiffer(1. + 1e-6, integration);
              const Impactor impactor{mass, 0., 0.5};
              const ContactHistory
                before =
                  plate.response.impact(*contact, impactor, scheme.n_steps)
                    .history,
                after =
                  stiffer.response.impact(*contact, impactor, scheme.n_steps)
                    .history;
              const Eigen::VectorXd phi =
                forces_to_peak(before, *contact, integration);
              const Eigen::VectorXd mu        = peak_force_weights(before,
                                                            scheme,
                                                            *contact,
                                                            integration,
                                                            impactor,
                                                            plate.response);
              double                predicted = 0.;
              for (Eigen::Index n = 0; n < phi.size(); ++n)
                for (Eigen::Index k = 0; k <= n; ++k)
                  predicted -= mu[n] * phi[k] *
                    (stiffer.response.displacement(n - k) -
                     plate.response.displacement(n - k));
              // what a dent changes of later contacts the weights leave out
              if (contact == &yielding && before.n_contacts() > 1)
                continue;
              // at the same step, where the peak has not moved yet
              const double change = after.states()[phi.size()].force -
                before.states()[phi.size()].force;
              EXPECT_GT(std::abs(change), 1e-9 * before.peak().force);
              EXPECT_NEAR(predicted / change, 1., 3e-3)
                << mass << ' ' << before.n_contacts();
            }
    }



    TEST(PeakForceDual, MotionsBelongTogether)
    {
      // M = 0 would make the sum of products with K that of the response; with
      // inertia it is the work of both: sum_n mu_n w_n by one motion alone
      const ContactIntegration integration =
        ForceIntegration::energy_conserving;
      Responding          plate(1., integration);
      const NewmarkScheme scheme(twenty_seconds());
      Eigen::VectorXd     phi(61), mu(61);
      for (Eigen::Index n = 0; n < phi.size(); ++n)
        {
          phi[n] = std::pow(std::sin(0.05 * n), 2);
          mu[n]  = 0.02 * n;
        }
      const DualMotions all =
        dual_motions(phi, mu, scheme, integration, plate.system, 1000);
      const DualMotions some =
        dual_motions(phi, mu, scheme, integration, plate.system, 20);
      EXPECT_EQ(all.weight, 1.);
      EXPECT_EQ(some.weight, 4.);
      const auto products = [&](const DualMotions &motions) {
        double sum = 0.;
        for (Eigen::Index c = 0; c < motions.motion.cols(); ++c)
          sum += motions.motion.col(c).dot(
            multiply(plate.model.stiffness(), motions.dual.col(c)));
        return motions.weight * sum;
      };
      EXPECT_NEAR(products(some) / products(all), 1., 0.02);
    }



    /// w of a motion at the vertices of a mesh, a column per time.
    Eigen::MatrixXd
    deflections(const PlateDiscretization &plate, const Eigen::MatrixXd &motion)
    {
      const auto     &vertices = plate.mesh().get_vertices();
      Eigen::MatrixXd result(vertices.size(), motion.cols());
      for (std::size_t v = 0; v < vertices.size(); ++v)
        result.row(v) = plate.load({{vertices[v], 1.}}).transpose() * motion;
      return result;
    }



    /// Columns as text, each over its largest number, in thousandths.
    std::string
    in_thousandths(const Eigen::MatrixXd &columns)
    {
      nlohmann::json text;
      for (const auto &column : columns.colwise())
        {
          const Eigen::VectorXi digits =
            (1000. / column.lpNorm<Eigen::Infinity>() * column)
              .array()
              .round()
              .cast<int>();
          text.push_back(std::vector<int>(digits.begin(), digits.end()));
        }
      return text.dump();
    }



    /// The plate of lesson 10 without what waves do not reach by the time of
    /// the peak, on equal cells: both motions, and what the cells contribute at
    /// each time.
    TEST(PeakForceDual, LessonTenWaves)
    {
      const Parameters scene =
        read_scene(SCENES "/course/10-meshes-for-a-number.prm",
                   {"Plate/Side lengths=0.08, 0.08",
                    "Discretization/Initial cells=32, 32",
                    "Time/End time=15e-6",
                    "Time/Time step=0.1e-6"})
          .parameters;
      PlateModel        plate(scene.plate,
                       scene.discretization,
                       make_plate_mesh(scene.plate,
                                       scene.discretization.initial_cells));
      const LoadedPlate loaded  = plate.under(scene, true);
      const auto        history = loaded.strike().history;
      const auto        problem = loaded.peak_force_problem(history);
      ASSERT_TRUE(problem);
      const auto          &mesh     = plate.discretization().mesh();
      const DualMotions   &motions  = problem->motions;
      const unsigned int   n_frames = 24;
      const StressRecovery recovery(mesh);
      Eigen::MatrixXd      motion(motions.motion.rows(), n_frames),
        dual(motions.dual.rows(), n_frames),
        cells(mesh.n_active_cells(), n_frames);
      std::vector<double> sums;
      for (unsigned int i = 0; i < n_frames; ++i)
        {
          // at rest is the plate at the first time, and the dual at the last
          const Eigen::Index at =
            1 + i * (motions.motion.cols() - 3) / (n_frames - 1);
          motion.col(i) = motions.motion.col(at);
          dual.col(i)   = motions.dual.col(at);
          const PeakForceError error =
            estimated_peak_force_error(plate.discretization(),
                                       recovery,
                                       *problem->system,
                                       {motion.col(i), dual.col(i), 1.},
                                       history.peak().force);
          cells.col(i) = Eigen::Map<const Eigen::VectorXd>(error.cells.data(),
                                                           error.cells.size());
          sums.push_back(error.bar());
        }
      // at the beginning the plate is at rest
      EXPECT_LT(sums.front(),
                0.1 * *std::max_element(sums.begin(), sums.end()));

      record("time of the peak", history.peak().time);
      nlohmann::json vertices;
      for (const auto &vertex : mesh.get_vertices())
        vertices.push_back({vertex[0], vertex[1]});
      nlohmann::json centers;
      for (const auto &cell : mesh.active_cell_iterators())
        centers.push_back({cell->center()[0], cell->center()[1]});
      RecordProperty("vertices", vertices.dump());
      RecordProperty("centers", centers.dump());
      RecordProperty("motion",
                     in_thousandths(
                       deflections(plate.discretization(),
                                   problem->system->unknowns(motion))));
      RecordProperty("dual",
                     in_thousandths(
                       deflections(plate.discretization(),
                                   problem->system->unknowns(dual))));
      // logarithms to base ten of the sizes over the largest of all
      const Eigen::MatrixXd decades =
        (cells.cwiseAbs() / cells.lpNorm<Eigen::Infinity>())
          .cwiseMax(1e-6)
          .array()
          .log10();
      nlohmann::json contributed;
      for (const auto &column : decades.colwise())
        {
          nlohmann::json of_cells;
          for (const double value : column)
            of_cells.push_back(std::round(100. * value) / 100.);
          contributed.push_back(of_cells);
        }
      RecordProperty("cells", contributed.dump());
    }



    /// What a mesh may leave of a force of 100 N.
    std::optional<double>
    bar(const PeakForceError            &estimate,
        const std::optional<PeakOnMesh> &before,
        const bool                       resolves_load,
        const std::optional<double>     &ripples = {})
    {
      return peak_force_error_by_mesh(estimate,
                                      100.,
                                      before,
                                      resolves_load,
                                      ripples);
    }



    TEST(PeakForceBar, OfAFirstMeshNeedsALoadThatIsResolved)
    {
      const PeakForceError some{{0.004, -0.006}}, much{{0.04, -0.02}};
      EXPECT_NEAR(bar(some, {}, true).value(), safety_of_bar * 0.01, 1e-15);
      EXPECT_FALSE(bar(some, {}, false));
      EXPECT_FALSE(bar(much, {}, true));
      EXPECT_TRUE(bar(much, PeakOnMesh{100., {}}, true));
      record("factor of safety", bar(some, {}, true).value() / 0.01);
    }



    TEST(PeakForceBar, IsNoLessThanAChangeThatShowsTheMeshBeforeToBeBlind)
    {
      const PeakForceError estimate{{0.001, -0.001}};
      const auto           change = [&](const PeakOnMesh &before) {
        return bar(estimate, before, false).value();
      };
      EXPECT_NEAR(change({110., 0.03}), 0.1, 1e-12);
      EXPECT_NEAR(change({110., {}}), 0.1, 1e-12);
      EXPECT_NEAR(change({102., 0.03}), safety_of_bar * 0.002, 1e-12);
    }



    TEST(PeakForceBar, OfAPeakOnRipplesIsAsWideAsTheseChange)
    {
      // the sum of absolute values has fallen from 8 to 2 %
      const PeakForceError estimate{
        {0.01 / safety_of_bar, 0.01 / safety_of_bar}};
      const PeakOnMesh before{100., {}, 0.08};
      EXPECT_NEAR(bar(estimate, before, true).value(), 0.02, 1e-12);
      EXPECT_NEAR(bar(estimate, before, true, 0.006).value(), 0.002, 1e-12);
      EXPECT_NEAR(bar(estimate, before, false, 0.006).value(), 0.002, 1e-12);
      // never more than the sum, nor by a mesh that is no better or has much
      // the same cells
      EXPECT_NEAR(bar(estimate, before, true, 0.5).value(), 0.02, 1e-12);
      EXPECT_NEAR(
        bar(estimate, PeakOnMesh{100., {}, 0.01, 1}, true, 0.001).value(),
        0.02,
        1e-12);
      EXPECT_NEAR(
        bar(estimate, PeakOnMesh{100., {}, 0.08, 2}, true, 0.001).value(),
        0.02,
        1e-12);
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
            result.add(state);
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
      EXPECT_NE(err.find("peak force error, 0.01 %, is not met"),
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
