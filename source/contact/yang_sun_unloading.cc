#include "plate_impact/contact/yang_sun_unloading.h"

#include <cmath>

namespace PlateImpact
{
  YangSunUnloading::YangSunUnloading(const double critical_indentation)
    : critical(critical_indentation)
  {}



  double
  YangSunUnloading::dent(const double largest_indentation) const
  {
    return largest_indentation > critical ? largest_indentation *
        (1. - std::pow(critical / largest_indentation, 0.4)) :
                                            0.;
  }



  double
  YangSunUnloading::power(double) const
  {
    return 2.5;
  }



  double
  YangSunUnloading::reloading_power(double) const
  {
    return 1.5;
  }
} // namespace PlateImpact
