#ifndef plate_impact_transient_ritz_reduction_h
#define plate_impact_transient_ritz_reduction_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/plate/plate_section.h"
#include "plate_impact/transient/integrator.h"
#include "plate_impact/transient/reduced_system.h"
#include "plate_impact/transient/ritz_basis.h"

#include <map>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// Reduces the plate of a mesh for one impactor after another. An impactor
  /// gets the first basis of a growing sequence with which the errors of its
  /// force and of the displacement under the load, as the last three bases tell
  /// them, are below `time.ritz_tolerance` of the peak, as a root mean square
  /// over the contact and over all steps, and, where fields are asked for,
  /// displacements hardly use what lies beyond the basis before. The number is
  /// found with an impactor of round numbers nearby, whose contact is shorter,
  /// so that similar impactors share it and what one gets depends on
  /// nothing but plate, load, time and itself; vectors that another one has
  /// asked for before are not computed again.
  class RitzReduction : public Integrator
  {
  public:
    /// @param full          must outlive the reduction, which factorizes it
    /// @param integration   must outlive the reduction
    /// @param needs_fields  whether more than the force is to be right
    RitzReduction(FullSystem               &full,
                  const PlateParameters    &plate,
                  const TimeParameters     &time,
                  const ContactIntegration &integration,
                  bool                      needs_fields);

    /// The reduced system, or that of the mesh where it takes fewer solves.
    SemidiscreteSystem &
    system_for(const Parameters &parameters) override;

    /// A solve each.
    unsigned int
    n_vectors() const override;

  private:
    /// @return null when it takes more solves than steps
    ReducedSystem *
    settle(const Contact &contact, const Impactor &impactor);
    /// Whether it is known beforehand that stepping on the mesh takes fewer
    /// solves than vectors would.
    bool
    steps_are_fewer(const Contact &contact, const Impactor &impactor) const;
    /// Twice the logarithm to base 2 of the root of the shift [1/s].
    int
    half_octave(const Contact &contact, const Impactor &impactor) const;
    /// What a number of vectors is judged by, relative to the peak force: the
    /// force, and without contact the displacement under the load times the
    /// stiffness of the contact at the peak, which is the error that it would
    /// bring into a force, for another impactor may be in contact when this one
    /// is not. NaN with contact.
    struct Histories
    {
      std::vector<double> force, displacement;
    };

    Histories
    histories(ReducedSystem  &reduced,
              const Contact  &contact,
              const Impactor &impactor);
    /// Norm over all times of what coordinates from the first on hold of the
    /// displacements, relative to that of all.
    double
    share_beyond(unsigned int    first,
                 ReducedSystem  &reduced,
                 const Contact  &contact,
                 const Impactor &impactor) const;
    ReducedSystem &
    reduced_system(int half_octave, unsigned int n);

    FullSystem           &full;
    const PlateParameters plate;
    const PlateSection    section;
    const bool            needs_fields;

    /// By the law's section and the impactor in round numbers.
    std::map<std::pair<ContactParameters, ImpactorParameters>, ReducedSystem *>
      settled;
    /// By the half octave of the shift, and by the number of vectors.
    std::map<int, RitzBasis>                              bases;
    std::map<std::pair<int, unsigned int>, ReducedSystem> reduced_systems;
  };
} // namespace PlateImpact

#endif
