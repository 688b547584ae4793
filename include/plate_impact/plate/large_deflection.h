#pragma once

#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>
#include <Epetra_CrsMatrix.h>

#include <map>
#include <vector>

namespace PlateImpact
{
  /// A state of a plate with large deflections, at the quadrature points of
  /// its cells, a column each.
  struct StretchedPlate
  {
    Eigen::MatrixXd slopes;  ///< of the deflection, as SlopeSquares has them
    Eigen::MatrixXd strains; ///< of the middle surface, by their squares
    Eigen::MatrixXd forces;  ///< membrane forces of the linear plate, weighted
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
               double                damping) const;

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
    /// Weighted membrane forces of strains at the quadrature points of a cell.
    Eigen::VectorXd
    forces_of(Eigen::Index                             cell,
              const Eigen::Ref<const Eigen::VectorXd> &strains) const;

    /// Weighted forces of the linear plate, three a point, by the dofs of a
    /// cell that cause some.
    const Eigen::MatrixXd &
    forces_of_unknowns(const Eigen::Index cell) const
    {
      return by_shape.at(&plate.shape(cell));
    }

    const PlateDiscretization &plate;
    /// Among the dofs of a cell: of the deflection, and that cause forces.
    std::vector<unsigned int>                    deflections, causes;
    std::map<const CellShape *, Eigen::MatrixXd> by_shape;
  };
} // namespace PlateImpact
