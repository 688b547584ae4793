#include "plate_impact/scene/allowed.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

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



    Allowed
    number(const std::string                 &words,
           const std::function<bool(double)> &in_range)
    {
      return {words, [in_range](const std::string &text) {
                double value;
                return to_number(text, value) && in_range(value);
              }};
    }



    template <typename T>
    void
    convert_pair(const std::string &text, std::array<T, 2> &value)
    {
      const std::vector<std::string> items =
        Utilities::split_string_list(text, ',');
      convert(items.at(0), value[0]);
      convert(items.at(1), value[1]);
    }
  } // namespace



  Allowed::Allowed(const std::string                              &words,
                   const std::function<bool(const std::string &)> &test)
    : words(words)
    , test(test)
  {}



  bool
  Allowed::match(const std::string &value) const
  {
    return test(value);
  }



  std::string
  Allowed::description(const OutputStyle) const
  {
    return words;
  }



  std::unique_ptr<Patterns::PatternBase>
  Allowed::clone() const
  {
    return std::make_unique<Allowed>(*this);
  }



  Allowed
  Allowed::any_number()
  {
    return number("a number", [](double) { return true; });
  }



  Allowed
  Allowed::number_above(const double bound)
  {
    return number("a number above " + shortest(bound),
                  [bound](const double x) { return x > bound; });
  }



  Allowed
  Allowed::number_from(const double first)
  {
    return number("a number not below " + shortest(first),
                  [first](const double x) { return x >= first; });
  }



  Allowed
  Allowed::number_between(const double lower, const double upper)
  {
    return number("a number above " + shortest(lower) + " and below " +
                    shortest(upper),
                  [lower, upper](const double x) {
                    return x > lower && x < upper;
                  });
  }



  Allowed
  Allowed::number_up_to(const double lower, const double upper)
  {
    return number("a number above " + shortest(lower) + " and up to " +
                    shortest(upper),
                  [lower, upper](const double x) {
                    return x > lower && x <= upper;
                  });
  }



  Allowed
  Allowed::whole_number(const unsigned int first, const unsigned int last)
  {
    return {"a whole number from " + std::to_string(first) + " to " +
              std::to_string(last),
            [first, last](const std::string &text) {
              unsigned int value;
              return to_number(text, value) && value >= first && value <= last;
            }};
  }



  Allowed
  Allowed::one_of(const std::vector<std::string> &words)
  {
    std::string list;
    for (const std::string &word : words)
      list += (list.empty() ? "" : " | ") + word;
    return {list, [words](const std::string &text) {
              return std::find(words.begin(), words.end(), text) != words.end();
            }};
  }



  namespace
  {
    constexpr unsigned int most_plies = 1000;



    /// "edge: word" taken apart; the edge is empty without a colon.
    std::pair<std::string, std::string>
    edge_and_word(const std::string &item)
    {
      const std::size_t colon = item.rfind(':');
      if (colon == std::string::npos)
        return {"", item};
      return {Utilities::trim(item.substr(0, colon)),
              Utilities::trim(item.substr(colon + 1))};
    }



    /// Angles of "0/90_2/45s", with the bracket that may be around all but
    /// the s; empty where the text is no lay-up.
    std::vector<double>
    read_layup(std::string text)
    {
      if (text.empty())
        return {};
      const bool is_half = text.back() == 's' || text.back() == 'S';
      if (is_half)
        text.pop_back();
      if (text.size() > 1 && text.front() == '[' && text.back() == ']')
        text = text.substr(1, text.size() - 2);
      if (text.empty() || text.front() == '/' || text.back() == '/')
        return {};
      std::vector<double> angles;
      for (const std::string &item : Utilities::split_string_list(text, '/'))
        {
          const std::size_t underscore = item.find('_');
          double            angle;
          unsigned int      n_plies = 1;
          if (!to_number(item.substr(0, underscore), angle) ||
              std::abs(angle) > 180.)
            return {};
          if (underscore != std::string::npos &&
              (!to_number(item.substr(underscore + 1), n_plies) ||
               n_plies == 0 || n_plies > most_plies))
            return {};
          angles.insert(angles.end(), n_plies, angle);
        }
      if (is_half)
        for (std::size_t k = angles.size(); k-- > 0;)
          angles.push_back(angles[k]);
      return angles.size() <= most_plies ? angles : std::vector<double>();
    }



    bool
    names_a_mesh(const std::string &text)
    {
      return std::filesystem::path(text).extension() == ".msh";
    }
  } // namespace



  Allowed
  Allowed::outline()
  {
    const Allowed word = word_for<PlateOutline>();
    return {word.words + " | the name of a mesh of Gmsh, ending in .msh",
            [word](const std::string &text) {
              return word.test(text) || names_a_mesh(text);
            }};
  }



  Allowed
  Allowed::layup()
  {
    return {"angles of up to 1000 plies in degrees between slashes, with an s "
            "for the mirrored half, as 0/90/45/-45s or 0_2/90s, or nothing",
            [](const std::string &text) {
              return text.empty() || !read_layup(text).empty();
            }};
  }



  Allowed
  Allowed::supports()
  {
    const Allowed word  = word_for<EdgeSupport>();
    const Allowed plain = list(word, 1, 2);
    return {plain.words + "; or, for an outline from a file, pairs edge: word",
            [word, plain](const std::string &text) {
              if (text.find(':') == std::string::npos)
                return plain.test(text);
              const auto items = Utilities::split_string_list(text, ',');
              return text.back() != ',' &&
                std::all_of(items.begin(),
                            items.end(),
                            [&word](const std::string &item) {
                              const auto [edge, support] = edge_and_word(item);
                              return !edge.empty() && word.test(support);
                            });
            }};
  }



  Allowed
  Allowed::truth()
  {
    return one_of({"true", "false"});
  }



  Allowed
  Allowed::anything(const std::string &words)
  {
    return {words, [](const std::string &) { return true; }};
  }



  Allowed
  Allowed::list(const Allowed     &item,
                const unsigned int first,
                const unsigned int last)
  {
    const std::string number = first == last ?
      std::to_string(first) :
      std::to_string(first) + " to " + std::to_string(last);
    return {number + " values separated by commas, each: " + item.words,
            [item, first, last](const std::string &text) {
              const std::vector<std::string> items =
                Utilities::split_string_list(text, ',');
              const bool ends_open = !text.empty() && text.back() == ',';
              return !ends_open && items.size() >= first &&
                items.size() <= last &&
                std::all_of(items.begin(), items.end(), item.test);
            }};
  }



  void
  convert(const std::string &text, double &value)
  {
    to_number(text, value);
  }



  void
  convert(const std::string &text, unsigned int &value)
  {
    to_number(text, value);
  }



  void
  convert(const std::string &text, bool &value)
  {
    value = text == "true";
  }



  void
  convert(const std::string &text, std::string &value)
  {
    value = text;
  }



  void
  convert(const std::string &text, std::vector<std::string> &words)
  {
    words = Utilities::split_string_list(text, ',');
  }



  void
  convert(const std::string &text, Outline &outline)
  {
    if (names_a_mesh(text))
      outline = {PlateOutline::file, text};
    else
      outline = {choice_of<PlateOutline>(text), ""};
  }



  void
  convert(const std::string &text, Layup &layup)
  {
    layup = {text, read_layup(text)};
  }



  void
  convert(const std::string &text, std::vector<EdgeSupports> &supports)
  {
    supports.clear();
    for (const std::string &item : Utilities::split_string_list(text, ','))
      {
        const auto [edge, word] = edge_and_word(item);
        supports.push_back({edge, choice_of<EdgeSupport>(word)});
      }
  }



  void
  convert(const std::string &text, std::array<double, 2> &value)
  {
    convert_pair(text, value);
  }



  void
  convert(const std::string &text, std::array<unsigned int, 2> &value)
  {
    convert_pair(text, value);
  }
} // namespace PlateImpact
