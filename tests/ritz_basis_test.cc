// The plate reduced to Ritz vectors against the plate of the mesh.
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    /// A plate on a mesh, ready to be struck.
    struct Target
    {
      explicit Target(std::vector<std::string> overrides)
        : parameters(by_ritz_vectors(std::move(overrides)))
        , mesh(make_plate_mesh(parameters.plate,
                               parameters.discretization.initial_cells))
        , element(parameters.discretization.element)
        , model(assembled(*mesh, element, parameters))
        , loaded(std::make_shared<LoadedMesh>(LoadedMesh{
            {std::make_shared<EffectiveStiffness>(*model, SolverType::CHOLMOD),
             model->load(make_load_distribution(parameters.contact,
                                                parameters.impactor.length))},
            {}}))
      {}

      static Parameters
      by_ritz_vectors(std::vector<std::string> overrides)
      {
        overrides.push_back("Time/Integrator=Ritz vectors");
        return read_scene(std::string(TEST_DATA) +
                            "/reference/scene-interface.prm",
                          overrides)
          .parameters;
      }

      static std::unique_ptr<PlateDiscretization>
      assembled(const dealii::Triangulation<2> &mesh,
                const PlateElement             &element,
                const Parameters               &parameters)
      {
        auto model = std::make_unique<PlateDiscretization>(mesh,
                                                           element,
                                                           parameters.plate);
        model->assemble();
        return model;
      }

      ContactHistory
      strike(SemidiscreteSystem &plate, const double velocity) const
      {
        Parameters struck        = parameters;
        struck.impactor.velocity = velocity;
        return impact(struck, plate);
      }

      ReducedSystem *
      settle(RitzReduction &reduction, const double velocity) const
      {
        Parameters struck        = parameters;
        struck.impactor.velocity = velocity;
        return dynamic_cast<ReducedSystem *>(&reduction.system_for(struck));
      }

      const Parameters                                parameters;
      const std::unique_ptr<dealii::Triangulation<2>> mesh;
      const PlateElement                              element;
      const std::unique_ptr<PlateDiscretization>      model;
      const ContactIntegration                        integration =
        ForceIntegration::energy_conserving;
      const std::shared_ptr<LoadedMesh> loaded;
      FullSystem                       &plate = loaded->system;
    };



    /// Root mean square over the steps with contact, of the peak.
    double
    difference(const ContactHistory &a, const ContactHistory &b)
    {
      double       sum = 0.;
      unsigned int n   = 0;
      for (std::size_t i = 0; i < b.states.size(); ++i)
        if (b.states[i].force > 0.)
          {
            const double d = a.states[i].force - b.states[i].force;
            sum += d * d;
            ++n;
          }
      return std::sqrt(sum / n) / b.peak().force;
    }



    /// Of n vectors on equal cells.
    void
    expect_orthonormal(const std::string &thickness,
                       const std::string &cells,
                       const unsigned int n)
    {
      Target       target({"Plate/Thickness=" + thickness,
                           "Discretization/Initial cells=" + cells});
      const double sigma = 1e12;
      RitzBasis    basis(target.plate, sigma);
      basis.grow(n / 2);
      basis.grow(n);
      ASSERT_EQ(basis.n_vectors(), n);
      const Eigen::MatrixXd Q = basis.vectors(),
                            M = dense(target.model->mass()),
                            A = dense(target.model->stiffness()) + sigma * M;
      EXPECT_LT((Q.transpose() * A * Q -
                 Eigen::MatrixXd::Identity(Q.cols(), Q.cols()))
                  .cwiseAbs()
                  .maxCoeff(),
                1e-8);
      Eigen::MatrixXd         T    = sigma * Q.transpose() * M * Q;
      const TridiagonalMatrix mass = basis.mass(n);
      T.diagonal() -= sigma * mass.diagonal;
      T.diagonal(1) -= sigma * mass.beside;
      T.diagonal(-1) -= sigma * mass.beside;
      EXPECT_LT(T.cwiseAbs().maxCoeff(), 1e-8);
      Eigen::VectorXd load = Q.transpose() * target.plate.load;
      load[0] -= basis.load();
      EXPECT_LT(load.cwiseAbs().maxCoeff(), 1e-8 * basis.load());
    }



    TEST(RitzBasis, VectorsAreOrthonormalAndProjectTheMass)
    {
      expect_orthonormal("0.008", "6, 6", 150);
      // many on a thin plate, of which the last are hardly coupled
      expect_orthonormal("0.0008", "10, 10", 600);
    }



    TEST(RitzBasis, EndsWhenTheSpaceIsExhausted)
    {
      Target    target({"Discretization/Initial cells=1,1"});
      RitzBasis basis(target.plate, 1e12);
      basis.grow(1000);
      EXPECT_TRUE(basis.is_complete());
      EXPECT_LE(basis.n_vectors(), target.model->n_unknowns());
      ReducedSystem reduced(basis, basis.n_vectors());
      EXPECT_LT(difference(target.strike(reduced, 1.),
                           target.strike(target.plate, 1.)),
                1e-8);
    }



    TEST(RitzBasis, EndsWhereNothingButRoundOffIsLeft)
    {
      for (const std::string thickness : {"2e-3", "2e-4", "2e-5", "2e-6"})
        {
          Target    target({"Discretization/Initial cells=3,3",
                            "Contact/Patch radius=0.001",
                            "Plate/Thickness=" + thickness});
          RitzBasis basis(target.plate, 1.6e6);
          basis.grow(1000);
          EXPECT_TRUE(basis.is_complete());
          EXPECT_GT(basis.n_vectors(), 10u);
          // half of the unknowns, those that are symmetric about the diagonal
          EXPECT_LE(basis.n_vectors(), 54u) << thickness;
          // a mass is positive
          const TridiagonalMatrix mass  = basis.mass(basis.n_vectors());
          double                  pivot = mass.diagonal[0];
          for (unsigned int n = 1; n < basis.n_vectors(); ++n)
            {
              pivot =
                mass.diagonal[n] - std::pow(mass.beside[n - 1], 2) / pivot;
              EXPECT_GT(pivot, 0.) << thickness << ' ' << n;
            }
        }
    }



    TEST(RitzReduction, ForcesAreThoseOfTheMesh)
    {
      const std::vector<std::vector<std::string>> scenes = {
        {"Discretization/Initial cells=12,12"},
        {"Discretization/Initial cells=12,8", "Plate/Support=free"},
        {"Discretization/Initial cells=12,12",
         "Plate/Thickness=0.002",
         "Impactor/Velocity=5",
         "Time/End time=160e-6",
         "Time/Time step=2e-7"},
        {"Discretization/Initial cells=8,8",
         "Impactor/Shape=cylinder",
         "Contact/Law=line",
         "Contact/Load distribution=strip",
         "Contact/Patch radius=0.0005"}};
      for (const auto &scene : scenes)
        {
          Target         target(scene);
          const double   velocity = target.parameters.impactor.velocity;
          RitzReduction  reduction(target.loaded,
                                  target.parameters.time,
                                  target.integration,
                                  /*needs_fields=*/false);
          ReducedSystem *reduced = target.settle(reduction, velocity);
          ASSERT_NE(reduced, nullptr);
          EXPECT_LE(target.plate.matrices->work.ritz_vectors, 250u);
          EXPECT_LT(difference(target.strike(*reduced, velocity),
                               target.strike(target.plate, velocity)),
                    3. * target.parameters.time.ritz_tolerance)
            << scene[1 % scene.size()];
        }
    }



    TEST(RitzReduction, AnImpactorDoesNotFeelTheOnesBeforeIt)
    {
      Target     target({"Discretization/Initial cells=6,6"});
      const auto fresh = [&](const std::shared_ptr<LoadedMesh> &loaded) {
        return RitzReduction(loaded,
                             target.parameters.time,
                             target.integration,
                             /*needs_fields=*/true);
      };
      RitzReduction shared = fresh(target.loaded);
      for (const double velocity : {50., 1., 0.01, 1.})
        {
          const auto without_bases =
            std::make_shared<LoadedMesh>(LoadedMesh{target.plate, {}});
          RitzReduction  alone = fresh(without_bases);
          ReducedSystem *a     = target.settle(shared, velocity);
          ReducedSystem *b     = target.settle(alone, velocity);
          ASSERT_NE(a, nullptr);
          ASSERT_NE(b, nullptr);
          EXPECT_EQ(difference(target.strike(*a, velocity),
                               target.strike(*b, velocity)),
                    0.);
        }
    }



    TEST(ReducedSystem, TerminatorTakesUpTheWaves)
    {
      Target    target({"Discretization/Initial cells=12,12"});
      RitzBasis basis(target.plate, 3e11);
      basis.grow(40);
      const ContactHistory of_mesh = target.strike(target.plate, 1.);
      const auto           error   = [&](const unsigned int n_beyond) {
        ReducedSystem reduced(basis, 40, n_beyond);
        return difference(target.strike(reduced, 1.), of_mesh);
      };
      EXPECT_LT(error(300), 2e-5);
      EXPECT_GT(error(0), 2. * error(300));
    }



    TEST(ReducedSystem, ErrorsWithAndWithoutATerminator)
    {
      Target target(
        {"Discretization/Initial cells=24,24", "Discretization/Element=MITC9"});
      // what RitzReduction chooses for this scene
      const double sigma = std::exp2(38.);
      const double distance =
        std::sqrt(sigma) * target.parameters.time.end_time;
      const unsigned int   n_beyond = 7. * distance;
      const ContactHistory of_mesh  = target.strike(target.plate, 1.);
      RitzBasis            basis(target.plate, sigma);
      basis.grow(60);
      const auto error = [&](const unsigned int n, const unsigned int beyond) {
        ReducedSystem reduced(basis, n, beyond);
        return difference(target.strike(reduced, 1.), of_mesh);
      };
      record("distance", distance);
      for (const unsigned int n : {10, 12, 15, 20, 25, 30, 40, 60})
        {
          const double without = error(n, 0), with = error(n, n_beyond);
          record(fmt::format("without/{}", n), without);
          record(fmt::format("with/{}", n), with);
          EXPECT_LT(with, 2e-4) << n;
          EXPECT_LT(with, without) << n;
        }

      // until waves come back from the edges, the chain is uniform
      const Eigen::VectorXd on  = 2. * sigma * basis.mass(60).diagonal,
                            off = 4. * sigma * basis.mass(60).beside;
      const double deviation =
        std::max((on.segment(3, 7).array() - 1.).abs().maxCoeff(),
                 (off.segment(3, 7).array() - 1.).abs().maxCoeff());
      record("deviation from the uniform chain", deviation);
      EXPECT_LT(deviation, 0.03);
    }



    TEST(ReducedSystem, StaysPositiveWithATerminator)
    {
      for (const std::string support : {"clamped", "free"})
        {
          Target target(
            {"Discretization/Initial cells=6,6", "Plate/Support=" + support});
          RitzBasis basis(target.plate, 1e10);
          basis.grow(80);
          for (unsigned int n = 1; n <= 80; ++n)
            {
              const ReducedSystem reduced(basis, n, 40);
              const Eigen::Index  size = reduced.load.size();
              ASSERT_EQ(size, n + 40);
              Eigen::MatrixXd K(size, size);
              Eigen::VectorXd column;
              for (Eigen::Index i = 0; i < size; ++i)
                {
                  reduced.multiply_stiffness(Eigen::VectorXd::Unit(size, i),
                                             column);
                  K.col(i) = column;
                }
              // sigma M = I - K
              const Eigen::VectorXd eigenvalues =
                Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
              EXPECT_GT(eigenvalues.minCoeff(), -1e-10) << support << ' ' << n;
              EXPECT_LT(eigenvalues.maxCoeff(), 1. + 1e-10)
                << support << ' ' << n;
            }
        }
    }



    TEST(FullSystem, KnowsTheStaticComplianceAndKeepsItsFactorization)
    {
      Target       clamped({"Discretization/Initial cells=6,6"});
      const double exact = clamped.plate.load.dot(
        solve_static(*clamped.model, clamped.plate.load));
      Eigen::VectorXd before, after;
      clamped.plate.solve(1e12, clamped.plate.load, before);
      const double bound = clamped.plate.static_compliance();
      EXPECT_GE(bound, exact);
      EXPECT_LT(bound, 1.01 * exact);
      clamped.plate.solve(1e12, clamped.plate.load, after);
      EXPECT_EQ(before, after);

      Target free({"Discretization/Initial cells=6,6", "Plate/Support=free"});
      EXPECT_TRUE(std::isinf(free.plate.static_compliance()));
    }



    TEST(ReducedSystem, KnowsTheStaticCompliance)
    {
      Target    clamped({"Discretization/Initial cells=6,6"});
      RitzBasis basis(clamped.plate, 1e12);
      basis.grow(120);
      const double exact = clamped.plate.load.dot(
        solve_static(*clamped.model, clamped.plate.load));
      const double bound = ReducedSystem(basis, 120).static_compliance();
      EXPECT_GE(bound, exact);
      EXPECT_LT(bound, 1.01 * exact);

      Target free({"Discretization/Initial cells=6,6", "Plate/Support=free"});
      RitzBasis of_free(free.plate, 1e12);
      of_free.grow(120);
      EXPECT_TRUE(std::isinf(ReducedSystem(of_free, 120).static_compliance()));
    }



    TEST(ReducedSystem, StatesAreJudgedAsThoseOfTheMesh)
    {
      Target         target({"Discretization/Initial cells=6,6"});
      RitzReduction  reduction(target.loaded,
                              target.parameters.time,
                              target.integration,
                              /*needs_fields=*/true);
      ReducedSystem *reduced = target.settle(reduction, 1.);
      ASSERT_NE(reduced, nullptr);
      const Contact contact  = make_contact(target.parameters);
      const auto    estimate = [&](SemidiscreteSystem &plate) {
        MeshEstimator estimator(*target.model);
        TimeStepper   stepper({target.parameters.time, target.integration},
                            plate,
                            contact,
                            make_impactor(target.parameters.impactor));
        std::vector<double> times;
        Eigen::MatrixXd     states(plate.load.size(), 0);
        for (unsigned int step = 1; step <= stepper.scheme.n_steps; ++step)
          {
            stepper.advance();
            if (step % 20 != 0)
              continue;
            times.push_back(stepper.state().time);
            states.conservativeResize(Eigen::NoChange, times.size());
            states.rightCols<1>() = stepper.displacement();
          }
        const SemidiscreteSystem::Span span = plate.span(states);
        estimator.estimator.add_samples(times, span.vectors, span.coordinates);
        return estimator.estimate();
      };
      const ErrorEstimate of_mesh    = estimate(target.plate),
                          of_vectors = estimate(*reduced);
      EXPECT_NEAR(of_vectors.eta, of_mesh.eta, 2e-3 * of_mesh.eta);
      EXPECT_NEAR(of_vectors.max_stresses(0, 0),
                  of_mesh.max_stresses(0, 0),
                  2e-3 * of_mesh.max_stresses(0, 0));
      const double largest = *std::max_element(of_mesh.element_errors.begin(),
                                               of_mesh.element_errors.end());
      for (std::size_t cell = 0; cell < of_mesh.element_errors.size(); ++cell)
        EXPECT_NEAR(of_vectors.element_errors[cell],
                    of_mesh.element_errors[cell],
                    0.02 * largest);
    }
  } // namespace
} // namespace PlateImpact
