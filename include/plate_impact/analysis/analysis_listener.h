#pragma once

#include <functional>
#include <string>

namespace PlateImpact
{
  class Cycle;

  /// Who follows an analysis: by default nobody.
  struct AnalysisListener
  {
    /// Before what may take long: the cycle and "assembly" or the like.
    std::function<void(unsigned int, const std::string &)> stage =
      [](const auto &...) {};

    /// After every step of a transient: the cycle, the step and their number.
    std::function<void(unsigned int, unsigned int, unsigned int)> step =
      [](const auto &...) {};

    /// After every cycle, before its mesh is adapted.
    std::function<void(Cycle &)> cycle = [](const auto &...) {};
  };
} // namespace PlateImpact
