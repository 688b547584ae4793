#ifndef plate_impact_struck_plate_h
#define plate_impact_struck_plate_h

#include <deal.II/grid/tria.h>

#include "plate_impact/contact_solver.h"
#include "plate_impact/parameters.h"
#include "plate_impact/plate_element.h"
#include "plate_impact/plate_model.h"
#include "plate_impact/plate_response.h"
#include "plate_impact/ritz_reduction.h"
#include "plate_impact/semidiscrete_plate.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

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

    const PlateModel &
    model() const;

    /// Loads and time steps that something was made for so far.
    unsigned int
    n_loads() const;

  private:
    /// Makes the load of an impact, unless it is the last one's.
    void
    prepare(const Parameters &parameters);

    const PlateElement                              element;
    const std::unique_ptr<dealii::Triangulation<2>> mesh;
    const std::string                               linear_solver;
    PlateModel                                      plate_model;

    std::optional<Parameters>                 prepared; ///< for these
    std::unique_ptr<const ContactIntegration> integration;
    std::unique_ptr<MeshPlate>                plate;
    std::optional<RitzReduction>              reduction;
    /// of the mesh and of reduced plates
    std::map<const SemidiscretePlate *, PlateResponse> responses;
    unsigned int                                       loads = 0;
  };
} // namespace PlateImpact

#endif
