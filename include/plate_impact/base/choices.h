#ifndef plate_impact_base_choices_h
#define plate_impact_base_choices_h

#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// What an entry of a scene may choose from. The words for it are in one table,
/// choices.cc; what they mean is documented where the entry is declared.
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

    bool
    operator==(const ComparedStrategy &other) const
    {
      return strategy == other.strategy && goal == other.goal;
    }

    bool
    operator<(const ComparedStrategy &other) const
    {
      return std::tie(strategy, goal) < std::tie(other.strategy, other.goal);
    }
  };

  enum class ErrorIndicator
  {
    SPR,
    Kelly
  };

  enum class RecoveryPatches
  {
    mirrored,
    interior
  };

  enum class SweepCombination
  {
    product,
    zip
  };

  enum class SweepAdaptation
  {
    worst_point,
    each_point
  };


  /// The choices of a kind with their words, in the order in which a user reads
  /// them.
  template <typename Choice>
  const std::vector<std::pair<Choice, std::string>> &
  choices();

  template <>
  const std::vector<std::pair<EdgeSupport, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ImpactorShape, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ForceLaw, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<LocalResponse, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<LoadShape, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ForceIntegration, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ElementType, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<SolverType, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<IntegratorType, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<AdaptationStrategy, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<AdaptationGoal, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ComparedStrategy, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<ErrorIndicator, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<SweepCombination, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<SweepAdaptation, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<PlateOutline, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<RecoveryPatches, std::string>> &
  choices();
  template <>
  const std::vector<std::pair<UnloadingLaw, std::string>> &
  choices();

  /// The word for a choice.
  template <typename Choice>
  const std::string &
  word_for(const Choice choice)
  {
    for (const auto &[value, word] : choices<Choice>())
      if (value == choice)
        return word;
    throw std::logic_error("a choice without a word");
  }

  /// What a word chooses.
  /// @throws std::logic_error for one that is not in words_for()
  template <typename Choice>
  Choice
  choice_of(const std::string &word)
  {
    for (const auto &[value, its_word] : choices<Choice>())
      if (its_word == word)
        return value;
    throw std::logic_error("no choice '" + word + "'");
  }

  /// All words of a kind.
  template <typename Choice>
  std::vector<std::string>
  words_for()
  {
    std::vector<std::string> words;
    for (const auto &[value, word] : choices<Choice>())
      words.push_back(word);
    return words;
  }
} // namespace PlateImpact

#endif
