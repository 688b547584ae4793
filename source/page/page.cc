#include "plate_impact/page/page.h"

#include "page/page_assets.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>
#include <string_view>

namespace PlateImpact
{
  namespace
  {
    using Json = nlohmann::ordered_json;



    std::string
    name_of(const Style style)
    {
      const std::map<Style, std::string> names = {{Style::line, "line"},
                                                  {Style::faint, "faint"},
                                                  {Style::dashed, "dashed"},
                                                  {Style::points, "points"},
                                                  {Style::line_and_points,
                                                   "line and points"}};
      return names.at(style);
    }



    void
    append_number(std::string &text, const double value)
    {
      if (!std::isfinite(value))
        {
          text += "null";
          return;
        }
      char       digits[32];
      const auto end = std::to_chars(std::begin(digits),
                                     std::end(digits),
                                     value,
                                     std::chars_format::general,
                                     6)
                         .ptr;
      text.append(digits, end);
    }



    /// JSON within a script element: nothing may look like its end.
    std::string
    script_text(const Json &value)
    {
      std::string text;
      for (const char c :
           value.dump(-1, ' ', false, Json::error_handler_t::replace))
        if (c == '<')
          text += "\\u003c";
        else
          text += c;
      return text;
    }



    /// Writes a template with its places, %NAME%, filled.
    void
    write_filled(std::ostream                                  &out,
                 std::string_view                               text,
                 const std::map<std::string_view, std::string> &values)
    {
      while (!text.empty())
        {
          const std::size_t begin = text.find('%');
          out << text.substr(0, begin);
          if (begin == text.npos)
            return;
          const std::size_t end = text.find('%', begin + 1);
          out << values.at(text.substr(begin + 1, end - begin - 1));
          text.remove_prefix(end + 1);
        }
    }



    /// Two numbers, or nothing.
    Json
    to_json(const Range &range)
    {
      if (!std::isfinite(range.lowest) || !std::isfinite(range.highest))
        return nullptr;
      return {range.lowest, range.highest};
    }



    Json
    to_json(const Axis &axis)
    {
      return {{"title", axis.title},
              {"logarithmic", axis.logarithmic},
              {"range", to_json(axis.range)},
              {"limits", to_json(axis.limits)}};
    }
  } // namespace



  std::string
  escaped(const std::string &text)
  {
    std::string result;
    for (const char c : text)
      if (c == '&')
        result += "&amp;";
      else if (c == '<')
        result += "&lt;";
      else if (c == '>')
        result += "&gt;";
      else if (c == '"')
        result += "&quot;";
      else
        result += c;
    return result;
  }



  Page::Page(const std::string &title, const std::string &lead)
    : title(title)
    , lead(lead)
    , plot_data(Json::array())
    , map_data(Json::array())
    , mesh_data(Json::array())
    , embedded(Json::object())
  {}



  void
  Page::section(const std::string &title)
  {
    const std::string id = "section-" + std::to_string(++n_sections);
    if (is_in_section)
      content += "</section>\n";
    is_in_section = true;
    content += "<section id=\"" + id + "\">\n<h2>" + escaped(title) + "</h2>\n";
    contents += "<li><a href=\"#" + id + "\">" + escaped(title) + "</a></li>\n";
  }



  void
  Page::heading(const std::string &title)
  {
    content += "<h3>" + escaped(title) + "</h3>\n";
  }



  void
  Page::paragraph(const std::string &text)
  {
    content += "<p>" + escaped(text) + "</p>\n";
  }



  void
  Page::notice(const std::string &text)
  {
    content += "<p class=\"notice\" role=\"note\">" + escaped(text) + "</p>\n";
  }



  void
  Page::verdict(const std::string              &trust,
                const std::string              &text,
                const std::vector<std::string> &reasons)
  {
    const std::string sign = trust == "good" ? "✓" :
      trust == "doubtful"                    ? "!" :
                                               "✗";
    content += "<div class=\"verdict " + escaped(trust) +
      "\" role=\"note\"><span class=\"sign\" aria-hidden=\"true\">" + sign +
      "</span><div><strong>" + escaped(text) + "</strong>";
    for (const std::string &reason : reasons)
      content += "<br>" + escaped(reason);
    content += "</div></div>\n";
  }



  void
  Page::facts(const std::vector<Fact> &facts)
  {
    content += "<dl class=\"facts\">\n";
    for (const Fact &fact : facts)
      content += "<div><dt>" + escaped(fact.name) +
        "</dt><dd><span class=\"value\">" + escaped(fact.value) +
        "</span><div class=\"note\">" + escaped(fact.note) +
        "</div></dd></div>\n";
    content += "</dl>\n";
  }



  void
  Page::table(const Table &table)
  {
    content += std::string("<div class=\"wide\" tabindex=\"0\"><table") +
      (table.has_words     ? " class=\"words\"" :
         table.is_sortable ? " class=\"sortable\"" :
                             "") +
      ">\n<thead><tr>";
    for (const std::string &column : table.columns)
      content += "<th scope=\"col\">" + escaped(column) + "</th>";
    content += "</tr></thead>\n<tbody>\n";
    for (const auto &row : table.rows)
      {
        content += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
          content += i == 0 ? "<th scope=\"row\">" + escaped(row[i]) + "</th>" :
                              "<td>" + escaped(row[i]) + "</td>";
        content += "</tr>\n";
      }
    content += "</tbody></table></div>\n";
  }



  void
  Page::plots(const std::vector<Plot> &plots, const PlotSize size)
  {
    const char *const sizes[] = {" small", "", " large"};
    content += std::string("<div class=\"grid") +
      sizes[static_cast<int>(size)] + (plots.size() == 1 ? " single" : "") +
      "\">\n";
    for (const Plot &plot : plots)
      {
        content += "<figure><h3>" + escaped(plot.title) +
          "</h3><div class=\"plot\" data-plot=\"" +
          std::to_string(plot_data.size()) + "\"></div>";
        if (!plot.caption.empty())
          content += "<figcaption>" + escaped(plot.caption) + "</figcaption>";
        content += "</figure>\n";

        Json series = Json::array();
        for (const Series &s : plot.series)
          {
            series.push_back({{"name", s.name},
                              {"x", array(s.x)},
                              {"y", array(s.y)},
                              {"colour", s.colour},
                              {"style", name_of(s.style)}});
            if (!s.marker.empty())
              series.back()["marker"] = s.marker;
            for (const auto &x : s.more_x)
              series.back()["moreX"].push_back(array(x));
          }
        Json more_x = Json::array();
        for (const Axis &x : plot.more_x)
          more_x.push_back(to_json(x));
        plot_data.push_back({{"title", plot.title},
                             {"x", to_json(plot.x)},
                             {"moreX", more_x},
                             {"y", to_json(plot.y)},
                             {"categories", plot.categories},
                             {"series", series}});
      }
    content += "</div>\n";
  }



  void
  Page::colour_maps(const std::vector<ColourMap> &maps, const bool small)
  {
    content +=
      std::string("<div class=\"grid") + (small ? " small" : "") + "\">\n";
    for (const ColourMap &map : maps)
      {
        content += "<figure><h3>" + escaped(map.title) +
          "</h3><div class=\"map\" data-map=\"" +
          std::to_string(map_data.size()) + "\"></div></figure>\n";
        map_data.push_back({{"title", map.title},
                            {"value", map.value_title},
                            {"x", to_json(map.x)},
                            {"y", to_json(map.y)},
                            {"xValues", array(map.x_values)},
                            {"yValues", array(map.y_values)},
                            {"values", array(map.values)},
                            {"marked", array(map.marked)},
                            {"range", to_json(map.range)}});
      }
    content += "</div>\n";
  }



  void
  Page::meshes(const std::vector<MeshPicture> &meshes)
  {
    Json group = Json::array();
    content += "<div class=\"mesh-group\" data-meshes=\"" +
      std::to_string(mesh_data.size()) + "\"><div class=\"grid meshes\">\n";
    for (const MeshPicture &mesh : meshes)
      {
        content += "<figure>" + mesh.svg + "<figcaption>" +
          escaped(mesh.title) + "</figcaption></figure>\n";
        Json fields = Json::array();
        for (const CellField &field : mesh.fields)
          fields.push_back({{"name", field.name},
                            {"isRatio", field.is_ratio},
                            {"values", array(field.values)}});
        group.push_back({{"title", mesh.title}, {"fields", fields}});
      }
    content += "</div></div>\n";
    mesh_data.push_back(group);
  }



  void
  Page::film(const Json &film)
  {
    content += "<figure class=\"player\" data-film></figure>\n";
    embed("film", film);
  }



  void
  Page::preformatted(const std::string &text)
  {
    content += "<pre tabindex=\"0\">" + escaped(text) + "</pre>\n";
  }



  void
  Page::embed(const std::string &name, const Json &value)
  {
    embedded[name] = value;
  }



  unsigned int
  Page::array(const std::vector<double> &values)
  {
    const auto known = std::find(arrays.begin(), arrays.end(), values);
    if (known != arrays.end())
      return known - arrays.begin();
    arrays.push_back(values);
    return arrays.size() - 1;
  }



  void
  Page::write(std::ostream &out) const
  {
    std::string data = "{\"arrays\":[";
    for (const std::vector<double> &values : arrays)
      {
        data += data.back() == '[' ? "[" : ",\n[";
        for (const double value : values)
          {
            append_number(data, value);
            data += ',';
          }
        if (data.back() == ',')
          data.pop_back();
        data += ']';
      }
    data += "],\n\"plots\":" + script_text(plot_data) +
      ",\n\"maps\":" + script_text(map_data) +
      ",\n\"meshes\":" + script_text(mesh_data);
    for (const auto &[name, value] : embedded.items())
      data += ",\n\"" + name + "\":" + script_text(value);
    data += "}";

    const std::string header = "<h1>" + escaped(title) +
      "</h1>\n<p class=\"lead\">" + escaped(lead) +
      "</p>\n<nav aria-label=\"Contents\"><ul>\n" + contents + "</ul></nav>";
    write_filled(out,
                 PageAssets::page,
                 {{"TITLE", escaped(title)},
                  {"STYLE", std::string(PageAssets::style)},
                  {"HEADER", header},
                  {"CONTENT", content + (is_in_section ? "</section>" : "")},
                  {"DATA", data},
                  {"LIBRARY", std::string(PageAssets::chart_js)},
                  {"SCRIPT",
                   std::string(PageAssets::plots_js)
                     .append(PageAssets::zoom_js)
                     .append(PageAssets::maps_js)
                     .append(PageAssets::film_js)}});
  }
} // namespace PlateImpact
