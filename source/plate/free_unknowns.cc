#include "plate_impact/plate/free_unknowns.h"

#include <algorithm>

namespace PlateImpact
{
  using namespace dealii;

  void
  FreeUnknowns::reinit(const DoFHandler<2>             &dof_handler,
                       const AffineConstraints<double> &homogeneous_constraints)
  {
    constraints = &homogeneous_constraints;
    n_cell_dofs = dof_handler.get_fe().n_dofs_per_cell();
    unknown_of_dof.assign(dof_handler.n_dofs(), -1);
    unsigned int n_free = 0;
    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
      if (!constraints->is_constrained(dof))
        unknown_of_dof[dof] = n_free++;
    components_of.assign(n_free, 0);

    std::vector<types::global_dof_index> dofs(n_cell_dofs);
    std::vector<Eigen::Triplet<double>>  weights;
    int                                  row = 0;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i, ++row)
          {
            const auto add = [&](const int unknown, const double weight) {
              weights.emplace_back(row, unknown, weight);
              components_of[unknown] |= 1u
                << cell->get_fe().system_to_component_index(i).first;
            };
            if (unknown_of_dof[dofs[i]] >= 0)
              add(unknown_of_dof[dofs[i]], 1.);
            else
              for (const auto &[master, weight] :
                   *constraints->get_constraint_entries(dofs[i]))
                add(unknown_of_dof[master], weight);
          }
      }
    nodal_values_of_cells.resize(row, n_free);
    nodal_values_of_cells.setFromTriplets(weights.begin(), weights.end());
  }



  std::vector<types::global_dof_index>
  FreeUnknowns::of_cell(const unsigned int cell) const
  {
    const int *const columns = nodal_values_of_cells.innerIndexPtr(),
                     *first  = nodal_values_of_cells.outerIndexPtr() +
      n_cell_dofs * cell;
    std::vector<types::global_dof_index> unknowns(columns + first[0],
                                                  columns + first[n_cell_dofs]);
    std::sort(unknowns.begin(), unknowns.end());
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()),
                   unknowns.end());
    return unknowns;
  }



  Eigen::MatrixXd
  FreeUnknowns::resolve_constraints(
    const unsigned int                          cell,
    const std::vector<types::global_dof_index> &unknowns,
    const Eigen::MatrixXd                      &matrix) const
  {
    using Weights = decltype(nodal_values_of_cells);
    Weights weights(n_cell_dofs, unknowns.size());
    for (int i = 0; i < n_cell_dofs; ++i)
      for (Weights::InnerIterator entry(nodal_values_of_cells,
                                        n_cell_dofs * cell + i);
           entry;
           ++entry)
        weights.insert(i,
                       std::lower_bound(unknowns.begin(),
                                        unknowns.end(),
                                        entry.col()) -
                         unknowns.begin()) = entry.value();
    const Eigen::MatrixXd of_rows = matrix * weights;
    return weights.transpose() * of_rows;
  }



  Eigen::MatrixXd
  FreeUnknowns::values_of_cells(const Eigen::VectorXd &unknowns) const
  {
    const Eigen::VectorXd values = nodal_values_of_cells * unknowns;
    return Eigen::Map<const Eigen::MatrixXd>(values.data(),
                                             n_cell_dofs,
                                             values.size() / n_cell_dofs);
  }



  Eigen::VectorXd
  FreeUnknowns::forces(const Eigen::MatrixXd &of_cells) const
  {
    return nodal_values_of_cells.transpose() *
      Eigen::Map<const Eigen::VectorXd>(of_cells.data(), of_cells.size());
  }



  Eigen::VectorXd
  FreeUnknowns::of_nodal_values(const Vector<double> &values) const
  {
    Eigen::VectorXd unknowns(size());
    for (types::global_dof_index dof = 0; dof < values.size(); ++dof)
      if (unknown_of_dof[dof] >= 0)
        unknowns[unknown_of_dof[dof]] = values[dof];
    return unknowns;
  }



  Vector<double>
  FreeUnknowns::nodal_values(const Eigen::VectorXd &unknowns) const
  {
    Vector<double> values(unknown_of_dof.size());
    for (types::global_dof_index dof = 0; dof < values.size(); ++dof)
      if (unknown_of_dof[dof] >= 0)
        values[dof] = unknowns[unknown_of_dof[dof]];
    constraints->distribute(values);
    return values;
  }
} // namespace PlateImpact
