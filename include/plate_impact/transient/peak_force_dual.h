#pragma once

#include "plate_impact/transient/time_stepper.h"

#include <Eigen/Core>

namespace PlateImpact
{
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
} // namespace PlateImpact
