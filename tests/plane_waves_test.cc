// Plane bending waves on an endless mesh of squares: Bloch's theorem makes one
// cell of it.
#include <deal.II/grid/grid_generator.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/scene/scene.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Square of the frequency of bending waves on a Mindlin plate.
    double
    exact_square(const PlateSection &section, const double wave_number)
    {
      const double k2 = wave_number * wave_number,
                   D  = section.mean_bending_stiffness(),
                   S  = section.mean_shear_stiffness(),
                   m = section.mass_per_area, I = section.rotary_inertia,
                   b = m * (D * k2 + S) + I * S * k2;
      return (b - std::sqrt(b * b - 4. * m * I * S * D * k2 * k2)) /
        (2. * m * I);
    }



    /// Relative errors of the square of the frequency.
    struct WaveErrors
    {
      double consistent; ///< with the consistent mass
      double error;      ///< with the element's mass
    };

    WaveErrors
    wave_errors(const ElementType type,
                const double      thickness,
                const double      cells_per_wave,
                const double      angle)
    {
      Triangulation<2> mesh;
      GridGenerator::hyper_cube(mesh);
      const PlateElement element(type, Stretching::none, PlateMass::of_waves);
      const PlateDiscretization model(mesh,
                                      element,
                                      unit_plate(EdgeSupport::free, thickness),
                                      1.);
      AffineConstraints<double> constraints;
      element.add_internal_constraints(model.dof_handler(), constraints);
      constraints.close();

      // nodes by those at the lower left, the middle of the sides and the
      // centre, up to a phase
      const auto      &fe = element.finite_element;
      const double     k  = 2. * numbers::PI / cells_per_wave;
      const int        n  = fe.n_dofs_per_cell();
      Eigen::MatrixXcd of_nodes =
        Eigen::MatrixXcd::Zero(n, 4 * fe.n_components());
      for (int i = 0; i < n; ++i)
        {
          const auto [component, node] = fe.system_to_component_index(i);
          const Point<2> p = element.scalar_element.unit_support_point(node);
          const int      column =
            4 * component + (p[0] == 0.5 ? 1 : 0) + (p[1] == 0.5 ? 2 : 0);
          of_nodes(i, column) =
            std::polar(1.,
                       k *
                         (std::floor(p[0]) * std::cos(angle) +
                          std::floor(p[1]) * std::sin(angle)));
        }
      std::vector<types::global_dof_index> dofs(n);
      model.dof_handler().begin_active()->get_dof_indices(dofs);
      const auto local = [&](const types::global_dof_index dof) {
        return std::find(dofs.begin(), dofs.end(), dof) - dofs.begin();
      };
      std::vector<Eigen::Index> used;
      for (int i = 0; i < n; ++i)
        if (constraints.is_constrained(dofs[i]))
          {
            of_nodes.row(i).setZero();
            for (const auto &[dof, weight] :
                 *constraints.get_constraint_entries(dofs[i]))
              of_nodes.row(i) += weight * of_nodes.row(local(dof));
          }
      for (Eigen::Index column = 0; column < of_nodes.cols(); ++column)
        if (of_nodes.col(column).norm() > 0.)
          used.push_back(column);
      const Eigen::MatrixXcd T = of_nodes(Eigen::all, used);

      const auto square = [&](const Eigen::MatrixXd &mass) {
        const Eigen::MatrixXcd K = T.adjoint() *
          element.stiffness(model.shape(0), model.section) * T,
                               M = T.adjoint() * mass * T;
        return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd>(
                 K,
                 M,
                 Eigen::EigenvaluesOnly)
          .eigenvalues()[0];
      };
      const auto error = [&](const PlateElement &of_mass) {
        return square(of_mass.mass(model.shape(0), model.section)) /
          exact_square(model.section, k) -
          1.;
      };
      return {error(PlateElement(type)), error(element)};
    }



    TEST(PlaneWaves, HaveTheirFrequencyInAnyDirection)
    {
      for (const ElementType type : {ElementType::MITC9,
                                     ElementType::Lagrange,
                                     ElementType::heterosis,
                                     ElementType::serendipity})
        // of one cell
        for (const double thickness : {0.3, 1.})
          for (const double degrees : {0., 10., 22.5, 30., 45., 60., 90.})
            {
              const WaveErrors of_wave =
                wave_errors(type, thickness, 8., degrees * numbers::PI / 180.);
              EXPECT_LT(std::abs(of_wave.error), 2e-4)
                << thickness << " " << degrees;
              EXPECT_LT(std::abs(of_wave.error), 0.5 * of_wave.consistent)
                << thickness << " " << degrees;
            }
      for (const double degrees : {0., 22.5, 45.})
        {
          const WaveErrors of_wave = wave_errors(ElementType::MITC9,
                                                 0.1,
                                                 6.,
                                                 degrees * numbers::PI / 180.);
          EXPECT_LT(std::abs(of_wave.error), 0.2 * of_wave.consistent);
          const std::string angle = std::to_string(std::lround(degrees));
          RecordProperty("consistent, " + angle,
                         std::to_string(of_wave.consistent));
          RecordProperty("error, " + angle, std::to_string(of_wave.error));
        }
    }



    TEST(PlaneWaves, LoseTheErrorOfFourthOrder)
    {
      const auto errors = [](const double n, const double degrees) {
        return wave_errors(ElementType::MITC9,
                           0.1,
                           n,
                           degrees * numbers::PI / 180.);
      };
      const WaveErrors coarse = errors(5., 0.), fine = errors(10., 0.),
                       diagonal = errors(10., 45.);
      EXPECT_NEAR(std::log2(coarse.consistent / fine.consistent), 4., 0.2);
      EXPECT_GT(std::log2(coarse.error / fine.error), 5.5);
      // a part depends on Poisson's ratio
      EXPECT_LT(std::abs(diagonal.error), 0.15 * diagonal.consistent);
    }



    /// Peak force of a light ball on equal cells. [N]
    double
    early_peak(const PlateMass mass, const unsigned int n_cells)
    {
      const std::string n = std::to_string(n_cells);
      Parameters        parameters =
        read_scene(SCENES "/sphere-on-steel-plate.prm",
                   {"Plate/Thickness=0.003",
                    "Impactor/Radius=0.005",
                    "Impactor/Velocity=2",
                    "Time/Time step=4e-7",
                    "Time/End time=4e-5",
                    "Adaptivity/Strategy=none",
                    "Discretization/Initial cells=" + n + "," + n})
          .parameters;
      EXPECT_EQ(parameters.discretization.mass, PlateMass::consistent);
      parameters.discretization.mass = mass;
      ImpactAnalysis analysis(parameters);
      analysis.run();
      return analysis.last_cycle().result.history->peak().force;
    }



    TEST(PlaneWaves, ThatLeaveTheContactNeedTheConsistentMass)
    {
      // they feel the root of stiffness times mass, and the stiffness is too
      // large
      const double force      = early_peak(PlateMass::consistent, 60),
                   consistent = early_peak(PlateMass::consistent, 10) / force,
                   of_waves   = early_peak(PlateMass::of_waves, 10) / force;
      EXPECT_GT(consistent, 1.);
      EXPECT_GT(of_waves, consistent + 0.002);
      RecordProperty("consistent", std::to_string(consistent - 1.));
      RecordProperty("of waves", std::to_string(of_waves - 1.));
    }



    TEST(PlaneWaves, KeepTheirFrequencyUnderHeavyImpactors)
    {
      const auto mass = [](const std::string &kilograms,
                           const std::string &more = "Time/End time=0") {
        return read_scene(SCENES "/sphere-on-steel-plate.prm",
                          {"Impactor/Mass=" + kilograms, more})
          .parameters.discretization.mass;
      };
      // the plate has 2.51 kg
      EXPECT_EQ(mass("1.2"), PlateMass::consistent);
      EXPECT_EQ(mass("1.3"), PlateMass::of_waves);
      // nothing has come back, or can be counted on to
      EXPECT_EQ(mass("1.3", "Time/End time=5e-5"), PlateMass::consistent);
      EXPECT_EQ(mass("1.3", "Time/End time=5e-3"), PlateMass::of_waves);
    }
  } // namespace
} // namespace PlateImpact
