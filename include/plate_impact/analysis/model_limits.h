#pragma once

#include "plate_impact/analysis/warnings.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace PlateImpact
{
  /// The limits of the model, what an impact inside of them may leave of the
  /// peak force, and the sentences for those that it passes.
  class ModelLimits : private ComputedImpact
  {
  public:
    explicit ModelLimits(const ComputedImpact &impact);

    Warnings warnings;

  private:
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

    /// What the contact takes for the answer of plate and ball to short waves,
    /// as far as doc/validation.md has compared it.
    void
    check_local_response();
    /// Relative drop of the peak force when the radius of the load on the plate
    /// is halved a number of times: each time the plate gives way by
    /// F ln 2 / (2 pi kappa G t) more under it.
    double
    drop_by(double halvings) const;
    void
    check_load();
    void
    check_disc();
    void
    check_patch();
    void
    check_plate();
    void
    check_slopes(double mean_slope);
    void
    check_contact();
    /// The local response is a static one: measured (tests/layer/layer.py,
    /// doc/theory.md), a force is 0.3 % too large where the contact lasts ten
    /// transits of a shear wave through the plate, 0.2 to 0.7 % at eight to
    /// three, 1.1 % at two: however short, the force is never far off.
    void
    check_duration();

    /// A loss factor that grows in proportion to the frequency is that of a
    /// material near the first natural frequency only.
    void
    check_damping();

    // what breaks or yields, in strength_limits.cc

    void
    check_strengths();
    /// The law of a contact that yields was compared up to w = 100
    /// (doc/validation.md).
    void
    check_yielding();
    /// Of a body that may yield, but whose strength is not given.
    void
    check_unknown_strength();
    void
    check_delamination();

    const bool is_layer = contact.local_response == LocalResponse::layer,
               plate_is_softer =
                 section.contact_modulus < impactor.youngs_modulus;
    /// Or half-width of the contact.
    const double radius = bodies.radius(peak.force, peak.indentation);
    /// Largest of an elastic contact.
    const double pressure         = peak.force > 0. ?
              bodies.elastic_pressure(peak.force, peak.indentation) :
              0.;
    bool         is_beyond_limits = false;
  };
} // namespace PlateImpact
