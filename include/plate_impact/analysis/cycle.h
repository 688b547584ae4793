#pragma once

#include <deal.II/base/timer.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/plate_model.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace PlateImpact
{
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


  /// Charges wall time to the stages of a transient. Matrices and
  /// factorizations are made when they are first needed: their seconds are
  /// taken out of the stage in which that was.
  class StageCharges
  {
  public:
    /// Both must outlive this object.
    StageCharges(const PlateModel &plate, Seconds &seconds)
      : plate(plate)
      , seconds(seconds)
      , noted(plate.work())
    {}

    /// Since the last charge, or since this object was made.
    void
    charge(double Seconds::*stage)
    {
      seconds.*stage += timer.wall_time();
      timer.restart();
      const PlateModel::Work work = plate.work();
      const double assembly = work.assembly_seconds - noted.assembly_seconds,
                   factorization =
                     work.factorization_seconds - noted.factorization_seconds;
      seconds.assembly += assembly;
      seconds.factorization += factorization;
      seconds.*stage -= assembly + factorization;
      noted = work;
    }

  private:
    const PlateModel &plate;
    Seconds          &seconds;
    PlateModel::Work  noted;
    dealii::Timer     timer;
  };


  /// A mesh of an analysis with all that is made on it, and the result. What
  /// belongs to a mesh lives and dies with its cycle.
  class Cycle
  {
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
    recovery() const
    {
      if (!stress_recovery)
        stress_recovery.emplace(make_stress_recovery(parameters, mesh()));
      return *stress_recovery;
    }

    /// Strikes the plate; the seconds are charged to the result.
    /// @param impact    the scene with end time and step of the transient
    /// @param listener  told of stages and steps
    /// @throws ComputationError naming step and quantity
    Observation
    observe(const Parameters       &impact,
            const Wanted           &wanted,
            const AnalysisListener &listener);

    const Parameters &parameters;
    PlateModel        plate;
    CycleResult       result;

  private:
    mutable std::optional<StressRecovery> stress_recovery;
  };
} // namespace PlateImpact
