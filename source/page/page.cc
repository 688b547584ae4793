#include "plate_impact/page/page.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/plate/plate_geometry.h"

#include <string_view>
#include <utility>

/// The files of source/page/, its scripts as one, and Chart.js, which
/// cmake/embed.cmake writes into the program.
namespace PlateImpact::PageAssets
{
  extern const std::string_view page, style, script, library;
}

namespace PlateImpact
{
  using dealii::Utilities::replace_in_string;

  namespace
  {
    std::string
    as_html(std::string text)
    {
      // the first first: it is in all that stands for others
      const std::pair<const char *, const char *> characters[] =
        {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}};
      for (const auto &[character, entity] : characters)
        text = replace_in_string(text, character, entity);
      return text;
    }
  } // namespace



  std::string
  page(const PageText &text, const Json &study)
  {
    using namespace PageAssets;
    const std::string data =
      study.dump(-1, ' ', false, Json::error_handler_t::replace);
    return fmt::format(fmt::runtime(PageAssets::page),
                       fmt::arg("title", as_html(text.title)),
                       fmt::arg("lead", as_html(text.lead)),
                       fmt::arg("words", as_html(text.words)),
                       fmt::arg("style", style),
                       // nothing in a script element may look like its end
                       fmt::arg("data",
                                replace_in_string(data, "<", "\\u003c")),
                       fmt::arg("library", library),
                       fmt::arg("script", script));
  }



  Json
  mesh_on_page(const dealii::Triangulation<2> &mesh,
               const std::string              &title,
               const std::vector<double>      &errors)
  {
    std::vector<double>       coordinates;
    std::vector<unsigned int> cells, number(mesh.n_vertices());
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      if (mesh.vertex_used(v))
        {
          number[v] = coordinates.size() / 2;
          coordinates.push_back(mesh.get_vertices()[v][0]);
          coordinates.push_back(mesh.get_vertices()[v][1]);
        }
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        cells.push_back(number[cell->vertex_index(v)]);
    Json fields = Json::array();
    if (!errors.empty())
      fields.push_back({{"name", "local error ratio ξ′"},
                        {"isRatio", true},
                        {"values", numbers_on_page(errors)}});
    return {{"title", title},
            {"vertices", numbers_on_page(coordinates)},
            {"cells", cells},
            {"fields", fields}};
  }



  Json
  plate_on_page(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    const double radius = contact.has_patch() ? contact.patch_radius : 0.;
    return {{"patch",
             {{"radius", radius},
              {"isDisc", radius > 0. && !contact.load_has_length()}}},
            {"symmetric", geometry_of(parameters.plate).is_symmetric}};
  }
} // namespace PlateImpact
