#ifndef plate_impact_estimator_error_estimator_h
#define plate_impact_estimator_error_estimator_h

#include <deal.II/base/point.h>

#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace PlateImpact
{
  /// Result of the estimator for one mesh; cells by active index.
  struct ErrorEstimate
  {
    /// Overall discretization error, a fraction; without the singular cells.
    double eta = 0.;

    /// The same with them.
    double eta_of_all_cells = 0.;

    unsigned int n_singular_cells = 0;

    /// Errors of the cells relative to the whole, the mean over time of
    /// ||e||_i / (||u||^2 + ||e||^2)^{1/2}; the denominator leaves out the
    /// singular cells.
    std::vector<double> element_errors;

    /// Largest von Mises stress at the faces of the plate over vertices and
    /// samples, from recovered resultants. [Pa]
    double max_effective_stress = 0.;

    /// Relative error ||e|| / (||u||^2 + ||e||^2)^{1/2} at the samples, without
    /// singular cells; eta is its mean with the denominator as weight.
    std::vector<double> sample_times, sample_errors;

    /// The same without the mean, at the samples that were to be kept.
    std::vector<Eigen::VectorXf> kept_element_errors;
  };


  /// Zienkiewicz-Zhu error of a transient, integrated over time (Table 1 of the
  /// paper, after Dutta & Ramakrishnan, Engng Comput 14, 1997, 135-158):
  ///   ||e||_i^2 = int_i (sigma* - sigma)^T D^-1 (sigma* - sigma),
  ///   eta       = int ||e|| dt / int (||u||^2 + ||e||^2)^{1/2} dt,
  ///   eta_i     = 1/T int ||e||_i / (||u||^2 + ||e||^2)^{1/2} dt,
  /// with sigma* recovered by patches (StressRecovery), and time integrals by
  /// the trapezoidal rule over samples. While the plate is at rest eta_i is
  /// taken as 0 (the paper's table has 0/0 at t = 0). What a cell may have of
  /// the error is for the adaptation to say (element_errors_over_limit()).
  ///
  /// Under a point load the energy of the exact error is infinite around the
  /// load, on every mesh: there is nothing to estimate, and nearer than about
  /// half the thickness plate theory means nothing either. Cells in such a
  /// singular zone are left out of eta, which then is the error in the rest of
  /// the plate and converges; what they would add is told beside.
  ///
  /// The estimate is no bound: it judges what the mesh resolves, and sees waves
  /// shorter than its cells only after refinement.
  class ErrorEstimator
  {
  public:
    /// @param model           must outlive the estimator; needs no K and M
    /// @param singular_cells  active indices of cells to leave out
    /// @param is_rough        as in StressRecovery
    ErrorEstimator(
      const PlateDiscretization                           &model,
      const std::vector<unsigned int>                     &singular_cells = {},
      const std::function<bool(const dealii::Point<2> &)> &is_rough       = {});

    /// Keeps the errors of the elements at one sample of so many; 0: at none.
    void
    keep_element_errors(unsigned int interval);

    /// Takes states of the plate at times later than those before. All are
    /// evaluated together, as matrix products.
    /// @param times     [s]
    /// @param unknowns  of the plate, a column per time
    void
    add_samples(const std::vector<double>               &times,
                const Eigen::Ref<const Eigen::MatrixXd> &unknowns);

    /// The same for states given in a basis: since estimates are linear in the
    /// states up to the norms of cells, they are made for as many vectors as
    /// the states span, which is fewer than there are states.
    /// @param vectors      unknowns of the plate, a column per vector;
    ///                     orthonormal in an energy norm
    /// @param coordinates  a row per vector, a column per time
    void
    add_samples(const std::vector<double>               &times,
                const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                const Eigen::MatrixXd                   &coordinates);

    /// Error over all samples; the plate is at rest at t = 0.
    ErrorEstimate
    estimate();

    /// Recovered resultants of one state: 5 point + resultant for points of a
    /// cell. For output.
    Eigen::MatrixXd
    recovered_resultants(
      const Eigen::VectorXd               &unknowns,
      const std::vector<dealii::Point<2>> &unit_points) const;

    unsigned int
    n_samples() const;

  private:
    /// ||e||, (||u||^2 + ||e||^2)^{1/2} without singular cells, and with them.
    using Norms = Eigen::Vector4d;

    /// A factor times the strains of n fields at points of a cell, a row per
    /// point by 5 n columns.
    RowMajorMatrix
    at_points(unsigned int                             cell,
              const Eigen::Matrix<double, 5, 5>       &factor,
              const CellOperator                      &strains,
              const Eigen::Ref<const Eigen::MatrixXd> &fields) const;
    /// Resultants of n fields times a factor, recovered.
    /// @param fields  must outlive the result
    RecoveredField
    recovered_field(const Eigen::Matrix<double, 5, 5>       &factor,
                    const Eigen::Ref<const Eigen::MatrixXd> &fields) const;
    /// Takes states as combinations of fields.
    void
    evaluate(const std::vector<double>               &times,
             const Eigen::Ref<const Eigen::MatrixXd> &fields,
             const Eigen::MatrixXd                   &coordinates);
    void
    integrate(double                 time,
              const Eigen::VectorXd &e2,
              double                 counted_u2,
              double                 u2);
    /// At the vertices of a cell, for states that are combinations of fields.
    void
    update_max_stress(
      const dealii::Triangulation<2>::active_cell_iterator &cell,
      RecoveredField                                       &field,
      const Eigen::MatrixXd                                &coordinates,
      std::vector<bool>                                    &vertex_is_done);

    const PlateDiscretization        &model;
    const Eigen::Matrix<double, 5, 5> stiffness, root_of_compliance;
    const StressRecovery              recovery;
    Eigen::VectorXd is_counted; ///< 0 for singular cells, else 1
    unsigned int    samples = 0;

    /// integrals so far, and integrands at the last time
    double          last_time = 0.;
    Norms           norm_integrals, last_norms;
    Eigen::VectorXd relative_integral, last_relative; ///< ||e||_i by norm
    double          max_stress = 0.;

    unsigned int                 interval_of_kept = 0;
    std::vector<double>          sample_times, sample_errors;
    std::vector<Eigen::VectorXf> kept_element_errors;
  };
} // namespace PlateImpact

#endif
