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
    unknown_of_dof.assign(dof_handler.n_dofs(), -1);
    unsigned int n_free = 0;
    for (types::global_dof_index dof = 0; dof < dof_handler.n_dofs(); ++dof)
      if (!constraints->is_constrained(dof))
        unknown_of_dof[dof] = n_free++;
    components.resize(n_free);

    std::vector<types::global_dof_index> dofs(n_cell_dofs);
    first_contribution = {0};
    contributions.clear();
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const types::global_dof_index dof = dofs[i];
            if (!constraints->is_constrained(dof))
              {
                contributions.push_back({unknown_of_dof[dof], 1.});
                components[unknown_of_dof[dof]] =
                  cell->get_fe().system_to_component_index(i).first;
              }
            else
              for (const auto &[master, weight] :
                   *constraints->get_constraint_entries(dof))
                contributions.push_back({unknown_of_dof[master], weight});
            first_contribution.push_back(contributions.size());
          }
      }
  }



  std::vector<types::global_dof_index>
  FreeUnknowns::of_cell(const unsigned int cell) const
  {
    const auto first = first_contribution.begin() + n_cell_dofs * cell;
    std::vector<types::global_dof_index> unknowns;
    for (std::size_t k = first[0]; k < first[n_cell_dofs]; ++k)
      unknowns.push_back(contributions[k].unknown);
    std::sort(unknowns.begin(), unknowns.end());
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()),
                   unknowns.end());
    return unknowns;
  }



  void
  FreeUnknowns::resolve_constraints(
    const unsigned int                          cell,
    const std::vector<types::global_dof_index> &unknowns,
    const CellMatrix                           &matrix,
    Eigen::MatrixXd                            &result) const
  {
    const auto        first = first_contribution.begin() + n_cell_dofs * cell;
    const std::size_t begin = first[0];
    std::vector<int>  position, dof; // of contributions
    for (int i = 0; i < n_cell_dofs; ++i)
      for (std::size_t k = first[i]; k < first[i + 1]; ++k)
        {
          dof.push_back(i);
          position.push_back(std::lower_bound(unknowns.begin(),
                                              unknowns.end(),
                                              contributions[k].unknown) -
                             unknowns.begin());
        }
    result.setZero(unknowns.size(), unknowns.size());
    for (std::size_t l = 0; l < dof.size(); ++l)
      for (std::size_t k = 0; k < dof.size(); ++k)
        result(position[k], position[l]) += contributions[begin + k].weight *
          contributions[begin + l].weight * matrix(dof[k], dof[l]);
  }



  void
  FreeUnknowns::cell_values(const unsigned int                       cell,
                            const Eigen::Ref<const Eigen::MatrixXd> &unknowns,
                            Eigen::MatrixXd &values) const
  {
    values.setZero(n_cell_dofs, unknowns.cols());
    const auto first = first_contribution.begin() + n_cell_dofs * cell;
    for (int i = 0; i < n_cell_dofs; ++i)
      for (std::size_t k = first[i]; k < first[i + 1]; ++k)
        values.row(i) +=
          contributions[k].weight * unknowns.row(contributions[k].unknown);
  }



  void
  FreeUnknowns::add_force(const unsigned int cell,
                          const unsigned int i,
                          const double       force,
                          Eigen::VectorXd   &forces) const
  {
    const auto first = first_contribution.begin() + n_cell_dofs * cell;
    for (std::size_t k = first[i]; k < first[i + 1]; ++k)
      forces[contributions[k].unknown] += force * contributions[k].weight;
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
