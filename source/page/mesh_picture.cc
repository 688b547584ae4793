#include "plate_impact/page/mesh_picture.h"

#include <deal.II/grid/grid_tools.h>

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    constexpr double lowest = 0.1, highest = 10.;

    /// Colour of xi' on a logarithmic scale from 0.1 to 10: blue below the
    /// limit of 1, white at it, red above.
    std::string
    colour(const double xi)
    {
      const double s =
        std::log(std::clamp(xi, lowest, highest)) / std::log(highest);
      const std::array<double, 3> blue  = {{33, 102, 172}},
                                  white = {{247, 247, 247}},
                                  red   = {{178, 24, 43}};
      const std::array<double, 3> &end  = s < 0. ? blue : red;
      std::ostringstream           text;
      text << "rgb(";
      for (unsigned int i = 0; i < 3; ++i)
        text << (i > 0 ? "," : "")
             << std::lround(white[i] + std::abs(s) * (end[i] - white[i]));
      text << ")";
      return text.str();
    }



    void
    write_scale(std::ostream &out, const double left, const double top)
    {
      const double       height = 300.;
      const unsigned int n      = 40;
      out << "<text x=\"" << left << "\" y=\"" << top - 12
          << "\">local error ratio xi&#8242;</text>\n";
      for (unsigned int i = 0; i < n; ++i)
        out << "<rect x=\"" << left << "\" y=\"" << top + height * i / n
            << "\" width=\"18\" height=\"" << height / n + 0.5 << "\" fill=\""
            << colour(highest *
                      std::pow(lowest / highest, (i + 0.5) / double(n)))
            << "\"/>\n";
      for (const double tick : {10., 3., 1., 0.3, 0.1})
        out << "<text x=\"" << left + 24 << "\" y=\""
            << top + 4 +
            height * std::log(highest / tick) / std::log(highest / lowest)
            << "\">" << tick << (tick == 1. ? " (limit)" : "") << "</text>\n";
    }
  } // namespace



  void
  write_mesh_svg(std::ostream              &out,
                 const Triangulation<2>    &mesh,
                 const std::string         &caption,
                 const std::vector<double> &errors)
  {
    const auto box =
      GridTools::compute_bounding_box(mesh).get_boundary_points();
    const Tensor<1, 2> extent = box.second - box.first;
    const double       size = 600., margin = 20., header = 34.;
    const double       scale     = size / std::max(extent[0], extent[1]);
    const double       height    = extent[1] * scale;
    const bool         has_scale = !errors.empty();
    const double       total_width =
      std::max(2 * margin + extent[0] * scale + (has_scale ? 150. : 0.), 420.);
    const double total_height =
      header + 2 * margin + std::max(height, has_scale ? 330. : 0.);

    out << std::setprecision(8)
        << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 "
        << total_width << ' ' << total_height << "\" width=\"" << total_width
        << "\" height=\"" << total_height
        << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << "<text x=\"" << margin << "\" y=\"" << header - 8 << "\">" << caption
        << "</text>\n"
        << "<g class=\"mesh\" stroke=\"#444\" stroke-width=\"0.6\">\n"
        << std::fixed << std::setprecision(2);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        out << "<polygon points=\"";
        for (const unsigned int v : {0, 1, 3, 2})
          {
            const Tensor<1, 2> place = cell->vertex(v) - box.first;
            out << (v == 0 ? "" : " ") << margin + scale * place[0] << ','
                << header + margin + height - scale * place[1];
          }
        out << "\" fill=\""
            << (has_scale ? colour(errors[cell->active_cell_index()]) : "none")
            << "\"/>\n";
      }
    out << "</g>\n" << std::defaultfloat << std::setprecision(8);
    if (has_scale)
      write_scale(out, 2 * margin + extent[0] * scale, header + margin + 24.);
    out << "</svg>\n";
  }



  Json
  mesh_on_page(const Triangulation<2>    &mesh,
               const std::string         &title,
               const std::vector<double> &errors)
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
    const PlateParameters   &plate   = parameters.plate;
    const double radius = contact.has_patch() ? contact.patch_radius : 0.;
    return {{"patch",
             {{"radius", radius},
              {"isDisc", radius > 0. && !contact.load_has_length()}}},
            {"symmetric",
             {geometry_of(plate).is_symmetric[0],
              geometry_of(plate).is_symmetric[1]}}};
  }
} // namespace PlateImpact
