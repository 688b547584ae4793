#ifndef plate_impact_transient_struck_plate_h
#define plate_impact_transient_struck_plate_h

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/transient/full_system.h"
#include "plate_impact/transient/impact.h"
#include "plate_impact/transient/integrator.h"
#include "plate_impact/transient/peak_force_dual.h"
#include "plate_impact/transient/sensitivity.h"
#include "plate_impact/transient/time_stepper.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace PlateImpact
{
  /// Who follows a transient step by step.
  class TransientListener
  {
  public:
    virtual ~TransientListener() = default;

    /// Before the first step.
    /// @param system  that is stepped; lives until the plate is struck again
    virtual void
    begin(const SemidiscreteSystem &system, const TimeStepper &stepper) = 0;

    /// After every step.
    /// @param step  from 1
    virtual void
    take_step(unsigned int step, const TimeStepper &stepper) = 0;
  };


  /// A plate on one mesh that is struck by one impactor after another. What the
  /// impactor does not change is made once, when it is first needed: matrices
  /// for the mesh, factorizations for the time step, reduced systems and
  /// discrete responses for the load.
  class StruckPlate
  {
  public:
    /// Numbers the unknowns.
    /// @param mesh  of the part of the plate that symmetry leaves
    StruckPlate(const PlateParameters                    &plate,
                const DiscretizationParameters           &discretization,
                std::unique_ptr<dealii::Triangulation<2>> mesh);

    /// @param parameters  with the plate and the discretization of this object
    /// @throws ComputationError naming step and quantity, and where an energy
    ///         that the scheme keeps has changed
    Impact
    strike(const Parameters &parameters);

    /// The same where there is an end time; where there is none, until the
    /// first contact ends. It ends by the time that an impactor takes to be
    /// thrown back by a massless plate and the contact, twice over; beyond it,
    /// or 2^18 steps, nobody waits.
    Parameters
    until_contact_ends(const Parameters &parameters);

    /// The same impact in steps, up to round-off.
    Impact
    strike(const Parameters &parameters, TransientListener &listener);

    /// As estimated_time_error().
    /// @param history  of the impact
    std::optional<double>
    time_error(const Parameters &parameters, const ContactHistory &history);

    /// How the history answers to another velocity; empty for a single contact,
    /// which changes in proportion.
    /// @param history  of the impact
    std::optional<Sensitivity>
    sensitivity(const Parameters &parameters, const ContactHistory &history);

    /// What the estimate of the error of the peak force needs: the motions, and
    /// the system whose states they are, which lives until the plate is struck
    /// again.
    struct PeakForceProblem
    {
      DualMotions               motions;
      const SemidiscreteSystem *system;
    };

    /// In Ritz vectors wherever they are fewer than the steps, even if the mesh
    /// itself was stepped. Empty for schemes that do not conserve energy,
    /// without a force, and with more than 20000 steps to the peak.
    /// @param history  of the impact
    std::optional<PeakForceProblem>
    peak_force_problem(const Parameters     &parameters,
                       const ContactHistory &history);

    /// As the function of that name. [Hz]
    std::vector<double>
    natural_frequencies(unsigned int n);

    const PlateDiscretization &
    discretization() const;

    /// What was made so far.
    struct Work
    {
      unsigned int loads          = 0; ///< with time steps
      unsigned int factorizations = 0;
      unsigned int linear_solves  = 0;
      unsigned int ritz_vectors   = 0; ///< a solve each

      /// Wall time of matrices and loads, and of factorizations. [s]
      double assembly_seconds = 0., factorization_seconds = 0.;
    };

    Work
    work() const;

  private:
    /// What makes the load and the steps of an impact: of the contact all but
    /// the law, of the impactor shape and length, the time up to the horizon,
    /// and whether there is an estimator.
    using LoadKey = std::
      tuple<ContactParameters, ImpactorShape, double, TimeParameters, bool>;

    static LoadKey
    load_key(const Parameters &parameters);

    /// What impacts with one load share.
    struct Load
    {
      Eigen::VectorXd                           u;
      double                                    layer_constant = 0.;
      std::unique_ptr<const ContactIntegration> integration;
      std::unique_ptr<Integrator>               integrator;
    };

    /// Assembled when it is first needed.
    FullSystem &
    assembled();
    /// The load of an impact, now that of the plate as well.
    Load &
    prepare(const Parameters &parameters);
    /// Size of the smallest cell that the load falls on. [m]
    double
    finest_cell_under_load(const Parameters &parameters) const;
    bool
    is_stepped_on_the_mesh(const Parameters &parameters);
    /// A little after the end of the first contact, on the mesh by steps four
    /// times as long, or as long as anybody waits. [s]
    double
    end_by_steps(const Parameters &parameters);
    /// Longest first contact that is waited for. [s]
    double
    longest_contact(const Parameters &parameters);
    /// Makes room for another one.
    void
    forget_loads();
    static Impact
    strike_system(Load                 &load,
                  SemidiscreteSystem   &system,
                  const TimeParameters &time,
                  const ContactLaw     &law,
                  const Impactor       &impactor);

    const PlateElement                              element;
    const std::unique_ptr<dealii::Triangulation<2>> mesh;
    const SolverType                                linear_solver;
    PlateDiscretization                             plate;

    std::unique_ptr<FullSystem> full; ///< of assembled()
    std::map<LoadKey, Load>     loads;

    /// Vectors for the estimate of a mesh that was stepped, until the next load
    /// is prepared.
    std::unique_ptr<Integrator> for_one_estimate;
    unsigned int                n_loads = 0, n_forgotten_vectors = 0;
    double                      assembly_seconds = 0.;
  };
} // namespace PlateImpact

#endif
