#include "plate_impact/base/entries.h"

#include <deal.II/base/parameter_handler.h>

#include "plate_impact/base/text.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// The whole text as a finite number; no other word than a number matches.
    template <typename T>
    bool
    to_number(const std::string &text, T &value)
    {
      const char *begin = text.data(), *end = begin + text.size();
      if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        ++begin;
      const auto [last, error] = std::from_chars(begin, end, value);
      return error == std::errc() && last == end &&
        std::isfinite(static_cast<double>(value));
    }



    Allowed<double>
    number_of(const std::string                 &range,
              const std::function<bool(double)> &is_in_range)
    {
      return {"a number" + range, [=](const std::string &text, double &value) {
                return to_number(text, value) && is_in_range(value);
              }};
    }
  } // namespace



  Allowed<double>
  any_number()
  {
    return number_of("", [](double) { return true; });
  }



  Allowed<double>
  number_above(const double bound)
  {
    return number_of(" above " + shortest(bound),
                     [=](const double x) { return x > bound; });
  }



  Allowed<double>
  number_from(const double first)
  {
    return number_of(" not below " + shortest(first),
                     [=](const double x) { return x >= first; });
  }



  Allowed<double>
  number_up_to(const double lower, const double upper)
  {
    return number_of(fmt::format(" above {} and up to {}", lower, upper),
                     [=](const double x) { return x > lower && x <= upper; });
  }



  Allowed<double>
  number_between(const double lower, const double upper)
  {
    return number_of(fmt::format(" above {} and below {}", lower, upper),
                     [=](const double x) { return x > lower && x < upper; });
  }



  Allowed<unsigned int>
  whole_number(const unsigned int first, const unsigned int last)
  {
    return {fmt::format("a whole number from {} to {}", first, last),
            [=](const std::string &text, unsigned int &value) {
              return to_number(text, value) && value >= first && value <= last;
            }};
  }



  Allowed<bool>
  truth()
  {
    return {"true | false", [](const std::string &text, bool &value) {
              value = text == "true";
              return value || text == "false";
            }};
  }



  Allowed<bool>
  second_of(const std::string &first, const std::string &second)
  {
    return {first + " | " + second, [=](const std::string &text, bool &value) {
              value = text == second;
              return value || text == first;
            }};
  }



  Allowed<std::string>
  any_text(const std::string &words)
  {
    return {words, [](const std::string &text, std::string &value) {
              value = text;
              return true;
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
  Entry::unit() const
  {
    const std::size_t begin = meaning.rfind('[') + 1;
    return !meaning.empty() && meaning.back() == ']' ?
      meaning.substr(begin, meaning.size() - begin - 1) :
      "";
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
