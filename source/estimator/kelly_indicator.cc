#include "plate_impact/estimator/kelly_indicator.h"

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include "plate_impact/plate/plate_mesh.h"

namespace PlateImpact
{
  using namespace dealii;



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
    Eigen::MatrixXd result(discretization.mesh().n_active_cells(), n_states);
    for (unsigned int n = 0; n < n_states; ++n)
      result.col(n) =
        Eigen::Map<Eigen::VectorXf>(jumps[n].data(), jumps[n].size())
          .cast<double>();
    return result;
  }
} // namespace PlateImpact
