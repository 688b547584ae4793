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


    /// The rectangle around a mesh. [m]
    struct Extent
    {
      explicit Extent(const Triangulation<2> &mesh)
      {
        const auto box = GridTools::compute_bounding_box(mesh);
        begin          = box.get_boundary_points().first;
        size           = Point<2>(box.get_boundary_points().second - begin);
      }

      double
      longest() const
      {
        return std::max(size[0], size[1]);
      }

      Point<2> begin, size;
    };



    /// The cells, coloured by xi' where it is known, y upwards.
    /// @param scale      from metres
    /// @param begin      lower left corner of the mesh [m]
    /// @param left, bottom  where it is
    void
    write_cells(std::ostream              &out,
                const Triangulation<2>    &mesh,
                const std::vector<double> &errors,
                const double               scale,
                const Point<2>            &begin,
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
            out << (v == 0 ? "" : " ")
                << left + scale * (cell->vertex(v)[0] - begin[0]) << ','
                << bottom - scale * (cell->vertex(v)[1] - begin[1]);
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
    const Extent extent(mesh);
    const double size = 600., margin = 20., header = 34.;
    const double scale  = size / extent.longest();
    const double width  = extent.size[0] * scale,
                 height = extent.size[1] * scale;
    const double total_width =
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
    write_cells(out,
                mesh,
                errors,
                scale,
                extent.begin,
                margin,
                header + margin + height);
    if (!errors.empty())
      write_scale(out, 2 * margin + width, header + margin + 24.);
    out << "</svg>\n";
  }



  std::string
  mesh_picture(const Triangulation<2>    &mesh,
               const Parameters          &parameters,
               const std::string         &label,
               const std::vector<double> &errors)
  {
    const Extent             extent(mesh);
    const double             scale   = 400. / extent.longest();
    const ContactParameters &contact = parameters.contact;
    // the impact is the origin
    const double x = -scale * extent.begin[0],
                 y = scale * (extent.size[1] + extent.begin[1]),
                 r = contact.has_patch() ? scale * contact.patch_radius : 0.;
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-1 -1 "
        << scale * extent.size[0] + 2. << ' ' << scale * extent.size[1] + 2.
        << "\" role=\"img\" aria-label=\"" << label << "\" data-unit=\""
        << scale << "\" data-x=\"" << x << "\" data-y=\"" << y << "\" data-r=\""
        << r << "\">\n";
    write_cells(out,
                mesh,
                errors,
                scale,
                extent.begin,
                0.,
                scale * extent.size[1]);
    if (r > 0. && !contact.load_has_length())
      out << "<circle class=\"patch\" cx=\"" << x << "\" cy=\"" << y
          << "\" r=\"" << r << "\"/>\n";
    out << "</svg>";
    return out.str();
  }



  std::string
  meshed_part_in_words(const PlateParameters &plate)
  {
    const bool left  = geometry_of(plate)->is_symmetric(0),
               lower = geometry_of(plate)->is_symmetric(1);
    if (left && lower)
      return "A quarter of the plate; the impact is at the lower left corner.";
    if (left || lower)
      return std::string("Half of the plate; the impact is on the ") +
        (left ? "left" : "lower") + " side.";
    return "The whole plate.";
  }
} // namespace PlateImpact
