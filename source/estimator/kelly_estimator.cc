#include "plate_impact/estimator/kelly_estimator.h"

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include "plate_impact/plate/plate_mesh.h"

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;


  void
  KellyEstimator::add_samples(const std::vector<double>               &times,
                              const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                              const Eigen::MatrixXd &coordinates)
  {
    amount->add_samples(times, vectors, coordinates);
    const Eigen::MatrixXd               unknowns = vectors * coordinates;
    std::vector<Vector<double>>         states;
    std::vector<Vector<float>>          jumps(times.size());
    std::vector<const Vector<double> *> solutions;
    std::vector<Vector<float> *>        errors;
    states.reserve(times.size());
    for (unsigned int n = 0; n < times.size(); ++n)
      {
        // deal.II has jumps as floats: states are scaled to numbers near 1
        const double largest = unknowns.col(n).cwiseAbs().maxCoeff();
        states.push_back(discretization.nodal_values(
          unknowns.col(n) / (largest > 0. ? largest : 1.)));
        solutions.push_back(&states[n]);
        errors.push_back(&jumps[n]);
      }
    // jumps of slopes and of rotations as energies
    const PlateSection &section = discretization.section();
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
    for (unsigned int n = 0; n < times.size(); ++n)
      {
        const Eigen::VectorXd eta =
          Eigen::Map<Eigen::VectorXf>(jumps[n].data(), jumps[n].size())
            .cast<double>();
        const double norm = eta.norm();
        shares.add(times[n], norm > 0. ? eta / norm : eta);
      }
  }



  ErrorEstimate
  KellyEstimator::estimate() const
  {
    ErrorEstimate result = amount->estimate();
    if (shares.time > 0.)
      for (unsigned int cell = 0; cell < result.element_errors.size(); ++cell)
        result.element_errors[cell] =
          result.eta * shares.integral[cell] / shares.time;
    return result;
  }
} // namespace PlateImpact
