// Whole impacts against the histories of series and Ritz solutions of high
// order (tests/reference), computed through the library.
#include <deal.II/base/timer.h>
#include <deal.II/grid/grid_generator.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/analysis/time_control.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/transient/plate_model.h"
#include "test_plate.h"

#include <gtest/gtest.h>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// A scene with entries changed.
    Parameters
    parameters_with(const std::vector<std::string> &overrides)
    {
      return read_scene(std::string(TEST_DATA) +
                          "/reference/scene-interface.prm",
                        overrides)
        .parameters;
    }



    double
    largest_difference(const ContactHistory &a, const ContactHistory &b)
    {
      double difference = 0.;
      for (std::size_t n = 0; n < a.states.size(); ++n)
        difference =
          std::max(difference, std::abs(a.states[n].force - b.states[n].force));
      return difference / a.peak().force;
    }



    const std::vector<std::string> coarse_steps = {
      "Time/Time step=1e-6",
      "Contact/Patch radius=0.005",
      "Discretization/Initial cells=4,6"};



    TEST(Impact, QuadrantEqualsWholePlate)
    {
      for (const std::string support :
           {"clamped", "simply supported, free", "soft simply supported"})
        {
          std::vector<std::string> overrides = coarse_steps;
          overrides.push_back("Plate/Support=" + support);
          overrides.push_back("Plate/Side lengths=0.2,0.15");
          const Parameters parameters = parameters_with(overrides);
          const auto       load = make_load_distribution(parameters.contact,
                                                   parameters.impactor.length);
          const auto       quadrant =
            make_plate_mesh(parameters.plate,
                            parameters.discretization.initial_cells);

          // the whole plate, without planes of symmetry
          const auto      &cells = parameters.discretization.initial_cells;
          const auto      &sides = parameters.plate.side_lengths;
          const Point<2>   corner(0.5 * sides[0], 0.5 * sides[1]);
          Triangulation<2> whole;
          GridGenerator::subdivided_hyper_rectangle(whole,
                                                    {2 * cells[0],
                                                     2 * cells[1]},
                                                    -corner,
                                                    corner,
                                                    true);
          for (const auto &face : whole.active_face_iterators())
            if (face->at_boundary())
              face->set_boundary_id(face->boundary_id() < 2 ? edge_x : edge_y);
          std::vector<LoadPoint> whole_load;
          for (const LoadPoint &p : load)
            for (const double sx : {-1., 1.})
              for (const double sy : {-1., 1.})
                whole_load.push_back(
                  {Point<2>(sx * p.point[0], sy * p.point[1]), p.weight / 4.});

          EXPECT_LT(
            largest_difference(impact(parameters, *quadrant, load, 4.),
                               impact(parameters, whole, whole_load, 1.)),
            1e-9)
            << support;
        }
    }



    TEST(Impact, LinearSolversAgree)
    {
      std::vector<std::string> overrides = coarse_steps;
      const Parameters         cholmod   = parameters_with(overrides);
      overrides.push_back("Discretization/Linear solver=KLU");
      const Parameters klu  = parameters_with(overrides);
      const auto       load = make_load_distribution(cholmod.contact, 0.);
      const auto       mesh =
        make_plate_mesh(cholmod.plate, cholmod.discretization.initial_cells);
      EXPECT_LT(largest_difference(impact(cholmod, *mesh, load, 4.),
                                   impact(klu, *mesh, load, 4.)),
                1e-9);
    }



    TEST(Impact, EnergyIsConservedForEveryStep)
    {
      for (const std::string step : {"1e-7", "1e-6", "20e-6"})
        {
          std::vector<std::string> overrides = coarse_steps;
          overrides[0]                       = "Time/Time step=" + step;
          const Parameters parameters        = parameters_with(overrides);
          const auto       mesh =
            make_plate_mesh(parameters.plate,
                            parameters.discretization.initial_cells);
          EXPECT_LT(impact(parameters,
                           *mesh,
                           make_load_distribution(parameters.contact,
                                                  parameters.impactor.length),
                           4.)
                      .relative_energy_drift(),
                    1e-11)
            << step;
        }
    }



    TEST(Impact, PeakDoesNotDependOnTheSupportBeforeWavesReturn)
    {
      std::vector<double> peaks;
      for (const std::string support : {"clamped", "free"})
        {
          std::vector<std::string> overrides = coarse_steps;
          overrides.push_back("Plate/Support=" + support);
          overrides[2]                = "Discretization/Initial cells=16,16";
          const Parameters parameters = parameters_with(overrides);
          const auto       mesh =
            make_plate_mesh(parameters.plate,
                            parameters.discretization.initial_cells);
          peaks.push_back(
            impact(parameters,
                   *mesh,
                   make_load_distribution(parameters.contact,
                                          parameters.impactor.length),
                   4.)
              .peak()
              .force);
        }
      EXPECT_NEAR(peaks[1] / peaks[0], 1., 1e-3);
    }



    TEST(ImpactAnalysis, StagesTakeNoMoreSecondsThanTheCycle)
    {
      for (const std::string integrator : {"Newmark", "Ritz vectors"})
        {
          const Parameters parameters =
            parameters_with({"Discretization/Initial cells=4,6",
                             "Time/Integrator=" + integrator});
          const Timer    timer; // the whole
          ImpactAnalysis analysis(parameters);
          analysis.run();
          const CycleResult &result  = analysis.last_cycle().result;
          const Seconds     &seconds = result.seconds;
          EXPECT_LE(seconds.total(), timer.wall_time()) << integrator;
          for (const double stage : {seconds.mesh,
                                     seconds.assembly,
                                     seconds.factorization,
                                     seconds.stepping,
                                     seconds.estimation})
            EXPECT_GT(stage, 0.) << integrator;
        }
    }



    TEST(Impact, LoadsOfAPlateNeedNoOrder)
    {
      const auto plate_for = [](const Parameters &parameters) {
        return PlateModel(
          parameters.plate,
          parameters.discretization,
          make_plate_mesh(parameters.plate,
                          parameters.discretization.initial_cells));
      };
      std::vector<Parameters> impacts;
      for (const std::string different : {"Contact/Patch radius=0.005",
                                          "Contact/Patch radius=0.009",
                                          "Time/Time step=2e-6"})
        {
          std::vector<std::string> overrides = coarse_steps;
          overrides.push_back("Time/Integrator=Newmark");
          overrides.push_back(different);
          impacts.push_back(parameters_with(overrides));
        }
      PlateModel shared = plate_for(impacts[0]);
      std::vector<std::unique_ptr<const LoadedPlate>> loaded;
      for (const Parameters &impact : impacts)
        loaded.emplace_back(new LoadedPlate(shared.under(impact, true)));
      for (std::size_t i = impacts.size(); i-- > 0;)
        {
          PlateModel own = plate_for(impacts[i]);
          EXPECT_EQ(loaded[i]->strike().history.peak().force,
                    own.under(impacts[i], true).strike().history.peak().force);
        }
    }



    TEST(Impact, VectorsForAnErrorAreCountedAndKeptForTheNext)
    {
      std::vector<std::string> overrides = coarse_steps;
      overrides.push_back("Time/Integrator=Newmark");
      const Parameters parameters = parameters_with(overrides);
      PlateModel       plate(
        parameters.plate,
        parameters.discretization,
        make_plate_mesh(parameters.plate,
                        parameters.discretization.initial_cells));
      const LoadedPlate  loaded = plate.under(parameters, true);
      const Impact       impact = loaded.strike();
      const unsigned int before = plate.work().ritz_vectors;
      EXPECT_EQ(before, 0u);
      {
        const auto problem = loaded.peak_force_problem(impact.history);
        ASSERT_TRUE(problem);
        EXPECT_NE(problem->own_reduction, nullptr);
      }
      const unsigned int n_vectors = plate.work().ritz_vectors;
      EXPECT_GT(n_vectors, 0u);
      EXPECT_TRUE(loaded.peak_force_problem(impact.history));
      EXPECT_EQ(plate.work().ritz_vectors, n_vectors);
      EXPECT_EQ(loaded.strike().history.peak().force,
                impact.history.peak().force);
    }



    TEST(ImpactAnalysis, DividesARectangleAnewForALatePeak)
    {
      // four plate masses
      const Parameters parameters =
        parameters_with({"Plate/Side lengths=0.3, 0.2",
                         "Plate/Thickness=0.005",
                         "Impactor/Radius=0.015",
                         "Impactor/Mass=10",
                         "Impactor/Velocity=0.2",
                         "Time/End time=0",
                         "Time/Time step=0",
                         "Discretization/Initial cells=3,3",
                         "Adaptivity/Goal=peak force",
                         "Adaptivity/Target peak force error=0.004"});
      ImpactAnalysis    analysis(parameters);
      AdaptationControl control(parameters.adaptivity);
      AnalysisListener  listener;
      std::vector<unsigned int>
        equal; // cells of the cycles, without halved ones
      listener.cycle = [&](Cycle &cycle) {
        equal.push_back(cycle.mesh().n_cells(0));
      };
      EXPECT_EQ(analysis.run(control, listener), Outcome::target_reached);
      ASSERT_GT(equal.size(), 1u);
      EXPECT_EQ(equal.front(), 9u); // and 9 for ever, if they were halved
      for (std::size_t i = 1; i < equal.size(); ++i)
        {
          EXPECT_GT(equal[i], equal[i - 1]);
          EXPECT_LE(equal[i], 4 * equal[i - 1]);
        }
    }



    TEST(ImpactAnalysis, TellsEveryStepAndCycleToTheEnd)
    {
      const Parameters parameters =
        parameters_with({"Discretization/Initial cells=3,3",
                         "Time/Time step=1e-6",
                         "Adaptivity/Maximum cycles=2",
                         "Adaptivity/Target error=0.01"});
      ImpactAnalysis            analysis(parameters);
      AdaptationControl         control(parameters.adaptivity);
      unsigned int              n_steps = 0;
      std::vector<unsigned int> cells; // of the cycles
      AnalysisListener          counter;
      counter.step = [&](const unsigned int cycle, unsigned int, unsigned int) {
        EXPECT_EQ(cycle, cells.size() + 1); // the cycle of the step comes after
        ++n_steps;
      };
      counter.cycle = [&](Cycle &cycle) {
        EXPECT_EQ(cycle.mesh().n_active_cells(), cycle.result.cells);
        EXPECT_TRUE(cycle.result.error_ratios);
        cells.push_back(cycle.result.cells);
      };
      EXPECT_EQ(analysis.run(control, counter), Outcome::maximum_cycles);
      ASSERT_EQ(cells.size(), 2u);
      EXPECT_EQ(cells[0], 9u);
      EXPECT_GT(cells[1], 9u);
      EXPECT_EQ(analysis.last_cycle().result.cells, cells[1]);
      EXPECT_EQ(n_steps, 2 * analysis.last_cycle().result.steps);
    }



    TEST(ImpactAnalysis, LeavesAPlateAtRestThatNothingStrikes)
    {
      ImpactAnalysis analysis(parameters_with({"Impactor/Shape=none"}));
      EXPECT_EQ(analysis.run(), Outcome::single_mesh);
      EXPECT_FALSE(analysis.last_cycle().result.history);
      EXPECT_FALSE(analysis.last_cycle().result.error);
      EXPECT_EQ(analysis.last_cycle().plate.work().factorizations, 0u);
      EXPECT_TRUE(analysis.all_warnings().all().empty());
    }



    TEST(ImpactAnalysis, AChosenStepLeavesTheErrorOfALatePeakKnown)
    {
      // However large the error of the step is: with too many steps to the peak
      // nothing is known, and on the next mesh it may come at twice the time.
      const Parameters parameters = parameters_with(
        {"Time/End time=0", "Time/Time step=0", "Adaptivity/Goal=peak force"});
      const TimeControl control(parameters, make_zener_impact(parameters));
      CycleResult       seen;
      seen.history.emplace();
      seen.time_error = 0.2;
      for (const double force : {0., 1., 0.})
        {
          ContactState state;
          state.time  = seen.history->states.size() * 0.01;
          state.force = force;
          seen.history->states.push_back(state);
        }
      Window window{Extent::whole, parameters.time.time_step};
      while (const auto next = control.next(window, seen))
        {
          EXPECT_LT(next->step, window.step);
          window = *next;
        }
      EXPECT_LT(window.step, parameters.time.time_step);
      EXPECT_LE(2. * 0.01 / window.step, most_steps_to_peak * (1. + 1e-9));
    }
  } // namespace
} // namespace PlateImpact
