#ifndef plate_impact_plate_plate_element_h
#define plate_impact_plate_plate_element_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/plate/assumed_shear.h"
#include "plate_impact/plate/plate_section.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace PlateImpact
{
  /// Components of the unknowns at a node: deflection [m], positive in the
  /// direction of impact, and the rotations of the normal in the planes xz and
  /// yz [rad], which equal the slopes of the deflection where there is no
  /// transverse shear: gamma = grad w - theta.
  enum PlateComponent : unsigned int
  {
    deflection = 0,
    rotation_x = 1,
    rotation_y = 2,
    n_components
  };

  using CellMatrix = Eigen::Matrix<double, n_cell_dofs, n_cell_dofs>;

  /// Everything about a cell that depends on its shape only, so that congruent
  /// cells share it.
  struct CellShape
  {
    /// Curvatures and shear strains, five numbers a point.
    CellOperator strains_at_quadrature, strains_at_samples;

    /// Weights of the quadrature points times the Jacobian determinant. [m^2]
    std::vector<double> weights;

    /// Values of the nine shape functions (columns) at the quadrature points.
    Eigen::MatrixXd shape_values;
  };


  /// A Reissner-Mindlin plate element: FE_Q(2) for the deflection and both
  /// rotations, 3x3 Gauss points, and an assumed transverse shear strain. What
  /// is constrained at the centre node and how the shear is assumed makes the
  /// element.
  ///
  /// Constrained to -1/4 of the corners plus 1/2 of the midsides, the centre
  /// node turns FE_Q(2) into the 8-node serendipity element exactly.
  ///  - `serendipity`, the paper's: all components constrained, shear
  ///    integrated with 2x2 points;
  ///  - `serendipity full`: the same with 3x3 points for the shear, which locks
  ///    on plates that are thin for their cells;
  ///  - `heterosis` (Hughes & Cohen, Comput Struct 9, 1978, 445-450): the
  ///    deflection constrained, 2x2 points;
  ///  - `Lagrange`: nothing constrained, 2x2 points; has a spurious zero-energy
  ///    mode that the assembly of a uniform mesh does not suppress;
  ///  - `MITC9`: nothing constrained, mixed_shear().
  class PlateElement
  {
  public:
    explicit PlateElement(ElementType type);

    const dealii::FESystem<2> &
    finite_element() const
    {
      return element;
    }

    const dealii::Quadrature<2> &
    quadrature() const
    {
      return quadrature_points;
    }

    /// Adds the constraints that make this element of FE_Q(2).
    void
    add_internal_constraints(
      const dealii::DoFHandler<2>       &dof_handler,
      dealii::AffineConstraints<double> &constraints) const;

    /// Curvatures and shear strains at points of the reference cell, five rows
    /// each.
    CellOperator
    strains_at(const dealii::Triangulation<2>::active_cell_iterator &cell,
               const std::vector<dealii::Point<2>> &unit_points) const;

    CellShape
    shape(const dealii::Triangulation<2>::active_cell_iterator &cell) const;

    /// Stiffness of a cell. [N/m, N, N m by the components]
    CellMatrix
    stiffness(const CellShape &shape, const PlateSection &section) const;

    /// Consistent mass with rotary inertia. [kg, kg m^2 by the components]
    CellMatrix
    mass(const CellShape &shape, const PlateSection &section) const;

  private:
    CellOperator
    strains(const dealii::Triangulation<2>::active_cell_iterator &cell,
            const dealii::FEValues<2>                            &values) const;

    std::array<bool, n_components> centre_is_constrained;
    const AssumedShear             assumed_shear;
    const dealii::FE_Q<2>          scalar_element;
    const dealii::FESystem<2>      element;
    const dealii::QGauss<2>        quadrature_points;
    const dealii::QGauss<2>        samples; ///< 2x2, superconvergent
  };
} // namespace PlateImpact

#endif
