#pragma once

#include <deal.II/base/timer.h>

#include "plate_impact/analysis/analysis_listener.h"
#include "plate_impact/analysis/cycle.h"

namespace PlateImpact
{
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


  /// Strikes the plate of a cycle.
  /// @param cycle     is charged with the seconds
  /// @param impact    the scene with end time and step of the transient
  /// @param listener  told of stages and steps
  /// @throws ComputationError naming step and quantity
  Observation
  observe(Cycle            &cycle,
          const Parameters &impact,
          const Wanted     &wanted,
          AnalysisListener &listener);
} // namespace PlateImpact
