#include "plate_impact/estimator/recovered_field.h"

#include <deal.II/base/geometry_info.h>

#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  RecoveredField::RecoveredField(const StressRecovery &recovery,
                                 Sampler               sampler)
    : recovery(recovery)
    , sampler(std::move(sampler))
    , samples(recovery.n_cells())
    , coefficients(recovery.n_patches())
    , n_patches_to_come(samples.size())
    , n_cells_to_come(coefficients.size())
  {
    for (unsigned int patch = 0; patch < coefficients.size(); ++patch)
      for (const StressRecovery::Image &image : recovery.images(patch))
        ++n_patches_to_come[image.cell];
    for (unsigned int cell = 0; cell < samples.size(); ++cell)
      for (unsigned int v = 0; v < 4; ++v)
        for (const unsigned int patch : recovery.patches_at(cell, v))
          ++n_cells_to_come[patch];
  }



  void
  RecoveredField::fit(const unsigned int patch)
  {
    const auto &images = recovery.images(patch);
    for (const StressRecovery::Image &image : images)
      if (samples[image.cell].size() == 0)
        samples[image.cell] = sampler(image.cell);
    recovery.fit(patch, samples, coefficients[patch]);
    for (const StressRecovery::Image &image : images)
      if (--n_patches_to_come[image.cell] == 0)
        samples[image.cell] = {};
  }



  void
  RecoveredField::evaluate(const unsigned int           cell,
                           const std::vector<Point<2>> &unit_points,
                           const std::vector<Point<2>> &points,
                           RowMajorMatrix              &values)
  {
    const unsigned int n_points = unit_points.size();
    values.resize(n_points, 0);
    Eigen::VectorXd blend(n_points);
    Eigen::MatrixXd weights(n_points, StressRecovery::n_terms);
    for (unsigned int v = 0; v < 4; ++v)
      {
        for (unsigned int q = 0; q < n_points; ++q)
          blend[q] =
            GeometryInfo<2>::d_linear_shape_function(unit_points[q], v);
        if (blend.isZero(0.))
          continue;
        const auto &patches = recovery.patches_at(cell, v);
        for (const unsigned int patch : patches)
          {
            if (coefficients[patch].size() == 0)
              fit(patch);
            for (unsigned int q = 0; q < n_points; ++q)
              weights.row(q) = blend[q] / patches.size() *
                recovery.polynomial(patch, points[q]);
            if (values.cols() == 0)
              values.setZero(n_points, coefficients[patch].cols());
            values.noalias() += weights * coefficients[patch];
          }
      }
  }



  void
  RecoveredField::finish(const unsigned int cell)
  {
    for (unsigned int v = 0; v < 4; ++v)
      for (const unsigned int patch : recovery.patches_at(cell, v))
        if (--n_cells_to_come[patch] == 0)
          coefficients[patch] = {};
  }
} // namespace PlateImpact
