#include "plate_impact/ritz_basis.h"

#include "plate_impact/exceptions.h"
#include "plate_impact/zener.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace PlateImpact
{
  RitzBasis::RitzBasis(MeshPlate &plate, const double sigma)
    : plate(plate)
    , sigma(sigma)
  {
    plate.factorize(sigma);
  }



  void
  RitzBasis::grow(const unsigned int n_wanted)
  {
    if (n_wanted > Q.cols())
      {
        Q.conservativeResize(plate.load().size(), n_wanted);
        diagonal.conservativeResize(n_wanted);
        subdiagonal.conservativeResize(n_wanted);
      }
    while (n < n_wanted && !complete)
      append();
  }



  void
  RitzBasis::append()
  {
    // A times the candidate is what it is solved for
    if (n == 0)
      A_candidate = plate.load();
    else
      A_candidate = M_last;
    plate.solve(A_candidate, candidate);
    const double norm_before = norm_of_candidate();

    if (n > 0)
      {
        candidate -= diagonal[n - 1] * Q.col(n - 1);
        A_candidate -= diagonal[n - 1] * A_last;
      }
    if (n > 1)
      {
        candidate -= subdiagonal[n - 2] * Q.col(n - 2);
        A_candidate -= subdiagonal[n - 2] * A_before;
      }
    orthogonalize();

    const double norm = norm_of_candidate();
    if (norm <= 1e-10 * norm_before || n == Q.rows())
      {
        complete = true;
        return;
      }
    if (n == 0)
      load_norm = norm;
    else
      subdiagonal[n - 1] = norm;
    Q.col(n) = candidate / norm;
    A_before.swap(A_last);
    A_last = A_candidate / norm;
    plate.multiply_mass(Q.col(n), M_last);
    diagonal[n] = Q.col(n).dot(M_last);
    ++n;
  }



  void
  RitzBasis::orthogonalize()
  {
    if (n == 0)
      return;
    // orthogonal to the root of round-off serves as well as to round-off
    const double          tolerance = 1e-9 * norm_of_candidate();
    const Eigen::VectorXd overlap   = Q.leftCols(n).transpose() * A_candidate;
    if (overlap.cwiseAbs().maxCoeff() <= tolerance)
      return;
    candidate -= Q.leftCols(n) * overlap;
    plate.multiply_shifted(sigma, candidate, A_candidate);
  }



  double
  RitzBasis::norm_of_candidate() const
  {
    const double square = candidate.dot(A_candidate);
    if (!std::isfinite(square))
      throw ComputationError("Ritz vector " + std::to_string(n + 1) +
                             " is not finite");
    return std::sqrt(std::max(0., square));
  }



  unsigned int
  RitzBasis::n_vectors() const
  {
    return n;
  }



  bool
  RitzBasis::is_complete() const
  {
    return complete;
  }



  double
  RitzBasis::shift() const
  {
    return sigma;
  }



  Eigen::Ref<const Eigen::MatrixXd>
  RitzBasis::vectors() const
  {
    return Q.leftCols(n);
  }



  Eigen::Ref<const Eigen::VectorXd>
  RitzBasis::mass_diagonal() const
  {
    return diagonal.head(n);
  }



  Eigen::Ref<const Eigen::VectorXd>
  RitzBasis::mass_subdiagonal() const
  {
    return subdiagonal.head(n - 1);
  }



  double
  RitzBasis::load() const
  {
    return load_norm;
  }



  RitzPlate::RitzPlate(const RitzBasis &basis)
  {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(basis.mass_diagonal(),
                                  basis.mass_subdiagonal());
    if (solver.info() != Eigen::Success)
      throw ComputationError("the modes of the Ritz vectors were not found");
    modes = solver.eigenvectors();
    u     = basis.load() * modes.row(0);
    // round-off can make zeros negative: masses of the fastest modes,
    // stiffnesses of rigid motions
    mass      = solver.eigenvalues().cwiseMax(0.);
    stiffness = (1. - basis.shift() * mass.array()).cwiseMax(0.);
  }



  const Eigen::VectorXd &
  RitzPlate::load() const
  {
    return u;
  }



  void
  RitzPlate::multiply_stiffness(const Eigen::VectorXd &x,
                                Eigen::VectorXd       &y) const
  {
    y = stiffness.cwiseProduct(x);
  }



  void
  RitzPlate::factorize(const double c)
  {
    inverse = (stiffness + c * mass).cwiseInverse();
  }



  void
  RitzPlate::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    x = inverse.cwiseProduct(b);
  }



  double
  RitzPlate::static_compliance() const
  {
    // a stiffness is known to round-off of 1, not of itself
    if (stiffness.minCoeff() < 1e-13)
      return std::numeric_limits<double>::infinity();
    return 1.001 * u.cwiseAbs2().dot(stiffness.cwiseInverse());
  }



  Eigen::MatrixXd
  RitzPlate::to_basis(const Eigen::MatrixXd &modal) const
  {
    return modes * modal;
  }



  namespace
  {
    /// Share of the last third of the vectors in the displacements, in the norm
    /// of K + sigma M, below which they serve the error estimator: measured,
    /// eta is then that of the mesh to better than 1 % of itself.
    constexpr double displacement_tolerance = 1e-3;



    /// An impact on the plate in a basis.
    struct Trial
    {
      std::vector<double> forces; ///< after every step

      /// Largest norm over time of the displacements in the last third of the
      /// vectors, relative to that in all of them.
      double tail = 0.;
    };

    Trial
    try_impact(const RitzBasis          &basis,
               const TimeParameters     &time,
               const ContactLaw         &law,
               const ContactIntegration &integration,
               const Impactor           &impactor)
    {
      RitzPlate          plate(basis);
      TimeStepper        stepper(time, plate, law, integration, impactor);
      const unsigned int n_tail   = basis.n_vectors() / 3,
                         interval = std::max(1u, stepper.n_steps() / 100);
      double all = 0., tail = 0.;
      Trial  result;
      for (unsigned int step = 1; step <= stepper.n_steps(); ++step)
        {
          stepper.advance();
          result.forces.push_back(stepper.state().force);
          if (step % interval != 0 && step != stepper.n_steps())
            continue;
          const Eigen::VectorXd z = plate.to_basis(stepper.displacement());
          all                     = std::max(all, z.norm());
          tail                    = std::max(tail, z.tail(n_tail).norm());
        }
      if (all > 0.)
        result.tail = tail / all;
      return result;
    }



    /// Largest difference of two histories, relative to the peak of the second.
    double
    relative_difference(const std::vector<double> &a,
                        const std::vector<double> &b)
    {
      double largest = 0.;
      for (std::size_t n = 0; n < b.size(); ++n)
        largest = std::max(largest, std::abs(a[n] - b[n]));
      const double peak = *std::max_element(b.begin(), b.end());
      return peak > 0. ? largest / peak : largest;
    }
  } // namespace



  std::unique_ptr<RitzBasis>
  settled_ritz_basis(MeshPlate                &plate,
                     const PlateSection       &section,
                     const TimeParameters     &time,
                     const ContactLaw         &law,
                     const ContactIntegration &integration,
                     const Impactor           &impactor)
  {
    // Vectors resolve frequencies around the root of sigma best. The force is
    // smooth enough for those beyond about a hundred over the contact time not
    // to matter, and 40 pi measured best between 5 and 100 pi.
    const double contact_time = 2. * zener_peak(law, impactor, section).time;
    const double frequency    = 40. * std::acos(-1.) / contact_time;
    auto basis = std::make_unique<RitzBasis>(plate, frequency * frequency);

    // beyond half as many solves as steps the steps themselves are cheaper
    const double        n_steps = time.end_time / time.time_step;
    std::vector<double> previous;
    for (double n = 16.; n == 16. || n <= 0.5 * n_steps; n = 1.5 * n)
      {
        basis->grow(static_cast<unsigned int>(n));
        Trial trial = try_impact(*basis, time, law, integration, impactor);
        // The force is a scalar product of displacements with the load, and
        // settles before they do.
        const bool is_settled = !previous.empty() &&
          trial.tail <= displacement_tolerance &&
          relative_difference(previous, trial.forces) <= time.ritz_tolerance;
        if (basis->is_complete() || is_settled)
          return basis;
        previous = std::move(trial.forces);
      }
    return nullptr;
  }
} // namespace PlateImpact
