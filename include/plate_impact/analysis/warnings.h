#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/impact_quantities.h"

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
  Warnings
  model_warnings(const ComputedImpact &impact);

  /// The same, and where end time, time step and mesh leave the peak force
  /// open.
  /// @param mesh  null: not judged
  Warnings
  impact_warnings(const ComputedImpact           &impact,
                  const dealii::Triangulation<2> *mesh = nullptr);
} // namespace PlateImpact
