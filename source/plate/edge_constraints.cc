#include "plate_impact/plate/edge_constraints.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/vector_tools_constraints.h>

#include "plate_impact/plate/plate_element.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <set>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    void
    hold(const DoFHandler<2>       &dofs,
         const types::boundary_id   edge,
         const ComponentMask       &components,
         AffineConstraints<double> &constraints)
    {
      if (components.n_selected_components() > 0)
        DoFTools::make_zero_boundary_constraints(dofs,
                                                 edge,
                                                 constraints,
                                                 components);
    }



    /// An edge whose normal is x or y.
    void
    hold_straight(const DoFHandler<2>       &dofs,
                  const types::boundary_id   edge,
                  const Support             &support,
                  AffineConstraints<double> &constraints)
    {
      const bool normal_is_x = edge == symmetry_x || edge == edge_x;
      hold(dofs, edge, support.held_components(normal_is_x), constraints);
    }



    /// Both rotations where two edges, or two sides of one, meet at an angle
    /// and each holds the rotation along its own tangent.
    void
    hold_corners(const DoFHandler<2>                &dofs,
                 const std::set<types::boundary_id> &edges,
                 AffineConstraints<double>          &constraints)
    {
      // a mean normal, which deal.II takes at vertices of several cells, is
      // that of a smooth edge
      const double least_cosine = std::cos(10. * std::acos(-1.) / 180.);
      const auto  &mesh         = dofs.get_triangulation();
      std::map<unsigned int, Tensor<1, 2>> normals;
      for (const auto &cell : dofs.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            if (!face->at_boundary() || edges.count(face->boundary_id()) == 0)
              continue;
            for (const unsigned int v : face->vertex_indices())
              {
                const Tensor<1, 2> normal =
                  mesh.get_manifold(face->manifold_id())
                    .normal_vector(face, face->vertex(v));
                const auto [known, is_new] =
                  normals.insert({face->vertex_index(v), normal});
                if (is_new || std::abs(known->second * normal) > least_cosine)
                  continue;
                for (const unsigned int component : {rotation_x, rotation_y})
                  if (const auto dof = face->vertex_dof_index(v, component);
                      !constraints.is_constrained(dof))
                    constraints.add_line(dof);
              }
          }
    }



    /// Edges that run in any direction.
    void
    hold_turned(const DoFHandler<2>                         &dofs,
                const std::map<types::boundary_id, Support> &supports,
                AffineConstraints<double>                   &constraints)
    {
      std::set<types::boundary_id> held_along;
      for (const auto &[edge, support] : supports)
        if (edge >= edge_round)
          {
            const bool    holds_both = support.normal_rotation;
            ComponentMask mask(n_components, holds_both);
            mask.set(deflection, support.deflection);
            hold(dofs, edge, mask, constraints);
            if (support.tangential_rotation && !holds_both)
              held_along.insert(edge);
          }
      if (held_along.empty())
        return;
      hold_corners(dofs, held_along, constraints);
      VectorTools::compute_normal_flux_constraints(dofs,
                                                   rotation_x,
                                                   held_along,
                                                   constraints,
                                                   curved_mapping());
    }
  } // namespace



  void
  hold_edges(const DoFHandler<2>                         &dofs,
             const std::map<types::boundary_id, Support> &supports,
             AffineConstraints<double>                   &constraints)
  {
    hold_straight(dofs, symmetry_x, symmetry_plane(), constraints);
    hold_straight(dofs, symmetry_y, symmetry_plane(), constraints);
    for (const auto &[edge, support] : supports)
      if (edge == edge_x || edge == edge_y)
        hold_straight(dofs, edge, support, constraints);
    hold_turned(dofs, supports, constraints);
  }
} // namespace PlateImpact
