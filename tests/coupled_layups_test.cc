// Lay-ups that are not symmetric, of plates with small deflections.
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    PlateParameters
    unsymmetric_plate(const std::vector<double> &angles,
                      const InPlaneSupport       in_plane)
    {
      PlateParameters plate   = unit_plate(EdgeSupport::simply_supported, 0.05);
      plate.side_lengths      = {{1., 0.8}};
      plate.layup.angles      = angles;
      plate.ply               = {25., 1., 0.25, 0.5, 0.5, 0.2};
      plate.in_plane_supports = {{"", in_plane}};
      plate.is_skew           = PlateSection(plate).is_skew();
      return plate;
    }



    /// Strains of the section, PlateSection::stiffness() of which gives the
    /// energy, by the amplitudes w, theta_x, theta_y, u, v of Navier's solution
    /// for a wave of a plate (Reddy 2004, secs. 6.3 and 6.4): of cross-plies u
    /// = U cos(a x) sin(b y), of angle-plies U sin(a x) cos(b y).
    Eigen::Matrix<double, 8, 5>
    navier_strains(const double a, const double b, const bool is_cross_ply)
    {
      const double                s = is_cross_ply ? -1. : 1.;
      Eigen::Matrix<double, 8, 5> E = Eigen::Matrix<double, 8, 5>::Zero();
      E(0, 1)                       = -a;
      E(1, 2)                       = -b;
      E(2, 1)                       = b;
      E(2, 2)                       = a;
      E(3, 0)                       = a;
      E(3, 1)                       = -1.;
      E(4, 0)                       = b;
      E(4, 2)                       = -1.;
      E(5, 3)                       = s * a;
      E(6, 4)                       = s * b;
      E(7, 3)                       = -s * b;
      E(7, 4)                       = -s * a;
      return E;
    }



    // Antisymmetric cross- and angle-plies, whose edges slide as in Navier's
    // solutions.
    TEST(CoupledLayups, HaveNaviersDeflectionAndFrequency)
    {
      for (const auto &[angles, in_plane] :
           {std::pair<std::vector<double>, InPlaneSupport>{
              {0., 90.},
              InPlaneSupport::held_along},
            {{0., 90., 0., 90.}, InPlaneSupport::held_along},
            {{45., -45.}, InPlaneSupport::held_across},
            {{30., -30., 30., -30.}, InPlaneSupport::held_across}})
        {
          const PlateParameters plate = unsymmetric_plate(angles, in_plane);
          const PlateSection    section(plate);
          const bool is_cross_ply = in_plane == InPlaneSupport::held_along;
          EXPECT_EQ(section.stretching, Stretching::linear);
          EXPECT_EQ(plate.is_skew, !is_cross_ply);
          const double a = numbers::PI / plate.side_lengths[0],
                       b = numbers::PI / plate.side_lengths[1];
          const auto E   = navier_strains(a, b, is_cross_ply);
          const Eigen::Matrix<double, 5, 5> K =
            E.transpose() * section.stiffness() * E;
          Eigen::Matrix<double, 5, 1> mass;
          mass << section.mass_per_area, section.rotary_inertia,
            section.rotary_inertia, section.mass_per_area,
            section.mass_per_area;
          const double frequency =
            std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                        K,
                        mass.asDiagonal().toDenseMatrix())
                        .eigenvalues()[0]) /
            (2. * numbers::PI);
          // under a pressure of the same shape
          const double deflection =
            K.ldlt().solve(Eigen::Matrix<double, 5, 1>::Unit(0))[0];

          const auto          mesh = make_plate_mesh(plate, {{12, 12}});
          const PlateElement  element(ElementType::MITC9, Stretching::linear);
          PlateDiscretization model(*mesh, element, plate);
          model.assemble();
          EffectiveStiffness matrices(model, SolverType::CHOLMOD);
          EXPECT_NEAR(natural_frequencies(matrices, 1)[0] / frequency,
                      1.,
                      1e-3);
          const Eigen::VectorXd load = model.n_parts *
            model.load(pressure_load(*mesh, [&](const Point<2> &p) {
              return std::cos(a * p[0]) * std::cos(b * p[1]);
            }));
          const Eigen::VectorXd z = solve_static(model, load);
          const Eigen::VectorXd at_centre =
            model.load({{Point<2>(), 1. / model.n_parts}});
          EXPECT_NEAR(model.n_parts * at_centre.dot(z) / deflection, 1., 1e-3)
            << angles.size();
        }
    }



    // Curvature and stretch along x at once: what each ply bears follows from
    // its own modulus, and tells the sign of the coupling.
    TEST(CoupledLayups, StressesAreThoseOfThePlies)
    {
      const PlateParameters plate =
        unsymmetric_plate({0., 90.}, InPlaneSupport::sliding);
      const PlateSection section(plate);
      const double       t = plate.thickness, curvature = 0.3, stretch = 0.01;
      Eigen::VectorXd    strains = Eigen::VectorXd::Zero(8);
      strains[0]                 = curvature;
      strains[5]                 = stretch;
      const Eigen::MatrixXd stresses =
        section.stresses(section.stiffness() * strains);
      // the upper ply, on the struck side, is stretched where M compresses
      const double minor = plate.ply.poissons_ratio *
        plate.ply.transverse_modulus / plate.ply.longitudinal_modulus,
                   share = 1. / (1. - minor * plate.ply.poissons_ratio);
      EXPECT_NEAR(stresses(0, 0) /
                    (share * plate.ply.longitudinal_modulus *
                     (stretch + 0.5 * curvature * t)),
                  1.,
                  1e-10);
      EXPECT_NEAR(stresses(1, 1) /
                    (share * plate.ply.transverse_modulus *
                     std::max(stretch,
                              std::abs(stretch - 0.5 * curvature * t))),
                  1.,
                  1e-10);
    }



    // Equal wave speeds of bending and stretching along x, which the coupling
    // parts: (Q_11 + Q_22) / 2 and sqrt(12) / 8 (Q_11 - Q_22) over the density.
    TEST(CoupledLayups, WavesOfBendingAndStretchingAreCoupled)
    {
      const PlateParameters plate =
        unsymmetric_plate({0., 90.}, InPlaneSupport::sliding);
      const double minor = plate.ply.poissons_ratio *
        plate.ply.transverse_modulus / plate.ply.longitudinal_modulus,
                   share  = 1. / (1. - minor * plate.ply.poissons_ratio);
      const double along  = share * plate.ply.longitudinal_modulus,
                   across = share * plate.ply.transverse_modulus;
      EXPECT_NEAR(PlateSection(plate).fastest_wave() /
                    std::sqrt((0.5 * (along + across) +
                               std::sqrt(12.) / 8. * (along - across)) /
                              plate.density),
                  1.,
                  1e-10);
    }



    class CoupledLayupsRun : public Program
    {};

    // What a lay-up does not do on its own, it does when it is not symmetric:
    // edges that are held in the plane make it stiffer.
    TEST_F(CoupledLayupsRun, EdgesMatter)
    {
      const auto frequency = [this](const std::string &more) {
        EXPECT_EQ(run(SCENES "/laminate-unsymmetric.prm",
                      "--set Impactor/Shape=none --set 'Output/Natural "
                      "frequencies=1' --set 'Discretization/Initial cells=8, "
                      "8'" +
                        more),
                  0)
          << err;
        return last_cycle()["natural_frequencies"][0].get<double>();
      };
      const std::string held      = " --set 'Plate/In-plane support=held'",
                        symmetric = " --set Plate/Layup=0/90/0/90/0s";
      const double sliding        = frequency("");
      EXPECT_GT(frequency(held), 1.05 * sliding);
      EXPECT_GT(frequency(symmetric), 1.2 * sliding);
      EXPECT_EQ(frequency(symmetric), frequency(symmetric + held));
    }



    // Supports that leave some motions in the plane as a rigid body, which are
    // not taken for vibrations: a shift, a turn of a round plate.
    TEST_F(CoupledLayupsRun, PlatesMayMoveInTheirPlane)
    {
      const std::string loose =
        " --set 'Plate/Loss factor=0.01' --set 'Discretization/Initial "
        "cells=6, 6' --set Adaptivity/Strategy=none --set 'Output/Natural "
        "frequencies=2' --set 'Time/End time=2e-5' --set 'Plate/Impact "
        "point=0.005, 0.003' ";
      for (const std::string support :
           {"--set 'Plate/In-plane support=held across, sliding'",
            "--set 'Plate/In-plane support=sliding, held across'",
            "--set 'Plate/In-plane support=held along, sliding'",
            "--set 'Plate/In-plane support=sliding'",
            "--set 'Plate/In-plane support=held across' --set "
            "Plate/Outline=circle --set 'Plate/Side lengths=0.1, 0.1' --set "
            "Plate/Layup=45/-45"})
        {
          ASSERT_EQ(run(SCENES "/laminate-unsymmetric.prm", loose + support), 0)
            << support << err;
          const auto frequencies = last_cycle()["natural_frequencies"];
          ASSERT_EQ(frequencies.size(), 2) << support << err;
          EXPECT_GT(frequencies[0], 100.) << support;
        }
    }
  } // namespace
} // namespace PlateImpact
