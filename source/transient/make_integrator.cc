#include "plate_impact/base/entries.h"
#include "plate_impact/transient/integrator.h"
#include "plate_impact/transient/ritz_reduction.h"

namespace PlateImpact
{
  namespace
  {
    struct IntegratorRow
    {
      IntegratorType             choice;
      std::string                word;
      decltype(make_integrator) *make;
    };

    const std::vector<IntegratorRow> integrators = {
      {IntegratorType::Newmark,
       "Newmark",
       make_as<Integrator, NewmarkOnTheMesh>},
      {IntegratorType::Ritz_vectors,
       "Ritz vectors",
       make_as<Integrator, RitzReduction>}};
  } // namespace



  std::unique_ptr<Integrator>
  make_integrator(LoadedMesh               &mesh,
                  const TimeParameters     &time,
                  const ContactIntegration &integration,
                  const bool                needs_fields)
  {
    const IntegratorType type =
      mesh.system.is_linear() ? time.integrator : IntegratorType::Newmark;
    return row_of(type, integrators)
      .make(mesh, time, integration, needs_fields);
  }



  void
  TimeParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Time");
    entry("End time", "80e-6", number_from(0), end_time)
      .means("0: to the end of the first contact. [s]");
    entry("Time step", "1e-7", number_from(0), time_step)
      .means("Shortened where End time is not a multiple of it. 0: by powers "
             "of two, the largest that meets Step tolerance in Zener's "
             "equation. [s]");
    entry("Step tolerance", "1e-4", number_between(0, 1), step_tolerance)
      .means("Error of the peak force by the time step, relative to it, with "
             "which the program chooses a step. [-]");
    entry("Integrator", "Ritz vectors", one_of(integrators), integrator)
      .means("What Newmark's method integrates: the unknowns of the mesh "
             "(Newmark), or their coordinates in load-dependent Ritz vectors, "
             "as many as the force needs; on the mesh nevertheless where that "
             "takes more of them than steps.");
    entry("Ritz tolerance", "1e-5", number_above(0), ritz_tolerance)
      .means("Estimated error of the force against that of the mesh, as a "
             "fraction of its peak, below which no further Ritz vectors are "
             "added: a root mean square over the contact. [-]");
    entry("Newmark beta", "0.25", number_up_to(0, 1), newmark_beta)
      .means("At least half of gamma: unconditionally stable. [-]");
    entry("Newmark gamma", "0.5", number_from(0.5), newmark_gamma)
      .means("Above 0.5 the scheme damps, to first order. [-]");
  }
} // namespace PlateImpact
