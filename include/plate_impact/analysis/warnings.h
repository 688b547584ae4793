#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/impact_quantities.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a part of the model may leave of the peak force.
  struct ModelError
  {
    std::string           of;       ///< the part, as "local response"
    std::optional<double> relative; ///< to the force; empty: not known
  };

  /// What limits the trust in a result: sentences, each with numbers and
  /// advice.
  struct Warnings
  {
    std::vector<std::string> numerical; ///< mesh, time step, end time
    std::vector<std::string> model;     ///< where the impact leaves the model

    /// The quantity that passes its limit by most, over the limit; 1 or less
    /// inside of the model.
    double farthest_from_model = 0.;

    /// Whether a quantity passes a limit beyond which the error is not known.
    bool is_beyond_limits = false;

    /// As far as the parts of the model were compared (doc/validation.md).
    std::vector<ModelError> model_errors;

    /// Whether the contact yields, or the strength that it needs not to; empty
    /// without a contact.
    std::string contact;

    /// Whether a laminate delaminates; empty where nothing is said of its
    /// toughness.
    std::string damage;

    /// Whether nothing is said of the strength of a body that may yield.
    bool assumes_elastic_contact = false;

    /// Of all parts together, relative to the force; empty where one is not
    /// known.
    std::optional<double>
    model_error() const
    {
      double sum = 0.;
      for (const ModelError &error : model_errors)
        {
          if (!error.relative)
            return {};
          sum += *error.relative;
        }
      return sum;
    }

    /// Notes what a part of the model leaves of the peak force.
    void
    leaves(const std::string &part, const std::optional<double> &relative)
    {
      model_errors.push_back({part, relative});
    }

    /// Notes where the impact leaves the model, with {} for each number.
    template <typename... Numbers>
    void
    warn(const double over_limit,
         const char  *sentence,
         const Numbers &...numbers)
    {
      model.push_back(fmt::format(sentence, numbers...));
      farthest_from_model = std::max(farthest_from_model, over_limit);
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

    /// The numerical ones first.
    std::vector<std::string>
    all() const
    {
      std::vector<std::string> result = numerical;
      result.insert(result.end(), model.begin(), model.end());
      return result;
    }
  };

  /// Where an impact leaves what the model can tell, on whatever mesh: the area
  /// of the load, deflection, yield, indentation.
  /// @param before  those to add to
  Warnings
  model_warnings(const ComputedImpact &impact, const Warnings &before = {});

  /// The same, and where end time, time step and mesh leave the peak force
  /// open.
  /// @param mesh  null: not judged
  Warnings
  impact_warnings(const ComputedImpact           &impact,
                  const dealii::Triangulation<2> *mesh = nullptr);
} // namespace PlateImpact
