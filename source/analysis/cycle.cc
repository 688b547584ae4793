#include "plate_impact/analysis/cycle.h"

#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Fewer samples over the transient do not make an integral over time.
    constexpr unsigned int min_estimator_samples = 20;

    /// More than these cost time alone, where the program chooses short steps.
    constexpr unsigned int most_estimator_samples = 1000;

    /// Unknowns in all frames of a film: 64 MB.
    constexpr unsigned int most_frame_unknowns = 8000000;



    /// What is kept of a transient while it is stepped: samples for the
    /// estimator, states for the fields, and what the page shows, the state of
    /// the largest force and frames of a film, at most 48, fewer where they
    /// would take more than 64 MB.
    class TransientRecord
    {
    public:
      /// All must outlive the record.
      /// @param system  that is stepped
      TransientRecord(const Parameters         &impact,
                      Cycle                    &cycle,
                      const Wanted             &wanted,
                      const SemidiscreteSystem &system)
        : n_steps(
            NewmarkScheme(impact.time, impact.contact.integration).n_steps)
        , wanted(wanted)
        , system(system)
        , cycle(cycle)
        , sampling_interval(
            std::clamp(n_steps / min_estimator_samples,
                       1u,
                       std::max(impact.time.step_is_chosen ?
                                  n_steps / most_estimator_samples :
                                  0u,
                                impact.adaptivity.sampling_interval)))
        , samples_per_frame(1 +
                            n_steps / sampling_interval /
                              std::clamp(most_frame_unknowns /
                                           cycle.discretization().n_unknowns(),
                                         8u,
                                         48u))
      {
        cycle.charge(&Seconds::stepping);
        // cells nearer to a point load than half the thickness
        std::vector<unsigned int> singular_cells;
        if (impact.contact.load_is_singular())
          for (const auto &cell : cycle.mesh().active_cell_iterators())
            if (cell->center().norm() < 0.5 * impact.plate.thickness)
              singular_cells.push_back(cell->active_cell_index());
        if (wanted.errors)
          {
            states.resize(system.load.size(),
                          std::min(n_steps / sampling_interval + 1,
                                   system.n_states_at_once()));
            estimator.emplace(cycle.discretization(),
                              cycle.recovery(),
                              singular_cells,
                              impact.adaptivity.singular_cells_count,
                              wanted.film ? samples_per_frame : 0,
                              impact.adaptivity.indicator);
          }
        cycle.charge(&Seconds::estimation);
      }

      void
      take_step(const unsigned int step, const TimeStepper &stepper)
      {
        const double           time  = stepper.state().time;
        const Eigen::VectorXd &state = stepper.displacement();
        // steps at which k n_steps / fields passes a whole number
        const std::uint64_t n_fields = wanted.fields;
        if (step * n_fields / n_steps > (step - 1) * n_fields / n_steps)
          seen.snapshots.push_back({time, state});
        if (wanted.film && stepper.state().force > peak_force)
          {
            peak_force      = stepper.state().force;
            seen.peak_state = Snapshot{time, state};
          }
        if (!estimator || (step % sampling_interval != 0 && step != n_steps))
          return;
        if (wanted.film && ++n_samples % samples_per_frame == 0)
          seen.frames.push_back({time, state});
        states.col(times.size()) = state;
        times.push_back(time);
        if (states.cols() == static_cast<Eigen::Index>(times.size()))
          {
            cycle.charge(&Seconds::stepping);
            estimate();
            cycle.charge(&Seconds::estimation);
          }
      }

      /// What was kept, on the mesh.
      Observation
      finish()
      {
        cycle.charge(&Seconds::stepping);
        seen.steps = n_steps;
        to_mesh(seen.snapshots);
        to_mesh(seen.frames);
        if (seen.peak_state)
          seen.peak_state->unknowns =
            system.unknowns(seen.peak_state->unknowns);
        if (estimator)
          {
            estimate();
            seen.error = estimator->estimate();
          }
        cycle.charge(&Seconds::estimation);
        return std::move(seen);
      }

      const unsigned int n_steps;

    private:
      /// Gives the samples that wait to the estimator.
      void
      estimate()
      {
        if (times.empty())
          return;
        const auto span = system.span(states.leftCols(times.size()));
        estimator->add_samples(times, span.vectors, span.coordinates);
        times.clear();
      }

      void
      to_mesh(std::vector<Snapshot> &snapshots) const
      {
        // products of matrices instead of many with a vector, a few at a time
        const std::size_t batch = 16;
        for (std::size_t first = 0; first < snapshots.size(); first += batch)
          {
            const std::size_t n = std::min(batch, snapshots.size() - first);
            Eigen::MatrixXd   columns(snapshots[first].unknowns.size(), n);
            for (std::size_t i = 0; i < n; ++i)
              columns.col(i) = snapshots[first + i].unknowns;
            const Eigen::MatrixXd unknowns = system.unknowns(columns);
            for (std::size_t i = 0; i < n; ++i)
              snapshots[first + i].unknowns = unknowns.col(i);
          }
      }

      const Wanted             &wanted;
      const SemidiscreteSystem &system;
      Cycle                    &cycle;

      const unsigned int                 sampling_interval, samples_per_frame;
      unsigned int                       n_samples = 0;
      std::optional<EnergyNormEstimator> estimator; ///< where errors are wanted

      Observation         seen; ///< states in coordinates of the system
      double              peak_force = 0.;
      std::vector<double> times;  ///< of samples that wait
      Eigen::MatrixXd     states; ///< at these
    };
  } // namespace



  Cycle::Cycle(const unsigned int                number,
               const Parameters                 &parameters,
               std::unique_ptr<Triangulation<2>> mesh_of_quadrant)
    : parameters(parameters)
    , plate(parameters.plate,
            parameters.discretization,
            std::move(mesh_of_quadrant))
  {
    result.cycle              = number;
    result.cells              = mesh().n_active_cells();
    result.degrees_of_freedom = discretization().n_unknowns();
    result.min_cell_size      = smallest_cell_size(mesh());
    result.cell_size_at_load =
      cell_sizes_near_load(mesh(), parameters.impactor.contact_half_length())
        .second;
  }



  const StressRecovery &
  Cycle::recovery() const
  {
    if (stress_recovery)
      return *stress_recovery;
    const double line        = parameters.contact.load_is_line() ?
             0.5 * parameters.impactor.length :
             -1.;
    const bool   is_interior = parameters.adaptivity.patches_are_interior;
    const std::array<bool, 2> mirrors =
      geometry_of(parameters.plate).is_symmetric;
    return stress_recovery.emplace(mesh(), [=](const Point<2> &point) {
      const bool is_on_plane =
        (mirrors[0] && point[0] == 0.) || (mirrors[1] && point[1] == 0.);
      return (point[1] == 0. && std::abs(point[0]) <= line) ||
        (is_interior && is_on_plane);
    });
  }



  void
  Cycle::charge(double Seconds::*stage)
  {
    const PlateWork work     = plate.work();
    const double    assembly = work.assembly_seconds - charged.assembly_seconds;
    const double    factorization =
      work.factorization_seconds - charged.factorization_seconds;
    result.seconds.*stage += timer.wall_time() - assembly - factorization;
    result.seconds.assembly += assembly;
    result.seconds.factorization += factorization;
    timer.restart();
    charged = work;
  }



  Observation
  Cycle::observe(const Parameters                               &impact,
                 const Wanted                                   &wanted,
                 const std::function<bool(const Observation &)> &is_kept,
                 const AnalysisListener                         &listener)
  {
    const PlateWork before = plate.work();
    listener.stage(result.cycle, "factors and vectors");
    const LoadedPlate loaded =
      plate.under(impact, wanted.errors || wanted.fields > 0);
    TransientRecord record(impact, *this, wanted, loaded.system);
    Impact          struck =
      loaded.strike([&](const unsigned int step, const TimeStepper &stepper) {
        record.take_step(step, stepper);
        listener.step(result.cycle, step, record.n_steps);
      });
    Observation seen = record.finish();

    const PlateWork work = plate.work();
    seen.new_vectors     = work.ritz_vectors - before.ritz_vectors;
    seen.new_solves      = work.linear_solves - before.linear_solves;
    seen.time            = impact.time;
    seen.impulse         = struck.impulse;
    seen.separation_time = struck.separation_time;
    seen.damping         = loaded.system.damping;
    seen.vector_error =
      loaded.is_stepped_on_the_mesh() ? 0. : impact.time.ritz_tolerance;
    if (wanted.errors)
      listener.stage(result.cycle, "error of the force");
    seen.time_error       = loaded.time_error(struck.history);
    seen.contact_steps    = struck.n_contact_steps;
    seen.history          = std::move(struck.history);
    const bool keeps_step = is_kept(seen);
    if (keeps_step)
      seen.sensitivity = loaded.sensitivity(*seen.history);
    charge(&Seconds::stepping);
    // under a point load the exact energy is infinite
    if (wanted.errors && !impact.contact.load_is_singular() && keeps_step)
      seen.peak_force_error = estimated_peak_force_error(discretization(),
                                                         recovery(),
                                                         loaded,
                                                         *seen.history);
    charge(&Seconds::estimation);

    seen.work = plate.work();
    return seen;
  }
} // namespace PlateImpact
