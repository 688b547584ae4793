#include "plate_impact/estimator/energy_norm_estimator.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/estimator/kelly_indicator.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/LU>

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

    struct IndicatorRow
    {
      ErrorIndicator choice;
      std::string    word;
      /// Ranks the cells in place of their errors; null for the recovery.
      decltype(&jumps_of_cells) of_cells;
    };

    const std::vector<IndicatorRow> indicators = {
      {ErrorIndicator::SPR, "SPR", nullptr},
      {ErrorIndicator::Kelly, "Kelly", jumps_of_cells}};
  } // namespace



  template <>
  const std::vector<Word<ErrorIndicator>>
    Choices<ErrorIndicator>::words = words_of(indicators);



  EnergyNormEstimator::EnergyNormEstimator(
    const PlateDiscretization       &discretization,
    const StressRecovery            &recovery,
    const std::vector<unsigned int> &singular_cells,
    const bool                       singular_cells_count,
    const unsigned int               kept_interval,
    const ErrorIndicator             indicator)
    : discretization(discretization)
    , recovery(recovery)
    , kept_interval(kept_interval)
    , indicator(indicator)
    , is_regular(Eigen::VectorXd::Ones(discretization.mesh().n_active_cells()))
    , norms(Norms::Zero())
    , relative(Eigen::VectorXd::Zero(is_regular.size()))
    , ranks(relative)
  {
    for (const unsigned int cell : singular_cells)
      is_regular[cell] = 0.;
    samples.n_singular_cells     = singular_cells.size();
    samples.singular_cells_count = singular_cells_count;
  }



  void
  EnergyNormEstimator::add_samples(
    const std::vector<double>               &times,
    const Eigen::Ref<const Eigen::MatrixXd> &vectors,
    const Eigen::MatrixXd                   &coordinates)
  {
    if (const auto of_cells = row_of(indicator, indicators).of_cells)
      {
        const Eigen::MatrixXd values =
          of_cells(discretization, vectors * coordinates);
        for (std::size_t n = 0; n < times.size(); ++n)
          ranks.add(times[n], values.col(n).normalized());
      }
    const Eigen::Index batch =
      std::max<Eigen::Index>(1, max_numbers / vectors.rows());
    if (!discretization.is_nonlinear())
      if (const Eigen::MatrixXd combinations =
            leading_combinations(coordinates, span_tolerance);
          combinations.cols() <= batch)
        return evaluate(times,
                        vectors * combinations,
                        combinations.transpose() * coordinates);
    // each state is one of its own
    for (Eigen::Index first = 0; first < coordinates.cols(); first += batch)
      {
        const Eigen::Index size = std::min(batch, coordinates.cols() - first);
        evaluate({times.begin() + first, times.begin() + first + size},
                 vectors * coordinates.middleCols(first, size),
                 Eigen::MatrixXd::Identity(size, size));
      }
  }



  void
  EnergyNormEstimator::evaluate(const std::vector<double> &times,
                                const Eigen::MatrixXd     &fields,
                                const Eigen::MatrixXd     &coordinates)
  {
    const Triangulation<2> &mesh = discretization.mesh();
    EnergyRoots             roots(discretization, recovery, fields);
    const unsigned int      m = discretization.section().n_resultants();
    Eigen::MatrixXd         e2(mesh.n_active_cells(), times.size());
    // energies of pairs of fields
    Eigen::MatrixXd regular_u2 =
      Eigen::MatrixXd::Zero(fields.cols(), fields.cols());
    Eigen::MatrixXd   u2 = regular_u2;
    std::vector<bool> vertex_is_done(mesh.n_vertices());
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        roots.evaluate(cell);
        e2.row(c) =
          (by_resultant(roots.errors, m) * coordinates).colwise().squaredNorm();
        (is_regular[c] == 0. ? u2 : regular_u2)
          .selfadjointView<Eigen::Upper>()
          .rankUpdate(by_resultant(roots.resultants, m).transpose());
        update_max_stress(cell, roots.recovered, coordinates, vertex_is_done);
        roots.recovered.finish(cell);
      }
    u2 += regular_u2;

    const unsigned int first = samples.singular_cells_count ? 2 : 0;
    for (std::size_t n = 0; n < times.size(); ++n)
      {
        const auto energy = [&](const Eigen::MatrixXd &energies) {
          const Eigen::VectorXd state = coordinates.col(n);
          return state.dot(energies.selfadjointView<Eigen::Upper>() * state);
        };
        const double regular_e2 = is_regular.dot(e2.col(n)),
                     all_e2     = e2.col(n).sum();
        const Norms  squares(regular_e2,
                            regular_e2 + energy(regular_u2),
                            all_e2,
                            all_e2 + energy(u2));
        const Norms  now   = squares.cwiseSqrt();
        const double scale = now[first + 1] > 0. ? 1. / now[first + 1] : 0.;
        norms.add(times[n], now);
        relative.add(times[n], scale * e2.col(n).cwiseSqrt());
        samples.sample_times.push_back(times[n]);
        samples.sample_errors.push_back(scale * now[first]);
        if (kept_interval > 0 &&
            samples.sample_times.size() % kept_interval == 0)
          samples.kept_element_errors.push_back(relative.last.cast<float>());
      }
  }



  void
  EnergyNormEstimator::update_max_stress(const RecoveredField::Cell &cell,
                                         RecoveredField             &field,
                                         const Eigen::MatrixXd &coordinates,
                                         std::vector<bool>     &vertex_is_done)
  {
    const PlateSection   &section = discretization.section();
    const unsigned int    n       = section.n_for_stresses();
    const Eigen::MatrixXd unscaled =
      section.root_of_compliance().topLeftCorner(n, n).inverse();
    Eigen::MatrixXd &max_stresses = samples.max_stresses;
    for (const unsigned int v : cell->vertex_indices())
      {
        // all cells recover the same there, or at an edge nearly so
        if (vertex_is_done[cell->vertex_index(v)])
          continue;
        vertex_is_done[cell->vertex_index(v)] = true;
        const RowMajorMatrix recovered =
          field.evaluate(cell, {GeometryInfo<2>::unit_cell_vertex(v)});
        const Eigen::MatrixXd resultants = unscaled *
          by_resultant(recovered, section.n_resultants()).topRows(n) *
          coordinates;
        for (Eigen::Index state = 0; state < resultants.cols(); ++state)
          {
            const Eigen::MatrixXd stresses =
              section.stresses(resultants.col(state));
            max_stresses = max_stresses.size() == 0 ?
              stresses :
              max_stresses.cwiseMax(stresses).eval();
          }
      }
  }



  ErrorEstimate
  EnergyNormEstimator::estimate() const
  {
    ErrorEstimate result = samples;
    const auto    eta    = [this](const unsigned int first) {
      return norms.integral[first + 1] > 0. ?
              norms.integral[first] / norms.integral[first + 1] :
              0.;
    };
    result.eta_of_regular_cells = eta(0);
    result.eta_of_all_cells     = eta(2);
    result.eta = samples.singular_cells_count ? result.eta_of_all_cells :
                                                result.eta_of_regular_cells;
    const Eigen::VectorXd errors =
      row_of(indicator, indicators).of_cells == nullptr ?
      relative.integral :
      result.eta * ranks.integral;
    for (const double integral : errors)
      result.element_errors.push_back(
        relative.time > 0. ? integral / relative.time : 0.);
    return result;
  }
} // namespace PlateImpact
