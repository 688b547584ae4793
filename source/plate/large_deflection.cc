#include "plate_impact/plate/large_deflection.h"

namespace PlateImpact
{
  LargeDeflection::LargeDeflection(const PlateDiscretization &plate)
    : plate(plate)
    , deflections(plate.element.dofs_of(deflection))
  {
    const PlateSection   &section    = plate.section();
    const Eigen::MatrixXd of_strains = section.stiffness().bottomRows<3>();
    for (unsigned int c = section.is_unsymmetric() ? rotation_x :
                                                     displacement_x;
         c < plate.element.finite_element.n_components();
         ++c)
      {
        const auto dofs = plate.element.dofs_of(c);
        causes.insert(causes.end(), dofs.begin(), dofs.end());
      }
    for (unsigned int cell = 0; cell < plate.mesh().n_active_cells(); ++cell)
      {
        const CellShape &shape     = plate.shape(cell);
        const auto [known, is_new] = by_shape.insert({&shape, {}});
        if (!is_new)
          continue;
        Eigen::MatrixXd &forces = known->second;
        forces.resize(3 * shape.weights.size(), causes.size());
        const Eigen::MatrixXd strains =
          shape.at_quadrature.linear(Eigen::all, causes);
        for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
          forces.middleRows<3>(3 * q) = shape.weights[q] * of_strains *
            strains.middleRows(of_strains.cols() * q, of_strains.cols());
      }
  }



  Eigen::VectorXd
  LargeDeflection::forces_of(
    const Eigen::Index                       cell,
    const Eigen::Ref<const Eigen::VectorXd> &strains) const
  {
    const Eigen::VectorXd &weights = plate.shape(cell).weights;
    Eigen::VectorXd        result(strains.size());
    for (Eigen::Index q = 0; q < weights.size(); ++q)
      result.segment<3>(3 * q).noalias() = weights[q] *
        (plate.section().membrane_stiffness * strains.segment<3>(3 * q));
    return result;
  }



  StretchedPlate
  LargeDeflection::stretched(const Eigen::VectorXd &unknowns) const
  {
    const Eigen::MatrixXd values  = plate.values_of_cells(unknowns),
                          causing = values(causes, Eigen::all);
    StretchedPlate result;
    result.slopes = SlopeSquares::slopes() * values(deflections, Eigen::all);
    result.strains.resize(3 * plate.element.quadrature.size(), values.cols());
    result.forces.resize(result.strains.rows(), values.cols());
    for (Eigen::Index cell = 0; cell < values.cols(); ++cell)
      {
        auto strains      = result.strains.col(cell),
             forces       = result.forces.col(cell);
        strains.noalias() = plate.shape(cell).at_quadrature.of_squares *
          SlopeSquares::squares(result.slopes.col(cell));
        forces.noalias() = forces_of_unknowns(cell) * causing.col(cell);
        result.energy += strains.dot(forces + 0.5 * forces_of(cell, strains));
      }
    result.energy *= plate.n_parts;
    return result;
  }



  Eigen::VectorXd
  LargeDeflection::mean_forces(const StretchedPlate &begin,
                               const StretchedPlate &end,
                               const double          damping) const
  {
    const Eigen::MatrixXd strains = (0.5 - damping) * begin.strains +
      (0.5 + damping) * end.strains,
                          forces = (0.5 - damping) * begin.forces +
      (0.5 + damping) * end.forces,
                          slopes = 0.5 * (begin.slopes + end.slopes);
    Eigen::MatrixXd of_cells =
      Eigen::MatrixXd::Zero(plate.element.finite_element.n_dofs_per_cell(),
                            strains.cols());
    for (Eigen::Index cell = 0; cell < of_cells.cols(); ++cell)
      {
        of_cells(causes, cell) =
          forces_of_unknowns(cell).transpose() * strains.col(cell);
        const Eigen::VectorXd of_squares =
          plate.shape(cell).at_quadrature.of_squares.transpose() *
          (forces.col(cell) + forces_of(cell, strains.col(cell)));
        of_cells(deflections, cell) =
          SlopeSquares::derivative(slopes.col(cell)).transpose() * of_squares;
      }
    return plate.n_parts * plate.forces_on_unknowns(of_cells);
  }



  double
  LargeDeflection::dissipated(const StretchedPlate &begin,
                              const StretchedPlate &end,
                              const double          damping) const
  {
    const Eigen::MatrixXd strains = end.strains - begin.strains,
                          forces  = end.forces - begin.forces;
    double sum                    = 0.;
    for (Eigen::Index cell = 0; cell < strains.cols(); ++cell)
      sum += strains.col(cell).dot(2. * forces.col(cell) +
                                   forces_of(cell, strains.col(cell)));
    return damping * plate.n_parts * sum;
  }



  void
  LargeDeflection::add_tangent(const StretchedPlate &begin,
                               const StretchedPlate &end,
                               const double          damping,
                               const bool            with_stresses,
                               Epetra_CrsMatrix     &sum) const
  {
    plate.add_cells(
      [&](const unsigned int cell) {
        const Eigen::MatrixXd &of_squares =
          plate.shape(cell).at_quadrature.of_squares;
        const Eigen::VectorXd slopes =
          0.5 * (begin.slopes.col(cell) + end.slopes.col(cell));
        const Eigen::MatrixXd strains =
          (1. + 2. * damping) * of_squares * SlopeSquares::derivative(slopes);
        Eigen::MatrixXd forces(strains.rows(), strains.cols());
        for (Eigen::Index node = 0; node < strains.cols(); ++node)
          forces.col(node) = forces_of(cell, strains.col(node));
        const Eigen::MatrixXd of_causes =
          forces_of_unknowns(cell).transpose() * strains;
        const unsigned int n_dofs =
          plate.element.finite_element.n_dofs_per_cell();
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n_dofs, n_dofs);
        K(deflections, deflections) =
          strains.transpose() * forces / (1. + 2. * damping);
        K(causes, deflections) += of_causes;
        K(deflections, causes) += of_causes.transpose();
        if (!with_stresses)
          return K;
        const Eigen::VectorXd halfway =
          0.5 * (begin.strains.col(cell) + end.strains.col(cell));
        const Eigen::VectorXd stresses =
          0.5 * (begin.forces.col(cell) + end.forces.col(cell)) +
          forces_of(cell, halfway);
        K(deflections, deflections) +=
          SlopeSquares::second_derivative(of_squares.transpose() * stresses);
        return K;
      },
      sum);
  }
} // namespace PlateImpact
