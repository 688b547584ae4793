#include "plate_impact/plate/plate_element.h"

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/slope_squares.h"

#include <string>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    struct ElementRow
    {
      ElementType  choice;
      std::string  word;
      bool         constrains_deflection, constrains_others; ///< at the centre
      AssumedShear assumed_shear;
    };

    const std::vector<ElementRow> elements = {
      {ElementType::serendipity,
       "serendipity",
       true,
       true,
       shear_at_gauss_points(2)},
      {ElementType::serendipity_full,
       "serendipity full",
       true,
       true,
       shear_at_gauss_points(3)},
      {ElementType::heterosis,
       "heterosis",
       true,
       false,
       shear_at_gauss_points(2)},
      {ElementType::Lagrange,
       "Lagrange",
       false,
       false,
       shear_at_gauss_points(2)},
      {ElementType::MITC9, "MITC9", false, false, mixed_shear()}};



    unsigned int
    n_components(const Stretching stretching)
    {
      return stretching == Stretching::none ? 3 : 5;
    }
  } // namespace



  PlateElement::PlateElement(const ElementType type,
                             const Stretching  stretching)
    : type(type)
    , how_it_stretches(stretching)
    , assumed_shear(row_of(type, elements).assumed_shear)
    , scalar_element(2)
    , element(scalar_element, n_components(stretching))
    , quadrature_points(3)
    , samples(2)
  {}



  void
  PlateElement::add_internal_constraints(
    const DoFHandler<2>       &dof_handler,
    AffineConstraints<double> &constraints) const
  {
    const ElementRow &row = row_of(type, elements);
    // FE_Q(2) numbers the four corners first, then the midsides, then the
    // centre
    const unsigned int                   centre = 8;
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int c = 0; c < element.n_components(); ++c)
          if (c == deflection ? row.constrains_deflection :
                                row.constrains_others)
            {
              const auto line =
                dofs[element.component_to_system_index(c, centre)];
              constraints.add_line(line);
              for (unsigned int node = 0; node < centre; ++node)
                constraints.add_entry(
                  line,
                  dofs[element.component_to_system_index(c, node)],
                  node < 4 ? -0.25 : 0.5);
            }
      }
  }



  CellStrains
  PlateElement::strains(const Triangulation<2>::active_cell_iterator &cell,
                        const FEValues<2> &values) const
  {
    FEValues<2> tying(mapping_of(cell),
                      scalar_element,
                      assumed_shear.tying_points,
                      update_values | update_gradients | update_jacobians);
    tying.reinit(cell);
    const unsigned int n_tying = tying.n_quadrature_points,
                       n       = values.n_quadrature_points;

    const int n_dofs    = element.n_dofs_per_cell(),
              n_strains = how_it_stretches == Stretching::none ? 5 : 8;
    CellStrains  result;
    CellOperator tied = CellOperator::Zero(2 * n_tying, n_dofs);
    result.linear     = CellOperator::Zero(n_strains * n, n_dofs);
    for (int i = 0; i < n_dofs; ++i)
      {
        const auto [component, node] = element.system_to_component_index(i);
        // curvatures, and strains of the middle surface
        const unsigned int row = component < displacement_x ? 0 : 5;
        for (unsigned int q = 0; q < n; ++q)
          {
            const Tensor<1, 2> dN = values.shape_grad(node, q);
            if (component == rotation_x || component == displacement_x)
              result.linear.col(i).segment<3>(n_strains * q + row) << dN[0], 0.,
                dN[1];
            else if (component == rotation_y || component == displacement_y)
              result.linear.col(i).segment<3>(n_strains * q + row) << 0., dN[1],
                dN[0];
          }
        if (component >= displacement_x)
          continue;
        // gamma = grad w - theta
        for (unsigned int t = 0; t < n_tying; ++t)
          {
            const Tensor<1, 2> dN = tying.shape_grad(node, t);
            const double       N  = tying.shape_value(node, t);
            if (component == deflection)
              tied.col(i).segment<2>(2 * t) << dN[0], dN[1];
            else
              tied(2 * t + (component == rotation_x ? 0 : 1), i) = -N;
          }
      }

    const CellOperator shear = assumed_shear.interpolate(tied, tying, values);
    for (unsigned int q = 0; q < n; ++q)
      result.linear.middleRows<2>(n_strains * q + 3) =
        shear.middleRows<2>(2 * q);
    if (how_it_stretches == Stretching::large)
      result.of_squares = SlopeSquares::strains(values);
    return result;
  }



  CellStrains
  PlateElement::strains_at(const Triangulation<2>::active_cell_iterator &cell,
                           const std::vector<Point<2>> &unit_points) const
  {
    FEValues<2> values(mapping_of(cell),
                       scalar_element,
                       Quadrature<2>(unit_points),
                       update_values | update_gradients |
                         update_inverse_jacobians);
    values.reinit(cell);
    return strains(cell, values);
  }



  Eigen::MatrixXd
  PlateElement::evaluate(const CellStrains     &strains,
                         const Eigen::MatrixXd &nodal_values) const
  {
    Eigen::MatrixXd result = strains.linear * nodal_values;
    if (how_it_stretches != Stretching::large)
      return result;
    Eigen::MatrixXd deflections(scalar_element.n_dofs_per_cell(),
                                nodal_values.cols());
    for (Eigen::Index node = 0; node < deflections.rows(); ++node)
      deflections.row(node) =
        nodal_values.row(element.component_to_system_index(deflection, node));
    const Eigen::MatrixXd slopes = SlopeSquares::slopes() * deflections;
    for (Eigen::Index state = 0; state < result.cols(); ++state)
      {
        const Eigen::VectorXd of_squares =
          strains.of_squares * SlopeSquares::squares(slopes.col(state));
        for (Eigen::Index q = 0; 3 * q < of_squares.size(); ++q)
          result.col(state).segment<3>(8 * q + 5) +=
            of_squares.segment<3>(3 * q);
      }
    return result;
  }



  CellShape
  PlateElement::shape(const Triangulation<2>::active_cell_iterator &cell) const
  {
    const UpdateFlags flags = update_values | update_gradients |
      update_inverse_jacobians | update_JxW_values;
    const Mapping<2> &mapping = mapping_of(cell);
    FEValues<2>       values(mapping, scalar_element, quadrature_points, flags);
    FEValues<2>       sample_values(mapping, scalar_element, samples, flags);
    values.reinit(cell);
    sample_values.reinit(cell);

    CellShape shape;
    shape.at_quadrature = strains(cell, values);
    shape.at_samples    = strains(cell, sample_values);
    shape.weights       = values.get_JxW_values();
    shape.shape_values.resize(quadrature_points.size(),
                              scalar_element.n_dofs_per_cell());
    for (unsigned int q = 0; q < quadrature_points.size(); ++q)
      for (unsigned int node = 0; node < scalar_element.n_dofs_per_cell();
           ++node)
        shape.shape_values(q, node) = values.shape_value(node, q);
    return shape;
  }



  CellMatrix
  PlateElement::stiffness(const CellShape    &shape,
                          const PlateSection &section) const
  {
    const int n_dofs                 = element.n_dofs_per_cell(),
              n_strains              = section.n_resultants();
    const Eigen::MatrixXd by_strains = section.stiffness();
    CellMatrix            K          = CellMatrix::Zero(n_dofs, n_dofs);
    for (unsigned int q = 0; q < shape.weights.size(); ++q)
      {
        const auto B =
          shape.at_quadrature.linear.middleRows(n_strains * q, n_strains);
        const CellOperator weighted   = shape.weights[q] * B,
                           resultants = by_strains * weighted;
        K.noalias() += B.transpose() * resultants;
      }
    return K;
  }



  CellMatrix
  PlateElement::mass(const CellShape &shape, const PlateSection &section) const
  {
    const Eigen::Map<const Eigen::VectorXd> weights(shape.weights.data(),
                                                    shape.weights.size());
    const Eigen::MatrixXd scalar_mass = shape.shape_values.transpose() *
      weights.asDiagonal() * shape.shape_values;
    const unsigned int n_dofs = element.n_dofs_per_cell();
    CellMatrix         M      = CellMatrix::Zero(n_dofs, n_dofs);
    for (unsigned int c = 0; c < element.n_components(); ++c)
      for (unsigned int i = 0; i < scalar_element.n_dofs_per_cell(); ++i)
        for (unsigned int j = 0; j < scalar_element.n_dofs_per_cell(); ++j)
          M(element.component_to_system_index(c, i),
            element.component_to_system_index(c, j)) = scalar_mass(i, j) *
            (c == rotation_x || c == rotation_y ? section.rotary_inertia :
                                                  section.mass_per_area);
    return M;
  }



  template <>
  const std::vector<Word<ElementType>>
    Choices<ElementType>::words = words_of(elements);



  void
  DiscretizationParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Discretization");
    entry("Element", "MITC9", one_of<ElementType>(), element)
      .means("serendipity: 8 nodes, the paper's element. serendipity full: the "
             "same with 3x3 Gauss points for the shear. heterosis: 8 nodes for "
             "the deflection, 9 for the rotations. Lagrange: 9 nodes. MITC9: 9 "
             "nodes with mixed interpolation of the shear; it neither locks on "
             "thin plates nor has spurious modes.");
    entry("Initial cells",
          "3, 3",
          pair_of(whole_number(1, 10000)),
          initial_cells)
      .means("Cells along x and y of the first mesh, on the part of the plate "
             "that is meshed: a quarter if the impact is at the centre.");
    entry("Linear solver", "CHOLMOD", one_of<SolverType>(), linear_solver)
      .means("Direct solver of the effective stiffness: CHOLMOD (supernodal "
             "Cholesky) or KLU of Trilinos' Amesos.");
  }
} // namespace PlateImpact
