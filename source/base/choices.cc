// The words of scene files, each written once.
#include "plate_impact/base/choices.h"

namespace PlateImpact
{
  template <typename Choice>
  using Words = std::vector<std::pair<Choice, std::string>>;



  template <>
  const Words<PlateOutline> &
  choices()
  {
    static const Words<PlateOutline> words = {{PlateOutline::rectangle,
                                               "rectangle"},
                                              {PlateOutline::circle, "circle"}};
    return words;
  }



  template <>
  const Words<EdgeSupport> &
  choices()
  {
    static const Words<EdgeSupport> words = {
      {EdgeSupport::clamped, "clamped"},
      {EdgeSupport::simply_supported, "simply supported"},
      {EdgeSupport::soft_simply_supported, "soft simply supported"},
      {EdgeSupport::free, "free"}};
    return words;
  }



  template <>
  const Words<ImpactorShape> &
  choices()
  {
    static const Words<ImpactorShape> words = {
      {ImpactorShape::sphere, "sphere"},
      {ImpactorShape::cylinder, "cylinder"},
      {ImpactorShape::none, "none"}};
    return words;
  }



  template <>
  const Words<ForceLaw> &
  choices()
  {
    static const Words<ForceLaw> words = {{ForceLaw::Sun, "Sun"},
                                          {ForceLaw::Hertz, "Hertz"},
                                          {ForceLaw::line, "line"}};
    return words;
  }



  template <>
  const Words<UnloadingLaw> &
  choices()
  {
    static const Words<UnloadingLaw> words = {
      {UnloadingLaw::elastic, "elastic"},
      {UnloadingLaw::Yang_Sun, "Yang-Sun"}};
    return words;
  }



  template <>
  const Words<LocalResponse> &
  choices()
  {
    static const Words<LocalResponse> words = {{LocalResponse::layer, "layer"},
                                               {LocalResponse::half_space,
                                                "half-space"}};
    return words;
  }



  template <>
  const Words<LoadShape> &
  choices()
  {
    static const Words<LoadShape> words = {
      {LoadShape::point, "point"},
      {LoadShape::Hertz_disc, "Hertz disc"},
      {LoadShape::uniform_disc, "uniform disc"},
      {LoadShape::line, "line"},
      {LoadShape::strip, "strip"}};
    return words;
  }



  template <>
  const Words<ForceIntegration> &
  choices()
  {
    static const Words<ForceIntegration> words = {
      {ForceIntegration::energy_conserving, "energy conserving"},
      {ForceIntegration::collocation, "collocation"}};
    return words;
  }



  template <>
  const Words<ElementType> &
  choices()
  {
    static const Words<ElementType> words = {
      {ElementType::serendipity, "serendipity"},
      {ElementType::serendipity_full, "serendipity full"},
      {ElementType::heterosis, "heterosis"},
      {ElementType::Lagrange, "Lagrange"},
      {ElementType::MITC9, "MITC9"}};
    return words;
  }



  template <>
  const Words<SolverType> &
  choices()
  {
    static const Words<SolverType> words = {{SolverType::CHOLMOD, "CHOLMOD"},
                                            {SolverType::KLU, "KLU"}};
    return words;
  }



  template <>
  const Words<IntegratorType> &
  choices()
  {
    static const Words<IntegratorType> words = {
      {IntegratorType::Newmark, "Newmark"},
      {IntegratorType::Ritz_vectors, "Ritz vectors"}};
    return words;
  }



  template <>
  const Words<AdaptationStrategy> &
  choices()
  {
    static const Words<AdaptationStrategy> words = {
      {AdaptationStrategy::none, "none"},
      {AdaptationStrategy::hanging_nodes, "hanging nodes"},
      {AdaptationStrategy::remeshing, "remeshing"},
      {AdaptationStrategy::fixed_fraction, "fixed fraction"},
      {AdaptationStrategy::fixed_number, "fixed number"},
      {AdaptationStrategy::uniform, "uniform"},
      {AdaptationStrategy::graded, "graded"}};
    return words;
  }



  template <>
  const Words<AdaptationGoal> &
  choices()
  {
    static const Words<AdaptationGoal> words = {
      {AdaptationGoal::energy_norm, "energy norm"},
      {AdaptationGoal::peak_force, "peak force"}};
    return words;
  }



  template <>
  const Words<ComparedStrategy> &
  choices()
  {
    static const Words<ComparedStrategy> words = [] {
      Words<ComparedStrategy> all;
      for (const auto &[strategy, word] : choices<AdaptationStrategy>())
        if (strategy != AdaptationStrategy::none)
          all.push_back({{strategy, AdaptationGoal::energy_norm}, word});
      for (const AdaptationStrategy strategy :
           {AdaptationStrategy::hanging_nodes,
            AdaptationStrategy::remeshing,
            AdaptationStrategy::fixed_fraction})
        all.push_back({{strategy, AdaptationGoal::peak_force},
                       word_for(strategy) + " by force"});
      return all;
    }();
    return words;
  }



  template <>
  const Words<ErrorIndicator> &
  choices()
  {
    static const Words<ErrorIndicator> words = {{ErrorIndicator::SPR, "SPR"},
                                                {ErrorIndicator::Kelly,
                                                 "Kelly"}};
    return words;
  }



  template <>
  const Words<RecoveryPatches> &
  choices()
  {
    static const Words<RecoveryPatches> words = {
      {RecoveryPatches::mirrored, "mirrored"},
      {RecoveryPatches::interior, "interior"}};
    return words;
  }



  template <>
  const Words<SweepCombination> &
  choices()
  {
    static const Words<SweepCombination> words =
      {{SweepCombination::product, "product"}, {SweepCombination::zip, "zip"}};
    return words;
  }



  template <>
  const Words<SweepAdaptation> &
  choices()
  {
    static const Words<SweepAdaptation> words = {
      {SweepAdaptation::worst_point, "worst point"},
      {SweepAdaptation::each_point, "each point"}};
    return words;
  }
} // namespace PlateImpact
