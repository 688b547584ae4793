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

#include <cmath>
#include <map>
#include <set>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What a support holds on an edge of the plate, of two components across
    /// and along it.
    struct Held
    {
      bool normal, tangential;
    };

    struct SupportRow
    {
      EdgeSupport choice;
      std::string word;
      bool        deflection;
      Held        rotations;
    };

    const std::vector<SupportRow> support_rows = {
      {EdgeSupport::clamped, "clamped", true, {true, true}},
      {EdgeSupport::simply_supported, "simply supported", true, {false, true}},
      {EdgeSupport::soft_simply_supported,
       "soft simply supported",
       true,
       {false, false}},
      {EdgeSupport::free, "free", false, {false, false}}};

    struct InPlaneRow
    {
      InPlaneSupport choice;
      std::string    word;
      Held           displacements;
    };

    const std::vector<InPlaneRow> in_plane_rows = {
      {InPlaneSupport::held, "held", {true, true}},
      {InPlaneSupport::sliding, "sliding", {false, false}},
      {InPlaneSupport::held_along, "held along", {false, true}},
      {InPlaneSupport::held_across, "held across", {true, false}}};

    /// Of both rotations and displacements in a plane of symmetry.
    constexpr Held mirrored = {true, false};



    /// Holds components on edges.
    class EdgeHolder
    {
    public:
      EdgeHolder(const DoFHandler<2>       &dof_handler,
                 AffineConstraints<double> &constraints)
        : dof_handler(dof_handler)
        , constraints(constraints)
      {}

      void
      hold(const types::boundary_id edge, const unsigned int component)
      {
        ComponentMask mask(dof_handler.get_fe().n_components(), false);
        mask.set(component, true);
        DoFTools::make_zero_boundary_constraints(dof_handler,
                                                 edge,
                                                 constraints,
                                                 mask);
      }



      /// A vector whose first component is given.
      void
      hold(const types::boundary_id edge,
           const Held              &held,
           const unsigned int       first)
      {
        const bool is_across_y = edge == symmetry_y || edge == edge_y;
        const bool is_straight =
          is_across_y || edge == symmetry_x || edge == edge_x;
        if (is_straight || held.normal == held.tangential)
          {
            if (held.normal)
              hold(edge, first + is_across_y);
            if (held.tangential)
              hold(edge, first + !is_across_y);
          }
        else
          (held.normal ? held_across : held_along)[first].insert(edge);
      }



      /// Edges that run in any direction, after all others.
      void
      hold_oblique(const unsigned int first)
      {
        hold_corners(first);
        const Mapping<2> &mapping = curved_mapping();
        if (const Edges &edges = held_along[first]; !edges.empty())
          VectorTools::compute_normal_flux_constraints(dof_handler,
                                                       first,
                                                       edges,
                                                       constraints,
                                                       mapping);
        if (const Edges &edges = held_across[first]; !edges.empty())
          VectorTools::compute_no_normal_flux_constraints(dof_handler,
                                                          first,
                                                          edges,
                                                          constraints,
                                                          mapping);
      }

    private:
      using Edges = std::set<types::boundary_id>;

      /// Both components where edges, or sides of one, meet that hold two
      /// directions.
      void
      hold_corners(const unsigned int first)
      {
        // a mean normal, which deal.II takes at vertices of several cells, is
        // that of a smooth edge
        const double least_cosine = std::cos(10. * numbers::PI / 180.);
        const auto  &mesh         = dof_handler.get_triangulation();
        std::map<unsigned int, Tensor<1, 2>> directions;
        for (const auto &cell : dof_handler.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            {
              const types::boundary_id edge = face->boundary_id();
              const bool is_along           = held_along[first].count(edge) > 0;
              if (!face->at_boundary() ||
                  (!is_along && held_across[first].count(edge) == 0))
                continue;
              for (const unsigned int v : face->vertex_indices())
                {
                  const Tensor<1, 2> normal =
                    mesh.get_manifold(face->manifold_id())
                      .normal_vector(face, face->vertex(v));
                  const Tensor<1, 2> held =
                    is_along ? cross_product_2d(normal) : normal;
                  const auto [known, is_new] =
                    directions.insert({face->vertex_index(v), held});
                  if (is_new || std::abs(known->second * held) > least_cosine)
                    continue;
                  for (const unsigned int component : {first, first + 1})
                    if (const auto dof = face->vertex_dof_index(v, component);
                        !constraints.is_constrained(dof))
                      constraints.add_line(dof);
                }
            }
      }

      const DoFHandler<2>          &dof_handler;
      AffineConstraints<double>    &constraints;
      std::map<unsigned int, Edges> held_along, held_across; ///< by component
    };
  } // namespace



  template <>
  const std::vector<Word<EdgeSupport>>
    Choices<EdgeSupport>::words = words_of(support_rows);

  template <>
  const std::vector<Word<InPlaneSupport>>
    Choices<InPlaneSupport>::words = words_of(in_plane_rows);



  bool
  hold_edges(const DoFHandler<2>       &dof_handler,
             const PlateGeometry       &geometry,
             AffineConstraints<double> &constraints)
  {
    EdgeHolder holder(dof_handler, constraints);
    const bool stretches = dof_handler.get_fe().n_components() > displacement_x;
    for (const types::boundary_id plane : {symmetry_x, symmetry_y})
      {
        holder.hold(plane, mirrored, rotation_x);
        if (stretches)
          holder.hold(plane, mirrored, displacement_x);
      }
    bool                       holds_deflection = false;
    const InPlaneSupportOfEdge in_plane         = geometry.in_plane_supports();
    for (const auto &[edge, support] : geometry.supports())
      {
        const SupportRow &row = row_of(support, support_rows);
        if (row.deflection)
          holder.hold(edge, deflection);
        holds_deflection |= row.deflection;
        holder.hold(edge, row.rotations, rotation_x);
        if (stretches && row.deflection)
          holder.hold(edge,
                      row_of(in_plane.at(edge), in_plane_rows).displacements,
                      displacement_x);
      }
    holder.hold_oblique(rotation_x);
    if (stretches)
      holder.hold_oblique(displacement_x);
    return holds_deflection;
  }
} // namespace PlateImpact
