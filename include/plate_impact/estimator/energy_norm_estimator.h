#pragma once

#include <deal.II/base/point.h>

#include "plate_impact/base/choices.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace PlateImpact
{
  /// Errors over what a target allows (Table 1 of the paper): every cell may
  /// have the same share of the target,
  ///   e_m = target (||u||^2 + ||e||^2)^{1/2} / n^{1/2},
  /// so that the target is met when all cells keep to it. n is the number of
  /// cells that count, e_m their limit and that of singular ones.
  struct ErrorRatios
  {
    double overall       = 0.; ///< eta / target
    double element_limit = 0.; ///< e_m / (||u||^2 + ||e||^2)^{1/2}
    /// xi' = 1/T int ||e||_i / e_m dt, by active index.
    std::vector<double> elements;

    /// Equal cells along x and y, of a rectangle or circle, that are to take
    /// the place of all of these; 0: none.
    std::array<unsigned int, 2> equal_cells = {};

    double
    max_element() const
    {
      return *std::max_element(elements.begin(), elements.end());
    }
  };


  /// Result of the estimator for one mesh; cells by active index.
  struct ErrorEstimate
  {
    /// Relative error in the energy norm, eta, a fraction, over the cells that
    /// count.
    double eta = 0.;

    /// The same with the singular cells and without them.
    double eta_of_all_cells = 0., eta_of_regular_cells = 0.;

    unsigned int n_singular_cells     = 0;
    bool         singular_cells_count = false;

    /// Errors of all cells relative to the whole, the mean over time of
    /// ||e||_i / (||u||^2 + ||e||^2)^{1/2}, with the denominator over the cells
    /// that count.
    std::vector<double> element_errors;

    /// Largest PlateSection::stresses() over vertices and samples, from
    /// recovered resultants. [Pa]
    Eigen::MatrixXd max_stresses;

    /// Relative error ||e|| / (||u||^2 + ||e||^2)^{1/2} at the samples; eta is
    /// its mean with the denominator as weight.
    std::vector<double> sample_times, sample_errors;

    /// The same without the mean, at the samples that were to be kept.
    std::vector<Eigen::VectorXf> kept_element_errors;

    ErrorRatios
    ratios(const double target_error) const
    {
      // without cells that count the limit is that of one
      const std::size_t n_counted =
        element_errors.size() - (singular_cells_count ? 0 : n_singular_cells);
      ErrorRatios result;
      result.overall = eta / target_error;
      result.element_limit =
        target_error / std::sqrt(std::max<double>(1., n_counted));
      for (const double error : element_errors)
        result.elements.push_back(error / result.element_limit);
      return result;
    }
  };


  /// Integral over time of what is zero at t = 0, by the trapezoidal rule.
  template <typename Value>
  struct TimeIntegral
  {
    Value  last; ///< integrand; at first zero
    Value  integral = last;
    double time     = 0.; ///< of the last integrand [s]

    void
    add(const double at, const Value &integrand)
    {
      integral += 0.5 * (at - time) * (last + integrand);
      time = at;
      last = integrand;
    }
  };


  /// Few orthonormal combinations, a column each, of the vectors that states
  /// are combinations of.
  /// @param coordinates  of the states, a row per vector
  /// @param tolerance    what the combinations may leave out of the states,
  ///                     relative to the largest
  inline Eigen::MatrixXd
  leading_combinations(const Eigen::MatrixXd &coordinates,
                       const double           tolerance)
  {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(tolerance);
    qr.compute(coordinates);
    return qr.householderQ() *
      Eigen::MatrixXd::Identity(coordinates.rows(), qr.rank());
  }


  /// Resultants of n fields at the quadrature points of a cell, or what the
  /// recovery changes of them, as the roots of energies: the squares of a
  /// column, a row per point and resultant, sum up to the integral over the
  /// cell.
  using EnergyRoots = Eigen::Map<const RowMajorMatrix>;

  /// Takes the roots of a cell and what recovers the field, scaled like them.
  using EnergyVisitor = std::function<void(const RecoveredField::Cell &cell,
                                           const EnergyRoots &resultants,
                                           const EnergyRoots &errors,
                                           RecoveredField    &recovered)>;

  /// Calls a function with every cell.
  /// @param fields  unknowns of the plate, a column per field
  void
  visit_energies(const PlateDiscretization &discretization,
                 const StressRecovery      &recovery,
                 const Eigen::MatrixXd     &fields,
                 const EnergyVisitor       &visit);


  /// Where the error is, by the jumps across the sides of cells instead of a
  /// recovered field (Kelly, Gago, Zienkiewicz & Babuska 1983,
  /// doi:10.1002/nme.1620191103; deal.II's KellyErrorEstimator):
  ///   eta_i^2 = h_i/24 sum over sides int (kappa G t [dw/dn]^2 + D
  ///   [dtheta/dn]^2),
  /// with the shear and bending stiffness, so that both jumps count as
  /// energies. The jumps only rank the cells: how large the error is together
  /// stays what EnergyNormEstimator says. For teaching what the recovery adds.
  /// @param states  unknowns of the plate, a column each
  /// @return eta_i by active index, a column per state, each times some factor
  Eigen::MatrixXd
  jumps_of_cells(const PlateDiscretization &discretization,
                 const Eigen::MatrixXd     &states);


  /// Zienkiewicz-Zhu error of a transient, integrated over time (Table 1 of the
  /// paper, after Dutta & Ramakrishnan, Engng Comput 14, 1997, 135-158):
  ///   ||e||_i^2 = int_i (sigma* - sigma)^T D^-1 (sigma* - sigma),
  ///   eta       = int ||e|| dt / int (||u||^2 + ||e||^2)^{1/2} dt,
  ///   eta_i     = 1/T int ||e||_i / (||u||^2 + ||e||^2)^{1/2} dt,
  /// with sigma* recovered by patches (StressRecovery), and time integrals by
  /// the trapezoidal rule over samples. While the plate is at rest eta_i is
  /// taken as 0 (the paper's table has 0/0 at t = 0).
  ///
  /// Around a point load the energy of the exact error is infinite on every
  /// mesh, and plate theory means nothing. Cells in such a singular zone may be
  /// left out of eta, which then converges; the paper counts them. Both are
  /// told.
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
    /// @param indicator       other than SPR: the errors of the elements are
    ///   eta 1/T int eta_i / (sum eta_j^2)^{1/2} dt
    ///                        with eta_i of that indicator
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

    /// ||e||, (||u||^2 + ||e||^2)^{1/2} without singular cells, and with them.
    TimeIntegral<Eigen::Vector4d> norms;
    TimeIntegral<Eigen::VectorXd> relative; ///< ||e||_i by the norm
    TimeIntegral<Eigen::VectorXd> ranks;    ///< of an indicator
    ErrorEstimate                 samples;  ///< stresses, errors over time
  };


  /// Error of a transient in the energy norm against that on a much finer mesh,
  ///   int ||sigma_ref - sigma_h|| dt / int ||sigma_ref|| dt,
  /// what ErrorEstimate::eta estimates. Stress resultants are compared at the
  /// quadrature points of the fine mesh, wherever they fall in the other: there
  /// the resultants of the cell are interpolated between its own quadrature
  /// points, exactly on parallelograms. Needs no relation between the meshes.
  class ReferenceError
  {
  public:
    /// @param snapshots  of the fine mesh, the plate at rest before
    ReferenceError(const PlateDiscretization   &fine,
                   const std::vector<Snapshot> &snapshots);

    /// @param snapshots  at the times of those of the fine mesh
    double
    of(const PlateDiscretization   &discretization,
       const std::vector<Snapshot> &snapshots) const;

  private:
    std::vector<dealii::Point<2>> points;
    std::vector<double>           weights; ///< [m^2]
    Eigen::MatrixXd exact; ///< m point + resultant, scaled, by times
  };
} // namespace PlateImpact
