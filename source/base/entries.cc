#include "plate_impact/base/entries.h"

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  Allowed<double>
  number_of(const std::string &words, const std::function<bool(double)> &is_met)
  {
    return {"a number" + words, [=](const std::string &text, double &value) {
              return to_number(text, value) && is_met(value);
            }};
  }



  Allowed<unsigned int>
  whole_number(const unsigned int first, const unsigned int last)
  {
    return {fmt::format("a whole number from {} to {}", first, last),
            [=](const std::string &text, unsigned int &value) {
              return to_number(text, value) && value >= first && value <= last;
            }};
  }



  std::vector<std::string>
  split_list(const std::string &text, const char separator)
  {
    std::vector<std::string> items =
      Utilities::split_string_list(text, separator);
    if (text.empty() || text.back() == separator)
      items.push_back("");
    return items;
  }



  std::string
  Entries::text(const bool with_meanings) const
  {
    ParameterHandler prm;
    for (const Entry &entry : all)
      {
        prm.enter_subsection(entry.section());
        prm.declare_entry(entry.name(),
                          entry.default_value,
                          Patterns::Anything(),
                          entry.meaning);
        prm.set(entry.name(), entry.text());
        prm.leave_subsection();
      }
    std::ostringstream out;
    prm.print_parameters(out,
                         (with_meanings ? ParameterHandler::PRM :
                                          ParameterHandler::ShortPRM) |
                           ParameterHandler::KeepDeclarationOrder);
    return out.str();
  }
} // namespace PlateImpact
