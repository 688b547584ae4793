#ifndef plate_impact_scene_allowed_h
#define plate_impact_scene_allowed_h

#include <deal.II/base/patterns.h>

#include "plate_impact/base/parameters.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace PlateImpact
{
  /// What an entry may hold: a test and the words for it that a user reads.
  class Allowed : public dealii::Patterns::PatternBase
  {
  public:
    Allowed(const std::string                              &words,
            const std::function<bool(const std::string &)> &test);

    bool
    match(const std::string &value) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

    static Allowed
    any_number();
    static Allowed
    number_above(double bound);
    static Allowed
    number_from(double first);
    static Allowed
    number_up_to(double lower, double upper); ///< the lower excluded
    static Allowed
    number_between(double lower, double upper); ///< both excluded
    static Allowed
    whole_number(unsigned int first, unsigned int last);
    static Allowed
    one_of(const std::vector<std::string> &words);
    /// A word of choices.cc.
    template <typename Choice>
    static Allowed
    word_for()
    {
      return one_of(words_for<Choice>());
    }

    /// Of a plate: a word, or the name of a file.
    static Allowed
    outline();

    /// Angles of plies, symmetric with an s at the end; or nothing.
    static Allowed
    layup();

    /// One or two words, or pairs of an edge of a file and a word.
    static Allowed
    supports();

    static Allowed
    truth();
    static Allowed
    anything(const std::string &words);

    /// Between `first` and `last` values of one kind, separated by commas.
    static Allowed
    list(const Allowed &item, unsigned int first, unsigned int last);

  private:
    std::string                              words;
    std::function<bool(const std::string &)> test;
  };


  /// A value that matches its pattern, as the type of its variable.
  void
  convert(const std::string &text, double &value);
  void
  convert(const std::string &text, unsigned int &value);
  void
  convert(const std::string &text, bool &value);
  void
  convert(const std::string &text, std::string &value);
  void
  convert(const std::string &text, std::vector<std::string> &words);

  void
  convert(const std::string &text, Outline &outline);
  void
  convert(const std::string &text, Layup &layup);
  void
  convert(const std::string &text, std::vector<EdgeSupports> &supports);

  template <typename Choice>
  std::enable_if_t<std::is_enum_v<Choice>>
  convert(const std::string &text, Choice &value)
  {
    value = choice_of<Choice>(text);
  }

  template <typename Choice>
  void
  convert(const std::string &text, std::vector<Choice> &values)
  {
    std::vector<std::string> words;
    convert(text, words);
    values.clear();
    for (const std::string &word : words)
      values.push_back(choice_of<Choice>(word));
  }

  void
  convert(const std::string &text, std::array<double, 2> &value);
  void
  convert(const std::string &text, std::array<unsigned int, 2> &value);
} // namespace PlateImpact

#endif
