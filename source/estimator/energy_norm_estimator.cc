#include "plate_impact/estimator/energy_norm_estimator.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/estimator/recovered_resultants.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What the combinations of the states leave out, relative to the largest:
    /// measured, eta is right to 0.1 % of itself.
    constexpr double span_tolerance = 3e-5;

    /// Unknowns times fields evaluated together, which bounds the memory.
    constexpr double max_numbers = 1e8;
  } // namespace



  EnergyNormEstimator::EnergyNormEstimator(
    const PlateDiscretization       &discretization,
    const StressRecovery            &recovery,
    const std::vector<unsigned int> &singular_cells,
    const unsigned int               kept_interval)
    : discretization(discretization)
    , recovery(recovery)
    , kept_interval(kept_interval)
    , root_of_compliance(discretization.section().root_of_compliance())
    , is_counted(Eigen::VectorXd::Ones(discretization.mesh().n_active_cells()))
    , norm_integrals(Norms::Zero())
    , last_norms(Norms::Zero())
    , relative_integral(Eigen::VectorXd::Zero(is_counted.size()))
    , last_relative(relative_integral)
  {
    for (const unsigned int cell : singular_cells)
      is_counted[cell] = 0.;
  }



  void
  EnergyNormEstimator::add_samples(
    const std::vector<double>               &times,
    const Eigen::Ref<const Eigen::MatrixXd> &vectors,
    const Eigen::MatrixXd                   &coordinates)
  {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(span_tolerance);
    qr.compute(coordinates);
    const Eigen::Index    n = coordinates.rows(), span = qr.rank();
    const Eigen::MatrixXd combinations =
      qr.householderQ() * Eigen::MatrixXd::Identity(n, span);
    const Eigen::MatrixXd in_combinations =
      combinations.transpose() * coordinates;

    const Eigen::Index batch =
      std::max<Eigen::Index>(1, max_numbers / vectors.rows());
    if (span <= batch)
      return evaluate(times, vectors * combinations, in_combinations);
    for (Eigen::Index first = 0; first < coordinates.cols(); first += batch)
      {
        const Eigen::Index size = std::min(batch, coordinates.cols() - first);
        evaluate({times.begin() + first, times.begin() + first + size},
                 vectors * coordinates.middleCols(first, size),
                 Eigen::MatrixXd::Identity(size, size));
      }
  }



  void
  EnergyNormEstimator::evaluate(const std::vector<double>               &times,
                                const Eigen::Ref<const Eigen::MatrixXd> &fields,
                                const Eigen::MatrixXd &coordinates)
  {
    // Resultants s are scaled to R s, whose square is their energy: recovery is
    // linear, and R mixes moments of the same parity only.
    const Eigen::Matrix<double, 5, 5> factor =
      root_of_compliance * discretization.section().stiffness();
    RecoveredField field =
      recovered_field(discretization, recovery, factor, fields);
    const std::vector<Point<2>> &unit_points =
      discretization.element().quadrature().get_points();
    Eigen::MatrixXd e2(discretization.mesh().n_active_cells(), times.size());
    // energies of pairs of fields
    Eigen::MatrixXd counted_u2 =
      Eigen::MatrixXd::Zero(fields.cols(), fields.cols());
    Eigen::MatrixXd   u2 = counted_u2;
    RowMajorMatrix    error;
    std::vector<bool> vertex_is_done(discretization.mesh().n_vertices());
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const unsigned int c     = cell->active_cell_index();
        const CellShape   &shape = discretization.shape(c);
        RowMajorMatrix     raw   = resultants_at(discretization,
                                           c,
                                           factor,
                                           shape.strains_at_quadrature,
                                           fields);
        field.evaluate(c, unit_points, to_real(cell, unit_points), error);
        error -= raw;
        for (unsigned int q = 0; q < shape.weights.size(); ++q)
          {
            raw.row(q) *= std::sqrt(shape.weights[q]);
            error.row(q) *= std::sqrt(shape.weights[q]);
          }
        e2.row(c) = (by_resultant(error) * coordinates).colwise().squaredNorm();
        (is_counted[c] == 0. ? u2 : counted_u2)
          .selfadjointView<Eigen::Upper>()
          .rankUpdate(by_resultant(raw).transpose());
        update_max_stress(cell, field, coordinates, vertex_is_done);
        field.finish(c);
      }
    u2 += counted_u2;

    for (std::size_t n = 0; n < times.size(); ++n)
      {
        const auto energy = [&](const Eigen::MatrixXd &energies) {
          const Eigen::VectorXd state = coordinates.col(n);
          return state.dot(energies.selfadjointView<Eigen::Upper>() * state);
        };
        integrate(times[n], e2.col(n), energy(counted_u2), energy(u2));
      }
  }



  void
  EnergyNormEstimator::integrate(const double           time,
                                 const Eigen::VectorXd &e2,
                                 const double           counted_u2,
                                 const double           u2)
  {
    const double counted_e2 = is_counted.dot(e2);
    const Norms  norms =
      Norms(counted_e2, counted_e2 + counted_u2, e2.sum(), e2.sum() + u2)
        .cwiseSqrt();
    Eigen::VectorXd relative = Eigen::VectorXd::Zero(e2.size());
    if (norms[1] > 0.)
      relative = e2.cwiseSqrt() / norms[1];

    const double half_step = 0.5 * (time - last_time);
    norm_integrals += half_step * (last_norms + norms);
    relative_integral += half_step * (last_relative + relative);
    last_time     = time;
    last_norms    = norms;
    last_relative = relative;
    sample_times.push_back(time);
    sample_errors.push_back(norms[1] > 0. ? norms[0] / norms[1] : 0.);
    if (kept_interval > 0 && sample_times.size() % kept_interval == 0)
      kept_element_errors.push_back(relative.cast<float>());
  }



  void
  EnergyNormEstimator::update_max_stress(
    const Triangulation<2>::active_cell_iterator &cell,
    RecoveredField                               &field,
    const Eigen::MatrixXd                        &coordinates,
    std::vector<bool>                            &vertex_is_done)
  {
    const Eigen::Matrix3d unscaled =
      root_of_compliance.topLeftCorner<3, 3>().inverse();
    RowMajorMatrix recovered;
    for (const unsigned int v : cell->vertex_indices())
      {
        // all cells recover the same there, or at an edge nearly so
        if (vertex_is_done[cell->vertex_index(v)])
          continue;
        vertex_is_done[cell->vertex_index(v)] = true;
        field.evaluate(cell->active_cell_index(),
                       {GeometryInfo<2>::unit_cell_vertex(v)},
                       {cell->vertex(v)},
                       recovered);
        const Eigen::MatrixXd moments =
          unscaled * by_resultant(recovered).topRows<3>() * coordinates;
        for (Eigen::Index n = 0; n < moments.cols(); ++n)
          {
            const Eigen::MatrixXd stresses =
              discretization.section().stresses(moments(0, n),
                                                moments(1, n),
                                                moments(2, n));
            max_stresses = max_stresses.size() == 0 ?
              stresses :
              max_stresses.cwiseMax(stresses).eval();
          }
      }
  }



  ErrorEstimate
  EnergyNormEstimator::estimate() const
  {
    ErrorEstimate result;
    if (norm_integrals[1] > 0.)
      {
        result.eta              = norm_integrals[0] / norm_integrals[1];
        result.eta_of_all_cells = norm_integrals[2] / norm_integrals[3];
      }
    result.n_singular_cells = std::lround(is_counted.size() - is_counted.sum());
    result.element_errors.assign(relative_integral.size(), 0.);
    if (last_time > 0.)
      Eigen::Map<Eigen::VectorXd>(result.element_errors.data(),
                                  relative_integral.size()) =
        relative_integral / last_time;
    result.max_stresses        = max_stresses;
    result.sample_times        = sample_times;
    result.sample_errors       = sample_errors;
    result.kept_element_errors = kept_element_errors;
    return result;
  }
} // namespace PlateImpact
