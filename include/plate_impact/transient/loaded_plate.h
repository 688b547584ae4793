#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/transient/peak_force_dual.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "plate_impact/transient/time_stepper.h"

#include <functional>
#include <memory>
#include <optional>

namespace PlateImpact
{
  /// Steps to the peak with which its error is estimated: the weights take
  /// their square.
  constexpr double most_steps_to_peak = 120000.;


  /// How a force history answers to a change of the velocity by a millionth.
  /// One contact changes in proportion; a ball that bounces on a plate in
  /// motion may multiply the change with every contact, until nothing that
  /// follows is known, whatever the mesh and the step.
  struct Sensitivity
  {
    /// Largest change of the force, relative to the peak, over the relative
    /// change of the velocity: about 1 for a single contact.
    double factor = 0.;

    /// The first time at which the force changes by more than a thousandth of
    /// its peak; empty where it never does. [s]
    std::optional<double> unpredictable_from;
  };


  /// What the estimate of the error of the peak force needs: the motions, and
  /// the system whose states they are.
  struct PeakForceProblem
  {
    DualMotions                    motions;
    const SemidiscreteSystem      *system;
    std::unique_ptr<RitzReduction> own_reduction; ///< null: shared
  };


  /// A plate and the impactor that strikes it. What is not computed again from
  /// one impactor to the next belongs to the reduction. The histories below are
  /// of this impact.
  class LoadedPlate
  {
  public:
    /// @param impact  a scene with the plate and the load
    LoadedPlate(const Parameters              &impact,
                std::shared_ptr<RitzReduction> reduction);

    /// From first touch to the end time.
    /// @throws ComputationError naming step and quantity, and where an energy
    ///         that the scheme keeps has changed
    Impact
    strike() const;

    /// The same impact in steps, up to round-off.
    /// @param take_step  called after every step, counted from 1
    Impact
    strike(const std::function<void(unsigned int, const TimeStepper &)>
             &take_step) const;

    /// Error of the peak force by the time step, relative to it: its change
    /// when the step is doubled by 2^p - 1, p the order of the scheme
    /// (Richardson), and what the peak of the curve exceeds the largest step.
    /// A peak after others sits on ripples, and a difference of two peaks may
    /// be small by accident: there the change is at least 1.25 times the root
    /// of the mean square of that of the force from 0.9 to 1.1 of the time of
    /// the peak, and what it is divided by follows from steps of four times the
    /// length. They are taken until then, on a mesh three quarters of the
    /// solves up to there, without ripples half of them; Newmark's local error
    /// (Zienkiewicz & Xie 1991, doi:10.1002/eqe.4290200907) needs no second run
    /// but judges displacements, not the force. Empty where fewer than four
    /// steps lead from first touch to the peak: a doubled step then says
    /// nothing.
    std::optional<double>
    time_error(const ContactHistory &history) const;

    /// How the history answers to another velocity; empty for a single contact,
    /// which changes in proportion.
    std::optional<Sensitivity>
    sensitivity(const ContactHistory &history) const;

    /// In Ritz vectors wherever they are fewer than the steps, even if the mesh
    /// itself was stepped. Empty for schemes that do not conserve energy,
    /// without a force, and with more than most_steps_to_peak.
    std::optional<PeakForceProblem>
    peak_force_problem(const ContactHistory &history) const;

    /// Lives as long as the loaded plate.
    const SemidiscreteSystem &
    stepped_system() const
    {
      return system;
    }

    /// Whether Ritz vectors would cost more than the steps.
    bool
    is_stepped_on_the_mesh() const
    {
      return &system == &reduction->mesh->system;
    }

    /// Steps of other times on the mesh; the loaded plate must outlive them.
    TimeStepper
    steps_on_the_mesh(const TimeParameters &time) const
    {
      return {{time, scheme.integration},
              reduction->mesh->system,
              contact,
              impactor};
    }

  private:
    /// In a multiple of the step, no further than until a time.
    ContactHistory
    in_longer_steps(unsigned int factor, double until) const;

    const Parameters                     parameters;
    const NewmarkScheme                  scheme;
    const std::shared_ptr<RitzReduction> reduction;
    const Contact                        contact;
    const Impactor                       impactor;
    SemidiscreteSystem                  &system; ///< that is stepped
  };
} // namespace PlateImpact
