#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// against round-off in sizes that are powers of two apart
    constexpr double rounding = 1e-9;



    /// Level that brings a cell to its target size, as far as the smallest and
    /// the largest size allow it; of these the largest comes first.
    int
    wanted_level(const Triangulation<2>::active_cell_iterator &cell,
                 const double                                  target_size,
                 const AdaptivityParameters                   &adaptivity)
    {
      const double h      = cell_size(cell);
      const auto   levels = [](const double ratio) {
        return std::ceil(std::log2(ratio) - rounding);
      };
      // The error of a cell grows by 2^{p+1} when it is coarsened (p = 2),
      // while h_new = h / xi'^phi counts on 2^{1/phi}: without the margin the
      // next cycle refines again what this one coarsens.
      const double margin =
        std::max(1., std::pow(2., 3. * adaptivity.size_exponent - 1.));
      const double refinement = levels(h / target_size);
      const double coarsening = std::min(0., levels(margin * h / target_size));
      const CellSizing sizing(cell, adaptivity);
      const double     most =
        std::max(0., std::floor(std::log2(h / sizing.minimum) + rounding));
      const double least = levels(h / sizing.maximum);
      const double change =
        std::max(refinement > 0. ? std::min(refinement, most) : coarsening,
                 least);
      return static_cast<int>(std::max(0., cell->level() + change));
    }



    /// The wanted level, which plus one is the user index of the cell or of the
    /// ancestor that it was refined from; away from a singular point that the
    /// ancestor touches cells may be larger.
    int
    inherited_level(const Triangulation<2>::cell_iterator &cell,
                    const AdaptivityParameters            &adaptivity)
    {
      auto ancestor = cell;
      while (ancestor->user_index() == 0 && ancestor->level() > 0)
        ancestor = ancestor->parent();
      const int wanted = static_cast<int>(ancestor->user_index()) - 1;
      if (ancestor == cell || wanted <= cell->level())
        return wanted;
      const double size =
        cell_size(ancestor) * std::exp2(ancestor->level() - wanted);
      const CellSizing sizing(ancestor, adaptivity);
      double           here = std::numeric_limits<double>::infinity();
      for (const unsigned int v : cell->vertex_indices())
        here = std::min(here, sizing.at(cell->vertex(v), size));
      const int larger =
        static_cast<int>(std::floor(std::log2(here / size) + rounding));
      return std::max(wanted - larger, cell->level());
    }



    /// Flags cells off their target level; a family is coarsened when all of
    /// its cells are too fine, to the finest of their levels.
    /// @return whether there are any
    bool
    flag(Triangulation<2> &mesh, const AdaptivityParameters &adaptivity)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const int wanted = inherited_level(cell, adaptivity);
          cell->set_user_index(wanted + 1);
          if (wanted > cell->level())
            cell->set_refine_flag();
          else if (wanted < cell->level())
            cell->set_coarsen_flag();
        }
      mesh.prepare_coarsening_and_refinement();
      bool is_flagged = false;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          is_flagged |= cell->refine_flag_set() || cell->coarsen_flag_set();
          if (cell->coarsen_flag_set())
            {
              const auto parent = cell->parent();
              int        wanted = 0;
              for (const auto &child : parent->child_iterators())
                wanted = std::max(wanted, inherited_level(child, adaptivity));
              parent->set_user_index(wanted + 1);
            }
        }
      return is_flagged;
    }
  } // namespace



  bool
  adapt_by_hanging_nodes(const Adapting &adapting)
  {
    Triangulation<2>           &mesh       = adapting.mesh;
    const AdaptivityParameters &adaptivity = adapting.adaptivity;
    const std::vector<CellId>   before     = sorted_cells(mesh);
    const std::vector<double>   sizes =
      target_sizes(mesh, adapting.error, adaptivity);
    mesh.clear_user_data();
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_user_index(
        1 + wanted_level(cell, sizes[cell->active_cell_index()], adaptivity));

    // One level at a time. Cells refined for the sake of their neighbours are
    // flagged to be coarsened again; prepare_coarsening_and_refinement() takes
    // such flags back, which ends the loop. The bound is for meshes where it
    // does not.
    for (unsigned int pass = 0; pass < 64 && flag(mesh, adaptivity); ++pass)
      mesh.execute_coarsening_and_refinement();
    return sorted_cells(mesh) != before;
  }
} // namespace PlateImpact
