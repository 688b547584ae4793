#pragma once

#include <deal.II/base/exceptions.h>

#include "plate_impact/base/choices.h"
#include "plate_impact/base/text.h"

#include <array>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The entries of a scene, declared by what they configure: what deal.II's
/// ParameterHandler knows of an entry, and where it was set and what a user
/// reads when its value is not allowed.
namespace PlateImpact
{
  /// What an entry may hold.
  template <typename T>
  struct Allowed
  {
    std::string words; ///< that a user reads
    /// Makes the value of a text, unless the text is not allowed: false.
    std::function<bool(const std::string &text, T &value)> read;
  };


  /// Finite numbers that fulfil a condition, which the words tell.
  inline Allowed<double>
  number_of(const std::string &words, const std::function<bool(double)> &is_met)
  {
    return {"a number" + words, [=](const std::string &text, double &value) {
              return to_number(text, value) && is_met(value);
            }};
  }

  inline Allowed<double>
  any_number()
  {
    return number_of("", [](double) { return true; });
  }

  inline Allowed<double>
  number_above(const double bound)
  {
    return number_of(" above " + shortest(bound),
                     [=](const double x) { return x > bound; });
  }

  inline Allowed<double>
  number_from(const double first)
  {
    return number_of(" not below " + shortest(first),
                     [=](const double x) { return x >= first; });
  }

  inline Allowed<double>
  number_up_to(const double lower, const double upper)
  {
    return number_of(fmt::format(" above {} and up to {}", lower, upper),
                     [=](const double x) { return x > lower && x <= upper; });
  }

  inline Allowed<double>
  number_between(const double lower, const double upper)
  {
    return number_of(fmt::format(" above {} and below {}", lower, upper),
                     [=](const double x) { return x > lower && x < upper; });
  }

  inline Allowed<unsigned int>
  whole_number(const unsigned int first, const unsigned int last)
  {
    return {fmt::format("a whole number from {} to {}", first, last),
            [=](const std::string &text, unsigned int &value) {
              return to_number(text, value) && value >= first && value <= last;
            }};
  }

  inline Allowed<std::string>
  any_text(const std::string &words, const bool may_be_empty = true)
  {
    return {words, [=](const std::string &text, std::string &value) {
              value = text;
              return may_be_empty || !text.empty();
            }};
  }


  /// A word of a table with rows that begin with choice and word.
  template <typename Row>
  auto
  one_of(const std::vector<Row> &rows)
  {
    using Choice = decltype(Row::choice);
    std::string words;
    for (const Row &row : rows)
      words += (words.empty() ? "" : " | ") + row.word;
    return Allowed<Choice>{words,
                           [rows](const std::string &text, Choice &choice) {
                             for (const Row &row : rows)
                               if (row.word == text)
                                 {
                                   choice = row.choice;
                                   return true;
                                 }
                             return false;
                           }};
  }

  template <typename Choice>
  Allowed<Choice>
  one_of()
  {
    return one_of(Choices<Choice>::words);
  }

  /// Whether it is the second of two words.
  inline Allowed<bool>
  second_of(const std::string &first, const std::string &second)
  {
    return one_of<Word<bool>>({{false, first}, {true, second}});
  }

  inline Allowed<bool>
  truth()
  {
    return one_of<Word<bool>>({{true, "true"}, {false, "false"}});
  }

  /// The items between separators, without blanks at their ends; an empty one
  /// after a separator at the end.
  std::vector<std::string>
  split_list(const std::string &text, char separator = ',');

  /// Values of one kind, separated by commas.
  template <typename T>
  Allowed<std::vector<T>>
  list(const Allowed<T> &item, const std::size_t first, const std::size_t last)
  {
    return {(first == last ? fmt::format("{}", first) :
                             fmt::format("{} to {}", first, last)) +
              " values separated by commas, each: " + item.words,
            [=](const std::string &text, std::vector<T> &values) {
              values.clear();
              for (const std::string &one : split_list(text))
                if (!item.read(one, values.emplace_back()))
                  return false;
              return values.size() >= first && values.size() <= last;
            }};
  }

  template <typename T>
  Allowed<std::array<T, 2>>
  pair_of(const Allowed<T> &item)
  {
    const Allowed<std::vector<T>> two = list(item, 2, 2);
    return {two.words,
            [two](const std::string &text, std::array<T, 2> &values) {
              std::vector<T> items;
              if (!two.read(text, items))
                return false;
              values = {{items[0], items[1]}};
              return true;
            }};
  }


  /// An entry, bound to a variable.
  struct Entry
  {
    std::string path; ///< Section/Entry
    std::string default_value;
    std::string allowed; ///< in words
    /// Whether a text is allowed; where it is and `sets`, sets the variable.
    std::function<bool(const std::string &text, bool sets)> read;
    std::string                                             value;

    std::string meaning  = "";        ///< ends with the unit in brackets
    std::string origin   = "default"; ///< or where it was set: "scene.prm:12"
    bool        is_known = true; ///< false of what was refused, and while swept
    /// by the program, in place of the value; the variable stays
    std::optional<std::string> chosen = {};

    void
    means(const std::string &text)
    {
      meaning = text;
    }

    /// @return whether the value is allowed; if not, the entry keeps its own
    bool
    set(const std::string &new_value, const std::string &new_origin)
    {
      is_known = read(new_value, /*sets=*/true);
      if (is_known)
        {
          value  = new_value;
          origin = new_origin;
        }
      return is_known;
    }

    /// The value in words.
    const std::string &
    text() const
    {
      return chosen ? *chosen : value;
    }

    std::string
    section() const
    {
      return path.substr(0, path.find('/'));
    }

    std::string
    name() const
    {
      return path.substr(path.find('/') + 1);
    }

    /// Empty without one.
    std::string
    unit() const
    {
      const std::size_t begin = meaning.rfind('[') + 1;
      return !meaning.empty() && meaning.back() == ']' ?
        meaning.substr(begin, meaning.size() - begin - 1) :
        "";
    }
  };


  struct Entries
  {
    /// What declares the entries of a section, one a call: sets the variable to
    /// the default. To be followed by what the entry means.
    auto
    section(const std::string &section)
    {
      return [this, section](const std::string &name,
                             const std::string &default_value,
                             const auto        &allowed,
                             auto              &variable) -> Entry & {
        const auto read = [read = allowed.read,
                           &variable](const std::string &text,
                                      const bool         sets) {
          std::decay_t<decltype(variable)> value{};
          const bool                       is_allowed = read(text, value);
          if (is_allowed && sets)
            variable = value;
          return is_allowed;
        };
        AssertThrow(read(default_value, /*sets=*/true),
                    dealii::ExcMessage(name + " cannot have its default"));
        return all.emplace_back(Entry{section + '/' + name,
                                      default_value,
                                      allowed.words,
                                      read,
                                      default_value});
      };
    }

    /// Null for a path without an entry.
    Entry *
    find(const std::string &path)
    {
      for (Entry &entry : all)
        if (entry.path == path)
          return &entry;
      return nullptr;
    }

    Entry &
    at(const std::string &path)
    {
      Entry *const entry = find(path);
      AssertThrow(entry != nullptr, dealii::ExcMessage("no entry " + path));
      return *entry;
    }

    /// All, as a scene in deal.II's format.
    std::string
    text(bool with_meanings) const;

    std::vector<Entry> all; ///< in the order of declaration
  };
} // namespace PlateImpact
