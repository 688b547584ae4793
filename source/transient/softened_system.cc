#include "plate_impact/transient/softened_system.h"

#include "plate_impact/base/exceptions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace PlateImpact
{
  namespace
  {
    /// L such that the matrix A of a plate loses L L^T, for A Z of motions Z.
    /// @param missed    by pairs of motions, in the unit of Z^T A Z
    /// @param share_of  which share of a product of 1 is lost for what is
    /// missed
    template <typename ShareOf>
    Eigen::MatrixXd
    root_of_lost(const Eigen::MatrixXd &Z,
                 const Eigen::MatrixXd &A_Z,
                 const Eigen::MatrixXd &missed,
                 const ShareOf         &share_of)
    {
      // combinations without products in common, each of which has one of 1;
      // what is left out is round-off, or has no stiffness as a rigid body
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> apart(Z.transpose() *
                                                                 A_Z);
      const Eigen::ArrayXd products = apart.eigenvalues();
      const Eigen::Index   n_apart =
        (products > 1e-8 * products.maxCoeff()).count();
      if (n_apart == 0 || !products.allFinite() || !missed.allFinite())
        throw ComputationError("what the mesh misses is not finite");
      const Eigen::MatrixXd unit = apart.eigenvectors().rightCols(n_apart) *
        products.tail(n_apart).rsqrt().matrix().asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_missed(
        unit.transpose() * missed.selfadjointView<Eigen::Lower>() * unit);
      const Eigen::ArrayXd shares = share_of(of_missed.eigenvalues().array());
      // the last ones: no force shows less
      const Eigen::Index n = (shares > 1e-7).count();
      return A_Z * unit * of_missed.eigenvectors().rightCols(n) *
        shares.tail(n).sqrt().matrix().asDiagonal();
    }
  } // namespace



  SoftenedSystem::SoftenedSystem(SemidiscreteSystem &plate,
                                 const MissedByMesh &missed)
    : SemidiscreteSystem(plate.load, plate.damping)
    , plate(plate)
  {
    const Eigen::MatrixXd &Z   = missed.motions;
    Eigen::MatrixXd        K_Z = Z, M_Z = Z;
    Eigen::VectorXd        product;
    for (Eigen::Index i = 0; i < Z.cols(); ++i)
      {
        plate.multiply_stiffness(Z.col(i), product);
        K_Z.col(i) = product;
        plate.multiply_mass(Z.col(i), product);
        M_Z.col(i) = product;
      }
    lost_stiffness =
      root_of_lost(Z, K_Z, missed.energies, [](const Eigen::ArrayXd &e) {
        return Eigen::ArrayXd(e / (1. + e));
      });
    // less than 1, since the mass without it is positive
    lost_mass = root_of_lost(Z, M_Z, missed.masses, [](const auto &g) {
      return Eigen::ArrayXd(g);
    });
  }



  void
  SoftenedSystem::solve(const double           c,
                        const Eigen::VectorXd &b,
                        Eigen::VectorXd       &x)
  {
    if (c != factorized_for)
      {
        lost.resize(load.size(), lost_stiffness.cols() + lost_mass.cols());
        lost << lost_stiffness, std::sqrt(c) * lost_mass;
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
