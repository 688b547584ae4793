#pragma once

#include <deal.II/base/function.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/full_system.h"
#include "plate_impact/transient/time_stepper.h"

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A plate of unit material with the given support and thickness, side 1.
  PlateParameters
  unit_plate(EdgeSupport support, double thickness);

  /// Every element that a scene can name.
  std::vector<ElementType>
  all_elements();

  /// For messages of failed tests.
  std::ostream &
  operator<<(std::ostream &out, ElementType element);

  /// The unit square without planes of symmetry: all sides are edges.
  std::unique_ptr<dealii::Triangulation<2>>
  unit_square(unsigned int n_cells);

  /// Moves interior vertices at random by up to a fraction of the cell size.
  void
  distort(dealii::Triangulation<2> &mesh, double fraction);

  /// Refines cells at random, with hanging nodes; reproducible.
  void
  refine_randomly(dealii::Triangulation<2> &mesh, unsigned int n_times);

  /// Makes a mesh of a quadrant anew: unstructured quadrilaterals whose size
  /// grows from `fine` at the origin by `growth` over a distance.
  void
  remesh(dealii::Triangulation<2> &mesh, double fine, double growth);

  /// Makes all sides edges of the plate.
  void
  unset_symmetry(dealii::Triangulation<2> &mesh);

  /// Points of a load with a pressure p(x,y), from the Gauss points of a mesh.
  std::vector<LoadPoint>
  pressure_load(
    const dealii::Triangulation<2>                        &mesh,
    const std::function<double(const dealii::Point<2> &)> &pressure);

  /// The unknowns of a given field.
  Eigen::VectorXd
  interpolate(const PlateDiscretization &model,
              const dealii::Function<2> &field);

  /// K z = f.
  Eigen::VectorXd
  solve_static(const PlateDiscretization &model, const Eigen::VectorXd &load);

  /// y = A x.
  Eigen::VectorXd
  multiply(const Epetra_CrsMatrix &matrix, const Eigen::VectorXd &x);

  Eigen::MatrixXd
  dense(const Epetra_CrsMatrix &matrix);

  /// An impact with the law, integration, impactor and time of a scene on a
  /// plate.
  ContactHistory
  impact(const Parameters &parameters, SemidiscreteSystem &plate);

  /// The same on a given mesh.
  ContactHistory
  impact(const Parameters               &parameters,
         const dealii::Triangulation<2> &mesh,
         const std::vector<LoadPoint>   &load,
         double                          multiplicity = 4.);

  /// The estimator with a recovery of its own, for states of the mesh.
  class MeshEstimator
  {
  public:
    explicit MeshEstimator(const PlateDiscretization       &discretization,
                           const std::vector<unsigned int> &singular = {})
      : recovery(discretization.mesh())
      , estimator(discretization, recovery, singular)
    {}

    /// @param states  unknowns, a column a time
    void
    add_samples(const std::vector<double> &times, const Eigen::MatrixXd &states)
    {
      estimator.add_samples(times,
                            states,
                            Eigen::MatrixXd::Identity(states.cols(),
                                                      states.cols()));
    }

    ErrorEstimate
    estimate() const
    {
      return estimator.estimate();
    }

  private:
    const StressRecovery recovery;

  public:
    EnergyNormEstimator estimator;
  };

  /// A mesh in version 2.2 of Gmsh's format, with a physical group for every
  /// boundary id that has a name.
  std::string
  msh(const dealii::Triangulation<2>                          &mesh,
      const std::map<dealii::types::boundary_id, std::string> &names);

  /// A file of tests/reference.
  nlohmann::json
  reference(const std::string &name);

  /// Puts a number that the test measures into GoogleTest's report, from which
  /// doc/make takes it.
  void
  record(const std::string &name, double value);

  /// Unknowns given by a function of a point: deflection and rotations, and of
  /// plates that stretch displacements in the plane.
  template <unsigned int n>
  class FieldOf : public dealii::Function<2>
  {
  public:
    using Values = std::array<double, n>;

    explicit FieldOf(
      const std::function<Values(const dealii::Point<2> &)> &field)
      : dealii::Function<2>(n)
      , field(field)
    {}

    double
    value(const dealii::Point<2> &point,
          const unsigned int      component) const override
    {
      return field(point)[component];
    }

  private:
    const std::function<Values(const dealii::Point<2> &)> field;
  };

  using Field = FieldOf<3>;
} // namespace PlateImpact
