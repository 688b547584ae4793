#include "plate_impact/estimator/energy_norm_estimator.h"

#include <deal.II/base/function.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include "plate_impact/base/exceptions.h"
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



    /// Resultants at the quadrature points of a cell, point by point, a column
    /// per state, scaled so that their squares are energies.
    Eigen::MatrixXd
    resultants(const PlateDiscretization &discretization,
               const unsigned int         cell,
               const Eigen::MatrixXd     &states)
    {
      const PlateSection &section = discretization.section;
      return by_resultant(
        resultants_at(discretization,
                      cell,
                      section.root_of_compliance() * section.stiffness(),
                      discretization.shape(cell).at_quadrature,
                      states),
        section.n_resultants());
    }



    Eigen::MatrixXd
    columns(const std::vector<Snapshot> &snapshots)
    {
      Eigen::MatrixXd states(snapshots.front().unknowns.size(),
                             snapshots.size());
      for (unsigned int n = 0; n < snapshots.size(); ++n)
        states.col(n) = snapshots[n].unknowns;
      return states;
    }
  } // namespace



  template <>
  const std::vector<Word<ErrorIndicator>> Choices<ErrorIndicator>::words =
    {{ErrorIndicator::SPR, "SPR"}, {ErrorIndicator::Kelly, "Kelly"}};



  void
  visit_energies(const PlateDiscretization &discretization,
                 const StressRecovery      &recovery,
                 const Eigen::MatrixXd     &fields,
                 const EnergyVisitor       &visit)
  {
    // Resultants s are scaled to R s, whose square is their energy: recovery is
    // linear, and R mixes moments of the same parity only.
    const PlateSection   &section = discretization.section;
    const Eigen::MatrixXd factor =
      section.root_of_compliance() * section.stiffness();
    RecoveredField recovered(discretization, recovery, factor, fields);
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const unsigned int c     = cell->active_cell_index();
        const CellShape   &shape = discretization.shape(c);
        RowMajorMatrix     resultants =
          resultants_at(discretization, c, factor, shape.at_quadrature, fields);
        RowMajorMatrix errors =
          recovered.evaluate(cell,
                             discretization.element.quadrature.get_points()) -
          resultants;
        resultants.array().colwise() *= shape.weights.array().sqrt();
        errors.array().colwise() *= shape.weights.array().sqrt();
        visit(cell,
              by_resultant(resultants, factor.rows()),
              by_resultant(errors, factor.rows()),
              recovered);
        recovered.finish(cell);
      }
  }



  Eigen::MatrixXd
  jumps_of_cells(const PlateDiscretization &discretization,
                 const Eigen::MatrixXd     &states)
  {
    const unsigned int                  n_states = states.cols();
    std::vector<Vector<double>>         nodal(n_states);
    std::vector<Vector<float>>          jumps(n_states);
    std::vector<const Vector<double> *> solutions;
    std::vector<Vector<float> *>        errors;
    for (unsigned int n = 0; n < n_states; ++n)
      {
        // deal.II has jumps as floats: states are scaled to numbers near 1
        const double largest = states.col(n).cwiseAbs().maxCoeff();
        nodal[n]             = discretization.nodal_values(states.col(n) /
                                               (largest > 0. ? largest : 1.));
        solutions.push_back(&nodal[n]);
        errors.push_back(&jumps[n]);
      }
    // jumps of slopes and of rotations as energies
    const PlateSection &section = discretization.section;
    std::vector<double> roots(
      discretization.element.finite_element.n_components(),
      std::sqrt(section.membrane_stiffness.topLeftCorner<2, 2>().trace() / 2.));
    roots[deflection] = std::sqrt(section.mean_shear_stiffness());
    roots[rotation_x] = roots[rotation_y] =
      std::sqrt(section.mean_bending_stiffness());
    const Functions::ConstantFunction<2> coefficients(roots);
    KellyErrorEstimator<2>::estimate(mapping_of(discretization.mesh()),
                                     discretization.dof_handler(),
                                     QGauss<1>(3),
                                     {},
                                     solutions,
                                     errors,
                                     {},
                                     &coefficients);
    Eigen::MatrixXd result(discretization.mesh().n_active_cells(), n_states);
    for (unsigned int n = 0; n < n_states; ++n)
      result.col(n) =
        Eigen::Map<Eigen::VectorXf>(jumps[n].data(), jumps[n].size())
          .cast<double>();
    return result;
  }



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
    , norms{Eigen::Vector4d::Zero()}
    , relative{Eigen::VectorXd::Zero(is_regular.size())}
    , ranks(relative)
  {
    for (const unsigned int cell : singular_cells)
      is_regular[cell] = 0.;
    samples.n_singular_cells     = singular_cells.size();
    samples.singular_cells_count = singular_cells_count;
    const PlateSection &section  = discretization.section;
    samples.max_stresses =
      section.stresses(Eigen::VectorXd::Zero(section.n_for_stresses()));
  }



  void
  EnergyNormEstimator::add_samples(
    const std::vector<double>               &times,
    const Eigen::Ref<const Eigen::MatrixXd> &vectors,
    const Eigen::MatrixXd                   &coordinates)
  {
    if (indicator == ErrorIndicator::Kelly)
      {
        const Eigen::MatrixXd values =
          jumps_of_cells(discretization, vectors * coordinates);
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
    Eigen::MatrixXd         e2(mesh.n_active_cells(), times.size());
    // energies of pairs of fields
    Eigen::MatrixXd regular_u2 =
      Eigen::MatrixXd::Zero(fields.cols(), fields.cols());
    Eigen::MatrixXd   u2 = regular_u2;
    std::vector<bool> vertex_is_done(mesh.n_vertices());
    visit_energies(
      discretization,
      recovery,
      fields,
      [&](const auto &cell, const auto &u, const auto &e, auto &recovered) {
        const unsigned int c = cell->active_cell_index();
        e2.row(c)            = (e * coordinates).colwise().squaredNorm();
        (is_regular[c] == 0. ? u2 : regular_u2)
          .selfadjointView<Eigen::Upper>()
          .rankUpdate(u.transpose());
        update_max_stress(cell, recovered, coordinates, vertex_is_done);
      });
    u2 += regular_u2;

    const auto energies = [&](const Eigen::MatrixXd &of_pairs) {
      return Eigen::RowVectorXd(
        (of_pairs.selfadjointView<Eigen::Upper>() * coordinates)
          .cwiseProduct(coordinates)
          .colwise()
          .sum());
    };
    Eigen::MatrixXd squares(4, times.size());
    squares.row(0) = is_regular.transpose() * e2;
    squares.row(1) = squares.row(0) + energies(regular_u2);
    squares.row(2) = e2.colwise().sum();
    squares.row(3) = squares.row(2) + energies(u2);

    const unsigned int first = samples.singular_cells_count ? 2 : 0;
    for (std::size_t n = 0; n < times.size(); ++n)
      {
        const Eigen::Vector4d now = squares.col(n).cwiseSqrt();
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
    const PlateSection   &section = discretization.section;
    const unsigned int    n       = section.n_for_stresses();
    const Eigen::MatrixXd unscaled =
      section.root_of_compliance().topLeftCorner(n, n).inverse();
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
        for (const auto &state : resultants.colwise())
          samples.max_stresses =
            samples.max_stresses.cwiseMax(section.stresses(state)).eval();
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
    const Eigen::VectorXd errors = indicator == ErrorIndicator::SPR ?
      relative.integral :
      result.eta * ranks.integral;
    for (const double integral : errors)
      result.element_errors.push_back(
        relative.time > 0. ? integral / relative.time : 0.);
    return result;
  }



  ReferenceError::ReferenceError(const PlateDiscretization   &fine,
                                 const std::vector<Snapshot> &snapshots)
  {
    const Eigen::MatrixXd        states = columns(snapshots);
    const std::vector<Point<2>> &unit_points =
      fine.element.quadrature.get_points();
    const unsigned int m = fine.section.n_resultants();
    exact.resize(m * unit_points.size() * fine.mesh().n_active_cells(),
                 states.cols());
    for (const auto &cell : fine.mesh().active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        exact.middleRows(m * points.size(), m * unit_points.size()) =
          resultants(fine, c, states);
        for (unsigned int q = 0; q < unit_points.size(); ++q)
          {
            points.push_back(
              mapping_of(cell).transform_unit_to_real_cell(cell,
                                                           unit_points[q]));
            weights.push_back(fine.shape(c).weights[q]);
          }
      }
  }



  double
  ReferenceError::of(const PlateDiscretization   &discretization,
                     const std::vector<Snapshot> &snapshots) const
  {
    const unsigned int           m      = discretization.section.n_resultants();
    const Eigen::MatrixXd        states = columns(snapshots);
    std::vector<Eigen::MatrixXd> of_cell;
    for (unsigned int c = 0; c < discretization.mesh().n_active_cells(); ++c)
      of_cell.push_back(resultants(discretization, c, states));
    const Quadrature<2> &quadrature = discretization.element.quadrature;
    // between the points of a tensor-product Gauss rule
    const FE_DGQArbitraryNodes<2> interpolation(
      QGauss<1>(std::lround(std::sqrt(quadrature.size()))));
    const Mapping<2>         &mapping = mapping_of(discretization.mesh());
    const GridTools::Cache<2> cache(discretization.mesh(), mapping);
    // curved cells of two meshes differ by a little at the edge, of a cell
    const double       tolerance = &mapping == &curved_mapping() ? 0.05 : 1e-10;
    auto               hint      = discretization.mesh().begin_active();
    Eigen::RowVectorXd e2 = Eigen::RowVectorXd::Zero(snapshots.size()), u2 = e2;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const auto [cell, unit_point] =
          GridTools::find_active_cell_around_point(cache,
                                                   points[p],
                                                   hint,
                                                   {},
                                                   tolerance);
        if (cell == discretization.mesh().end())
          throw ComputationError("a point of the reference lies outside of the "
                                 "mesh that is compared");
        hint                  = cell;
        Eigen::MatrixXd error = exact.middleRows(m * p, m);
        u2 += weights[p] * error.colwise().squaredNorm();
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          error -= interpolation.shape_value(q, unit_point) *
            of_cell[cell->active_cell_index()].middleRows(m * q, m);
        e2 += weights[p] * error.colwise().squaredNorm();
      }
    TimeIntegral<Eigen::Array2d> norms{Eigen::Array2d::Zero()};
    for (unsigned int n = 0; n < snapshots.size(); ++n)
      norms.add(snapshots[n].time, Eigen::Array2d(e2[n], u2[n]).sqrt());
    return norms.integral[0] / norms.integral[1];
  }
} // namespace PlateImpact
