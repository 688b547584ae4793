#ifndef plate_impact_plate_element_h
#define plate_impact_plate_element_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/plate_section.h"

#include <Eigen/Core>

#include <array>
#include <string>
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

  /// Unknowns of a cell before constraints: nine nodes, three components.
  constexpr int n_cell_dofs = 27;

  /// Rows: five numbers for each of some points of a cell, point by point.
  /// Columns: the unknowns of the cell in the order of the finite element.
  using CellOperator = Eigen::Matrix<double, Eigen::Dynamic, n_cell_dofs>;
  using CellMatrix   = Eigen::Matrix<double, n_cell_dofs, n_cell_dofs>;

  /// Everything about a cell that depends on its shape only, so that congruent
  /// cells share it.
  struct CellShape
  {
    /// Curvatures and shear strains at the points of the bending and the shear
    /// quadrature.
    CellOperator strains_at_bending_points, strains_at_shear_points;

    /// Weights of the points times the Jacobian determinant. [m^2]
    std::vector<double> bending_weights, shear_weights;

    /// Values of the nine shape functions at the bending points (row by row).
    Eigen::MatrixXd shape_values;
  };


  /// A Reissner-Mindlin plate element: FE_Q(2) for the deflection and both
  /// rotations, 3x3 Gauss points for bending and mass and 2x2 for shear.
  ///
  /// The centre node makes the difference. Constrained to -1/4 of the corners
  /// plus 1/2 of the midsides it turns FE_Q(2) into the 8-node serendipity
  /// element exactly. All components constrained: `serendipity`, the element of
  /// the paper; the deflection only: `heterosis` (Hughes & Cohen, Comput Struct
  /// 9, 1978, 445-450); none: `Lagrange`, which has a spurious zero-energy mode
  /// per element that the assembly does not always suppress.
  ///
  /// Reduced integration is used in its equivalent form, an assumed shear
  /// strain that interpolates the 2x2 points bilinearly: the shear at other
  /// points, where the raw one is polluted, is then defined as well.
  class PlateElement
  {
  public:
    /// @throws std::logic_error for a name that is not in names()
    explicit PlateElement(const std::string &name);

    static const std::vector<std::string> &
    names();

    const dealii::FESystem<2> &
    finite_element() const;

    const dealii::Quadrature<2> &
    bending_quadrature() const;

    /// Also the superconvergent points, where stresses are sampled.
    const dealii::Quadrature<2> &
    shear_quadrature() const;

    /// Adds the constraints that make this element of FE_Q(2).
    void
    add_internal_constraints(
      const dealii::DoFHandler<2>       &dof_handler,
      dealii::AffineConstraints<double> &constraints) const;

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
    raw_strains(const dealii::FEValues<2> &values) const;

    std::array<bool, n_components> centre_is_constrained;
    const dealii::FE_Q<2>          scalar_element;
    const dealii::FESystem<2>      element;
    const dealii::QGauss<2>        bending_points, shear_points;

    /// Bilinear interpolation from the shear points (columns) to the bending
    /// points (rows).
    Eigen::MatrixXd shear_interpolation;
  };
} // namespace PlateImpact

#endif
