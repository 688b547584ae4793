#ifndef plate_impact_transient_integrator_h
#define plate_impact_transient_integrator_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/transient/plate_response.h"
#include "plate_impact/transient/ritz_basis.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <map>
#include <memory>

namespace PlateImpact
{
  /// What Newmark's method integrates for an impact: the semidiscrete system of
  /// the mesh, or one reduced from it that gives the same force. An integrator
  /// belongs to one load, with the time steps and the integration of the
  /// contact force under it.
  class Integrator
  {
  public:
    /// @param integration  must outlive the integrator
    Integrator(const TimeParameters     &time,
               const ContactIntegration &integration)
      : time(time)
      , integration(integration)
    {}

    virtual ~Integrator() = default;

    /// The system to step for an impact; it belongs to the integrator.
    /// @param parameters  with the load and the times of this integrator
    virtual SemidiscreteSystem &
    system_for(const Parameters &parameters) = 0;

    /// An impact on a system of this integrator: by its response where scheme
    /// and plate conserve energy, otherwise in steps.
    /// @param n_steps  at most those of the integrator
    /// @throws ComputationError naming step and quantity
    Impact
    impact(SemidiscreteSystem &system,
           const Contact      &contact,
           const Impactor     &impactor,
           unsigned int        n_steps);

    /// The response of a system of this integrator, kept for the next impactor;
    /// for schemes that conserve energy.
    const PlateResponse &
    response(SemidiscreteSystem &system);

  protected:
    const TimeParameters      time;
    const ContactIntegration &integration;

  private:
    std::map<const SemidiscreteSystem *, PlateResponse> responses;
  };


  /// All unknowns of the mesh, whatever strikes it.
  class NewmarkOnTheMesh : public Integrator
  {
  public:
    /// @param mesh  must outlive the integrator
    NewmarkOnTheMesh(LoadedMesh               &mesh,
                     const TimeParameters     &time,
                     const ContactIntegration &integration,
                     bool /*needs_fields*/ = true)
      : Integrator(time, integration)
      , full(mesh.system)
    {}

    SemidiscreteSystem &
    system_for(const Parameters &) override
    {
      return full;
    }

  private:
    FullSystem &full;
  };


  /// The integrator that the scene names: `Newmark` or `Ritz vectors`. Mesh
  /// and integration must outlive it.
  /// @param needs_fields  whether more than the force is to be right
  std::unique_ptr<Integrator>
  make_integrator(LoadedMesh               &mesh,
                  const TimeParameters     &time,
                  const ContactIntegration &integration,
                  bool                      needs_fields);
} // namespace PlateImpact

#endif
