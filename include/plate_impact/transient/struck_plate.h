#ifndef plate_impact_transient_struck_plate_h
#define plate_impact_transient_struck_plate_h

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/transient/plate_response.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace PlateImpact
{
  /// A plate on one mesh that is struck by one impactor after another. What the
  /// impactor does not change is made once: matrices for the mesh,
  /// factorizations for the time step, Ritz vectors and discrete responses for
  /// the load. Every impact is the one that `run` computes on this mesh, up to
  /// round-off.
  class StruckPlate
  {
  public:
    /// Assembles the matrices.
    /// @param mesh  of the quadrant
    StruckPlate(const PlateParameters                    &plate,
                const DiscretizationParameters           &discretization,
                std::unique_ptr<dealii::Triangulation<2>> mesh);

    /// @param parameters  with the plate and the discretization of this object
    /// @throws ComputationError
    Impact
    strike(const Parameters &parameters);

    const PlateDiscretization &
    model() const;

    /// Loads and time steps that something was made for so far.
    unsigned int
    n_loads() const;

  private:
    /// What makes the load and the steps of an impact: of the contact all but
    /// the law, of the impactor shape and length, the time, and whether there
    /// is an estimator.
    using LoadKey = std::
      tuple<ContactParameters, ImpactorShape, double, TimeParameters, bool>;

    static LoadKey
    load_key(const Parameters &parameters);

    /// What impacts with one load share.
    struct Load
    {
      Eigen::VectorXd                           u;
      std::unique_ptr<const ContactIntegration> integration;
      std::optional<RitzReduction>              reduction;
      std::optional<PlateResponse>              response_of_mesh;
    };

    /// The load of an impact, now that of the plate as well.
    Load &
    prepare(const Parameters &parameters);

    const PlateElement                              element;
    const std::unique_ptr<dealii::Triangulation<2>> mesh;
    const SolverType                                linear_solver;
    PlateDiscretization                             plate_on_mesh;

    std::unique_ptr<FullSystem> plate;
    std::map<LoadKey, Load>     loads;
    unsigned int                n_made = 0; ///< loads
  };
} // namespace PlateImpact

#endif
