// What the stages of a run cost, on uniform meshes of the steel case:
//   build/release/tests/benchmark/benchmarks
#include <deal.II/base/multithread_info.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/transient/ritz_reduction.h"

#include <cholmod.h>

#include <benchmark/benchmark.h>
#include <cmath>
#include <optional>

namespace PlateImpact
{
  namespace
  {
    Parameters
    steel_case(const unsigned int cells, const IntegratorType integrator)
    {
      const std::string n = std::to_string(cells);
      return read_scene(
               std::string(TEST_DATA) + "/reference/scene-interface.prm",
               {"Discretization/Element=MITC9",
                "Discretization/Initial cells=" + n + "," + n,
                "Adaptivity/Strategy=none",
                "Time/End time=1e-4",
                std::string("Time/Integrator=") +
                  (integrator == IntegratorType::Newmark ? "Newmark" :
                                                           "Ritz vectors")})
        .parameters;
    }



    /// The steel case on a mesh, up to a stage.
    struct Stages
    {
      explicit Stages(const unsigned int cells)
        : parameters(steel_case(cells, IntegratorType::Newmark))
        , mesh(make_plate_mesh(parameters.plate,
                               parameters.discretization.initial_cells))
        , element(parameters.discretization.element)
        , model(*mesh, element, parameters.plate)
        , contact(make_contact(parameters))
        , scheme(parameters.time, parameters.contact.integration)
        , impactor(make_impactor(parameters.impactor))
      {}

      FullSystem
      plate()
      {
        model.assemble();
        return {std::make_shared<EffectiveStiffness>(model,
                                                     SolverType::CHOLMOD),
                model.load(make_load_distribution(parameters.contact,
                                                  parameters.impactor.length))};
      }

      const Parameters                                parameters;
      const std::unique_ptr<dealii::Triangulation<2>> mesh;
      const PlateElement                              element;
      PlateDiscretization                             model;
      const Contact                                   contact;
      const NewmarkScheme                             scheme;
      const Impactor                                  impactor;
    };

    constexpr double shift = 1e12; // of the order of the program's [1/s^2]



    /// The unknowns, by which the growth is judged.
    void
    count(benchmark::State &state, const Stages &stages)
    {
      state.counters["unknowns"] = stages.model.n_unknowns();
    }



    void
    Assembly(benchmark::State &state)
    {
      Stages stages(state.range(0));
      for (auto _ : state)
        {
          PlateDiscretization model(*stages.mesh,
                                    stages.element,
                                    stages.parameters.plate);
          model.assemble();
        }
      count(state, stages);
    }



    void
    OrderingAndFactorization(benchmark::State &state)
    {
      Stages stages(state.range(0));
      for (auto _ : state)
        {
          state.PauseTiming();
          FullSystem plate = stages.plate();
          state.ResumeTiming();
          plate.matrices->factorize(shift);
        }
      count(state, stages);
    }



    void
    Factorization(benchmark::State &state)
    {
      Stages     stages(state.range(0));
      FullSystem plate = stages.plate();
      double     c     = shift;
      plate.matrices->factorize(c);
      for (auto _ : state)
        plate.matrices->factorize(c *= 1.01);
      count(state, stages);
    }



    /// Memory of CHOLMOD's factor, as the program orders it. [bytes]
    double
    factor_size(const Epetra_CrsMatrix &matrix)
    {
      int    *rows, *columns;
      double *values;
      matrix.ExtractCrsDataPointers(rows, columns, values);
      cholmod_common common;
      cholmod_start(&common);
      common.supernodal         = CHOLMOD_SUPERNODAL;
      common.nmethods           = 1;
      common.method[0].ordering = CHOLMOD_AMD;
      cholmod_sparse A          = {};
      A.nrow = A.ncol = matrix.NumMyRows();
      A.nzmax         = matrix.NumMyNonzeros();
      A.p             = rows;
      A.i             = columns;
      A.stype         = 1;
      A.itype         = CHOLMOD_INT;
      A.xtype         = CHOLMOD_PATTERN;
      A.packed        = 1;

      cholmod_factor *factor = cholmod_analyze(&A, &common);
      const double    size   = factor->xsize * sizeof(double);
      cholmod_free_factor(&factor, &common);
      cholmod_finish(&common);
      return size;
    }



    /// With the bytes that it reads, the factor twice.
    void
    Solve(benchmark::State &state)
    {
      Stages          stages(state.range(0));
      FullSystem      plate = stages.plate();
      Eigen::VectorXd x;
      plate.solve(shift, plate.load, x);
      for (auto _ : state)
        plate.solve(shift, plate.load, x);
      count(state, stages);
      state.SetBytesProcessed(state.iterations() * 2 *
                              factor_size(stages.model.stiffness()));
    }



    /// What memory can deliver: the sum of an array of the size of a factor.
    void
    MemoryBandwidth(benchmark::State &state)
    {
      const Eigen::VectorXd array =
        Eigen::VectorXd::Ones(state.range(0) * (1 << 17));
      for (auto _ : state)
        benchmark::DoNotOptimize(array.sum());
      state.SetBytesProcessed(state.iterations() * 8 * array.size());
    }



    /// One more vector after the first hundred.
    void
    RitzVector(benchmark::State &state)
    {
      Stages                   stages(state.range(0));
      FullSystem               plate = stages.plate();
      std::optional<RitzBasis> basis;
      unsigned int             n = 0;
      for (auto _ : state)
        {
          if (n == 0 || n == 110)
            {
              state.PauseTiming();
              basis.emplace(plate, shift);
              basis->grow(n = 100);
              state.ResumeTiming();
            }
          basis->grow(++n);
        }
      count(state, stages);
    }



    void
    step(benchmark::State   &state,
         const Stages       &stages,
         SemidiscreteSystem &plate)
    {
      std::optional<TimeStepper> stepper;
      unsigned int               n = 0;
      for (auto _ : state)
        {
          if (n++ % 1000 == 0)
            {
              state.PauseTiming();
              stepper.emplace(stages.scheme,
                              plate,
                              stages.contact,
                              stages.impactor);
              state.ResumeTiming();
            }
          stepper->advance();
        }
    }



    void
    StepOnTheMesh(benchmark::State &state)
    {
      Stages     stages(state.range(0));
      FullSystem plate = stages.plate();
      step(state, stages, plate);
      count(state, stages);
    }



    void
    StepInRitzVectors(benchmark::State &state)
    {
      Stages     stages(24);
      FullSystem plate = stages.plate();
      RitzBasis  basis(plate, shift);
      basis.grow(state.range(0));
      ReducedSystem reduced(basis, state.range(0));
      step(state, stages, reduced);
    }



    /// The patches of superconvergent recovery.
    void
    RecoveryOperator(benchmark::State &state)
    {
      Stages stages(state.range(0));
      for (auto _ : state)
        benchmark::DoNotOptimize(StressRecovery(*stages.mesh));
      count(state, stages);
    }



    /// A hundred samples in a hundred vectors; the time is that of one.
    void
    EstimatorSample(benchmark::State &state)
    {
      Stages     stages(state.range(0));
      FullSystem plate = stages.plate();
      RitzBasis  basis(plate, shift);
      basis.grow(100);
      ReducedSystem       reduced(basis, 100);
      TimeStepper         stepper(stages.scheme,
                          reduced,
                          stages.contact,
                          stages.impactor);
      std::vector<double> times;
      Eigen::MatrixXd     coordinates(100, 100);
      for (unsigned int sample = 0; sample < 100; ++sample)
        {
          stepper.advance(10);
          times.push_back(stepper.state().time);
          coordinates.col(sample) = stepper.displacement();
        }
      const auto           span = reduced.span(coordinates);
      const StressRecovery recovery(*stages.mesh);
      for (auto _ : state)
        {
          state.PauseTiming();
          EnergyNormEstimator estimator(stages.model, recovery);
          state.ResumeTiming();
          estimator.add_samples(times, span.vectors, span.coordinates);
        }
      count(state, stages);
      state.SetItemsProcessed(state.iterations() * times.size());
    }



    /// Hanging-node refinement of a mesh whose error falls with the distance.
    void
    Adaptation(benchmark::State &state)
    {
      Stages               stages(state.range(0));
      AdaptivityParameters adaptivity = stages.parameters.adaptivity;
      adaptivity.strategy             = AdaptationStrategy::hanging_nodes;
      adaptivity.minimum_cell_size    = 1e-5;
      std::vector<std::string> warnings;
      ErrorRatios              error;
      for (const auto &cell : stages.mesh->active_cell_iterators())
        error.elements.push_back(0.02 / cell->center().norm());
      for (auto _ : state)
        {
          dealii::Triangulation<2> mesh;
          mesh.copy_triangulation(*stages.mesh);
          adapt_mesh({mesh, error, adaptivity, 0., warnings});
        }
      count(state, stages);
    }



    /// The steel case without start-up and files, 1000 steps, with its error.
    void
    whole_scene(benchmark::State &state, const IntegratorType integrator)
    {
      const Parameters parameters = steel_case(state.range(0), integrator);
      for (auto _ : state)
        {
          ImpactAnalysis analysis(parameters);
          analysis.run();
          const CycleResult &result  = analysis.last_cycle().result;
          state.counters["unknowns"] = result.degrees_of_freedom;
          state.counters["solves"]   = result.work.linear_solves;
        }
    }

    void
    SceneWithRitzVectors(benchmark::State &state)
    {
      whole_scene(state, IntegratorType::Ritz_vectors);
    }

    void
    SceneOnTheMesh(benchmark::State &state)
    {
      whole_scene(state, IntegratorType::Newmark);
    }

    void
    per_side(benchmark::internal::Benchmark *benchmark)
    {
      benchmark->Arg(24)->Arg(48)->Arg(96)->Unit(benchmark::kMillisecond);
    }

    BENCHMARK(Assembly)->Apply(per_side);
    BENCHMARK(OrderingAndFactorization)->Apply(per_side);
    BENCHMARK(Factorization)->Apply(per_side);
    BENCHMARK(Solve)->Apply(per_side);
    BENCHMARK(MemoryBandwidth)->Arg(4)->Arg(20)->Arg(100);
    BENCHMARK(RitzVector)->Apply(per_side);
    BENCHMARK(StepOnTheMesh)->Apply(per_side);
    BENCHMARK(StepInRitzVectors)->Arg(25)->Arg(50)->Arg(100)->Arg(200);
    BENCHMARK(RecoveryOperator)->Apply(per_side);
    BENCHMARK(EstimatorSample)->Apply(per_side);
    BENCHMARK(Adaptation)->Apply(per_side);
    BENCHMARK(SceneWithRitzVectors)->Apply(per_side)->Arg(192)->Arg(384);
    BENCHMARK(SceneOnTheMesh)->Apply(per_side);
  } // namespace
} // namespace PlateImpact



int
main(int argc, char **argv)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
