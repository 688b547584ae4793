#include "plate_impact/plate/plate_discretization.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/rtree.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/support.h"

#include <Eigen/SVD>
#include <Epetra_CrsGraph.h>
#include <Epetra_Map.h>
#include <Epetra_SerialComm.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Corners relative to the first one in units of the tolerance: equal for
    /// congruent cells of equal orientation.
    std::array<long, 6>
    congruence_key(const Triangulation<2>::active_cell_iterator &cell,
                   const double                                  tolerance)
    {
      std::array<long, 6> key;
      for (unsigned int v = 1; v < 4; ++v)
        for (unsigned int d = 0; d < 2; ++d)
          key[2 * (v - 1) + d] =
            std::lround((cell->vertex(v)[d] - cell->vertex(0)[d]) / tolerance);
      return key;
    }



    /// Calls a function with each cell that has points of a load, and with
    /// these, from left to right.
    /// @throws ComputationError when a point lies outside of the mesh
    template <typename Function>
    void
    for_cells_under_load(const Triangulation<2> &mesh,
                         std::vector<LoadPoint>  points,
                         const Function         &function)
    {
      std::sort(points.begin(),
                points.end(),
                [](const LoadPoint &p, const LoadPoint &q) {
                  return p.point[0] < q.point[0];
                });
      std::vector<Point<2>> positions;
      for (const LoadPoint &point : points)
        positions.push_back(point.point);
      const auto        tree = pack_rtree_of_indices(positions);
      std::vector<bool> is_found(points.size(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          BoundingBox<2> box = cell->bounding_box();
          // a curved cell reaches beyond the box of its corners, by a part of
          // it
          box.extend((&mapping_of(cell) == &curved_mapping() ? 0.25 : 1e-9) *
                     std::max(box.side_length(0), box.side_length(1)));
          std::vector<std::size_t> near;
          tree.query(boost::geometry::index::intersects(box),
                     std::back_inserter(near));
          if (near.empty())
            continue;
          std::sort(near.begin(), near.end());
          std::vector<Point<2>> real, unit(near.size()), within;
          for (const std::size_t p : near)
            real.push_back(positions[p]);
          mapping_of(cell).transform_points_real_to_unit_cell(cell, real, unit);
          std::vector<double> weights;
          for (std::size_t i = 0; i < near.size(); ++i)
            if (!is_found[near[i]] &&
                GeometryInfo<2>::is_inside_unit_cell(unit[i], 1e-9))
              {
                is_found[near[i]] = true;
                within.push_back(unit[i]);
                weights.push_back(points[near[i]].weight);
              }
          if (!within.empty())
            function(cell, Quadrature<2>(within, weights));
        }
      if (std::count(is_found.begin(), is_found.end(), false) > 0)
        throw ComputationError("the load distribution reaches beyond the mesh");
    }



    /// A matrix, all zero, with the entries of a sparsity pattern.
    std::unique_ptr<Epetra_CrsMatrix>
    make_matrix(const DynamicSparsityPattern &pattern)
    {
      const Epetra_SerialComm communicator;
      const Epetra_Map map(static_cast<int>(pattern.n_rows()), 0, communicator);
      // local indices of a known column map need no search, and a matrix whose
      // graph is complete takes its values at once
      Epetra_CrsGraph graph(Copy, map, map, 0);
      for (unsigned int row = 0; row < pattern.n_rows(); ++row)
        {
          std::vector<int> columns;
          for (unsigned int i = 0; i < pattern.row_length(row); ++i)
            columns.push_back(pattern.column_number(row, i));
          graph.InsertMyIndices(row, columns.size(), columns.data());
        }
      graph.FillComplete();
      graph.OptimizeStorage();
      auto matrix = std::make_unique<Epetra_CrsMatrix>(Copy, graph);
      matrix->FillComplete();
      return matrix;
    }
  } // namespace



  PlateDiscretization::PlateDiscretization(const Triangulation<2> &mesh,
                                           const PlateElement     &element,
                                           const PlateParameters  &plate,
                                           const double            n_parts)
    : element(element)
    , n_parts(n_parts > 0. ? n_parts : geometry_of(plate).n_parts())
    , plate_section(plate)
    , dofs(mesh)
  {
    if (element.stretching != plate_section.stretching)
      throw std::logic_error("the element has not the unknowns of the section");
    dofs.distribute_dofs(element.finite_element);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    element.add_internal_constraints(dofs, constraints);
    holds_deflection = hold_edges(dofs, plate, constraints);
    constraints.close();
    number_unknowns();

    const double tolerance = 1e-10 * mesh.begin_active(0)->diameter();
    std::map<std::array<long, 6>, unsigned int> known;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        unsigned int shape = shapes.size();
        // corners do not tell curved cells apart
        if (&mapping_of(cell) != &curved_mapping())
          shape = known.insert({congruence_key(cell, tolerance), shape})
                    .first->second;
        if (shape == shapes.size())
          shapes.push_back(element.shape(cell));
        shape_of_cell.push_back(shape);
      }
  }



  void
  PlateDiscretization::number_unknowns()
  {
    std::vector<int> unknown_of_dof(dofs.n_dofs());
    for (types::global_dof_index dof = 0; dof < dofs.n_dofs(); ++dof)
      if (!constraints.is_constrained(dof))
        {
          unknown_of_dof[dof] = n_unknowns();
          dof_of_unknown.push_back(dof);
        }
    components_of.assign(n_unknowns(), 0);

    const FiniteElement<2>              &fe = dofs.get_fe();
    std::vector<types::global_dof_index> of_cell(fe.n_dofs_per_cell());
    std::vector<Eigen::Triplet<double>>  weights;
    int                                  row = 0;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(of_cell);
        for (unsigned int i = 0; i < of_cell.size(); ++i, ++row)
          {
            const auto add = [&](const types::global_dof_index dof,
                                 const double                  weight) {
              weights.emplace_back(row, unknown_of_dof[dof], weight);
              components_of[unknown_of_dof[dof]] |= 1u
                << fe.system_to_component_index(i).first;
            };
            if (!constraints.is_constrained(of_cell[i]))
              add(of_cell[i], 1.);
            else
              for (const auto &[master, weight] :
                   *constraints.get_constraint_entries(of_cell[i]))
                add(master, weight);
          }
      }
    nodal_values_of_cells.resize(row, n_unknowns());
    nodal_values_of_cells.setFromTriplets(weights.begin(), weights.end());
  }



  std::vector<types::global_dof_index>
  PlateDiscretization::unknowns_of(const unsigned int cell) const
  {
    const int        n       = element.finite_element.n_dofs_per_cell(),
              *const columns = nodal_values_of_cells.innerIndexPtr(),
              *const first   = nodal_values_of_cells.outerIndexPtr() + n * cell;
    std::vector<types::global_dof_index> unknowns(columns + first[0],
                                                  columns + first[n]);
    std::sort(unknowns.begin(), unknowns.end());
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()),
                   unknowns.end());
    return unknowns;
  }



  void
  PlateDiscretization::assemble()
  {
    DynamicSparsityPattern of_K(n_unknowns(), n_unknowns()),
      of_M(n_unknowns(), n_unknowns());
    for (unsigned int cell = 0; cell < shape_of_cell.size(); ++cell)
      {
        const auto of_cell = unknowns_of(cell);
        for (const types::global_dof_index row : of_cell)
          {
            of_K.add_entries(row,
                             of_cell.begin(),
                             of_cell.end(),
                             /*indices_are_sorted=*/true);
            // inertia couples no component with another, but edges in any
            // direction give one unknown to both rotations
            for (const types::global_dof_index column : of_cell)
              if ((components_of[row] & components_of[column]) != 0)
                of_M.add(row, column);
          }
      }
    K = make_matrix(of_K);
    M = make_matrix(of_M);

    // congruent cells share their matrices
    std::vector<Eigen::MatrixXd> K_of_shape, M_of_shape;
    for (const CellShape &shape : shapes)
      {
        K_of_shape.push_back(element.stiffness(shape, plate_section));
        M_of_shape.push_back(element.mass(shape, plate_section));
      }
    add_cells(
      [&](const unsigned int cell) { return K_of_shape[shape_of_cell[cell]]; },
      *K);
    add_cells(
      [&](const unsigned int cell) { return M_of_shape[shape_of_cell[cell]]; },
      *M);
  }



  void
  PlateDiscretization::add_cells(
    const std::function<Eigen::MatrixXd(unsigned int)> &matrix_of,
    Epetra_CrsMatrix                                   &sum) const
  {
    using Weights         = decltype(nodal_values_of_cells);
    const int           n = element.finite_element.n_dofs_per_cell();
    std::vector<int>    columns;
    std::vector<double> values;
    for (unsigned int cell = 0; cell < shape_of_cell.size(); ++cell)
      {
        const auto of_cell = unknowns_of(cell);
        Weights    weights(n, of_cell.size());
        for (int i = 0; i < n; ++i)
          for (Weights::InnerIterator w(nodal_values_of_cells, n * cell + i); w;
               ++w)
            weights.insert(i,
                           std::lower_bound(of_cell.begin(),
                                            of_cell.end(),
                                            w.col()) -
                             of_cell.begin()) = w.value();
        const Eigen::MatrixXd of_rows = matrix_of(cell) * weights;
        Eigen::MatrixXd       A       = weights.transpose() * of_rows;
        A *= n_parts;
        // symmetric, so that a column is a row
        for (Eigen::Index j = 0; j < A.cols(); ++j)
          {
            columns.clear();
            values.clear();
            for (Eigen::Index i = 0; i < A.rows(); ++i)
              if (A(i, j) != 0.)
                {
                  columns.push_back(of_cell[i]);
                  values.push_back(A(i, j));
                }
            // Epetra leaves out what the pattern has not, and returns a warning
            if (sum.SumIntoMyValues(of_cell[j],
                                    columns.size(),
                                    values.data(),
                                    columns.data()) != 0)
              throw std::logic_error("a matrix lacks entries of its cells");
          }
      }
  }



  Eigen::VectorXd
  PlateDiscretization::load(const std::vector<LoadPoint> &points,
                            const double                  rotation_factor) const
  {
    const FESystem<2>      &fe     = element.finite_element;
    const FiniteElement<2> &scalar = fe.base_element(0);
    Eigen::MatrixXd         on_cells =
      Eigen::MatrixXd::Zero(fe.n_dofs_per_cell(), mesh().n_active_cells());
    for_cells_under_load(
      mesh(),
      points,
      [&](const auto &cell, const Quadrature<2> &on_points) {
        FEValues<2> values(mapping_of(cell),
                           scalar,
                           on_points,
                           update_values | update_gradients);
        values.reinit(cell);
        auto on_cell = on_cells.col(cell->active_cell_index());
        for (unsigned int p = 0; p < on_points.size(); ++p)
          for (unsigned int i = 0; i < scalar.n_dofs_per_cell(); ++i)
            {
              on_cell[fe.component_to_system_index(deflection, i)] +=
                on_points.weight(p) * values.shape_value(i, p);
              for (const unsigned int d : {0, 1})
                on_cell[fe.component_to_system_index(rotation_x + d, i)] +=
                  on_points.weight(p) * rotation_factor *
                  values.shape_grad(i, p)[d];
            }
      });
    return forces_on_unknowns(on_cells);
  }



  Vector<double>
  PlateDiscretization::nodal_values(const Eigen::VectorXd &unknowns) const
  {
    Vector<double> values(dofs.n_dofs());
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      values[dof_of_unknown[i]] = unknowns[i];
    constraints.distribute(values);
    return values;
  }



  unsigned int
  PlateDiscretization::n_rigid_motions() const
  {
    const double       size = GridTools::diameter(mesh());
    const unsigned int n_motions =
      plate_section.stretching != Stretching::none ? 6 : 3;
    // by how much each fails what is held, all of which is at the boundary
    const IndexSet  boundary = DoFTools::extract_boundary_dofs(dofs);
    Eigen::MatrixXd misfit(boundary.n_elements(), n_motions);
    for (unsigned int k = 0; k < n_motions; ++k)
      {
        std::vector<std::function<double(const Point<2> &)>> components;
        for (unsigned int c = 0; c < dofs.get_fe().n_components(); ++c)
          components.push_back([=](const Point<2> &p) {
            // Along z, about y and x, and of plates that stretch along x and y
            // and about z. The size makes all alike.
            const double x = p[0] / size, y = p[1] / size, slope = 1. / size;
            const double motions[6][5] = {{1., 0., 0., 0., 0.},
                                          {x, slope, 0., 0., 0.},
                                          {y, 0., slope, 0., 0.},
                                          {0., 0., 0., 1., 0.},
                                          {0., 0., 0., 0., 1.},
                                          {0., 0., 0., -y, x}};
            return motions[k][c];
          });
        Vector<double> values(dofs.n_dofs());
        VectorTools::interpolate(mapping_of(mesh()),
                                 dofs,
                                 FunctionFromFunctionObjects<2>(components),
                                 values);
        Vector<double> held = values;
        constraints.distribute(held);
        held -= values;
        for (unsigned int i = 0; i < boundary.n_elements(); ++i)
          misfit(i, k) = held[boundary.nth_index_in_set(i)];
      }
    const Eigen::VectorXd singular_values =
      Eigen::JacobiSVD<Eigen::MatrixXd>(misfit).singularValues();
    return (singular_values.array() < 1e-6).count();
  }



  double
  PlateDiscretization::square_of_bending() const
  {
    const double area = GridTools::volume(mesh());
    return plate_section.mean_bending_stiffness() /
      plate_section.mass_per_area / (area * area);
  }
} // namespace PlateImpact
