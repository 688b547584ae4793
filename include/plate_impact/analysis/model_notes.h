#pragma once

#include "plate_impact/analysis/warnings.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace PlateImpact
{
  /// What is noted while the limits of the model are checked one after another.
  struct ModelNotes
  {
    Warnings warnings;
    bool     is_beyond_limits = false; ///< so that the error is not known

    /// Notes what a part of the model leaves of the peak force.
    void
    leaves(const std::string &part, const std::optional<double> &relative)
    {
      warnings.model_errors.push_back({part, relative});
    }

    /// Notes a sentence, with {} for each number.
    template <typename... Numbers>
    void
    warn(const double over_limit,
         const char  *sentence,
         const Numbers &...numbers)
    {
      warnings.model.push_back(fmt::format(sentence, numbers...));
      warnings.farthest_from_model =
        std::max(warnings.farthest_from_model, over_limit);
    }

    /// The same where a quantity passes its limit, beyond which the error is
    /// not known.
    template <typename... Numbers>
    void
    limit(const double quantity,
          const double limit,
          const char  *sentence,
          const Numbers &...numbers)
    {
      if (quantity <= limit)
        return;
      warn(quantity / limit, sentence, numbers...);
      is_beyond_limits = true;
    }
  };

  /// Whether the bodies yield or the plate's faces do, by their strengths.
  void
  check_strengths(const ComputedImpact &impact, ModelNotes &notes);

  /// Whether a laminate delaminates; after all other limits.
  void
  check_delamination(const ComputedImpact &impact, ModelNotes &notes);
} // namespace PlateImpact
