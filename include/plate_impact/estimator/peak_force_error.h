#pragma once

#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/loaded_plate.h"
#include "plate_impact/transient/softened_system.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <optional>

namespace PlateImpact
{
  /// Cover what estimates miss, by a sum of contributions, by the peak on a
  /// softer plate and by the force around it: calibrated on random scenes
  /// (doc/theory.md).
  constexpr double safety_of_bar = 1.5, safety_on_softer_plate = 1.7,
                   safety_around_peak = 1.6;

  /// Estimated error of the peak force by the mesh: computed less exact,
  /// relative to the peak.
  struct PeakForceError
  {
    /// What the cells contribute to first order, by active index, with their
    /// signs.
    Eigen::VectorXd cells;

    /// Of a peak that comes after waves are back: how the force changes where
    /// the plate is softer by the energies that the recovery finds missing, and
    /// lighter by what its mass has for waves. Relative to the peak.
    struct Change
    {
      double of_peak            = 0.; ///< with its sign
      double around_it          = 0.; ///< root mean square
      double crossings_of_waves = 1.; ///< before the peak
    };
    std::optional<Change> on_softer_plate;

    double safety = safety_of_bar; ///< of the sum of contributions

    /// Of the computed peak, positive if it is too large. Late peaks have
    /// errors of phase, of which the contributions of cells say nothing.
    double
    estimate() const
    {
      return on_softer_plate ? -on_softer_plate->of_peak : cells.sum();
    }

    /// The mesh's part of the error bar. Where waves pass once it is the sum of
    /// absolute values, since contributions of an assumed shear strain may have
    /// the wrong sign. What they bring that have come back adds up with either
    /// sign, and not to first order alone: at the peak as a sum of as many
    /// random terms as they have crossed the plate.
    double
    bar() const
    {
      return on_softer_plate ?
        std::hypot(safety_on_softer_plate * on_softer_plate->of_peak,
                   safety_around_peak * on_softer_plate->around_it /
                     std::sqrt(on_softer_plate->crossings_of_waves)) :
        safety * cells.lpNorm<1>();
    }
  };


  /// The dual weighted residual of the peak force (Bangerth & Rannacher 2003,
  /// doi:10.1007/978-3-0348-7605-6), with the errors of both motions taken from
  /// patch recovery.
  struct DualWeightedErrors
  {
    /// By active index, sums over times of
    ///   int_i (sigma* - sigma)^T_motion D^-1 (sigma* - sigma)_dual. [N]
    Eigen::VectorXd cells;

    /// Of the motions that those above are combinations of. Energies are
    ///   int (sigma* - sigma)^T_i D^-1 (sigma* - sigma)_j
    /// over the plate, less cells at soft simply supported edges where the
    /// shear strain is reduced: recovery finds energy in the layer there that
    /// such a stiffness does not miss.
    MissedByMesh missed;
  };

  /// @param recovery  of the mesh
  /// @param system    that the motions are states of
  DualWeightedErrors
  dual_weighted_errors(const PlateDiscretization &discretization,
                       const StressRecovery      &recovery,
                       const SemidiscreteSystem  &system,
                       const DualMotions         &motions);

  /// Empty where LoadedPlate::peak_force_problem() is.
  /// @param recovery  of the mesh
  /// @param history   of the impact
  std::optional<PeakForceError>
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const LoadedPlate         &loaded,
                             const ContactHistory      &history);


  /// How far the computed peak force may be from that of the equations, by mesh
  /// and time step, relative to it. The model is another matter.
  struct PeakForceBar
  {
    double space = 0., time = 0., vectors = 0.;
    bool   is_on_softer_plate = false; ///< space

    /// Of late peaks, which move with the ripples that they are on, errors by
    /// mesh and step have either sign.
    double
    total() const
    {
      return (is_on_softer_plate ? std::hypot(space, time) : space + time) +
        vectors;
    }
  };

  /// The peak on a mesh.
  struct PeakOnMesh
  {
    double                force = 0.; ///< [N]
    std::optional<double> space;      ///< of the bar
    std::size_t           n_cells = 0;
  };

  /// The part of a bar that is the mesh's: its bar(). No less than the change
  /// of the force from the mesh before, if that was more than the bar there:
  /// for late peaks, and where the load is not resolved, also if there was no
  /// bar. Empty on a first mesh that does not resolve the load, or where it is
  /// above a twentieth of the factor of safety.
  /// @param resolves_load  whether cells at the load are no larger than it
  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           double                           peak,
                           const std::optional<PeakOnMesh> &before,
                           bool                             resolves_load);
} // namespace PlateImpact
