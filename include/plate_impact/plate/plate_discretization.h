#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/plate/plate_section.h"

#include <Eigen/SparseCore>
#include <Epetra_CrsMatrix.h>

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace PlateImpact
{
  /// The plate on one mesh: unknowns, supports, K and M.
  ///
  /// Only degrees of freedom that constraints leave free are unknowns, numbered
  /// without gaps: hanging nodes, supports, symmetry and the centre nodes of
  /// the element are resolved within each cell, whose nodal values are sums of
  /// unknowns with weights. K, M and loads are those of the whole plate moving
  /// symmetrically, `n_parts` times those of the part that is meshed (4 for a
  /// quadrant): forces and energies need no factor anywhere else.
  ///
  /// K and M are serial Epetra matrices: TrilinosWrappers::SparseMatrix needs
  /// MPI, whose start costs more than a small scene.
  class PlateDiscretization
  {
  public:
    const PlateElement &element;
    const double        n_parts; ///< like the one that is meshed in the plate
    const PlateSection  section;

    /// Numbers the unknowns; the mesh must outlive the discretization.
    /// @param n_parts  0: as many as the symmetry of the plate leaves
    PlateDiscretization(const dealii::Triangulation<2> &mesh,
                        const PlateElement             &element,
                        const PlateParameters          &plate,
                        double                          n_parts = 0.);

    /// Builds K and M.
    void
    assemble();

    unsigned int
    n_unknowns() const
    {
      return dof_of_unknown.size();
    }

    const Epetra_CrsMatrix &
    stiffness() const
    {
      return *K;
    }

    const Epetra_CrsMatrix &
    mass() const
    {
      return *M;
    }

    /// Forces conjugate to the unknowns under a unit force on the whole plate,
    /// distributed over these points; its product with the unknowns is the
    /// load-weighted deflection, or w + beta div theta in place of the
    /// deflection w.
    /// @param rotation_factor  beta [m^2]
    /// @throws ComputationError when a point lies outside of the mesh
    Eigen::VectorXd
    load(const std::vector<LoadPoint> &points,
         double                        rotation_factor = 0.) const;

    /// Values of a cell's nodal quantities, dofs of the cell x n.
    /// @param cell      active cell index
    /// @param unknowns  n_unknowns() x n
    Eigen::MatrixXd
    cell_values(unsigned int                             cell,
                const Eigen::Ref<const Eigen::MatrixXd> &unknowns) const
    {
      const int n = element.finite_element.n_dofs_per_cell();
      return nodal_values_of_cells.middleRows(n * cell, n) * unknowns;
    }

    /// Values of the nodal quantities of all cells, a column each.
    Eigen::MatrixXd
    values_of_cells(const Eigen::VectorXd &unknowns) const
    {
      // evaluated first: a product that is reshaped divides for every index
      const Eigen::VectorXd values = nodal_values_of_cells * unknowns;
      return values.reshaped(element.finite_element.n_dofs_per_cell(),
                             mesh().n_active_cells());
    }

    /// Forces on the unknowns from those on the nodal quantities of all cells,
    /// a column each.
    Eigen::VectorXd
    forces_on_unknowns(const Eigen::MatrixXd &of_cells) const
    {
      return nodal_values_of_cells.transpose() * of_cells.reshaped();
    }

    /// The unknowns that give values at all nodes, by degree of freedom.
    Eigen::VectorXd
    unknowns_of_nodal_values(const dealii::Vector<double> &values) const
    {
      return Eigen::Map<const Eigen::VectorXd>(values.begin(),
                                               values.size())(dof_of_unknown);
    }

    /// Values at all nodes, by degree of freedom.
    dealii::Vector<double>
    nodal_values(const Eigen::VectorXd &unknowns) const
    {
      dealii::Vector<double> values(dofs.n_dofs());
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        values[dof_of_unknown[i]] = unknowns[i];
      constraints.distribute(values);
      return values;
    }

    const CellShape &
    shape(unsigned int cell) const
    {
      return shapes[shape_of_cell[cell]];
    }

    const dealii::DoFHandler<2> &
    dof_handler() const
    {
      return dofs;
    }

    const dealii::Triangulation<2> &
    mesh() const
    {
      return dofs.get_triangulation();
    }

    /// Whether no support holds the deflection, so that the plate can move as
    /// a rigid body.
    bool
    is_free() const
    {
      return !holds_deflection;
    }

    /// How many motions as a rigid body supports and planes of symmetry leave;
    /// in the plane of a plate that stretches, too.
    unsigned int
    n_rigid_motions() const;

    /// Of the order of the square of the lowest frequency: bending of a square
    /// of the area of the mesh. [1/s^2]
    double
    square_of_bending() const;

    /// Whether its strains are no linear function of the unknowns.
    bool
    is_nonlinear() const
    {
      return section.stretching == Stretching::large;
    }

    /// Adds symmetric matrices of cells, over the parts of the plate.
    /// @param matrix_of  that of a cell, by active index
    /// @param sum        with the entries of K
    void
    add_cells(const std::function<Eigen::MatrixXd(unsigned int)> &matrix_of,
              Epetra_CrsMatrix                                   &sum) const;

    /// Whether a cell is at a soft simply supported edge, along which a layer
    /// as thin as the plate twists.
    bool
    is_at_soft_edge(
      const dealii::Triangulation<2>::active_cell_iterator &cell) const
    {
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && soft_edges.count(face->boundary_id()) > 0)
          return true;
      return false;
    }

  private:
    /// Constrains what supports and planes of symmetry hold. On an edge that
    /// runs in any direction a rotation is held along its tangent, an arc's
    /// too, and a displacement along tangent or normal; where such edges hold
    /// two directions, both components.
    void
    hold_edges(const PlateParameters &plate);

    void
    number_unknowns();

    dealii::DoFHandler<2>             dofs;
    dealii::AffineConstraints<double> constraints;
    bool                              holds_deflection = false; ///< some edge
    std::set<dealii::types::boundary_id> soft_edges;

    std::vector<dealii::types::global_dof_index> dof_of_unknown;
    std::vector<unsigned int>     components_of; ///< of an unknown, a bit each
    std::vector<std::vector<int>> unknowns_of_cells; ///< in ascending order

    /// A row for each nodal value of each cell, by unknowns.
    Eigen::SparseMatrix<double, Eigen::RowMajor> nodal_values_of_cells;

    std::vector<unsigned int> shape_of_cell;
    std::vector<CellShape>    shapes;

    std::unique_ptr<Epetra_CrsMatrix> K, M;
  };


  /// State of the plate kept for output.
  struct Snapshot
  {
    double          time; ///< [s]
    Eigen::VectorXd unknowns;
  };
} // namespace PlateImpact
