#ifndef plate_impact_transient_struck_plate_h
#define plate_impact_transient_struck_plate_h

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/transient/full_system.h"
#include "plate_impact/transient/loaded_plate.h"

#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace PlateImpact
{
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

    /// @param impact        with the plate and the discretization of this
    /// object
    /// @param needs_states  whether more than the force is to be right: its
    ///                      displacements as well
    LoadedPlate
    under(const Parameters &impact, bool needs_states);

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
    /// the contact, of the impactor shape and length, the time up to the horizon,
    /// and whether states are needed.
    using LoadKey = std::
      tuple<ContactParameters, ImpactorShape, double, TimeParameters, bool>;

    static LoadKey
    load_key(const Parameters &impact, bool needs_states);
    /// Assembled when it is first needed.
    const std::shared_ptr<EffectiveStiffness> &
    assembled();
    std::shared_ptr<Load>
    make_load(const Parameters &impact, bool needs_states);
    /// Size of the smallest cell that the load falls on. [m]
    double
    finest_cell_under_load(const Parameters &impact) const;
    /// Makes room for another one.
    void
    forget_loads();

    const PlateElement                              element;
    const std::unique_ptr<dealii::Triangulation<2>> mesh;
    const SolverType                                linear_solver;
    PlateDiscretization                             plate;

    std::shared_ptr<EffectiveStiffness>      matrices; ///< of assembled()
    std::map<LoadKey, std::shared_ptr<Load>> loads;
    unsigned int n_loads = 0, n_forgotten_vectors = 0;
    double       assembly_seconds = 0.;
  };
} // namespace PlateImpact

#endif
