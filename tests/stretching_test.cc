#include "plate_impact/plate/large_deflection.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/large_deflection_stepper.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>

// Plates that stretch: lay-ups that are not symmetric, and large deflections.
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
          EXPECT_EQ(section.stretching(), Stretching::linear);
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
          const Eigen::VectorXd load = model.n_parts() *
            model.load(pressure_load(*mesh, [&](const Point<2> &p) {
              return std::cos(a * p[0]) * std::cos(b * p[1]);
            }));
          const Eigen::VectorXd z = solve_static(model, load);
          const Eigen::VectorXd at_centre =
            model.load({{Point<2>(), 1. / model.n_parts()}});
          EXPECT_NEAR(model.n_parts() * at_centre.dot(z) / deflection, 1., 1e-3)
            << angles.size();
        }
    }



    /// The state under a load and what it takes of the plate, by Newton's
    /// method from a state nearby.
    void
    find_equilibrium(const PlateDiscretization &model,
                     const Eigen::VectorXd     &load,
                     Eigen::VectorXd           &z)
    {
      const LargeDeflection large(model);
      for (unsigned int iteration = 0; iteration < 40; ++iteration)
        {
          const StretchedPlate  state    = large.stretched(z);
          const Eigen::VectorXd residual = load -
            multiply(model.stiffness(), z) - large.mean_forces(state, state);
          if (residual.norm() < 1e-10 * load.norm())
            return;
          const auto tangent = large.tangent(state, state, 0., true);
          Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(
            Eigen::SparseMatrix<double>(as_eigen(*tangent)));
          z += solver.solve(residual);
        }
      FAIL() << "no equilibrium";
    }



    PlateParameters
    plate_with_large_deflection(const EdgeSupport    support,
                                const InPlaneSupport in_plane,
                                const double         thickness)
    {
      PlateParameters plate   = unit_plate(support, thickness);
      plate.deflection        = DeflectionTheory::large;
      plate.in_plane_supports = {{"", in_plane}};
      return plate;
    }



    /// Deflections at the centre, over the thickness, under pressures that
    /// grow.
    std::vector<double>
    static_deflections(const PlateParameters     &plate,
                       const std::vector<double> &pressures,
                       const unsigned int         n_cells,
                       const ElementType          type = ElementType::MITC9)
    {
      const auto          mesh = make_plate_mesh(plate, {{n_cells, n_cells}});
      const PlateElement  element(type, Stretching::large);
      PlateDiscretization model(*mesh, element, plate);
      model.assemble();
      const Eigen::VectorXd of_unit = model.n_parts() *
        model.load(pressure_load(*mesh, [](const Point<2> &) { return 1.; }));
      const Eigen::VectorXd at_centre = model.load({{Point<2>(), 1.}});
      Eigen::VectorXd       z         = Eigen::VectorXd::Zero(of_unit.size());
      std::vector<double>   result;
      for (const double pressure : pressures)
        {
          find_equilibrium(model, pressure * of_unit, z);
          result.push_back(at_centre.dot(z) / plate.thickness);
        }
      return result;
    }



    // CalculiX and von Karman's equations, of a clamped circular plate.
    TEST(LargeDeflections, OfACircularPlateAreThoseOfTheReference)
    {
      PlateParameters plate = plate_with_large_deflection(EdgeSupport::clamped,
                                                          InPlaneSupport::held,
                                                          1. / 120.);
      plate.outline.shape   = PlateOutline::circle;
      const double        unit  = std::pow(plate.thickness, 4) / 0.0625;
      const auto          given = reference("stretch_static.json")["rows"];
      std::vector<double> pressures;
      for (const auto &row : given)
        pressures.push_back(row["Q"].get<double>() * unit);
      const auto deflections = static_deflections(plate, pressures, 12);
      for (std::size_t i = 0; i < given.size(); ++i)
        EXPECT_NEAR(deflections[i] / given[i]["von_karman"].get<double>(),
                    1.,
                    0.005);
    }



    // Ritz's method with polynomials (tests/stretch/ritz.py), to two
    // thicknesses with edges that are held and to four with those that slide.
    TEST(LargeDeflections, OfSquarePlatesAreThoseOfRitz)
    {
      for (const auto &given : reference("stretch_square.json"))
        for (const ElementType type : all_elements())
          {
            const PlateParameters plate =
              plate_with_large_deflection(given["support"] == "clamped" ?
                                            EdgeSupport::clamped :
                                            EdgeSupport::simply_supported,
                                          given["in_plane"] == "held" ?
                                            InPlaneSupport::held :
                                            InPlaneSupport::sliding,
                                          given["thickness"]);
            std::vector<double> pressures;
            for (const double load : given["load"])
              pressures.push_back(load * std::pow(plate.thickness, 4));
            const auto deflections =
              static_deflections(plate, pressures, 8, type);
            // it locks in shear, on a linear plate too
            const double tolerance =
              type == ElementType::serendipity_full ? 0.015 : 0.005;
            for (std::size_t i = 0; i < pressures.size(); ++i)
              EXPECT_NEAR(deflections[i] / given["deflection"][i].get<double>(),
                          1.,
                          tolerance)
                << given["support"] << given["in_plane"] << i << ' ' << type;
          }
    }



    /// Unit square with the origin at its corner, no symmetry.
    struct BentStrip
    {
      BentStrip(const ElementType type, const double distortion)
        : mesh(unit_square(4))
        , element(type, Stretching::large)
      {
        if (distortion > 0.)
          distort(*mesh, distortion);
        model = std::make_unique<PlateDiscretization>(
          *mesh,
          element,
          plate_with_large_deflection(EdgeSupport::free,
                                      InPlaneSupport::sliding,
                                      0.01),
          1.);
        model->assemble();
      }

      std::unique_ptr<Triangulation<2>>    mesh;
      const PlateElement                   element;
      std::unique_ptr<PlateDiscretization> model;
    };

    class StretchedField : public Function<2>
    {
    public:
      using Values = std::array<double, 5>;
      explicit StretchedField(
        const std::function<Values(const Point<2> &)> &field)
        : Function<2>(5)
        , field(field)
      {}

      double
      value(const Point<2> &point, const unsigned int component) const override
      {
        return field(point)[component];
      }

    private:
      const std::function<Values(const Point<2> &)> field;
    };



    // The patch: a rotation as a rigid body, whose slopes are large, strains
    // nothing; a slope beside a stretch has von Karman's strains; on any mesh.
    TEST(LargeDeflections, SlopesAndStretchesPassThePatch)
    {
      for (const ElementType type : all_elements())
        for (const double distortion : {0., 0.2})
          {
            const BentStrip       strip(type, distortion);
            const LargeDeflection large(*strip.model);
            const double          wx = 0.03, wy = -0.02, e = 1e-3;
            const Eigen::VectorXd z =
              strip.model->interpolate(StretchedField([&](const Point<2> &p) {
                // u takes back what the slopes stretch, but for e along x
                return StretchedField::Values{
                  {wx * p[0] + wy * p[1],
                   wx,
                   wy,
                   (e - 0.5 * wx * wx) * p[0] - wx * wy * p[1],
                   -0.5 * wy * wy * p[1]}};
              }));
            const double energy =
              0.5 * z.dot(multiply(strip.model->stiffness(), z)) +
              large.stretched(z).energy;
            EXPECT_NEAR(energy /
                          (0.5 * e * e *
                           strip.model->section().membrane_stiffness(0, 0)),
                        1.,
                        1e-9)
              << type;
          }
    }



    // A plate that is bent to a cylinder with edges that slide has no membrane
    // forces, on any thickness: the squares of slopes, which are of a higher
    // degree than strains in the plane, do not lock.
    TEST(LargeDeflections, BendingToACylinderDoesNotLock)
    {
      const BentStrip       strip(ElementType::MITC9, 0.);
      const LargeDeflection large(*strip.model);
      const double          curvature = 0.1;
      Eigen::VectorXd       z =
        strip.model->interpolate(StretchedField([&](const Point<2> &p) {
          const double x = p[0] - 0.5;
          return StretchedField::Values{
            {0.5 * curvature * x * x, curvature * x, 0., 0., 0.}};
        }));
      // relaxed in the plane, with a little stiffness against rigid motions
      const auto      K     = as_eigen(strip.model->stiffness());
      const double    rigid = 1e-9;
      Eigen::VectorXd in_plane =
        strip.model->interpolate(StretchedField([](const Point<2> &) {
          return StretchedField::Values{{0., 0., 0., 1., 1.}};
        }));
      const double                        before = large.stretched(z).energy;
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index row = 0; row < K.outerSize(); ++row)
        for (decltype(K)::InnerIterator entry(K, row); entry; ++entry)
          if (in_plane[row] != 0. && in_plane[entry.col()] != 0.)
            entries.emplace_back(row, entry.col(), entry.value());
      for (Eigen::Index row = 0; row < K.outerSize(); ++row)
        entries.emplace_back(row, row, in_plane[row] != 0. ? rigid : 1.);
      Eigen::SparseMatrix<double> A(K.rows(), K.cols());
      A.setFromTriplets(entries.begin(), entries.end());
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
      for (unsigned int iteration = 0; iteration < 3; ++iteration)
        {
          const StretchedPlate  state = large.stretched(z);
          const Eigen::VectorXd residual =
            -(multiply(strip.model->stiffness(), z) +
              large.mean_forces(state, state));
          z += solver.solve(residual.cwiseProduct(in_plane));
        }
      const StretchedPlate  state    = large.stretched(z);
      const Eigen::VectorXd u        = z.cwiseProduct(in_plane);
      const double          membrane = state.energy + 0.5 * u.dot(K * u);
      EXPECT_GT(before, 0.);
      EXPECT_LT(membrane, 1e-10 * before);
    }



    // The tangent is the derivative of the forces, and these that of the
    // energy; a change does the work of the mean forces.
    TEST(LargeDeflections, TangentForcesAndEnergyBelongTogether)
    {
      for (const ElementType type : all_elements())
        {
          const BentStrip            strip(type, 0.15);
          const PlateDiscretization &model = *strip.model;
          const LargeDeflection      large(model);
          Eigen::VectorXd z(model.n_unknowns()), d(model.n_unknowns());
          for (Eigen::Index i = 0; i < z.size(); ++i)
            {
              z[i] = 0.01 * std::sin(3. * i);
              d[i] = 0.01 * std::cos(5. * i);
            }
          const auto energy = [&](const Eigen::VectorXd &x) {
            return 0.5 * x.dot(multiply(model.stiffness(), x)) +
              large.stretched(x).energy;
          };
          const auto forces = [&](const Eigen::VectorXd &from,
                                  const Eigen::VectorXd &to) {
            return (multiply(model.stiffness(), 0.5 * (from + to)) +
                    large.mean_forces(large.stretched(from),
                                      large.stretched(to)))
              .eval();
          };
          const double work = forces(z, z + d).dot(d);
          EXPECT_NEAR(work, energy(z + d) - energy(z), 1e-11 * energy(z + d));
          const double          h = 1e-4;
          const Eigen::VectorXd K_d =
            (forces(z + h * d, z + h * d) - forces(z - h * d, z - h * d)) /
            (2. * h);
          const StretchedPlate state   = large.stretched(z);
          const auto           tangent = large.tangent(state, state, 0., true);
          EXPECT_LT((multiply(*tangent, d) - K_d).norm(), 1e-6 * K_d.norm())
            << type;
        }
    }



    /// The ratio of the frequencies of a simply supported square plate that
    /// swings at its centre to an amplitude of so many
    /// thicknesses, and that of a small one; and the amplitude.
    std::pair<double, double>
    frequency_ratio(const double impulse)
    {
      const PlateParameters plate =
        plate_with_large_deflection(EdgeSupport::simply_supported,
                                    InPlaneSupport::held,
                                    0.01);
      const auto          mesh = make_plate_mesh(plate, {{6, 6}});
      const PlateElement  element(ElementType::MITC9, Stretching::large);
      PlateDiscretization model(*mesh, element, plate);
      model.assemble();
      EffectiveStiffness matrices(model, SolverType::CHOLMOD);
      const double       period = 1. / natural_frequencies(matrices, 1)[0];
      // struck in the shape of its first mode, which it then keeps
      const Eigen::VectorXd load = model.n_parts() *
        model.load(pressure_load(*mesh, [](const Point<2> &p) {
          return std::cos(numbers::PI * p[0]) * std::cos(numbers::PI * p[1]);
        }));
      const Eigen::VectorXd at_centre = model.load({{Point<2>(), 1.}});
      TimeParameters        time;
      time.newmark_beta  = 0.25;
      time.newmark_gamma = 0.5;
      time.end_time      = 2. * period;
      time.time_step     = period / 400.;
      const NewmarkScheme    scheme(time);
      LargeDeflectionStepper stepper(scheme, matrices, load);
      double                 before = 0., amplitude = 0., first = 0., last = 0.;
      for (unsigned int step = 1; step <= scheme.n_steps; ++step)
        {
          stepper.begin_step(0.);
          const double force = step == 1 ? impulse / scheme.dt : 0.;
          while (stepper.end_step(force, force))
            ;
          const double w = at_centre.dot(stepper.unknowns());
          amplitude      = std::max(amplitude, w / plate.thickness);
          if (before > 0. && w <= 0. && last == 0.)
            (first == 0. ? first : last) =
              scheme.dt * (step - 1. + before / (before - w));
          before = w;
        }
      return {period / (last - first), amplitude};
    }



    // Chu & Herrmann, J. Appl. Mech. 23 (1956) 532-540: edges that are held
    // across, one mode w, and the displacements in the plane that belong to it
    // make w'' + (1 + mu (w/h)^2) w = 0, mu = 3/8 (3 - nu^2 + 2 nu) of a square
    // plate. Its period by the arithmetic-geometric mean; 1.4024 at one
    // thickness is their number too.
    TEST(LargeDeflections, FrequencyGrowsWithTheAmplitude)
    {
      const double nu = 0.3, mu = 0.375 * (3. - nu * nu + 2. * nu);
      const auto   by_duffing = [=](const double amplitude) {
        const double m = mu * amplitude * amplitude;
        double       x = std::sqrt(1. + m), y = std::sqrt(1. + 0.5 * m);
        for (unsigned int i = 0; i < 8; ++i)
          std::tie(x, y) = std::make_pair(0.5 * (x + y), std::sqrt(x * y));
        return x;
      };
      EXPECT_NEAR(by_duffing(1.), 1.4024, 5e-5);
      for (const double impulse : {0.2, 0.5, 1., 1.4})
        {
          const auto [ratio, amplitude] = frequency_ratio(6e-6 * impulse);
          EXPECT_NEAR(ratio / by_duffing(amplitude), 1., 0.01)
            << "at " << amplitude << " thicknesses";
          record("ratio at " + std::to_string(amplitude), ratio);
        }
    }



    /// Whole impacts, by the program.
    class StretchedPlates : public Program
    {
    protected:
      const std::string coarse = " --set 'Adaptivity/Strategy=none'"
                                 " --set 'Discretization/Initial cells=4, 4'";

      /// The main scene on a thin plate that stretches.
      int
      run_large(const std::string &more)
      {
        return run(SCENES "/sphere-on-steel-plate.prm",
                   "--set Plate/Deflection=large --set Plate/Thickness=0.002 " +
                     coarse + more);
      }
    };



    // Axisymmetric elements of high order; the forces sit on ripples.
    TEST_F(StretchedPlates, AreThoseOfTheReference)
    {
      for (const auto &given : reference("stretch_cases.json"))
        for (const std::string theory : {"large", "linear"})
          {
            const auto       &plate = given["plate"], &ball = given["impactor"];
            const std::string scene = SCENES "/aluminium-sheet.prm";
            std::string       text;
            const auto        set = [&text](const std::string    &path,
                                     const nlohmann::json &value) {
              text += " --set \"" + path + "=" + value.dump() + "\"";
            };
            set("Plate/Thickness", plate["thickness"]);
            set("Plate/Young's modulus", plate["E"]);
            set("Plate/Poisson's ratio", plate["nu"]);
            set("Plate/Density", plate["rho"]);
            set("Contact/Patch radius", plate["patch_radius"]);
            set("Impactor/Radius", ball["radius"]);
            set("Impactor/Mass", ball["mass"]);
            set("Impactor/Velocity", given["velocity"]);
            set("Time/End time", given["end_time"]);
            const double diameter = 2. * plate["radius"].get<double>();
            ASSERT_EQ(run(scene,
                          text + " --set Plate/Deflection=" + theory +
                            " --set 'Plate/Side lengths=" +
                            std::to_string(diameter) + ", " +
                            std::to_string(diameter) + "'"),
                      0)
              << err;
            const auto  last     = last_cycle();
            const auto &expected = given[theory];
            EXPECT_NEAR(last["max_plate_displacement"].get<double>() /
                          expected["max_plate_displacement"].get<double>(),
                        1.,
                        0.01)
              << given["name"] << theory;
            EXPECT_NEAR(last["final_impactor_velocity"].get<double>(),
                        expected["velocity_at_end"].get<double>(),
                        0.02 * given["velocity"].get<double>())
              << given["name"] << theory;
            EXPECT_LT(last["relative_energy_drift"], 1e-9);
          }
    }



    // Ball and plate as elastic bodies with finite rotations (CalculiX,
    // NLGEOM): no plate theory, no law of contact.
    TEST_F(StretchedPlates, AgreeWithElasticBodies)
    {
      const auto  given = reference("calculix_stretch_cases.json").front();
      const auto &plate = given["plate"], &ball = given["impactor"];
      const auto &bodies = given["runs"].back();
      const auto  value  = [](const nlohmann::json &number) {
        return number.dump() + "'";
      };
      const std::string side =
        std::to_string(2. * plate["radius"].get<double>());
      ASSERT_EQ(
        run(SCENES "/aluminium-sheet.prm",
            "--set 'Plate/Side lengths=" + side + ", " + side +
              "' --set 'Plate/Thickness=" + value(plate["thickness"]) +
              " --set 'Impactor/Radius=" + value(ball["radius"]) +
              " --set 'Impactor/Mass=0' --set 'Impactor/Density=" +
              value(ball["rho"]) +
              " --set 'Impactor/Velocity=" + value(given["velocity"]) +
              " --set 'Time/End time=" + value(given["end_time"]) +
              " --set 'Contact/Local response=layer' --set 'Contact/Patch "
              "radius=0' --set 'Adaptivity/Target error=0.03'"),
        0)
        << err;
      const auto last = last_cycle();
      for (const char *quantity : {"max_plate_displacement", "peak_force"})
        EXPECT_NEAR(last[quantity].get<double>() /
                      bodies[quantity].get<double>(),
                    1.,
                    0.02)
          << quantity;
      EXPECT_NEAR(-last["final_impactor_velocity"].get<double>(),
                  bodies["rebound_velocity"].get<double>(),
                  0.02 * given["velocity"].get<double>());
    }



    TEST_F(StretchedPlates, SlowBallsStrikeALinearPlate)
    {
      const std::string slow = " --set Impactor/Velocity=0.001 --set "
                               "'Time/Integrator=Newmark'";
      ASSERT_EQ(run_large(slow), 0) << err;
      const auto large = last_cycle();
      ASSERT_EQ(run_large(slow + " --set Plate/Deflection=linear"), 0) << err;
      for (const char *quantity :
           {"peak_force", "max_plate_displacement", "final_impactor_velocity"})
        EXPECT_NEAR(large[quantity].get<double>() /
                      last_cycle()[quantity].get<double>(),
                    1.,
                    1e-4)
          << quantity;
    }



    TEST_F(StretchedPlates, EnergyIsKeptAtAnyStep)
    {
      for (const std::string step : {"2e-7", "2e-6", "2e-5"})
        {
          ASSERT_EQ(run_large(" --set Impactor/Velocity=30 --set 'Time/End "
                              "time=4e-4' --set 'Time/Time step=" +
                              step + "'"),
                    0)
            << err;
          EXPECT_GT(last_cycle()["max_plate_displacement"], 0.002);
          EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9) << step;
        }
    }



    TEST_F(StretchedPlates, DampingIsInTheBalance)
    {
      ASSERT_EQ(run_large(" --set Impactor/Velocity=10 --set 'Time/End "
                          "time=4e-4' --set 'Time/Time step=2e-6' --set "
                          "'Plate/Loss factor=0.01'"),
                0)
        << err;
      EXPECT_GT(last_cycle()["plate_dissipated_energy"], 0.);
      EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9);
    }



    TEST_F(StretchedPlates, AHalfIsTheTwoQuarters)
    {
      const std::string sliding =
        " --set 'Plate/In-plane support=sliding, held' --set "
        "Impactor/Velocity=10 --set 'Time/Time step=1e-6'";
      ASSERT_EQ(run_large(sliding), 0) << err;
      const double quarter = last_cycle()["peak_force"];
      ASSERT_EQ(run_large(sliding +
                          " --set 'Plate/Impact point=1e-12, 0' "
                          "--set 'Discretization/Initial cells=8, "
                          "4'"),
                0)
        << err;
      EXPECT_NEAR(last_cycle()["peak_force"].get<double>() / quarter, 1., 1e-6);
    }



    TEST_F(StretchedPlates, FieldsShowWhatStretches)
    {
      ASSERT_EQ(run_large(" --set Impactor/Velocity=10 --set 'Time/Time "
                          "step=1e-6' --set 'Output/Field samples=1'"),
                0)
        << err;
      const std::string fields = text(results() / "fields_0.vtu");
      for (const char *name : {"displacement_x", "membrane_force_xy"})
        EXPECT_NE(fields.find(name), std::string::npos) << name;
      EXPECT_NE(text(results() / "report.html").find("membrane force N_x"),
                std::string::npos);
    }



    // What a lay-up does not do on its own, it does when it is not symmetric:
    // edges that are held in the plane make it stiffer.
    TEST_F(StretchedPlates, EdgesOfUnsymmetricLayupsMatter)
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
  } // namespace
} // namespace PlateImpact
