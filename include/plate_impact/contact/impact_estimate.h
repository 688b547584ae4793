#ifndef plate_impact_contact_impact_estimate_h
#define plate_impact_contact_impact_estimate_h

#include "plate_impact/contact/zener.h"

namespace PlateImpact
{
  struct Parameters;

  /// Zener's peak of a scene: its impactor, its contact without the layer, its
  /// plate.
  ExpectedPeak
  zener_peak(const Parameters &parameters);


  /// What theory expects of the impact of a scene, on an infinite thin plate.
  struct ImpactEstimate
  {
    explicit ImpactEstimate(const Parameters &scene);
    /// @param peak  as zener_peak(scene), where it is known
    ImpactEstimate(const Parameters &scene, const ExpectedPeak &peak);

    ExpectedPeak peak;
    double       contact_time; ///< [s]
    BendingWave  wave;         ///< of the contact
  };
} // namespace PlateImpact

#endif
