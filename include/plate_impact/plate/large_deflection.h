#pragma once

#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>
#include <Epetra_CrsMatrix.h>

#include <map>
#include <vector>

namespace PlateImpact
{
  /// A state of a plate with large deflections, a column per cell.
  struct StretchedPlate
  {
    Eigen::MatrixXd slopes;  ///< of the deflection, as SlopeSquares has them
    Eigen::MatrixXd squares; ///< SlopeSquares::squares() of them
    Eigen::MatrixXd forces;  ///< conjugate to squares, of the linear plate
    double          energy = 0.; ///< beyond that of the linear plate [J]
  };


  /// What a plate with large deflections answers beyond the linear plate: von
  /// Karman's strains of the middle surface, with first-order shear (Reddy
  /// 2004, Mechanics of Laminated Composite Plates and Shells, sec. 10.2). As
  /// they are quadratic in the unknowns, the mean of the stresses at both ends
  /// of a change, with the strains as they vary halfway, does exactly the work
  /// that the energy changes by (Simo & Tarnow 1992, doi:10.1007/BF00913408).
  class LargeDeflection
  {
  public:
    /// @param plate  assembled, nonlinear; must outlive this object
    explicit LargeDeflection(const PlateDiscretization &plate);

    /// @param unknowns  of the plate
    StretchedPlate
    stretched(const Eigen::VectorXd &unknowns) const;

    /// Mean forces on the unknowns during a change, beside K times their mean:
    /// with no damping the work of both is the change of the energy.
    /// @param damping  b over the time of the change: stresses have b times the
    ///                 rate of the strains, too [-]
    Eigen::VectorXd
    mean_forces(const StretchedPlate &begin,
                const StretchedPlate &end,
                double                damping = 0.) const;

    /// Energy that damping takes in a change, beyond the linear plate. [J]
    double
    dissipated(const StretchedPlate &begin,
               const StretchedPlate &end,
               const double          damping) const
    {
      const Eigen::MatrixXd squares = end.squares - begin.squares,
                            forces  = end.forces - begin.forces;
      double sum                    = 0.;
      for (Eigen::Index cell = 0; cell < squares.cols(); ++cell)
        sum +=
          squares.col(cell).dot(2. * forces.col(cell) +
                                forces_of(cell).per_square * squares.col(cell));
      return damping * plate.n_parts * sum;
    }

    /// Adds the derivative of twice the mean forces with respect to the end,
    /// about: symmetric, with the strains halfway. That of the forces for a
    /// change that is none.
    /// @param with_stresses  adds what the stresses halfway contribute, which
    ///                       may take away positive definiteness
    /// @param sum            with the entries of K
    void
    add_tangent(const StretchedPlate &begin,
                const StretchedPlate &end,
                double                damping,
                bool                  with_stresses,
                Epetra_CrsMatrix     &sum) const;

  private:
    /// Forces conjugate to squares of slopes, of cells of one shape, per dof of
    /// the cell and per square.
    struct Forces
    {
      Eigen::MatrixXd per_dof, per_square;
    };

    const Forces &
    forces_of(const Eigen::Index cell) const
    {
      return by_shape.at(&plate.shape(cell));
    }

    const PlateDiscretization          &plate;
    const std::vector<unsigned int>     deflections; ///< dofs of a cell
    std::map<const CellShape *, Forces> by_shape;
  };
} // namespace PlateImpact
