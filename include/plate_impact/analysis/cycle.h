#pragma once

#include <deal.II/base/timer.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/plate_model.h"

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Wall time of the stages of a cycle, every second in one of them. [s]
  struct Seconds
  {
    double mesh = 0., assembly = 0., factorization = 0., stepping = 0.,
           estimation = 0., output = 0.;

    double
    total() const
    {
      return mesh + assembly + factorization + stepping + estimation + output;
    }
  };

  /// What somebody wants of a transient besides its force.
  struct Wanted
  {
    bool         errors = false; ///< of the stresses and of the peak force
    bool         film   = false; ///< states for the page
    unsigned int fields = 0;     ///< states for the files of fields
  };

  /// What a transient on a mesh has shown. Empty optionals are quantities that
  /// were not wanted, or that the impact does not have.
  struct Observation
  {
    TimeParameters                time; ///< end and steps of the transient
    std::optional<ContactHistory> history;
    unsigned int                  steps   = 0;
    double                        impulse = 0.;    ///< [N s]
    std::optional<double>         separation_time; ///< no contact since [s]

    double damping = 0.; ///< of the plate, b [s]

    std::optional<double> time_error; ///< of the peak force, relative to it
    double vector_error = 0.; ///< the same of Ritz vectors; 0 on the mesh
    std::optional<PeakForceError> peak_force_error; ///< by the mesh
    std::optional<Sensitivity>    sensitivity;      ///< of several contacts
    std::optional<ErrorEstimate>  error;            ///< of the stresses

    std::vector<Snapshot> snapshots; ///< for the files of fields

    /// For the page: the state of the largest force, and states evenly over the
    /// samples of the estimator, those of error->kept_element_errors.
    std::optional<Snapshot> peak_state;
    std::vector<Snapshot>   frames;

    PlateWork    work; ///< on the mesh, those of transients before included
    unsigned int contact_steps = 0; ///< with a force other than zero

    /// For this force alone: what the choice of steps or vectors is judged by.
    unsigned int new_vectors = 0, new_solves = 0;
  };

  /// What an observation is worth, by the targets of the scene.
  struct Judgement
  {
    std::optional<ErrorRatios> error_ratios; ///< of the energy norm's target
    unsigned int               cells_above_limit = 0; ///< xi' >= 1
    unsigned int cells_at_minimum_size = 0; ///< of these, not to be refined
    /// Of the bar of the peak force, also where nothing is known of the step's;
    /// none on blind meshes.
    std::optional<double>       mesh_part_of_bar;
    std::optional<PeakForceBar> peak_force_bar;
    double returns_of_waves     = 0.; ///< from the nearest edge before the peak
    bool   waves_are_everywhere = false; ///< back many times before the peak
    bool   is_uneven            = false; ///< a mesh too uneven for them
  };

  /// Result of one mesh: the last transient on it, and what it is worth.
  struct CycleResult : Observation, Judgement
  {
    unsigned int cycle = 0; ///< from 1
    unsigned int cells = 0, degrees_of_freedom = 0;
    double       min_cell_size     = 0.; ///< [m]
    double       cell_size_at_load = 0.; ///< of the largest that it touches [m]

    /// xi' by active index; empty where there is no estimate.
    std::vector<double>
    element_errors() const
    {
      return error_ratios ? error_ratios->elements : std::vector<double>();
    }

    /// Of the peak force, relative to it, as far as it is known.
    double
    mesh_error() const
    {
      return mesh_part_of_bar.value_or(
        peak_force_error ? peak_force_error->bar() : 0.);
    }

    /// Of a plate with damping at the frequency whose quarter period is the
    /// rise to the peak force: a contact may last much longer.
    double
    loss_factor_of_contact() const
    {
      return damping * std::acos(-1.) / (2. * history->rise_time());
    }

    std::vector<double> natural_frequencies; ///< where asked for [Hz]

    /// Where asked for: again, on the mesh with every cell halved.
    std::optional<PeakOnMesh> verification;

    Seconds seconds;             ///< on this mesh
    double  seconds_before = 0.; ///< of all meshes before

    /// From the beginning to the end of this cycle. [s]
    double
    cumulative_seconds() const
    {
      return seconds_before + seconds.total();
    }
  };


  class Cycle;

  /// Who follows an analysis: by default nobody.
  struct AnalysisListener
  {
    /// Before what may take long: the cycle and "assembly" or the like.
    std::function<void(unsigned int, const std::string &)> stage =
      [](const auto &...) {};

    /// After every step of a transient: the cycle, the step and their number.
    std::function<void(unsigned int, unsigned int, unsigned int)> step =
      [](const auto &...) {};

    /// After every cycle, before its mesh is adapted.
    std::function<void(Cycle &)> cycle = [](const auto &...) {};
  };


  /// A mesh of an analysis with all that is made on it, and the result. What
  /// belongs to a mesh lives and dies with its cycle.
  class Cycle
  {
    dealii::Timer timer; ///< from before the plate is made, for charge()

  public:
    /// @param number  from 1
    Cycle(unsigned int                              number,
          const Parameters                         &parameters,
          std::unique_ptr<dealii::Triangulation<2>> mesh);

    const PlateDiscretization &
    discretization() const
    {
      return plate.discretization();
    }

    const dealii::Triangulation<2> &
    mesh() const
    {
      return discretization().mesh();
    }

    /// Made when it is first asked for.
    const StressRecovery &
    recovery() const;

    /// Charges the wall time since the last charge, or since the cycle began,
    /// to a stage of the result. Matrices and factorizations are made when they
    /// are first needed: their seconds are charged to their own stages.
    void
    charge(double Seconds::*stage);

    /// Strikes the plate; the seconds are charged to the result.
    /// @param impact    the scene with end time and step of the transient
    /// @param is_kept   whether the step is, by the history and its error:
    ///                  without, the error by the mesh and the sensitivity are
    ///                  left out
    /// @param listener  told of stages and steps
    /// @throws ComputationError naming step and quantity
    Observation
    observe(const Parameters                               &impact,
            const Wanted                                   &wanted,
            const std::function<bool(const Observation &)> &is_kept,
            const AnalysisListener                         &listener);

    const Parameters &parameters;
    PlateModel        plate;
    CycleResult       result;

  private:
    PlateWork                             charged; ///< until the last charge
    mutable std::optional<StressRecovery> stress_recovery;
  };
} // namespace PlateImpact
