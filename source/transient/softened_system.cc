#include "plate_impact/transient/softened_system.h"

#include "plate_impact/base/exceptions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace PlateImpact
{
  SoftenedSystem::SoftenedSystem(SemidiscreteSystem    &plate,
                                 const Eigen::MatrixXd &motions,
                                 const Eigen::MatrixXd &missed)
    : SemidiscreteSystem(plate.load, plate.damping)
    , plate(plate)
  {
    Eigen::MatrixXd forces(motions.rows(), motions.cols()); // K Z
    Eigen::VectorXd force;
    for (Eigen::Index i = 0; i < motions.cols(); ++i)
      {
        plate.multiply_stiffness(motions.col(i), force);
        forces.col(i) = force;
      }
    // combinations without energies in common, each of which has one of 1;
    // what is left out is round-off or moves as a rigid body
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> apart(
      motions.transpose() * forces);
    const Eigen::ArrayXd energies = apart.eigenvalues();
    const Eigen::Index   n_apart =
      (energies > 1e-8 * energies.maxCoeff()).count();
    if (n_apart == 0 || !energies.allFinite() || !missed.allFinite())
      throw ComputationError(
        "the energies that the mesh misses are not finite");
    const Eigen::MatrixXd unit = apart.eigenvectors().rightCols(n_apart) *
      energies.tail(n_apart).rsqrt().matrix().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_missed(
      unit.transpose() * missed.selfadjointView<Eigen::Lower>() * unit);
    const Eigen::ArrayXd of_each = of_missed.eigenvalues(),
                         loss    = of_each / (1. + of_each);
    // the last ones: no force shows less
    const Eigen::Index n = (loss > 1e-7).count();
    lost = forces * unit * of_missed.eigenvectors().rightCols(n) *
      loss.tail(n).sqrt().matrix().asDiagonal();
  }



  void
  SoftenedSystem::solve(const double           c,
                        const Eigen::VectorXd &b,
                        Eigen::VectorXd       &x)
  {
    if (c != factorized_for)
      {
        responses.resize(lost.rows(), lost.cols());
        for (Eigen::Index i = 0; i < lost.cols(); ++i)
          {
            plate.solve(c, lost.col(i), x);
            responses.col(i) = x;
          }
        const Eigen::MatrixXd identity =
          Eigen::MatrixXd::Identity(lost.cols(), lost.cols());
        inverse =
          (identity - lost.transpose() * responses).llt().solve(identity);
        factorized_for = c;
      }
    plate.solve(c, b, x);
    x += responses * (inverse * (lost.transpose() * x));
  }
} // namespace PlateImpact
