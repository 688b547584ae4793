#include "plate_impact/page/mesh_picture.h"

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


    /// Size of a mesh that begins at the origin. [m]
    Point<2>
    extent(const Triangulation<2> &mesh)
    {
      Point<2> far;
      for (const auto &vertex : mesh.get_vertices())
        for (unsigned int d = 0; d < 2; ++d)
          far[d] = std::max(far[d], vertex[d]);
      return far;
    }



    /// The cells, coloured by xi' where it is known, y upwards.
    /// @param scale      from metres
    /// @param left, bottom  where the origin of the mesh is
    void
    write_cells(std::ostream              &out,
                const Triangulation<2>    &mesh,
                const std::vector<double> &errors,
                const double               scale,
                const double               left,
                const double               bottom)
    {
      const unsigned int around[] = {0, 1, 3, 2};
      out << "<g class=\"mesh\" stroke=\"#444\" stroke-width=\"0.6\">\n"
          << std::fixed << std::setprecision(2);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          out << "<polygon points=\"";
          for (const unsigned int v : around)
            out << (v == 0 ? "" : " ") << left + scale * cell->vertex(v)[0]
                << ',' << bottom - scale * cell->vertex(v)[1];
          const std::string fill =
            errors.empty() ? "none" : colour(errors[cell->active_cell_index()]);
          out << "\" fill=\"" << fill << "\"/>\n";
        }
      out << "</g>\n" << std::defaultfloat << std::setprecision(8);
    }
  } // namespace



  void
  write_mesh_svg(std::ostream              &out,
                 const Triangulation<2>    &mesh,
                 const std::string         &caption,
                 const std::vector<double> &errors)
  {
    const Point<2> far  = extent(mesh);
    const double   size = 600., margin = 20., header = 34.;
    const double   scale = size / std::max(far[0], far[1]);
    const double   width = far[0] * scale, height = far[1] * scale;
    const double   total_width =
      std::max(2 * margin + width + (errors.empty() ? 0. : 150.), 420.);
    const double total_height =
      header + 2 * margin + std::max(height, errors.empty() ? 0. : 330.);

    out << std::setprecision(8)
        << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 "
        << total_width << ' ' << total_height << "\" width=\"" << total_width
        << "\" height=\"" << total_height
        << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << "<text x=\"" << margin << "\" y=\"" << header - 8 << "\">" << caption
        << "</text>\n";
    write_cells(out, mesh, errors, scale, margin, header + margin + height);
    if (!errors.empty())
      write_scale(out, 2 * margin + width, header + margin + 24.);
    out << "</svg>\n";
  }



  std::string
  mesh_picture(const Triangulation<2>    &mesh,
               const std::string         &label,
               const std::vector<double> &errors)
  {
    const Point<2>     far   = extent(mesh);
    const double       scale = 400. / std::max(far[0], far[1]);
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-1 -1 "
        << scale * far[0] + 2. << ' ' << scale * far[1] + 2.
        << "\" role=\"img\" aria-label=\"" << label << "\">\n";
    write_cells(out, mesh, errors, scale, 0., scale * far[1]);
    out << "</svg>";
    return out.str();
  }
} // namespace PlateImpact
