#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/ritz_basis.h"
#include "plate_impact/transient/time_stepper.h"

#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace PlateImpact
{
  /// What Newmark's method integrates for one impactor after another, with one
  /// load, time step and integration of the contact force: the system of the
  /// mesh, if `time.integrator` names it and for plates with large deflections,
  /// or one reduced from it.
  ///
  /// An impactor gets the first basis of a growing sequence with which the
  /// errors of its force and of the displacement under the load, as the last
  /// three bases tell them, are below `time.ritz_tolerance` of the peak and,
  /// where fields are asked for, displacements hardly use what lies beyond the
  /// basis before. The number is found with an impactor of round numbers
  /// nearby, whose contact is shorter: similar impactors share it, and what one
  /// gets depends on nothing but plate, load, time and itself.
  class RitzReduction
  {
  public:
    /// @param mesh          is factorized, and its bases are added to
    /// @param needs_fields  whether more than the force is to be right
    RitzReduction(std::shared_ptr<LoadedMesh> mesh,
                  const TimeParameters       &time,
                  const ContactIntegration   &integration,
                  const bool                  needs_fields)
      : mesh(std::move(mesh))
      , scheme(time, integration)
      , time(time)
      , needs_fields(needs_fields)
    {}

    const std::shared_ptr<LoadedMesh> mesh;
    const NewmarkScheme               scheme;

    /// The system to step for an impact, the one that takes fewer solves. It
    /// belongs to the reduction.
    /// @param parameters  with the load and the times of this reduction
    SemidiscreteSystem &
    system_for(const Parameters &parameters);

    /// An impact on such a system: by its response where scheme and plate
    /// conserve energy and steps would take longer, otherwise in steps.
    /// @param n_steps  at most those of the scheme
    /// @throws ComputationError naming step and quantity
    Impact
    impact(const NewmarkScheme &by,
           SemidiscreteSystem  &system,
           const Contact       &contact,
           const Impactor      &impactor,
           unsigned int         n_steps);

  private:
    /// @return a reduced system, or that of the mesh
    SemidiscreteSystem *
    settle(const Parameters &rounded);
    ReducedSystem &
    reduced_system(int half_octave, unsigned int n);

    const TimeParameters time;
    const bool           needs_fields;

    /// By the law's section, the impactor in round numbers and the plate's
    /// yield strength.
    std::map<std::tuple<ContactParameters, ImpactorParameters, double>,
             SemidiscreteSystem *>
      settled;
    /// By the half octave of the shift and the number of vectors.
    std::map<std::pair<int, unsigned int>, ReducedSystem> reduced_systems;
    /// By the system and the number of steps.
    std::map<std::pair<const SemidiscreteSystem *, unsigned int>, PlateResponse>
      responses;
  };
} // namespace PlateImpact
