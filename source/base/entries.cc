#include "plate_impact/base/entries.h"

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

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
