#include "plate_impact/plate/support.h"

#include <deal.II/base/numbers.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/vector_tools_constraints.h>

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What a support holds on an edge of the plate.
    struct Support
    {
      bool deflection;
      bool normal_rotation;     ///< theta_n, in the plane across the edge
      bool tangential_rotation; ///< theta_s, in the plane along the edge
    };

    struct SupportRow
    {
      EdgeSupport choice;
      std::string word;
      Support     held;
    };

    const std::vector<SupportRow> support_rows = {
      {EdgeSupport::clamped, "clamped", {true, true, true}},
      {EdgeSupport::simply_supported, "simply supported", {true, false, true}},
      {EdgeSupport::soft_simply_supported,
       "soft simply supported",
       {true, false, false}},
      {EdgeSupport::free, "free", {false, false, false}}};

    /// It mirrors the plate.
    constexpr Support symmetry_plane = {false, true, false};



    /// Holds components on an edge: the deflection and rotations in the planes
    /// xz and yz.
    void
    hold(const DoFHandler<2>                  &dof_handler,
         const types::boundary_id              edge,
         const std::array<bool, n_components> &components,
         AffineConstraints<double>            &constraints)
    {
      ComponentMask mask(n_components, false);
      for (unsigned int c = 0; c < n_components; ++c)
        mask.set(c, components[c]);
      if (mask.n_selected_components() > 0)
        DoFTools::make_zero_boundary_constraints(dof_handler,
                                                 edge,
                                                 constraints,
                                                 mask);
    }



    /// An edge whose normal is x or y.
    void
    hold_straight(const DoFHandler<2>       &dof_handler,
                  const types::boundary_id   edge,
                  const Support             &support,
                  AffineConstraints<double> &constraints)
    {
      std::array<bool, n_components> held = {{support.deflection,
                                              support.normal_rotation,
                                              support.tangential_rotation}};
      if (edge == symmetry_y || edge == edge_y)
        std::swap(held[rotation_x], held[rotation_y]);
      hold(dof_handler, edge, held, constraints);
    }



    /// Both rotations where two edges, or two sides of one, meet at an angle
    /// and each holds the rotation along its own tangent.
    void
    hold_corners(const DoFHandler<2>                &dof_handler,
                 const std::set<types::boundary_id> &edges,
                 AffineConstraints<double>          &constraints)
    {
      // a mean normal, which deal.II takes at vertices of several cells, is
      // that of a smooth edge
      const double least_cosine = std::cos(10. * numbers::PI / 180.);
      const auto  &mesh         = dof_handler.get_triangulation();
      std::map<unsigned int, Tensor<1, 2>> normals;
      for (const auto &cell : dof_handler.active_cell_iterators())
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
  } // namespace



  template <>
  const std::vector<Word<EdgeSupport>>
    Choices<EdgeSupport>::words = words_of(support_rows);



  bool
  hold_deflection(const SupportOfEdge &supports)
  {
    return std::any_of(
      supports.begin(),
      supports.end(),
      [](const auto &of_edge) {
        return row_of(of_edge.second, support_rows).held.deflection;
      });
  }



  void
  hold_edges(const DoFHandler<2>       &dof_handler,
             const SupportOfEdge       &supports,
             AffineConstraints<double> &constraints)
  {
    hold_straight(dof_handler, symmetry_x, symmetry_plane, constraints);
    hold_straight(dof_handler, symmetry_y, symmetry_plane, constraints);
    // edges that run in any direction and hold the rotation along it
    std::set<types::boundary_id> held_along;
    for (const auto &[edge, name] : supports)
      {
        const Support &support = row_of(name, support_rows).held;
        if (edge == edge_x || edge == edge_y)
          {
            hold_straight(dof_handler, edge, support, constraints);
            continue;
          }
        const bool holds_both = support.normal_rotation;
        hold(dof_handler,
             edge,
             {{support.deflection, holds_both, holds_both}},
             constraints);
        if (support.tangential_rotation && !holds_both)
          held_along.insert(edge);
      }
    if (held_along.empty())
      return;
    hold_corners(dof_handler, held_along, constraints);
    VectorTools::compute_normal_flux_constraints(dof_handler,
                                                 rotation_x,
                                                 held_along,
                                                 constraints,
                                                 curved_mapping());
  }
} // namespace PlateImpact
