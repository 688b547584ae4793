// What supports hold.
#include <deal.II/base/numbers.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/numerics/vector_tools_constraints.h>

#include "plate_impact/plate/plate_discretization.h"
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

    template <typename Choice>
    struct SupportRow
    {
      Choice      choice;
      std::string word;
      Held        held; ///< of the rotations, or of displacements in the plane
      bool        holds_deflection = true;
    };

    const std::vector<SupportRow<EdgeSupport>> support_rows = {
      {EdgeSupport::clamped, "clamped", {true, true}},
      {EdgeSupport::simply_supported, "simply supported", {false, true}},
      {EdgeSupport::soft_simply_supported,
       "soft simply supported",
       {false, false}},
      {EdgeSupport::free, "free", {false, false}, false}};

    const std::vector<SupportRow<InPlaneSupport>> in_plane_rows = {
      {InPlaneSupport::held, "held", {true, true}},
      {InPlaneSupport::sliding, "sliding", {false, false}},
      {InPlaneSupport::held_along, "held along", {false, true}},
      {InPlaneSupport::held_across, "held across", {true, false}}};

    using Edges = std::set<types::boundary_id>;


    /// Both components where edges, or sides of one, meet that hold two
    /// directions.
    void
    hold_corners(const DoFHandler<2>       &dof_handler,
                 const Edges               &along,
                 const Edges               &across,
                 const unsigned int         first,
                 AffineConstraints<double> &constraints)
    {
      // a mean normal, which deal.II takes at vertices of several cells, is
      // that of a smooth edge
      const double least_cosine = std::cos(10. * numbers::PI / 180.);
      std::map<unsigned int, Tensor<1, 2>> directions;
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            const bool is_along = along.count(face->boundary_id()) > 0;
            if (!is_along && across.count(face->boundary_id()) == 0)
              continue;
            for (const unsigned int v : face->vertex_indices())
              {
                const Tensor<1, 2> normal =
                  face->get_manifold().normal_vector(face, face->vertex(v));
                const Tensor<1, 2> held =
                  is_along ? cross_product_2d(normal) : normal;
                const auto [known, is_new] =
                  directions.insert({face->vertex_index(v), held});
                if (is_new || std::abs(known->second * held) > least_cosine)
                  continue;
                for (const unsigned int component : {first, first + 1})
                  constraints.add_line(face->vertex_dof_index(v, component));
              }
          }
    }



    /// A vector whose first component is given.
    void
    hold_vector(const DoFHandler<2>                      &dof_handler,
                const std::map<types::boundary_id, Held> &on_edges,
                const unsigned int                        first,
                AffineConstraints<double>                &constraints)
    {
      // edges that run in any direction, after all others
      Edges along, across;
      for (const auto &[edge, held] : on_edges)
        if (edge < edge_round || held.normal == held.tangential)
          {
            const bool    is_across_y = edge == symmetry_y || edge == edge_y;
            ComponentMask mask(dof_handler.get_fe().n_components(), false);
            mask.set(first + is_across_y, held.normal);
            mask.set(first + !is_across_y, held.tangential);
            if (held.normal || held.tangential)
              DoFTools::make_zero_boundary_constraints(dof_handler,
                                                       edge,
                                                       constraints,
                                                       mask);
          }
        else
          (held.normal ? across : along).insert(edge);
      hold_corners(dof_handler, along, across, first, constraints);
      if (!along.empty())
        VectorTools::compute_normal_flux_constraints(dof_handler,
                                                     first,
                                                     along,
                                                     constraints,
                                                     curved_mapping());
      if (!across.empty())
        VectorTools::compute_no_normal_flux_constraints(dof_handler,
                                                        first,
                                                        across,
                                                        constraints,
                                                        curved_mapping());
    }
  } // namespace



  template <>
  const std::vector<Word<EdgeSupport>>
    Choices<EdgeSupport>::words = words_of(support_rows);

  template <>
  const std::vector<Word<InPlaneSupport>>
    Choices<InPlaneSupport>::words = words_of(in_plane_rows);



  void
  PlateDiscretization::hold_edges(const PlateParameters &plate)
  {
    const PlateGeometry geometry = geometry_of(plate);
    const auto          in_plane = geometry.by_edge(plate.in_plane_supports);
    // a plane of symmetry holds both alike
    std::map<types::boundary_id, Held> rotations = {{symmetry_x, {true, false}},
                                                    {symmetry_y,
                                                     {true, false}}},
                                       displacements = rotations;
    const ComponentMask of_deflection =
      dofs.get_fe().component_mask(FEValuesExtractors::Scalar(deflection));
    for (const auto &[edge, support] : geometry.by_edge(plate.supports))
      {
        const auto &row = row_of(support, support_rows);
        rotations[edge] = row.held;
        if (!row.holds_deflection)
          continue;
        holds_deflection = true;
        if (!row.held.tangential)
          soft_edges.insert(edge);
        DoFTools::make_zero_boundary_constraints(dofs,
                                                 edge,
                                                 constraints,
                                                 of_deflection);
        displacements[edge] = row_of(in_plane.at(edge), in_plane_rows).held;
      }
    hold_vector(dofs, rotations, rotation_x, constraints);
    if (dofs.get_fe().n_components() > displacement_x)
      hold_vector(dofs, displacements, displacement_x, constraints);
  }
} // namespace PlateImpact
