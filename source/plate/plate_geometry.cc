#include "plate_impact/plate/plate_geometry.h"

#include "plate_impact/base/entries.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <string>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;


  bool
  PlateGeometry::is_symmetric(const unsigned int d) const
  {
    return !plate.is_skew && plate.impact_point[d] == 0.;
  }



  double
  PlateGeometry::n_parts() const
  {
    return (is_symmetric(0) ? 2. : 1.) * (is_symmetric(1) ? 2. : 1.);
  }



  template <typename Support>
  std::map<types::boundary_id, Support>
  PlateGeometry::by_edge(const std::vector<OnEdge<Support>> &written) const
  {
    std::map<types::boundary_id, Support> result;
    const bool  is_named = !written.front().edge.empty();
    std::size_t n_edges  = 0;
    for (const auto &[id, name] : edges())
      {
        // one word is for all edges, or the first for the first of two
        const OnEdge<Support> *one =
          &written[std::min(n_edges++, written.size() - 1)];
        for (const OnEdge<Support> &named : written)
          if (is_named && named.edge == name)
            one = &named;
        result[id] = one->support;
      }
    return result;
  }



  SupportOfEdge
  PlateGeometry::supports() const
  {
    return by_edge(plate.supports);
  }



  InPlaneSupportOfEdge
  PlateGeometry::in_plane_supports() const
  {
    return by_edge(plate.in_plane_supports);
  }



  double
  PlateGeometry::begin(const unsigned int d) const
  {
    return is_symmetric(d) ? 0. : -0.5 * side_length(d) - plate.impact_point[d];
  }



  double
  PlateGeometry::end(const unsigned int d) const
  {
    return 0.5 * side_length(d) - plate.impact_point[d];
  }



  double
  PlateGeometry::n_initial_cells(const CellNumbers &n_cells) const
  {
    return static_cast<double>(n_cells[0]) * n_cells[1];
  }



  double
  PlateGeometry::initial_cell_size(const CellNumbers &n_cells) const
  {
    Triangulation<2> mesh;
    make_mesh(mesh, n_cells);
    double longest = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      longest = std::max(longest, cell_size(cell));
    return longest;
  }



  namespace
  {
    struct OutlineRow
    {
      PlateOutline choice;
      std::string  word; ///< empty: a file's name stands for it
      std::unique_ptr<const PlateGeometry> (*make)(const PlateParameters &);
    };

    const std::vector<OutlineRow> outlines = {
      {PlateOutline::rectangle, "rectangle", make_rectangular_plate},
      {PlateOutline::circle, "circle", make_circular_plate},
      {PlateOutline::file, "", make_plate_from_file}};
  } // namespace



  template <>
  const std::vector<Word<PlateOutline>> Choices<PlateOutline>::words = [] {
    auto words = words_of(outlines);
    words.pop_back(); // of files
    return words;
  }();



  std::unique_ptr<const PlateGeometry>
  geometry_of(const PlateParameters &plate)
  {
    return row_of(plate.outline.shape, outlines).make(plate);
  }



  std::unique_ptr<Triangulation<2>>
  make_plate_mesh(const PlateParameters             &plate,
                  const std::array<unsigned int, 2> &n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    geometry_of(plate)->make_mesh(*mesh, n_cells);
    return mesh;
  }



  double
  initial_cell_size(const Parameters &parameters)
  {
    return geometry_of(parameters.plate)
      ->initial_cell_size(parameters.discretization.initial_cells);
  }
} // namespace PlateImpact
