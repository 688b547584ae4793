#include "plate_impact/contact/impact_estimate.h"

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_section.h"

namespace PlateImpact
{
  ExpectedPeak
  zener_peak(const Parameters &parameters)
  {
    return zener_peak(make_half_space_contact(parameters),
                      make_impactor(parameters.impactor),
                      PlateSection(parameters.plate));
  }



  ImpactEstimate::ImpactEstimate(const Parameters &scene)
    : ImpactEstimate(scene, zener_peak(scene))
  {}



  ImpactEstimate::ImpactEstimate(const Parameters   &scene,
                                 const ExpectedPeak &peak)
    : peak(peak)
    , contact_time(2. * peak.time)
    , wave(contact_wave(PlateSection(scene.plate), contact_time))
  {}
} // namespace PlateImpact
