#include "plate_impact/page/page.h"

#include "page/page_assets.h"

#include <cmath>
#include <map>
#include <ostream>
#include <string_view>

namespace PlateImpact
{
  namespace
  {
    /// Text with characters replaced by what stands for them.
    std::string
    replaced(const std::string                  &text,
             const std::map<char, const char *> &replacements)
    {
      std::string result;
      for (const char c : text)
        if (const auto found = replacements.find(c);
            found != replacements.end())
          result += found->second;
        else
          result += c;
      return result;
    }



    std::string
    as_html(const std::string &text)
    {
      return replaced(
        text,
        {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
    }
  } // namespace



  void
  write_page(std::ostream &out, const PageText &text, const Json &study)
  {
    using namespace PageAssets;
    std::string script;
    for (const std::string_view part : {page_js,
                                        plots_js,
                                        zoom_js,
                                        maps_js,
                                        film_js,
                                        run_js,
                                        comparison_js,
                                        sweep_js})
      script += part;
    const std::map<std::string_view, std::string> values = {
      {"TITLE", as_html(text.title)},
      {"LEAD", as_html(text.lead)},
      {"WORDS", as_html(text.words)},
      {"STYLE", std::string(style)},
      // nothing within a script element may look like its end
      {"DATA",
       replaced(study.dump(-1, ' ', false, Json::error_handler_t::replace),
                {{'<', "\\u003c"}})},
      {"LIBRARY", std::string(chart_js)},
      {"SCRIPT", script}};
    std::string_view rest = page;
    for (std::size_t begin; (begin = rest.find('%')) != rest.npos;)
      {
        const std::size_t end = rest.find('%', begin + 1);
        out << rest.substr(0, begin)
            << values.at(rest.substr(begin + 1, end - begin - 1));
        rest.remove_prefix(end + 1);
      }
    out << rest;
  }



  Json
  numbers_on_page(const std::vector<double> &values)
  {
    Json numbers = Json::array();
    for (const double value : values)
      if (value == 0. || !std::isfinite(value))
        numbers.push_back(value);
      else
        {
          // of two exact numbers, so that the text has six digits as well
          const double exponent = 5. - std::floor(std::log10(std::abs(value)));
          const double power    = std::pow(10., std::abs(exponent));
          numbers.push_back(exponent < 0. ? std::round(value / power) * power :
                                            std::round(value * power) / power);
        }
    return numbers;
  }
} // namespace PlateImpact
