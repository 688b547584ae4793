#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include <Eigen/SparseCore>

#include <vector>

namespace PlateImpact
{
  /// The degrees of freedom that homogeneous constraints leave free, numbered
  /// without gaps, and what cells see of them: each of a cell's nodal values is
  /// a sum of free unknowns with weights.
  class FreeUnknowns
  {
  public:
    /// @param constraints  closed; both must outlive this object
    void
    reinit(const dealii::DoFHandler<2>             &dof_handler,
           const dealii::AffineConstraints<double> &constraints);

    unsigned int
    size() const
    {
      return components_of.size();
    }

    /// Whether two unknowns give values to the same component, a deflection or
    /// a rotation. Edges in any direction give one unknown to both rotations.
    bool
    share_component(unsigned int one, unsigned int other) const
    {
      return (components_of[one] & components_of[other]) != 0;
    }

    /// Those of a cell, in ascending order.
    std::vector<dealii::types::global_dof_index>
    of_cell(unsigned int cell) const;

    /// A cell's matrix in terms of its free unknowns.
    /// @param unknowns  of_cell(cell)
    Eigen::MatrixXd
    resolve_constraints(
      unsigned int                                        cell,
      const std::vector<dealii::types::global_dof_index> &unknowns,
      const Eigen::MatrixXd                              &matrix) const;

    /// Values of a cell's nodal quantities, dofs of the cell x n.
    /// @param cell      active cell index
    /// @param unknowns  size() x n
    Eigen::MatrixXd
    cell_values(unsigned int                             cell,
                const Eigen::Ref<const Eigen::MatrixXd> &unknowns) const
    {
      return nodal_values_of_cells.middleRows(n_cell_dofs * cell, n_cell_dofs) *
        unknowns;
    }

    /// Values of the nodal quantities of all cells, a column each.
    Eigen::MatrixXd
    values_of_cells(const Eigen::VectorXd &unknowns) const;

    /// Forces on the unknowns from those on the nodal quantities of all cells,
    /// a column each.
    Eigen::VectorXd
    forces(const Eigen::MatrixXd &of_cells) const;

    /// Those of values at all nodes, by degree of freedom.
    Eigen::VectorXd
    of_nodal_values(const dealii::Vector<double> &values) const;

    /// Values at all nodes, by degree of freedom.
    dealii::Vector<double>
    nodal_values(const Eigen::VectorXd &unknowns) const;

  private:
    const dealii::AffineConstraints<double> *constraints = nullptr;
    int                                      n_cell_dofs = 0;
    std::vector<int>          unknown_of_dof; ///< -1 for constrained ones
    std::vector<unsigned int> components_of;  ///< of an unknown, a bit each

    /// A row for each nodal value of each cell, by unknowns.
    Eigen::SparseMatrix<double, Eigen::RowMajor> nodal_values_of_cells;
  };
} // namespace PlateImpact
