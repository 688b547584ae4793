#pragma once

#include <stdexcept>
#include <string>
#include <vector>

/// What an entry of a scene may choose from. A word, its enumerator and what it
/// makes are one row of one table, beside what makes it; words that make
/// nothing are here. What a word means is said where the entry is declared.
namespace PlateImpact
{
  enum class PlateOutline
  {
    rectangle,
    circle,
    file ///< of Gmsh, named in its place
  };

  enum class EdgeSupport
  {
    clamped,
    simply_supported,
    soft_simply_supported,
    free
  };

  /// What holds the middle surface of an edge that holds the deflection.
  enum class InPlaneSupport
  {
    held,
    sliding,
    held_along,
    held_across
  };

  enum class ImpactorShape
  {
    sphere,
    cylinder,
    none
  };

  enum class ForceLaw
  {
    Sun,
    Hertz,
    line
  };

  enum class UnloadingLaw
  {
    elastic,
    Yang_Sun
  };

  enum class LocalResponse
  {
    layer,
    half_space
  };

  enum class LoadShape
  {
    point,
    Hertz_disc,
    uniform_disc,
    line,
    strip
  };

  enum class ForceIntegration
  {
    energy_conserving,
    collocation
  };

  enum class ElementType
  {
    serendipity,
    serendipity_full,
    heterosis,
    Lagrange,
    MITC9
  };

  /// Of the deflection. `of_waves` gives bending waves in any direction nearly
  /// their frequency, which the stiffness of a mesh makes too large.
  enum class PlateMass
  {
    consistent,
    of_waves
  };

  enum class SolverType
  {
    CHOLMOD,
    KLU
  };

  enum class IntegratorType
  {
    Newmark,
    Ritz_vectors
  };

  enum class AdaptationStrategy
  {
    none,
    hanging_nodes,
    remeshing,
    fixed_fraction,
    fixed_number,
    uniform,
    graded
  };

  enum class AdaptationGoal
  {
    energy_norm,
    peak_force
  };

  /// A strategy of a comparison, with what its meshes are made for.
  struct ComparedStrategy
  {
    AdaptationStrategy strategy;
    AdaptationGoal     goal;
    bool               is_outside = false; ///< a command marks the cells

    bool
    operator==(const ComparedStrategy &other) const
    {
      return strategy == other.strategy && goal == other.goal &&
        is_outside == other.is_outside;
    }
  };

  enum class ErrorIndicator
  {
    SPR,
    Kelly
  };


  /// A choice and its word, as a user types and reads it.
  template <typename Choice>
  struct Word
  {
    Choice      choice;
    std::string word;
  };

  /// The words of a kind that more than one file needs, in the order in which a
  /// user reads them.
  template <typename Choice>
  struct Choices
  {
    static const std::vector<Word<Choice>> words;
  };

  template <>
  const std::vector<Word<EdgeSupport>> Choices<EdgeSupport>::words;
  template <>
  const std::vector<Word<InPlaneSupport>> Choices<InPlaneSupport>::words;
  template <>
  inline const std::vector<Word<ImpactorShape>> Choices<ImpactorShape>::words =
    {{ImpactorShape::sphere, "sphere"},
     {ImpactorShape::cylinder, "cylinder"},
     {ImpactorShape::none, "none"}};
  template <>
  const std::vector<Word<ForceLaw>> Choices<ForceLaw>::words;
  template <>
  inline const std::vector<Word<LocalResponse>> Choices<LocalResponse>::words =
    {{LocalResponse::layer, "layer"},
     {LocalResponse::half_space, "half-space"}};
  template <>
  inline const std::vector<Word<LoadShape>> Choices<LoadShape>::words = {
    {LoadShape::point, "point"},
    {LoadShape::Hertz_disc, "Hertz disc"},
    {LoadShape::uniform_disc, "uniform disc"},
    {LoadShape::line, "line"},
    {LoadShape::strip, "strip"}};
  template <>
  const std::vector<Word<ElementType>> Choices<ElementType>::words;
  template <>
  const std::vector<Word<ErrorIndicator>> Choices<ErrorIndicator>::words;
  template <>
  const std::vector<Word<ComparedStrategy>> Choices<ComparedStrategy>::words;

  /// The row of a choice in a table of its kind.
  template <typename Row>
  const Row &
  row_of(const decltype(Row::choice) choice, const std::vector<Row> &rows)
  {
    for (const Row &row : rows)
      if (row.choice == choice)
        return row;
    throw std::logic_error("a choice without a row");
  }

  template <typename Choice>
  const std::string &
  word_for(const Choice choice)
  {
    return row_of(choice, Choices<Choice>::words).word;
  }

  template <typename Row>
  auto
  words_of(const std::vector<Row> &rows)
  {
    std::vector<Word<decltype(Row::choice)>> words;
    for (const Row &row : rows)
      words.push_back({row.choice, row.word});
    return words;
  }
} // namespace PlateImpact
