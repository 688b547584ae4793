#ifndef plate_impact_contact_yang_sun_unloading_h
#define plate_impact_contact_yang_sun_unloading_h

#include "plate_impact/contact/unloading.h"

#include <cmath>

namespace PlateImpact
{
  /// What Yang & Sun measured on laminates (NASA CR-165460, 1981; Tan & Sun, J.
  /// Appl. Mech. 52, 1985, p. 6): beyond a critical indentation alpha_cr the
  /// contact leaves a dent alpha_0 = alpha_m (1 - (alpha_cr / alpha_m)^0.4). It
  /// unloads with the power 2.5 and reloads with 1.5.
  class YangSunUnloading : public Unloading
  {
  public:
    /// @param critical_indentation alpha_cr [m]
    explicit YangSunUnloading(const double critical_indentation)
      : critical(critical_indentation)
    {}

    double
    dent(const double largest_indentation) const override
    {
      return largest_indentation > critical ? largest_indentation *
          (1. - std::pow(critical / largest_indentation, 0.4)) :
                                              0.;
    }

    double
    power(double) const override
    {
      return 2.5;
    }

    double
    reloading_power(double) const override
    {
      return 1.5;
    }

  private:
    const double critical;
  };
} // namespace PlateImpact

#endif
