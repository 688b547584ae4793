#pragma once

#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/peak_force_dual.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <numeric>
#include <optional>
#include <vector>

namespace PlateImpact
{
  /// Covers what the cells miss: calibrated on random scenes (doc/theory.md).
  constexpr double safety_of_bar = 1.55;

  /// Estimated error of the peak force by the mesh: computed less exact,
  /// relative to the peak.
  struct PeakForceError
  {
    /// What the cells contribute, by active index, with their signs; and its
    /// sums over rings around the load, which one wave reaches at one time.
    std::vector<double> cells, rings;

    double
    sum() const
    {
      return std::accumulate(cells.begin(), cells.end(), 0.);
    }

    /// The mesh's part of the error bar, of absolute values: contributions of
    /// an assumed shear strain may have the wrong sign.
    double
    bar() const
    {
      return safety_of_bar *
        Eigen::Map<const Eigen::VectorXd>(cells.data(), cells.size())
          .lpNorm<1>();
    }

    /// The same of rings whose signs are random: two standard deviations of
    /// their sum.
    double
    bar_of_random_signs() const
    {
      return 2. *
        Eigen::Map<const Eigen::VectorXd>(rings.data(), rings.size()).norm();
    }
  };

  /// The dual weighted residual of the peak force (Bangerth & Rannacher 2003,
  /// doi:10.1007/978-3-0348-7605-6), with the errors of both motions taken from
  /// patch recovery: sum over times of
  ///   int_i (sigma* - sigma)^T_motion D^-1 (sigma* - sigma)_dual.
  /// @param recovery  of the mesh
  /// @param system    that the motions are states of
  /// @param peak      [N]
  PeakForceError
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const SemidiscreteSystem  &system,
                             const DualMotions         &motions,
                             double                     peak);


  /// How far the computed peak force may be from that of the equations, by mesh
  /// and time step, relative to it. The model is another matter.
  struct PeakForceBar
  {
    double space = 0., time = 0., vectors = 0.;

    double
    total() const
    {
      return space + time + vectors;
    }
  };

  /// The peak on a mesh, for the next one.
  struct PeakOnMesh
  {
    double                force = 0.; ///< [N]
    std::optional<double> space;      ///< of the bar
    std::size_t           n_cells = 0;
  };

  /// The part of a bar that is the mesh's: its bar(). Where the load is not
  /// resolved, no less than the change of the force from the mesh before, if
  /// that was more than the bar there; and empty on a first mesh, as is any
  /// estimate above a twentieth of the force there.
  ///
  /// What waves bring that have come back several times adds up with either
  /// sign, and the sum of absolute values is many times the error: there it is
  /// bar_of_random_signs(), and no more than the force has changed from the
  /// mesh before if there are half as many cells again, or a third of this if
  /// there are four times as many, as when every cell is halved.
  /// @param resolves_load  whether cells at the load are no larger than it
  /// @param returns        how often waves are back before the peak
  /// @param change         of the force around the peak from the mesh before,
  ///                       over the peak
  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           double                           peak,
                           const std::optional<PeakOnMesh> &before,
                           bool                             resolves_load,
                           double                           returns = 0.,
                           const std::optional<double>     &change  = {});
} // namespace PlateImpact
