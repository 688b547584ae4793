#include "plate_impact/plate_element.h"

#include <deal.II/fe/fe_dgq.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    struct ElementRow
    {
      std::string                    name;
      std::array<bool, n_components> centre_is_constrained;
    };

    const std::vector<ElementRow> elements = {
      {"serendipity", {{true, true, true}}},
      {"heterosis", {{true, false, false}}},
      {"Lagrange", {{false, false, false}}}};



    std::array<bool, n_components>
    constrained_components(const std::string &name)
    {
      for (const ElementRow &row : elements)
        if (row.name == name)
          return row.centre_is_constrained;
      throw std::logic_error("no element named " + name);
    }
  } // namespace



  PlateElement::PlateElement(const std::string &name)
    : centre_is_constrained(constrained_components(name))
    , scalar_element(2)
    , element(scalar_element, n_components)
    , bending_points(3)
    , shear_points(2)
    , shear_interpolation(bending_points.size(), shear_points.size())
  {
    const FE_DGQArbitraryNodes<2> bilinear{QGauss<1>(2)};
    for (unsigned int q = 0; q < bending_points.size(); ++q)
      for (unsigned int g = 0; g < shear_points.size(); ++g)
        shear_interpolation(q, g) =
          bilinear.shape_value(g, bending_points.point(q));
  }



  const std::vector<std::string> &
  PlateElement::names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> result;
      for (const ElementRow &row : elements)
        result.push_back(row.name);
      return result;
    }();
    return names;
  }



  const FESystem<2> &
  PlateElement::finite_element() const
  {
    return element;
  }



  const Quadrature<2> &
  PlateElement::bending_quadrature() const
  {
    return bending_points;
  }



  const Quadrature<2> &
  PlateElement::shear_quadrature() const
  {
    return shear_points;
  }



  void
  PlateElement::add_internal_constraints(
    const DoFHandler<2>       &dof_handler,
    AffineConstraints<double> &constraints) const
  {
    // FE_Q(2) numbers the four corners first, then the midsides, then the
    // centre
    const unsigned int                   centre = 8;
    std::vector<types::global_dof_index> dofs(n_cell_dofs);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int c = 0; c < n_components; ++c)
          if (centre_is_constrained[c])
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



  CellOperator
  PlateElement::raw_strains(const FEValues<2> &values) const
  {
    CellOperator strains =
      CellOperator::Zero(5 * values.n_quadrature_points, n_cell_dofs);
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      for (unsigned int i = 0; i < n_cell_dofs; ++i)
        {
          const auto [component, node] = element.system_to_component_index(i);
          const double       N         = values.shape_value(node, q);
          const Tensor<1, 2> dN        = values.shape_grad(node, q);
          auto               strain    = strains.col(i).segment<5>(5 * q);
          switch (component)
            {
              case deflection:
                strain << 0., 0., 0., dN[0], dN[1];
                break;
              case rotation_x:
                strain << dN[0], 0., dN[1], -N, 0.;
                break;
              case rotation_y:
                strain << 0., dN[1], dN[0], 0., -N;
                break;
              default:
                Assert(false, ExcInternalError());
            }
        }
    return strains;
  }



  CellShape
  PlateElement::shape(const Triangulation<2>::active_cell_iterator &cell) const
  {
    const UpdateFlags flags =
      update_values | update_gradients | update_JxW_values;
    FEValues<2> bending_values(scalar_element, bending_points, flags);
    FEValues<2> shear_values(scalar_element, shear_points, flags);
    bending_values.reinit(cell);
    shear_values.reinit(cell);

    CellShape shape;
    shape.strains_at_bending_points = raw_strains(bending_values);
    shape.strains_at_shear_points   = raw_strains(shear_values);
    shape.bending_weights           = bending_values.get_JxW_values();
    shape.shear_weights             = shear_values.get_JxW_values();

    // the assumed shear strain in place of the raw one
    for (unsigned int q = 0; q < bending_points.size(); ++q)
      {
        auto shear = shape.strains_at_bending_points.middleRows<2>(5 * q + 3);
        shear.setZero();
        for (unsigned int g = 0; g < shear_points.size(); ++g)
          shear += shear_interpolation(q, g) *
            shape.strains_at_shear_points.middleRows<2>(5 * g + 3);
      }

    shape.shape_values.resize(bending_points.size(),
                              scalar_element.n_dofs_per_cell());
    for (unsigned int q = 0; q < bending_points.size(); ++q)
      for (unsigned int node = 0; node < scalar_element.n_dofs_per_cell();
           ++node)
        shape.shape_values(q, node) = bending_values.shape_value(node, q);
    return shape;
  }



  CellMatrix
  PlateElement::stiffness(const CellShape    &shape,
                          const PlateSection &section) const
  {
    CellMatrix K = CellMatrix::Zero();
    for (unsigned int q = 0; q < shape.bending_weights.size(); ++q)
      {
        const auto B = shape.strains_at_bending_points.middleRows<3>(5 * q);
        K.noalias() += B.transpose() *
          (shape.bending_weights[q] * section.bending_stiffness * B);
      }
    for (unsigned int q = 0; q < shape.shear_weights.size(); ++q)
      {
        const auto B = shape.strains_at_shear_points.middleRows<2>(5 * q + 3);
        K.noalias() +=
          shape.shear_weights[q] * section.shear_stiffness * B.transpose() * B;
      }
    return K;
  }



  CellMatrix
  PlateElement::mass(const CellShape &shape, const PlateSection &section) const
  {
    const Eigen::Map<const Eigen::VectorXd> weights(
      shape.bending_weights.data(),
      shape.bending_weights.size());
    const Eigen::MatrixXd scalar_mass = shape.shape_values.transpose() *
      weights.asDiagonal() * shape.shape_values;
    CellMatrix M = CellMatrix::Zero();
    for (unsigned int i = 0; i < n_cell_dofs; ++i)
      for (unsigned int j = 0; j < n_cell_dofs; ++j)
        {
          const auto [component_i, node_i] =
            element.system_to_component_index(i);
          const auto [component_j, node_j] =
            element.system_to_component_index(j);
          if (component_i == component_j)
            M(i, j) = scalar_mass(node_i, node_j) *
              (component_i == deflection ? section.mass
                                         : section.rotary_inertia);
        }
    return M;
  }
} // namespace PlateImpact
