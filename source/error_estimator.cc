#include "plate_impact/error_estimator.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    std::vector<Point<2>>
    to_real(const Triangulation<2>::active_cell_iterator &cell,
            const std::vector<Point<2>>                  &unit_points)
    {
      const MappingQ1<2>    mapping;
      std::vector<Point<2>> points;
      for (const Point<2> &unit_point : unit_points)
        points.push_back(mapping.transform_unit_to_real_cell(cell, unit_point));
      return points;
    }



    /// Resultants of strains, both 5 per point by any number of columns.
    void
    multiply_by_section(const PlateSection &section, Eigen::MatrixXd &values)
    {
      for (Eigen::Index q = 0; q < values.rows(); q += 5)
        {
          values.middleRows<3>(q) =
            (section.bending_stiffness * values.middleRows<3>(q)).eval();
          values.middleRows<2>(q + 3) *= section.shear_stiffness;
        }
    }



    /// Samples to evaluate together: many make matrix products fast; on large
    /// meshes, where one is work enough, few save memory.
    unsigned int
    buffer_size(const unsigned int n_cells)
    {
      return std::clamp(200000u / n_cells, 1u, 16u);
    }



    std::vector<Point<2>>
    corners()
    {
      std::vector<Point<2>> points;
      for (const unsigned int v : GeometryInfo<2>::vertex_indices())
        points.push_back(GeometryInfo<2>::unit_cell_vertex(v));
      return points;
    }
  } // namespace



  double
  ErrorEstimate::max_element_error() const
  {
    return *std::max_element(element_errors.begin(), element_errors.end());
  }



  ErrorEstimator::ErrorEstimator(
    const PlateModel                            &model,
    const double                                 target_error,
    const std::vector<unsigned int>             &singular_cells,
    const std::function<bool(const Point<2> &)> &is_rough)
    : model(model)
    , target(target_error)
    , recovery(model.mesh(), is_rough)
    , is_counted(Eigen::VectorXd::Ones(model.mesh().n_active_cells()))
    , buffer(model.n_unknowns(), buffer_size(model.mesh().n_active_cells()))
    , norm_integrals(Norms::Zero())
    , last_norms(Norms::Zero())
    , xi_integral(Eigen::VectorXd::Zero(model.mesh().n_active_cells()))
    , last_xi(xi_integral)
  {
    for (const unsigned int cell : singular_cells)
      is_counted[cell] = 0.;
  }



  void
  ErrorEstimator::add_sample(const double time, const Eigen::VectorXd &unknowns)
  {
    buffer.col(buffered_times.size()) = unknowns;
    buffered_times.push_back(time);
    ++samples;
    if (buffered_times.size() == static_cast<std::size_t>(buffer.cols()))
      evaluate_buffer();
  }



  Eigen::MatrixXd
  ErrorEstimator::sampled_resultants(const Eigen::MatrixXd &unknowns) const
  {
    const unsigned int rows_per_cell =
      StressRecovery::samples_per_cell * StressRecovery::n_resultants;
    const unsigned int n_cells = model.mesh().n_active_cells();
    Eigen::MatrixXd    samples(n_cells * rows_per_cell, unknowns.cols());
    Eigen::MatrixXd    values;
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      {
        model.cell_values(cell, unknowns, values);
        samples.middleRows(rows_per_cell * cell, rows_per_cell).noalias() =
          model.shape(cell).strains_at_samples * values;
      }
    multiply_by_section(model.section(), samples);
    return samples;
  }



  void
  ErrorEstimator::evaluate_buffer()
  {
    const unsigned int n_times = buffered_times.size();
    if (n_times == 0)
      return;
    const auto            unknowns = buffer.leftCols(n_times);
    const Eigen::MatrixXd coefficients =
      recovery.coefficients(sampled_resultants(unknowns));

    const PlateSection          &section = model.section();
    const std::vector<Point<2>> &unit_points =
      model.element().quadrature().get_points();
    const unsigned int n_cells = model.mesh().n_active_cells();
    Eigen::MatrixXd    e2      = Eigen::MatrixXd::Zero(n_cells, n_times);
    Eigen::MatrixXd    u2      = e2;
    Eigen::MatrixXd    values, resultants, recovered;
    for (const auto &cell : model.mesh().active_cell_iterators())
      {
        const unsigned int c     = cell->active_cell_index();
        const CellShape   &shape = model.shape(c);
        model.cell_values(c, unknowns, values);
        resultants.noalias() = shape.strains_at_quadrature * values;
        multiply_by_section(section, resultants);
        recovery.evaluate(c,
                          unit_points,
                          to_real(cell, unit_points),
                          coefficients,
                          recovered);
        recovered -= resultants;
        for (unsigned int n = 0; n < n_times; ++n)
          for (unsigned int q = 0; q < shape.weights.size(); ++q)
            {
              const double weight = shape.weights[q];
              e2(c, n) += weight *
                section.energy_density(recovered.col(n).segment<5>(5 * q));
              u2(c, n) += weight *
                section.energy_density(resultants.col(n).segment<5>(5 * q));
            }
      }
    update_max_stress(coefficients);
    for (unsigned int n = 0; n < n_times; ++n)
      integrate(buffered_times[n], e2.col(n), u2.col(n));
    buffered_times.clear();
  }



  void
  ErrorEstimator::integrate(const double           time,
                            const Eigen::VectorXd &e2,
                            const Eigen::VectorXd &u2)
  {
    const double counted_e2 = is_counted.dot(e2),
                 counted_u2 = is_counted.dot(u2);
    const Norms norms =
      Norms(counted_e2, counted_e2 + counted_u2, e2.sum(), e2.sum() + u2.sum())
        .cwiseSqrt();
    const double    e_m = target * norms[3] / std::sqrt(double(e2.size()));
    Eigen::VectorXd xi  = Eigen::VectorXd::Zero(e2.size());
    if (e_m > 0.)
      xi = e2.cwiseSqrt() / e_m;

    const double half_step = 0.5 * (time - last_time);
    norm_integrals += half_step * (last_norms + norms);
    xi_integral += half_step * (last_xi + xi);
    last_time  = time;
    last_norms = norms;
    last_xi    = xi;
  }



  void
  ErrorEstimator::update_max_stress(const Eigen::MatrixXd &coefficients)
  {
    Eigen::MatrixXd             recovered;
    const std::vector<Point<2>> unit_points = corners();
    for (const auto &cell : model.mesh().active_cell_iterators())
      {
        recovery.evaluate(cell->active_cell_index(),
                          unit_points,
                          to_real(cell, unit_points),
                          coefficients,
                          recovered);
        for (Eigen::Index n = 0; n < recovered.cols(); ++n)
          for (Eigen::Index q = 0; q < recovered.rows(); q += 5)
            max_stress = std::max(
              max_stress,
              model.section().surface_von_mises_stress(recovered(q, n),
                                                       recovered(q + 1, n),
                                                       recovered(q + 2, n)));
      }
  }



  ErrorEstimate
  ErrorEstimator::estimate()
  {
    evaluate_buffer();
    ErrorEstimate result;
    if (norm_integrals[1] > 0.)
      {
        result.eta              = norm_integrals[0] / norm_integrals[1];
        result.eta_of_all_cells = norm_integrals[2] / norm_integrals[3];
      }
    result.n_singular_cells = std::lround(is_counted.size() - is_counted.sum());
    result.element_errors.assign(xi_integral.size(), 0.);
    if (last_time > 0.)
      Eigen::Map<Eigen::VectorXd>(result.element_errors.data(),
                                  xi_integral.size()) = xi_integral / last_time;
    result.max_effective_stress = max_stress;
    return result;
  }



  Eigen::MatrixXd
  ErrorEstimator::recovered_resultants(
    const Eigen::VectorXd       &unknowns,
    const std::vector<Point<2>> &unit_points) const
  {
    const Eigen::MatrixXd coefficients =
      recovery.coefficients(sampled_resultants(unknowns));
    Eigen::MatrixXd result(5 * unit_points.size(),
                           model.mesh().n_active_cells());
    Eigen::MatrixXd values;
    for (const auto &cell : model.mesh().active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        recovery.evaluate(c,
                          unit_points,
                          to_real(cell, unit_points),
                          coefficients,
                          values);
        result.col(c) = values;
      }
    return result;
  }



  unsigned int
  ErrorEstimator::n_samples() const
  {
    return samples;
  }
} // namespace PlateImpact
