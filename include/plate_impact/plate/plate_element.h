#pragma once

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/plate/assumed_strains.h"
#include "plate_impact/plate/plate_section.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// Components of the unknowns at a node: deflection [m], positive in the
  /// direction of impact, and the rotations of the normal in the planes xz and
  /// yz [rad], gamma = grad w - theta. Of plates that stretch the displacements
  /// of the middle surface [m] as well.
  enum PlateComponent : unsigned int
  {
    deflection     = 0,
    rotation_x     = 1,
    rotation_y     = 2,
    displacement_x = 3,
    displacement_y = 4
  };

  /// The strains of the section at some points of a cell, PlateSection::
  /// n_resultants() numbers a point.
  struct CellStrains
  {
    /// From the unknowns of the cell: curvatures, shear strains, strains of the
    /// middle surface.
    CellOperator linear;

    /// Strains of the middle surface, three numbers a point, from the squares
    /// of slopes (SlopeSquares). Of plates with large deflections only.
    Eigen::MatrixXd of_squares;
  };

  /// Everything about a cell that depends on its shape only, so that congruent
  /// cells share it.
  struct CellShape
  {
    CellStrains at_quadrature, at_samples; ///< these are 2x2, superconvergent

    /// Weights of the quadrature points times the Jacobian determinant. [m^2]
    Eigen::VectorXd weights;
  };


  /// A Reissner-Mindlin plate element: FE_Q(2) for all components, 3x3 Gauss
  /// points, and an assumed transverse shear strain. What is constrained at the
  /// centre node and how the shear is assumed makes the element; in its plane
  /// the plate has the nodes of the rotations. Constrained to -1/4 of the
  /// corners plus 1/2 of the midsides, the centre node turns FE_Q(2) into the
  /// 8-node serendipity element exactly. `heterosis` (Hughes & Cohen, Comput
  /// Struct 9, 1978, 445-450) constrains the deflection only. `serendipity
  /// full` locks on plates that are thin for their cells; `Lagrange` has a
  /// spurious zero-energy mode that the assembly of a uniform mesh does not
  /// suppress.
  class PlateElement
  {
  public:
    const ElementType         type;
    const Stretching          stretching;
    const PlateMass           mass_of_deflection;
    const dealii::FE_Q<2>     scalar_element; ///< of each component
    const dealii::FESystem<2> finite_element;
    const dealii::QGauss<2>   quadrature;

    explicit PlateElement(const ElementType type,
                          const Stretching  stretching = Stretching::none,
                          const PlateMass   mass       = PlateMass::consistent)
      : type(type)
      , stretching(stretching)
      , mass_of_deflection(mass)
      , scalar_element(2)
      , finite_element(scalar_element, stretching == Stretching::none ? 3 : 5)
      , quadrature(3)
    {}

    /// The dofs of a cell that are values of a component, node by node.
    std::vector<unsigned int>
    dofs_of(const unsigned int component) const
    {
      std::vector<unsigned int> dofs;
      for (unsigned int n = 0; n < scalar_element.n_dofs_per_cell(); ++n)
        dofs.push_back(finite_element.component_to_system_index(component, n));
      return dofs;
    }

    /// Adds the constraints that make this element of FE_Q(2).
    void
    add_internal_constraints(
      const dealii::DoFHandler<2>       &dof_handler,
      dealii::AffineConstraints<double> &constraints) const;

    /// Whether the shear strain is that at 2 x 2 Gauss points: its energy then
    /// is not that of the displacements.
    bool
    has_reduced_shear() const;

    /// By this factor the recovery of stresses finds less of an error than with
    /// other elements: chosen on random scenes (doc/theory.md).
    double
    error_over_recovered() const;

    /// Strains at points of the reference cell.
    CellStrains
    strains_at(const dealii::Triangulation<2>::active_cell_iterator &cell,
               const dealii::Quadrature<2> &unit_points) const;

    /// Strains of states of a cell, with the squares of slopes.
    /// @param nodal_values  dofs of the cell, a column per state
    Eigen::MatrixXd
    evaluate(const CellStrains     &strains,
             const Eigen::MatrixXd &nodal_values) const;

    CellShape
    shape(const dealii::Triangulation<2>::active_cell_iterator &cell) const;

    /// Stiffness of a cell. [N/m, N, N m by the components]
    Eigen::MatrixXd
    stiffness(const CellShape &shape, const PlateSection &section) const;

    /// Consistent mass with rotary inertia, and wave_mass() where the element
    /// has it. [kg, kg m^2 by the components]
    Eigen::MatrixXd
    mass(const CellShape &shape, const PlateSection &section) const;

    /// What PlateMass::of_waves adds to the consistent mass of the deflection,
    /// so that bending waves nearly have their frequency: m/15 times the
    /// integral of w_xx v_xx + w_yy v_yy - (w_xx v_yy + w_yy v_xx) / 2 with the
    /// mass per area m and derivatives in coordinates of the cell from -1 to 1.
    /// Without it the stiffness of cells of length h makes the squares of
    /// frequencies too large by (kh)^4 (c^6 + s^6) / 240 for waves of wave
    /// number k in the direction (c, s). Not negative. In one dimension it is
    /// twice the difference to the mass with Gauss-Lobatto points, a blend as
    /// that of Ainsworth & Wajid 2010, doi:10.1137/090754017. [kg, by pairs of
    /// nodes]
    Eigen::MatrixXd
    wave_mass(const CellShape &shape, const PlateSection &section) const;
  };
} // namespace PlateImpact
