#include "plate_impact/plate/plate_element.h"

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_mesh.h"

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
      double       error_over_recovered = 1.;
    };

    const AssumedShear gauss_2 = shear_at_gauss_points(2),
                       gauss_3 = shear_at_gauss_points(3);

    const std::vector<ElementRow> elements = {
      {ElementType::serendipity, "serendipity", true, true, gauss_2, 1.2},
      {ElementType::serendipity_full, "serendipity full", true, true, gauss_3},
      {ElementType::heterosis, "heterosis", true, false, gauss_2},
      {ElementType::Lagrange, "Lagrange", false, false, gauss_2},
      {ElementType::MITC9, "MITC9", false, false, mixed_shear()}};
  } // namespace



  bool
  PlateElement::has_reduced_shear() const
  {
    return row_of(type, elements).assumed_shear.tying_points.size() ==
      gauss_2.tying_points.size();
  }



  double
  PlateElement::error_over_recovered() const
  {
    return row_of(type, elements).error_over_recovered;
  }



  void
  PlateElement::add_internal_constraints(
    const DoFHandler<2>       &dof_handler,
    AffineConstraints<double> &constraints) const
  {
    const ElementRow &row = row_of(type, elements);
    // FE_Q(2) numbers the four corners first, then the midsides, then the
    // centre
    const unsigned int                   centre = 8;
    std::vector<types::global_dof_index> dofs(finite_element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int c = 0; c < finite_element.n_components(); ++c)
          if (c == deflection ? row.constrains_deflection :
                                row.constrains_others)
            {
              const auto of_nodes = dofs_of(c);
              constraints.add_line(dofs[of_nodes[centre]]);
              for (unsigned int node = 0; node < centre; ++node)
                constraints.add_entry(dofs[of_nodes[centre]],
                                      dofs[of_nodes[node]],
                                      node < 4 ? -0.25 : 0.5);
            }
      }
  }



  CellStrains
  PlateElement::strains_at(const Triangulation<2>::active_cell_iterator &cell,
                           const Quadrature<2> &unit_points) const
  {
    const AssumedShear &assumed = row_of(type, elements).assumed_shear;
    FEValues<2>         values(mapping_of(cell),
                       scalar_element,
                       unit_points,
                       update_gradients | update_inverse_jacobians);
    FEValues<2>         tying(mapping_of(cell),
                      scalar_element,
                      assumed.tying_points,
                      update_values | update_gradients | update_jacobians);
    values.reinit(cell);
    tying.reinit(cell);
    const int n         = values.n_quadrature_points,
              n_tying   = tying.n_quadrature_points,
              n_dofs    = finite_element.n_dofs_per_cell(),
              n_strains = stretching == Stretching::none ? 5 : 8;
    CellStrains  result;
    CellOperator tied = CellOperator::Zero(2 * n_tying, n_dofs);
    result.linear     = CellOperator::Zero(n_strains * n, n_dofs);
    for (int i = 0; i < n_dofs; ++i)
      {
        const auto [component, node] =
          finite_element.system_to_component_index(i);
        const int d = component == rotation_y || component == displacement_y;
        // curvatures, and strains of the middle surface
        const int first = component < displacement_x ? 0 : 5;
        for (int q = 0; q < n && component != deflection; ++q)
          {
            const Tensor<1, 2> dN = values.shape_grad(node, q);
            result.linear(n_strains * q + first + d, i) = dN[d];
            result.linear(n_strains * q + first + 2, i) = dN[1 - d];
          }
        // gamma = grad w - theta
        for (int t = 0; t < n_tying; ++t)
          if (component == deflection)
            for (const int along : {0, 1})
              tied(along * n_tying + t, i) = tying.shape_grad(node, t)[along];
          else if (component < displacement_x)
            tied(d * n_tying + t, i) = -tying.shape_value(node, t);
      }

    const CellOperator shear = assumed.interpolate(tied, tying, values);
    for (const int d : {0, 1})
      result.linear(Eigen::seqN(3 + d, n, n_strains), Eigen::all) =
        shear.middleRows(d * n, n);
    if (stretching == Stretching::large)
      result.of_squares = SlopeSquares::strains(values);
    return result;
  }



  Eigen::MatrixXd
  PlateElement::evaluate(const CellStrains     &strains,
                         const Eigen::MatrixXd &nodal_values) const
  {
    Eigen::MatrixXd result = strains.linear * nodal_values;
    if (stretching != Stretching::large)
      return result;
    const Eigen::MatrixXd slopes = SlopeSquares::slopes() *
      nodal_values(dofs_of(deflection), Eigen::all),
                          of_squares =
                            strains.of_squares * SlopeSquares::squares(slopes);
    for (Eigen::Index q = 0; 3 * q < of_squares.rows(); ++q)
      result.middleRows<3>(8 * q + 5) += of_squares.middleRows<3>(3 * q);
    return result;
  }



  CellShape
  PlateElement::shape(const Triangulation<2>::active_cell_iterator &cell) const
  {
    FEValues<2> values(mapping_of(cell),
                       scalar_element,
                       quadrature,
                       update_JxW_values);
    values.reinit(cell);
    return {strains_at(cell, quadrature),
            strains_at(cell, QGauss<2>(2)),
            Eigen::Map<const Eigen::VectorXd>(values.get_JxW_values().data(),
                                              quadrature.size())};
  }



  Eigen::MatrixXd
  PlateElement::stiffness(const CellShape    &shape,
                          const PlateSection &section) const
  {
    const int n_dofs                 = finite_element.n_dofs_per_cell(),
              n_strains              = section.n_resultants();
    const Eigen::MatrixXd by_strains = section.stiffness();
    Eigen::MatrixXd       K          = Eigen::MatrixXd::Zero(n_dofs, n_dofs);
    for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
      {
        const auto B =
          shape.at_quadrature.linear.middleRows(n_strains * q, n_strains);
        const CellOperator weighted   = shape.weights[q] * B,
                           resultants = by_strains * weighted;
        K.noalias() += B.transpose() * resultants;
      }
    return K;
  }



  Eigen::MatrixXd
  PlateElement::mass(const CellShape &shape, const PlateSection &section) const
  {
    Eigen::MatrixXd N(quadrature.size(), scalar_element.n_dofs_per_cell());
    for (Eigen::Index q = 0; q < N.rows(); ++q)
      for (Eigen::Index node = 0; node < N.cols(); ++node)
        N(q, node) = scalar_element.shape_value(node, quadrature.point(q));
    const Eigen::MatrixXd of_component =
      N.transpose() * shape.weights.asDiagonal() * N;
    const unsigned int n_dofs = finite_element.n_dofs_per_cell();
    Eigen::MatrixXd    M      = Eigen::MatrixXd::Zero(n_dofs, n_dofs);
    for (unsigned int c = 0; c < finite_element.n_components(); ++c)
      M(dofs_of(c), dofs_of(c)) = of_component *
        (c == rotation_x || c == rotation_y ? section.rotary_inertia :
                                              section.mass_per_area);
    if (mass_of_deflection == PlateMass::of_waves)
      M(dofs_of(deflection), dofs_of(deflection)) += wave_mass(shape, section);
    return M;
  }



  Eigen::MatrixXd
  PlateElement::wave_mass(const CellShape    &shape,
                          const PlateSection &section) const
  {
    Eigen::MatrixXd along_x(quadrature.size(),
                            scalar_element.n_dofs_per_cell()),
      along_y = along_x;
    for (Eigen::Index q = 0; q < along_x.rows(); ++q)
      for (Eigen::Index node = 0; node < along_x.cols(); ++node)
        {
          // the unit cell's coordinates run from 0 to 1
          const Tensor<2, 2> second =
            0.25 * scalar_element.shape_grad_grad(node, quadrature.point(q));
          along_x(q, node) = second[0][0];
          along_y(q, node) = second[1][1];
        }
    const auto of = [&](const Eigen::MatrixXd &A, const Eigen::MatrixXd &B) {
      return Eigen::MatrixXd(A.transpose() * shape.weights.asDiagonal() * B);
    };
    const Eigen::MatrixXd of_both = of(along_x, along_y);
    return section.mass_per_area / 15. *
      (of(along_x, along_x) + of(along_y, along_y) -
       0.5 * (of_both + of_both.transpose()));
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
    entry("Linear solver",
          "CHOLMOD",
          one_of<Word<SolverType>>(
            {{SolverType::CHOLMOD, "CHOLMOD"}, {SolverType::KLU, "KLU"}}),
          linear_solver)
      .means("Direct solver of the effective stiffness: CHOLMOD (supernodal "
             "Cholesky) or KLU of Trilinos' Amesos.");
  }
} // namespace PlateImpact
