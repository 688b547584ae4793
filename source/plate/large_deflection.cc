#include "plate_impact/plate/large_deflection.h"

namespace PlateImpact
{
  namespace
  {
    /// Of the squares of slopes, with respect to the nine deflections.
    Eigen::MatrixXd
    derivative_of_squares(const Eigen::VectorXd &slopes)
    {
      constexpr int          n     = SlopeSquares::n_squares;
      const Eigen::MatrixXd &per_w = SlopeSquares::slopes();
      return slopes.tail<n>().asDiagonal() * per_w.topRows<n>() +
        slopes.head<n>().asDiagonal() * per_w.bottomRows<n>();
    }
  } // namespace



  LargeDeflection::LargeDeflection(const PlateDiscretization &plate)
    : plate(plate)
    , deflections(plate.element.dofs_of(deflection))
  {
    const Eigen::MatrixXd of_strains =
      plate.section.stiffness().bottomRows<3>();
    for (unsigned int cell = 0; cell < plate.mesh().n_active_cells(); ++cell)
      {
        const CellShape &shape     = plate.shape(cell);
        const auto [known, is_new] = by_shape.insert({&shape, {}});
        if (!is_new)
          continue;
        const auto &[linear, of_squares] = shape.at_quadrature;
        auto &[per_dof, per_square]      = known->second;
        per_dof.setZero(of_squares.cols(), linear.cols());
        per_square.setZero(of_squares.cols(), of_squares.cols());
        for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
          {
            const auto            squares = of_squares.middleRows<3>(3 * q);
            const Eigen::MatrixXd forces =
              shape.weights[q] * squares.transpose() * of_strains;
            per_dof +=
              forces * linear.middleRows(forces.cols() * q, forces.cols());
            per_square += forces.rightCols<3>() * squares;
          }
      }
  }



  StretchedPlate
  LargeDeflection::stretched(const Eigen::VectorXd &unknowns) const
  {
    const Eigen::MatrixXd values = plate.values_of_cells(unknowns);
    StretchedPlate        result;
    result.slopes  = SlopeSquares::slopes() * values(deflections, Eigen::all);
    result.squares = SlopeSquares::squares(result.slopes);
    result.forces.resizeLike(result.squares);
    for (Eigen::Index cell = 0; cell < values.cols(); ++cell)
      {
        const auto &[per_dof, per_square] = forces_of(cell);
        const auto squares                = result.squares.col(cell);
        auto       forces                 = result.forces.col(cell);
        forces.noalias()                  = per_dof * values.col(cell);
        result.energy += squares.dot(forces + 0.5 * per_square * squares);
      }
    result.energy *= plate.n_parts;
    return result;
  }



  Eigen::VectorXd
  LargeDeflection::mean_forces(const StretchedPlate &begin,
                               const StretchedPlate &end,
                               const double          damping) const
  {
    const double    of_begin = 0.5 - damping, of_end = 0.5 + damping;
    Eigen::MatrixXd of_cells(plate.element.finite_element.n_dofs_per_cell(),
                             begin.squares.cols());
    for (Eigen::Index cell = 0; cell < of_cells.cols(); ++cell)
      {
        const auto &[per_dof, per_square] = forces_of(cell);
        const Eigen::VectorXd squares     = of_begin * begin.squares.col(cell) +
          of_end * end.squares.col(cell),
                              forces = of_begin * begin.forces.col(cell) +
          of_end * end.forces.col(cell) + per_square * squares,
                              slopes = 0.5 *
          (begin.slopes.col(cell) + end.slopes.col(cell));
        of_cells.col(cell) = per_dof.transpose() * squares;
        of_cells(deflections, cell) +=
          derivative_of_squares(slopes).transpose() * forces;
      }
    return plate.n_parts * plate.forces_on_unknowns(of_cells);
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
        const auto &[per_dof, per_square] = forces_of(cell);
        const double          factor      = 1. + 2. * damping;
        const Eigen::MatrixXd squares =
                                derivative_of_squares(0.5 *
                                                      (begin.slopes.col(cell) +
                                                       end.slopes.col(cell))),
                              of_dofs = factor * per_dof.transpose() * squares;
        Eigen::MatrixXd K =
          Eigen::MatrixXd::Zero(per_dof.cols(), per_dof.cols());
        K(Eigen::all, deflections) += of_dofs;
        K(deflections, Eigen::all) += of_dofs.transpose();
        K(deflections, deflections) +=
          factor * squares.transpose() * per_square * squares;
        if (!with_stresses)
          return K;
        const Eigen::VectorXd forces = 0.5 *
          (begin.forces.col(cell) + end.forces.col(cell) +
           per_square * (begin.squares.col(cell) + end.squares.col(cell)));
        constexpr int          n      = SlopeSquares::n_squares;
        const Eigen::MatrixXd &per_w  = SlopeSquares::slopes();
        const Eigen::MatrixXd  second = per_w.topRows<n>().transpose() *
          forces.asDiagonal() * per_w.bottomRows<n>();
        K(deflections, deflections) += second + second.transpose();
        return K;
      },
      sum);
  }
} // namespace PlateImpact
