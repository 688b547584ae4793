#ifndef plate_impact_page_page_h
#define plate_impact_page_page_h

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// How a series of a plot is drawn.
  enum class Style
  {
    line,
    faint, ///< thin, for what comes before; hides and shows with the series of
           ///< the same colour
    dashed,
    points,
    line_and_points
  };

  struct Series
  {
    std::string         name;
    std::vector<double> x, y; ///< y alone in a bar plot; not finite: a gap
    unsigned int        colour = 0;
    Style               style  = Style::line;

    std::string marker = {}; ///< those of one name have points of one shape
    std::vector<std::vector<double>> more_x = {}; ///< over those of Plot
  };

  /// What an axis or a scale of colours shows at least; not finite: its values.
  struct Range
  {
    double lowest  = std::numeric_limits<double>::quiet_NaN(),
           highest = std::numeric_limits<double>::quiet_NaN();
  };

  struct Axis
  {
    std::string title; ///< with its unit in brackets
    bool        logarithmic = false;
    Range       range       = {};
    Range       limits      = {}; ///< beyond which it shows nothing
  };

  struct Plot
  {
    std::string         title, caption;
    Axis                x, y;
    std::vector<Series> series;

    /// When given: stacked horizontal bars, one for each category.
    std::vector<std::string> categories;

    std::vector<Axis> more_x = {}; ///< that a reader may choose in place of x
  };

  /// Of plots beside each other.
  enum class PlotSize
  {
    small, ///< for many
    medium,
    large
  };

  struct Table
  {
    std::vector<std::string>              columns; ///< with units
    std::vector<std::vector<std::string>> rows;    ///< the first cell is a name
    bool                                  has_words = false; ///< not numbers
    bool is_sortable = false; ///< by a click on a column
  };

  /// A number that a reader looks for first.
  struct Fact
  {
    std::string name, value, note;
  };

  /// Values of the cells of a mesh.
  struct CellField
  {
    std::string         name;             ///< with its unit
    bool                is_ratio = false; ///< to a limit of 1: scale 0.1 to 10
    std::vector<double> values;
  };

  struct MeshPicture
  {
    std::string            title;
    unsigned int           n_cells;
    std::string            svg;    ///< as mesh_picture() makes it
    std::vector<CellField> fields; ///< the first is what the picture shows
  };

  /// Values over a rectangular grid, as coloured fields with a scale.
  struct ColourMap
  {
    std::string         title, value_title; ///< the latter with its unit
    Axis                x, y;
    std::vector<double> x_values, y_values;
    std::vector<double> values; ///< row by row, x fastest; not finite: empty
    Range               range  = {}; ///< of the scale
    std::vector<double> marked = {}; ///< places among the values to look at
  };


  // clang-format off
  /// A self-contained HTML page of text, tables, plots and pictures: report.html
  /// and whatever else shows results in a browser.
  /// @code
  /// Page page("scene.prm", "Error of three strategies");
  /// page.section("Convergence");
  /// page.plots({{"Error of the force", "",
  ///              {"time [s]", true}, {"error [%]", true},
  ///              {{"uniform", seconds, errors, 0, Style::line_and_points}}, {}}});
  /// page.table({{"Strategy", "Error [%]"}, {{"uniform", number(error)}}});
  /// page.write(out);
  /// @endcode
  /// Text and tables are plain HTML and need no script. The numbers behind the
  /// plots are one JSON block, the element `data`: `plots`, whose series name their
  /// numbers by index into `arrays` (six digits; a vector used twice is stored
  /// once), `maps`, `meshes`, and whatever is embed()ded. Chart.js, which draws
  /// them, style and scripts (source/page/) are within the file: it needs no
  /// network. Strings are UTF-8 text, not HTML: they are escaped here.
  // clang-format on
  class Page
  {
  public:
    Page(const std::string &title, const std::string &lead);

    /// Begins a section and adds it to the table of contents.
    void
    section(const std::string &title);

    void
    heading(const std::string &title);

    void
    paragraph(const std::string &text);

    /// A paragraph that stands out: a warning.
    void
    notice(const std::string &text);

    /// What a reader must know first, in a colour and with a sign of its own.
    /// @param trust    `good`, `doubtful` or `none`
    /// @param reasons  why not good
    void
    verdict(const std::string              &trust,
            const std::string              &text,
            const std::vector<std::string> &reasons);

    void
    facts(const std::vector<Fact> &facts);

    void
    table(const Table &table);

    /// Plots beside each other where there is room. Those whose series have
    /// markers share one legend, by colours and by shapes, and the choice of x.
    void
    plots(const std::vector<Plot> &plots, PlotSize size = PlotSize::medium);

    /// Maps beside each other where there is room; `small` ones for many.
    void
    colour_maps(const std::vector<ColourMap> &maps, bool small = false);

    /// Meshes beside each other where there is room, to be coloured by any of
    /// their fields, on one scale for all.
    void
    meshes(const std::vector<MeshPicture> &meshes);

    /// A player for deflection_film().
    void
    film(const nlohmann::ordered_json &film);

    /// Text as it stands, such as a scene.
    void
    preformatted(const std::string &text);

    /// Adds a value to the JSON block.
    void
    embed(const std::string &name, const nlohmann::ordered_json &value);

    void
    write(std::ostream &out) const;

  private:
    unsigned int
    array(const std::vector<double> &values);

    const std::string                title, lead;
    std::string                      contents, content;
    bool                             is_in_section = false;
    unsigned int                     n_sections    = 0;
    nlohmann::ordered_json           plot_data, map_data, mesh_data, embedded;
    std::vector<std::vector<double>> arrays;
  };

  /// Text with the characters that mean something to HTML escaped.
  std::string
  escaped(const std::string &text);
} // namespace PlateImpact

#endif
