#ifndef plate_impact_time_error_h
#define plate_impact_time_error_h

#include "plate_impact/contact_history.h"
#include "plate_impact/contact_law.h"
#include "plate_impact/contact_solver.h"
#include "plate_impact/impactor.h"
#include "plate_impact/parameters.h"
#include "plate_impact/plate_section.h"
#include "plate_impact/semidiscrete_plate.h"

#include <optional>

namespace PlateImpact
{
  /// The step with which the peak force keeps to time.step_tolerance in
  /// Zener's equation: the inverse frequency of the plate's thickness shear
  /// times a power of two, so that impactors share their steps. [s]
  double
  chosen_time_step(const TimeParameters &time,
                   const ContactLaw     &law,
                   const Impactor       &impactor,
                   const PlateSection   &section);

  /// Error of the peak force by the time step, relative to it: its change when
  /// the step is doubled by 2^p - 1, p the order of the scheme (Richardson),
  /// and what the peak of the curve exceeds the largest step. The doubled step
  /// is taken until the peak is past, on a mesh half of the solves up to there;
  /// Newmark's local error (Zienkiewicz & Xie 1991,
  /// doi:10.1002/eqe.4290200907) needs no second run but judges displacements,
  /// not the force.
  /// @param history   of the scene's step
  /// @param plate     is factorized anew
  /// @param n_solves  of the plate, counted on
  /// @return empty where fewer than four steps lead from first touch to the
  ///         peak: a doubled step then says nothing
  std::optional<double>
  estimated_time_error(const ContactHistory     &history,
                       const TimeParameters     &time,
                       SemidiscretePlate        &plate,
                       const ContactLaw         &law,
                       const ContactIntegration &integration,
                       const Impactor           &impactor,
                       unsigned int             &n_solves);
} // namespace PlateImpact

#endif
