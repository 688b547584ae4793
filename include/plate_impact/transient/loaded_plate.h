#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "plate_impact/transient/time_stepper.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>

namespace PlateImpact
{
  /// Steps to the peak with which its error is estimated: the weights take
  /// their square.
  constexpr double most_steps_to_peak = 120000.;


  /// How a force history answers to a change of the velocity by a millionth: a
  /// ball that bounces on a plate in motion may multiply it with every contact.
  struct Sensitivity
  {
    /// Largest change of the force, over the peak, by that of the velocity.
    double factor = 0.;

    /// When the force first changes by more than a thousandth of its peak. [s]
    std::optional<double> unpredictable_from;
  };


  /// What moves a plate up to the peak force, and in the dual problem.
  struct DualLoads
  {
    Eigen::VectorXd forces;  ///< phi_1 ... phi_p of the contact [N]
    Eigen::VectorXd weights; ///< mu_1 ... mu_p of the displacements [N/m]
  };


  /// The forces, and what displacements of the plate weigh in the peak force:
  /// were those after the steps 1 ... p, p that of the peak, larger by dw_n,
  /// the peak would be smaller by sum mu_n dw_n, to first order. The linearized
  /// discrete Volterra equation of the contact,
  ///   d delta_n = -dw_n - sum_{k <= n} (R + R_m)_{n-k} d phi_k,
  ///   d phi_k   = a_k d delta_{k-1} + b_k d delta_k,
  /// with the impactor's response R_m, transposed and solved backwards. Of a
  /// law with memory the curve that a step runs on is held fixed.
  /// @param response  of the plate, by a scheme that conserves energy
  DualLoads
  dual_loads(const ContactHistory &history,
             const NewmarkScheme  &scheme,
             const Contact        &contact,
             const Impactor       &impactor,
             const PlateResponse  &response);

  /// The motion of a plate up to the peak force and the dual one, that under
  /// the weights above in reversed order, at times that belong together: an
  /// error e of the plate's response to both is worth
  ///   sum mu_n dw_n = sum_c weight K(e_motion,c, e_dual,c)
  /// in the peak force, up to higher orders in the cell size, by Galerkin
  /// orthogonality (Verdugo, Pares & Diez 2014,
  /// doi:10.1007/s00466-014-0988-2).
  struct DualMotions
  {
    Eigen::MatrixXd motion, dual; ///< states of the system, a column per time
    double          weight;       ///< of a time
  };

  /// @param most_times  columns at most
  DualMotions
  dual_motions(const DualLoads     &loads,
               const NewmarkScheme &scheme,
               SemidiscreteSystem  &plate,
               unsigned int         most_times);


  /// For the error of the peak force: motions, and the system that they are of.
  struct PeakForceProblem
  {
    DualMotions                    motions;
    SemidiscreteSystem            *system;
    std::unique_ptr<RitzReduction> own_reduction; ///< null: shared
    double returns_of_waves;   ///< from the nearest edge before the peak
    double crossings_of_waves; ///< of a square of the plate's area, at least 1
  };


  /// A plate and the impactor that strikes it. What impactors share belongs to
  /// the reduction. The histories below are of this impact.
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

    /// Error of the peak force by the time step, relative to it (Richardson):
    /// its change when the step is doubled, divided by 2^p - 1 with p the order
    /// of the scheme, and what the peak of the curve exceeds the largest step.
    /// On ripples and once waves are back, where two peaks may differ little by
    /// accident, the change is at least 1.8 times the root mean square of that
    /// of the force around the peak. Empty where fewer than four steps lead
    /// from first touch to the peak, or doubled ones fail.
    std::optional<double>
    time_error(const ContactHistory &history) const;

    /// Empty for a single contact, which changes in proportion.
    std::optional<Sensitivity>
    sensitivity(const ContactHistory &history) const;

    /// In Ritz vectors wherever they are fewer than the steps, even if the mesh
    /// itself was stepped. Empty for schemes that do not conserve energy,
    /// without a force, and with more than most_steps_to_peak.
    std::optional<PeakForceProblem>
    peak_force_problem(const ContactHistory &history) const;

    /// The force up to its peak and a tenth past it, if the plate were another,
    /// in steps of which 4000 lead to the peak where the scheme has more.
    /// @param history  of this impact
    ContactHistory
    on_other_plate(SemidiscreteSystem   &other,
                   const ContactHistory &history) const;

    /// That is stepped; lives as long as the loaded plate.
    SemidiscreteSystem &system;

    /// Whether Ritz vectors would cost more than the steps.
    bool
    is_stepped_on_the_mesh() const
    {
      return &system == &reduction->mesh->system;
    }

    /// Steps of other times; the loaded plate must outlive them.
    TimeStepper
    steps(const TimeParameters &time) const
    {
      return {{time, scheme.integration}, system, contact, impactor};
    }

  private:
    /// From the nearest edge, before a time [s]; no whole number. [-]
    double
    returns_of_waves(double time) const;

    ContactHistory
    in_longer_steps(unsigned int        factor,
                    SemidiscreteSystem &plate,
                    double              until) const;

    const Parameters                     parameters;
    const NewmarkScheme                  scheme;
    const std::shared_ptr<RitzReduction> reduction;
    const Contact                        contact;
    const Impactor                       impactor;
  };
} // namespace PlateImpact
