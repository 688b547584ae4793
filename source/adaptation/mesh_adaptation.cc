#include "plate_impact/adaptation/mesh_adaptation.h"

#include <deal.II/grid/grid_refinement.h>
#include <deal.II/lac/vector.h>

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Refines every cell, whatever its error, unless one is at the minimum
    /// size.
    bool
    refine_uniformly(const Adapting &adapting)
    {
      for (const auto &cell : adapting.mesh.active_cell_iterators())
        if (is_smallest(cell, adapting.adaptivity))
          return false;
      adapting.mesh.refine_global();
      return true;
    }



    /// Refines the cells with the largest errors and coarsens those with the
    /// smallest, one level a cycle: those that together hold a share of the
    /// squared error (Doerfler 1996, doi:10.1137/0733054), or a share of the
    /// cells.
    bool
    refine_ranked(const Adapting &adapting)
    {
      Triangulation<2>           &mesh       = adapting.mesh;
      const std::vector<double>  &errors     = adapting.error.elements;
      const AdaptivityParameters &adaptivity = adapting.adaptivity;
      // Cells that may not be refined, and ought not to be coarsened, stay as
      // they are. Under a point load they would have all of the share.
      const auto is_settled = [&](const auto &cell) {
        return errors[cell->active_cell_index()] >= 1. &&
          is_smallest(cell, adaptivity);
      };
      const std::vector<CellId> before = sorted_cells(mesh);
      Vector<double>            criteria(errors.size());
      // Of cells that mirror each other all or none: round-off ranks no one
      // when 16 bits are left, about five digits.
      for (const auto &cell : mesh.active_cell_iterators())
        if (const unsigned int c = cell->active_cell_index(); !is_settled(cell))
          {
            int          exponent;
            const double mantissa = std::frexp(errors[c], &exponent);
            criteria[c] =
              std::ldexp(std::round(std::ldexp(mantissa, 16)), exponent - 16);
          }
      if (adaptivity.strategy == AdaptationStrategy::fixed_fraction)
        GridRefinement::refine_and_coarsen_fixed_fraction(
          mesh,
          criteria,
          adaptivity.refined_share_of_error,
          adaptivity.coarsened_share_of_error,
          std::numeric_limits<unsigned int>::max(),
          VectorTools::L2_norm);
      else
        GridRefinement::refine_and_coarsen_fixed_number(
          mesh,
          criteria,
          adaptivity.refined_share_of_cells,
          adaptivity.coarsened_share_of_cells);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          if (is_smallest(cell, adaptivity))
            cell->clear_refine_flag();
          if (is_settled(cell))
            cell->clear_coarsen_flag();
        }
      mesh.execute_coarsening_and_refinement();
      return sorted_cells(mesh) != before;
    }



    /// A mesh chosen before anything is known of its error: cells are at most
    /// theta r large, r the distance of their centre from the contact, down to
    /// the minimum cell size. The ratio theta is 1 first and halved from mesh
    /// to mesh.
    bool
    refine_graded(const Adapting &adapting)
    {
      const AdaptivityParameters &adaptivity = adapting.adaptivity;
      // below that, cells far from the contact are at the minimum size as well
      const double smallest_theta = adaptivity.minimum_cell_size /
        (2. * adapting.mesh.n_active_cells() * adaptivity.maximum_cell_size);
      for (double theta = 1.; theta > smallest_theta; theta *= 0.5)
        if (refine_to_contact(adapting.mesh,
                              theta,
                              adaptivity,
                              adapting.contact_half_length))
          return true;
      return false;
    }



    struct StrategyRow
    {
      AdaptationStrategy choice;
      std::string        word;
      bool (*adapt)(const Adapting &);
      /// Sizes of cells that take the place of the present ones, by active
      /// index; null of strategies that refine cells once. [m]
      decltype(&target_sizes) wanted_sizes = nullptr;
    };

    const std::vector<StrategyRow> strategies = {
      {AdaptationStrategy::none,
       "none",
       [](const Adapting &) { return false; }},
      {AdaptationStrategy::hanging_nodes,
       "hanging nodes",
       adapt_by_hanging_nodes,
       target_sizes},
      {AdaptationStrategy::remeshing, "remeshing", remesh, sizes_for_remeshing},
      {AdaptationStrategy::fixed_fraction, "fixed fraction", refine_ranked},
      {AdaptationStrategy::fixed_number, "fixed number", refine_ranked},
      {AdaptationStrategy::uniform, "uniform", refine_uniformly},
      {AdaptationStrategy::graded, "graded", refine_graded}};

    const std::vector<Word<AdaptationGoal>> goals = {
      {AdaptationGoal::energy_norm, "energy norm"},
      {AdaptationGoal::peak_force, "peak force"}};



    /// automatic, none, or three numbers for each point.
    Allowed<SingularPoints>
    points_and_strengths()
    {
      return {"automatic | none | x, y, lambda of a point, with lambda from "
              "0.25 to 4; further points after a semicolon",
              [](const std::string &text, SingularPoints &singular) {
                singular.are_found_automatically = text == "automatic";
                singular.points.clear();
                if (text == "automatic" || text == "none")
                  return true;
                for (const std::string &item : split_list(text, ';'))
                  {
                    std::vector<double> numbers;
                    if (!list(any_number(), 3, 3).read(item, numbers) ||
                        numbers[2] < 0.25 || numbers[2] > 4.)
                      return false;
                    singular.points.push_back(
                      {{{numbers[0], numbers[1]}}, numbers[2]});
                  }
                return true;
              }};
    }
  } // namespace



  /// All but none; those that follow the error of the peak force as well.
  template <>
  const std::vector<Word<ComparedStrategy>> Choices<ComparedStrategy>::words =
    [] {
      std::vector<Word<ComparedStrategy>> all;
      for (const StrategyRow &row : strategies)
        if (row.choice != AdaptationStrategy::none)
          all.push_back({{row.choice, AdaptationGoal::energy_norm}, row.word});
      for (const AdaptationStrategy strategy :
           {AdaptationStrategy::hanging_nodes,
            AdaptationStrategy::remeshing,
            AdaptationStrategy::fixed_fraction})
        all.push_back({{strategy, AdaptationGoal::peak_force},
                       row_of(strategy, strategies).word + " by force"});
      return all;
    }();



  bool
  adapt_mesh(const Adapting &adapting)
  {
    return row_of(adapting.adaptivity.strategy, strategies).adapt(adapting);
  }



  double
  n_wanted_cells(const Triangulation<2>     &mesh,
                 const ErrorRatios          &error,
                 const AdaptivityParameters &adaptivity)
  {
    const auto sizes = row_of(adaptivity.strategy, strategies).wanted_sizes;
    return sizes == nullptr ?
      mesh.n_active_cells() :
      n_cells_of_sizes(mesh, sizes(mesh, error, adaptivity), adaptivity);
  }



  std::unique_ptr<Triangulation<2>>
  make_first_mesh(const Parameters                  &parameters,
                  const std::array<unsigned int, 2> &n_cells)
  {
    auto mesh = make_plate_mesh(parameters.plate, n_cells);
    if (!parameters.adaptivity.is_for_peak_force())
      return mesh;
    AdaptivityParameters grading = parameters.adaptivity;
    // cells that may be halved are larger than the patch
    grading.minimum_cell_size = 0.5 *
      (parameters.contact.has_patch() ? parameters.contact.patch_radius :
                                        parameters.plate.thickness);
    // along a line that is much longer than wide they are too many
    grading.maximum_cells =
      std::min(grading.maximum_cells, mesh->n_active_cells() + 5000);
    refine_to_contact(*mesh,
                      1.,
                      grading,
                      parameters.impactor.contact_half_length());
    return mesh;
  }



  bool
  may_have_equal_cells(const Parameters &parameters)
  {
    return parameters.adaptivity.strategy ==
      AdaptationStrategy::hanging_nodes &&
      !parameters.plate.is_from_file();
  }



  bool
  refine_to_contact(Triangulation<2>           &mesh,
                    const double                theta,
                    const AdaptivityParameters &adaptivity,
                    const double                contact_half_length)
  {
    const double largest = (1. + 1e-6) * adaptivity.maximum_cell_size;
    for (bool is_refined = false;; is_refined = true)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          {
            const Point<2> centre = cell->center();
            const Point<2> nearest(std::clamp(centre[0],
                                              -contact_half_length,
                                              contact_half_length),
                                   0.);
            if (cell_size(cell) >
                  std::min(theta * centre.distance(nearest), largest) &&
                !is_smallest(cell, adaptivity))
              cell->set_refine_flag();
          }
        // with those that hanging nodes ask for
        mesh.prepare_coarsening_and_refinement();
        unsigned int n_cells = mesh.n_active_cells();
        for (const auto &cell : mesh.active_cell_iterators())
          n_cells += cell->refine_flag_set() ? 3 : 0;
        if (n_cells == mesh.n_active_cells() ||
            n_cells > adaptivity.maximum_cells)
          {
            for (const auto &cell : mesh.active_cell_iterators())
              cell->clear_refine_flag();
            return is_refined;
          }
        mesh.execute_coarsening_and_refinement();
      }
  }



  void
  AdaptivityParameters::declare_entries(Entries &entries)
  {
    const auto share = number_between(0, 1);
    const auto entry = entries.section("Adaptivity");
    entry("Strategy", "hanging nodes", one_of(strategies), strategy)
      .means("How the mesh is adapted to the error. hanging nodes: cells are "
             "refined and coarsened to their target sizes; where the peak "
             "force is the goal and comes late a rectangle or circle is "
             "divided anew. "
             "remeshing: a new mesh of quadrilaterals has the target sizes. "
             "fixed fraction, fixed number: the cells with the largest errors "
             "are halved, up to a given share of the error or of the cells. "
             "uniform: all cells are halved. graded: cell sizes are "
             "proportional to the distance from the contact, whatever the "
             "error. none: one mesh.");
    entry("Goal", "energy norm", one_of(goals), goal)
      .means("What the mesh is adapted for. energy norm: the relative error in "
             "the energy norm eta, as in the paper, down to Target error. peak "
             "force: the error bar of the peak force, down to Target peak "
             "force error; the first mesh is then fine at the load.");
    entry("Indicator", "SPR", one_of<ErrorIndicator>(), indicator)
      .means("How the error of a cell is indicated. SPR: by the recovered "
             "field. Kelly: by the jumps of slopes and curvatures across the "
             "sides of cells, which rank cells only. eta is always that of the "
             "recovered field.");
    entry("Recovery patches",
          "mirrored",
          second_of("mirrored", "interior"),
          patches_are_interior)
      .means("Where the patches of the recovery lie. mirrored: around every "
             "vertex, continued across planes of symmetry by mirror images. "
             "interior: around interior vertices only; vertices on the edges "
             "of the mesh use their patches.");
    entry("Target error", "0.05", share, target_error)
      .means("Relative error in the energy norm eta, a fraction. [-]");
    entry("Target peak force error", "1e-3", share, target_peak_force_error)
      .means("For Goal = peak force: the largest error bar of the peak force, "
             "relative to it. [-]");
    entry("Verify", "false", truth(), verify)
      .means("Compute the peak force again on the last mesh with every cell "
             "halved, and say how far it is: of Deflection = large half of the "
             "error bar.");
    entry("Maximum cycles", "6", whole_number(1, 1000), maximum_cycles)
      .means("Meshes computed on, the initial one included.");
    entry("Maximum cells", "250000", whole_number(1, 100000000), maximum_cells)
      .means("Largest number of cells; the run ends before a mesh with more.");
    entry("Size exponent", "0.5", number_up_to(0, 4), size_exponent)
      .means("phi in h_new = h_old / xi'^phi: 1/p, or 1/lambda near a "
             "singularity of strength lambda. [-]");
    entry("Singular points",
          "automatic",
          points_and_strengths(),
          singular_points)
      .means(
        "Points with their x and y from the centre of the plate and their "
        "strength lambda; phi is 1/lambda in the cells that touch them. "
        "automatic: with Goal = energy norm the re-entrant corners and changes "
        "of support, with lambda from angle and supports, the ends of a line "
        "load and a point load. [m, m, -]");
    entry("Cells at singularities",
          "left out",
          second_of("left out", "counted"),
          singular_cells_count)
      .means("For Goal = energy norm. left out: eta and the number of cells n "
             "leave out the cells at a point load, and xi' may stay above 1 in "
             "cells at the Minimum cell size. counted, as in the paper: all "
             "cells count, and xi' of every cell must be below 1.");
    entry("Minimum cell size", "0", number_from(0), minimum_cell_size)
      .means("Smallest length of a cell's longer side. 0: a quarter of the "
             "patch radius, or of the thickness under a point or line load. "
             "[m]");
    entry("Maximum cell size", "0", number_from(0), maximum_cell_size)
      .means("Largest length of a cell's longer side in adapted meshes. 0: "
             "that of the initial cells. [m]");
    entry("Refined share of error", "0.7", share, refined_share_of_error)
      .means("fixed fraction: the cells with the largest errors that together "
             "hold at most this share of the squared error are halved "
             "(Doerfler's marking). [-]");
    entry("Coarsened share of error", "0.01", share, coarsened_share_of_error)
      .means("fixed fraction: the cells with the smallest errors that together "
             "hold at most this share are doubled. [-]");
    entry("Refined share of cells", "0.3", share, refined_share_of_cells)
      .means("fixed number: this share of the cells, those with the largest "
             "errors, is halved. [-]");
    entry("Coarsened share of cells", "0.03", share, coarsened_share_of_cells)
      .means("fixed number: this share of the cells, those with the smallest "
             "errors, is doubled. [-]");
    entry("Sampling interval", "5", whole_number(1, 1000000), sampling_interval)
      .means("Time steps between samples of the error estimator; fewer where "
             "the transient would have less than 20 samples, more where the "
             "program chooses the step and there would be more than 1000.");
  }
} // namespace PlateImpact
