#pragma once

#include "plate_impact/base/choices.h"
#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// Zienkiewicz-Zhu error of a transient, integrated over time (Table 1 of the
  /// paper, after Dutta & Ramakrishnan, Engng Comput 14, 1997, 135-158):
  ///   ||e||_i^2 = int_i (sigma* - sigma)^T D^-1 (sigma* - sigma),
  ///   eta       = int ||e|| dt / int (||u||^2 + ||e||^2)^{1/2} dt,
  ///   eta_i     = 1/T int ||e||_i / (||u||^2 + ||e||^2)^{1/2} dt,
  /// with sigma* recovered by patches (StressRecovery), and time integrals by
  /// the trapezoidal rule over samples. While the plate is at rest eta_i is
  /// taken as 0 (the paper's table has 0/0 at t = 0). What a cell may have of
  /// the error is for the adaptation to say (ErrorRatios).
  ///
  /// Under a point load the energy of the exact error is infinite around the
  /// load, on every mesh: there is nothing to estimate, and nearer than about
  /// half the thickness plate theory means nothing either. Cells in such a
  /// singular zone may be left out of eta, which then is the error in the rest
  /// of the plate and converges; the paper counts them. Both are told.
  ///
  /// The estimate is no bound: it measures what the mesh resolves, and contains
  /// waves shorter than its cells only after refinement.
  class EnergyNormEstimator
  {
  public:
    /// @param discretization  must outlive the estimator; needs no K and M
    /// @param recovery        of its mesh; must outlive the estimator
    /// @param singular_cells  active indices
    /// @param singular_cells_count  in eta and n
    /// @param kept_interval   keeps the errors of the elements at one sample of
    ///                        so many; 0: at none
    /// @param indicator       Kelly: the errors of the elements give way to
    ///   eta 1/T int eta_i / (sum eta_j^2)^{1/2} dt
    ///                        with eta_i of jumps_of_cells()
    EnergyNormEstimator(const PlateDiscretization       &discretization,
                        const StressRecovery            &recovery,
                        const std::vector<unsigned int> &singular_cells = {},
                        bool           singular_cells_count             = false,
                        unsigned int   kept_interval                    = 0,
                        ErrorIndicator indicator = ErrorIndicator::SPR);

    /// Takes states at times later than those before, as combinations of
    /// vectors. Since estimates are linear in the states up to the norms of
    /// cells, they are made for as many vectors as the states span, which may
    /// be fewer than there are states.
    /// @param times        [s]
    /// @param vectors      unknowns of the plate, a column per vector;
    ///                     orthonormal in an energy norm where they are fewer
    ///                     than the states
    /// @param coordinates  a row per vector, a column per time
    void
    add_samples(const std::vector<double>               &times,
                const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                const Eigen::MatrixXd                   &coordinates);

    /// Error over all samples; the plate is at rest at t = 0.
    ErrorEstimate
    estimate() const;

  private:
    /// ||e||, (||u||^2 + ||e||^2)^{1/2} without singular cells, and with them.
    using Norms = Eigen::Vector4d;

    /// Takes states as combinations of fields.
    void
    evaluate(const std::vector<double> &times,
             const Eigen::MatrixXd     &fields,
             const Eigen::MatrixXd     &coordinates);
    /// At the vertices of a cell, for states that are combinations of fields.
    void
    update_max_stress(const RecoveredField::Cell &cell,
                      RecoveredField             &field,
                      const Eigen::MatrixXd      &coordinates,
                      std::vector<bool>          &vertex_is_done);

    const PlateDiscretization &discretization;
    const StressRecovery      &recovery;
    const unsigned int         kept_interval;
    const ErrorIndicator       indicator;
    Eigen::VectorXd            is_regular; ///< 0 for singular cells

    TimeIntegral<Norms>           norms;
    TimeIntegral<Eigen::VectorXd> relative; ///< ||e||_i by the norm
    TimeIntegral<Eigen::VectorXd> jumps;    ///< eta_i by their norm
    ErrorEstimate                 samples;  ///< stresses, errors over time
  };
} // namespace PlateImpact
