#include "plate_impact/plate/plate_discretization.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/rtree.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/SVD>
#include <Epetra_CrsGraph.h>
#include <Epetra_Map.h>
#include <Epetra_SerialComm.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>

namespace PlateImpact
{
  using namespace dealii;

  PlateDiscretization::PlateDiscretization(const Triangulation<2> &mesh,
                                           const PlateElement     &element,
                                           const PlateParameters  &plate,
                                           const double            n_parts)
    : element(element)
    , n_parts(n_parts > 0. ? n_parts : geometry_of(plate).n_parts())
    , section(plate)
    , dofs(mesh)
  {
    if (element.stretching != section.stretching)
      throw std::logic_error("the element has not the unknowns of the section");
    dofs.distribute_dofs(element.finite_element);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    element.add_internal_constraints(dofs, constraints);
    hold_edges(plate);
    constraints.close();
    number_unknowns();

    const double tolerance = 1e-10 * mesh.begin_active(0)->diameter();
    // corners relative to the first one: equal for congruent cells of equal
    // orientation
    std::map<std::vector<long>, unsigned int> known;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        std::vector<long> corners;
        for (const unsigned int v : {1, 2, 3})
          for (const unsigned int d : {0, 1})
            corners.push_back(std::lround(
              (cell->vertex(v)[d] - cell->vertex(0)[d]) / tolerance));
        unsigned int shape = shapes.size();
        // corners do not tell curved cells apart
        if (&mapping_of(cell) != &curved_mapping())
          shape = known.insert({corners, shape}).first->second;
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

    using Entries = AffineConstraints<double>::ConstraintLine::Entries;
    const FiniteElement<2>              &fe = dofs.get_fe();
    std::vector<types::global_dof_index> of_cell(fe.n_dofs_per_cell());
    std::vector<Eigen::Triplet<double>>  weights;
    int                                  row = 0;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(of_cell);
        std::set<int> unknowns;
        for (unsigned int i = 0; i < of_cell.size(); ++i, ++row)
          {
            const auto *masters =
              constraints.get_constraint_entries(of_cell[i]);
            const Entries itself = {{of_cell[i], 1.}};
            for (const auto &[dof, weight] : masters ? *masters : itself)
              {
                weights.emplace_back(row, unknown_of_dof[dof], weight);
                unknowns.insert(unknown_of_dof[dof]);
                components_of[unknown_of_dof[dof]] |= 1u
                  << fe.system_to_component_index(i).first;
              }
          }
        unknowns_of_cells.emplace_back(unknowns.begin(), unknowns.end());
      }
    nodal_values_of_cells.resize(row, n_unknowns());
    nodal_values_of_cells.setFromTriplets(weights.begin(), weights.end());
  }



  void
  PlateDiscretization::assemble()
  {
    const Epetra_Map map(static_cast<int>(n_unknowns()),
                         0,
                         Epetra_SerialComm());
    // local indices of a known column map need no search, and a matrix whose
    // graph is complete takes its values at once
    Epetra_CrsGraph of_K(Copy, map, map, 0), of_M(Copy, map, map, 0);
    for (std::vector<int> &of_cell : unknowns_of_cells)
      for (const int row : of_cell)
        {
          of_K.InsertMyIndices(row, of_cell.size(), of_cell.data());
          // inertia couples no component with another, but edges in any
          // direction give one unknown to both rotations
          std::vector<int> coupled;
          for (const int column : of_cell)
            if ((components_of[row] & components_of[column]) != 0)
              coupled.push_back(column);
          of_M.InsertMyIndices(row, coupled.size(), coupled.data());
        }
    for (const auto &[graph, matrix] :
         {std::pair(&of_K, &K), std::pair(&of_M, &M)})
      {
        graph->FillComplete();
        graph->OptimizeStorage();
        *matrix = std::make_unique<Epetra_CrsMatrix>(Copy, *graph);
        (*matrix)->FillComplete();
      }

    // congruent cells share their matrices
    std::vector<Eigen::MatrixXd> K_of_shape, M_of_shape;
    for (const CellShape &shape : shapes)
      {
        K_of_shape.push_back(element.stiffness(shape, section));
        M_of_shape.push_back(element.mass(shape, section));
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
        const std::vector<int> &of_cell = unknowns_of_cells[cell];
        Weights                 weights(n, of_cell.size());
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
    const FESystem<2> &fe = element.finite_element;
    Eigen::MatrixXd    on_cells =
      Eigen::MatrixXd::Zero(fe.n_dofs_per_cell(), mesh().n_active_cells());
    std::vector<Point<2>> positions;
    for (const LoadPoint &point : points)
      positions.push_back(point.point);
    const auto        tree = pack_rtree_of_indices(positions);
    std::vector<bool> is_found(points.size(), false);
    for (const auto &cell : mesh().active_cell_iterators())
      {
        const Mapping<2> &mapping = mapping_of(cell);
        BoundingBox<2>    box     = cell->bounding_box();
        // a curved cell reaches beyond the box of its corners, by a part of it
        box.extend((&mapping == &curved_mapping() ? 0.25 : 1e-9) *
                   std::max(box.side_length(0), box.side_length(1)));
        std::vector<std::size_t> near;
        tree.query(boost::geometry::index::intersects(box),
                   std::back_inserter(near));
        if (near.empty())
          continue;
        std::vector<Point<2>> real, unit(near.size()), within;
        for (const std::size_t p : near)
          real.push_back(positions[p]);
        mapping.transform_points_real_to_unit_cell(cell, real, unit);
        std::vector<double> weights;
        for (std::size_t i = 0; i < near.size(); ++i)
          if (!is_found[near[i]] &&
              GeometryInfo<2>::is_inside_unit_cell(unit[i], 1e-9))
            {
              is_found[near[i]] = true;
              within.push_back(unit[i]);
              weights.push_back(points[near[i]].weight);
            }
        if (within.empty())
          continue;
        FEValues<2> values(mapping,
                           element.scalar_element,
                           Quadrature<2>(within, weights),
                           update_values | update_gradients);
        values.reinit(cell);
        auto on_cell = on_cells.col(cell->active_cell_index());
        for (unsigned int p = 0; p < within.size(); ++p)
          for (unsigned int i = 0; i < values.dofs_per_cell; ++i)
            {
              on_cell[fe.component_to_system_index(deflection, i)] +=
                weights[p] * values.shape_value(i, p);
              for (const unsigned int d : {0, 1})
                on_cell[fe.component_to_system_index(rotation_x + d, i)] +=
                  weights[p] * rotation_factor * values.shape_grad(i, p)[d];
            }
      }
    if (std::count(is_found.begin(), is_found.end(), false) > 0)
      throw ComputationError("the load distribution reaches beyond the mesh");
    return forces_on_unknowns(on_cells);
  }



  unsigned int
  PlateDiscretization::n_rigid_motions() const
  {
    const double       size = GridTools::diameter(mesh());
    const unsigned int n_motions =
      section.stretching != Stretching::none ? 6 : 3;
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
        Vector<double> held = nodal_values(unknowns_of_nodal_values(values));
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
    return section.mean_bending_stiffness() / section.mass_per_area /
      (area * area);
  }
} // namespace PlateImpact
