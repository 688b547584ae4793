// The dual problem of the peak force: what displacements weigh in it, and the
// motions that belong together.
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/transient/loaded_plate.h"
#include "plate_impact/transient/plate_model.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace PlateImpact
{
  namespace
  {
    TimeParameters
    twenty_seconds()
    {
      TimeParameters time = {};
      time.end_time       = 20.;
      time.time_step      = 0.02;
      time.newmark_beta   = 0.25;
      time.newmark_gamma  = 0.5;
      return time;
    }



    PlateParameters
    plate_of_modulus(const double factor)
    {
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.1);
      plate.youngs_modulus *= factor;
      return plate;
    }



    /// A unit plate, its system and its response.
    struct Responding
    {
      Responding(const double modulus, const NewmarkScheme &scheme)
        : mesh(unit_square(4))
        , element(ElementType::MITC9)
        , model(*mesh, element, plate_of_modulus(modulus), 1.)
        , system(std::make_shared<EffectiveStiffness>(assembled(model),
                                                      SolverType::CHOLMOD),
                 model.load({{dealii::Point<2>(0.5, 0.5), 1.}}))
        , response(scheme, system)
      {}

      ContactHistory
      strike(const Contact       &contact,
             const Impactor      &impactor,
             const NewmarkScheme &scheme)
      {
        TimeStepper stepper(scheme,
                            system,
                            contact,
                            impactor,
                            std::make_unique<PlateResponse>(response));
        stepper.advance(scheme.n_steps);
        return stepper.impact().history;
      }

      static PlateDiscretization &
      assembled(PlateDiscretization &model)
      {
        model.assemble();
        return model;
      }

      const std::unique_ptr<dealii::Triangulation<2>> mesh;
      const PlateElement                              element;
      PlateDiscretization                             model;
      FullSystem                                      system;
      const PlateResponse                             response;
    };



    TEST(PeakForceDual, WeightsPredictTheChangeOfThePeak)
    {
      const auto law          = std::make_shared<HertzLaw>(10.);
      const auto yielding_law = std::make_shared<YieldingLaw>(10., 0.01, 0.5);
      const Contact hertz(law), series(law, -0.01),
        soft(std::make_shared<HertzLaw>(0.1)),
        yielding(yielding_law, 0., plastic_unloading(yielding_law));
      for (const auto choice :
           {ForceIntegration::energy_conserving, ForceIntegration::collocation})
        for (const Contact *contact : {&hertz, &soft, &series, &yielding})
          for (const double mass : {0.01, 1., 100.})
            {
              const NewmarkScheme scheme(twenty_seconds(), choice);
              Responding          plate(1., scheme), stiffer(1. + 1e-6, scheme);
              const Impactor      impactor{mass, 0., 0.5};
              const ContactHistory before =
                                     plate.strike(*contact, impactor, scheme),
                                   after =
                                     stiffer.strike(*contact, impactor, scheme);
              const auto [phi, mu] =
                dual_loads(before, scheme, *contact, impactor, plate.response);
              double predicted = 0.;
              for (Eigen::Index n = 0; n < phi.size(); ++n)
                for (Eigen::Index k = 0; k <= n; ++k)
                  predicted -= mu[n] * phi[k] *
                    (stiffer.response.displacement(n - k) -
                     plate.response.displacement(n - k));
              // what a dent changes of later contacts the weights leave out
              if (contact == &yielding && before.n_contacts() > 1)
                continue;
              // at the same step, where the peak has not moved yet
              const double change = after.states[phi.size()].force -
                before.states[phi.size()].force;
              EXPECT_GT(std::abs(change), 1e-9 * before.peak().force);
              EXPECT_NEAR(predicted / change, 1., 3e-3)
                << mass << ' ' << before.n_contacts();
            }
    }



    TEST(PeakForceDual, MotionsBelongTogether)
    {
      // M = 0 would make the sum of products with K that of the response; with
      // inertia it is the work of both: sum_n mu_n w_n by one motion alone
      const NewmarkScheme scheme(twenty_seconds(),
                                 ForceIntegration::energy_conserving);
      Responding          plate(1., scheme);
      Eigen::VectorXd     phi(61), mu(61);
      for (Eigen::Index n = 0; n < phi.size(); ++n)
        {
          phi[n] = std::pow(std::sin(0.05 * n), 2);
          mu[n]  = 0.02 * n;
        }
      const DualMotions all =
        dual_motions({phi, mu}, scheme, plate.system, 1000);
      const DualMotions some =
        dual_motions({phi, mu}, scheme, plate.system, 20);
      EXPECT_EQ(all.weight, 1.);
      EXPECT_EQ(some.weight, 4.);
      const auto products = [&](const DualMotions &motions) {
        double sum = 0.;
        for (Eigen::Index c = 0; c < motions.motion.cols(); ++c)
          sum += motions.motion.col(c).dot(
            multiply(plate.model.stiffness(), motions.dual.col(c)));
        return motions.weight * sum;
      };
      EXPECT_NEAR(products(some) / products(all), 1., 0.02);
    }



    /// w of a motion at the vertices of a mesh, a column per time.
    Eigen::MatrixXd
    deflections(const PlateDiscretization &plate, const Eigen::MatrixXd &motion)
    {
      const auto     &vertices = plate.mesh().get_vertices();
      Eigen::MatrixXd result(vertices.size(), motion.cols());
      for (std::size_t v = 0; v < vertices.size(); ++v)
        result.row(v) = plate.load({{vertices[v], 1.}}).transpose() * motion;
      return result;
    }



    /// Columns as text, each over its largest number, in thousandths.
    std::string
    in_thousandths(const Eigen::MatrixXd &columns)
    {
      nlohmann::json text;
      for (const auto &column : columns.colwise())
        {
          const Eigen::VectorXi digits =
            (1000. / column.lpNorm<Eigen::Infinity>() * column)
              .array()
              .round()
              .cast<int>();
          text.push_back(std::vector<int>(digits.begin(), digits.end()));
        }
      return text.dump();
    }



    /// The plate of lesson 10 without what waves do not reach by the time of
    /// the peak, on equal cells: both motions, and what the cells contribute at
    /// each time.
    TEST(PeakForceDual, LessonTenWaves)
    {
      const Parameters scene =
        read_scene(SCENES "/course/10-meshes-for-a-number.prm",
                   {"Plate/Side lengths=0.08, 0.08",
                    "Discretization/Initial cells=32, 32",
                    "Time/End time=15e-6",
                    "Time/Time step=0.1e-6"})
          .parameters;
      PlateModel        plate(scene.plate,
                       scene.discretization,
                       make_plate_mesh(scene.plate,
                                       scene.discretization.initial_cells));
      const LoadedPlate loaded  = plate.under(scene, true);
      const auto        history = loaded.strike().history;
      const auto        problem = loaded.peak_force_problem(history);
      ASSERT_TRUE(problem);
      const auto          &mesh     = plate.discretization().mesh();
      const DualMotions   &motions  = problem->motions;
      const unsigned int   n_frames = 24;
      const StressRecovery recovery(mesh);
      Eigen::MatrixXd      motion(motions.motion.rows(), n_frames),
        dual(motions.dual.rows(), n_frames),
        cells(mesh.n_active_cells(), n_frames);
      std::vector<double> sums;
      for (unsigned int i = 0; i < n_frames; ++i)
        {
          // at rest is the plate at the first time, and the dual at the last
          const Eigen::Index at =
            1 + i * (motions.motion.cols() - 3) / (n_frames - 1);
          motion.col(i) = motions.motion.col(at);
          dual.col(i)   = motions.dual.col(at);
          const DualWeightedErrors errors =
            dual_weighted_errors(plate.discretization(),
                                 recovery,
                                 *problem->system,
                                 {motion.col(i), dual.col(i), 1.});
          cells.col(i) = errors.cells / history.peak().force;
          sums.push_back(cells.col(i).lpNorm<1>());
        }
      // at the beginning the plate is at rest
      EXPECT_LT(sums.front(),
                0.1 * *std::max_element(sums.begin(), sums.end()));

      record("time of the peak", history.peak().time);
      nlohmann::json vertices;
      for (const auto &vertex : mesh.get_vertices())
        vertices.push_back({vertex[0], vertex[1]});
      nlohmann::json centers;
      for (const auto &cell : mesh.active_cell_iterators())
        centers.push_back({cell->center()[0], cell->center()[1]});
      RecordProperty("vertices", vertices.dump());
      RecordProperty("centers", centers.dump());
      RecordProperty("motion",
                     in_thousandths(
                       deflections(plate.discretization(),
                                   problem->system->unknowns(motion))));
      RecordProperty("dual",
                     in_thousandths(
                       deflections(plate.discretization(),
                                   problem->system->unknowns(dual))));
      // logarithms to base ten of the sizes over the largest of all
      const Eigen::MatrixXd decades =
        (cells.cwiseAbs() / cells.lpNorm<Eigen::Infinity>())
          .cwiseMax(1e-6)
          .array()
          .log10();
      nlohmann::json contributed;
      for (const auto &column : decades.colwise())
        {
          nlohmann::json of_cells;
          for (const double value : column)
            of_cells.push_back(std::round(100. * value) / 100.);
          contributed.push_back(of_cells);
        }
      RecordProperty("cells", contributed.dump());
    }
  } // namespace
} // namespace PlateImpact
