#ifndef plate_impact_transient_time_error_h
#define plate_impact_transient_time_error_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <optional>

namespace PlateImpact
{
  /// Error of the peak force by the time step, relative to it: its change when
  /// the step is doubled by 2^p - 1, p the order of the scheme (Richardson),
  /// and what the peak of the curve exceeds the largest step. The doubled step
  /// is taken until the peak is past, on a mesh half of the solves up to there;
  /// Newmark's local error (Zienkiewicz & Xie 1991,
  /// doi:10.1002/eqe.4290200907) needs no second run but judges displacements,
  /// not the force.
  /// @param history  of the scene's step
  /// @param plate    is factorized anew
  /// @return empty where fewer than four steps lead from first touch to the
  ///         peak: a doubled step then says nothing
  std::optional<double>
  estimated_time_error(const ContactHistory     &history,
                       const TimeParameters     &time,
                       SemidiscreteSystem       &plate,
                       const Contact            &contact,
                       const ContactIntegration &integration,
                       const Impactor           &impactor);
} // namespace PlateImpact

#endif
