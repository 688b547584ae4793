// Von Karman's plate on one mesh: statics, locking, tangent, free vibration.
#include "plate_impact/plate/large_deflection.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "test_plate.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
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
          Epetra_CrsMatrix tangent(model.stiffness());
          large.add_tangent(state, state, 0., true, tangent);
          Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(
            Eigen::SparseMatrix<double>(as_eigen(tangent)));
          z += solver.solve(residual);
        }
      FAIL() << "no equilibrium";
    }



    PlateParameters
    plate_with_large_deflection(const EdgeSupport    support,
                                const InPlaneSupport in_plane,
                                const double         thickness)
    {
      PlateParameters plate      = unit_plate(support, thickness);
      plate.has_large_deflection = true;
      plate.in_plane_supports    = {{"", in_plane}};
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
      const Eigen::VectorXd of_unit = model.n_parts *
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
        for (const char *by : {"von_karman", "calculix"})
          EXPECT_NEAR(deflections[i] / given[i][by].get<double>(), 1., 0.005);
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

    using StretchedField = FieldOf<5>;



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
              interpolate(*strip.model, StretchedField([&](const Point<2> &p) {
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
                           strip.model->section.membrane_stiffness(0, 0)),
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
        interpolate(*strip.model, StretchedField([&](const Point<2> &p) {
          const double x = p[0] - 0.5;
          return StretchedField::Values{
            {0.5 * curvature * x * x, curvature * x, 0., 0., 0.}};
        }));
      // relaxed in the plane, with a little stiffness against rigid motions
      const auto      K     = as_eigen(strip.model->stiffness());
      const double    rigid = 1e-9;
      Eigen::VectorXd in_plane =
        interpolate(*strip.model, StretchedField([](const Point<2> &) {
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
          const StretchedPlate state = large.stretched(z);
          Epetra_CrsMatrix     tangent(model.stiffness());
          large.add_tangent(state, state, 0., true, tangent);
          EXPECT_LT((multiply(tangent, d) - K_d).norm(), 1e-6 * K_d.norm())
            << type;
        }
    }



    // A deflection that grows along x stretches alone: A_11 (w_x^2 / 2)^2 is
    // what damping takes of it, and the work of the forces that are more for
    // it.
    TEST(LargeDeflections, DampingTakesFromStretchingToo)
    {
      const double damping = 0.2, slope = 0.03;
      for (const ElementType type : all_elements())
        {
          const BentStrip       strip(type, 0.15);
          const LargeDeflection large(*strip.model);
          const Eigen::VectorXd z =
            interpolate(*strip.model, StretchedField([&](const Point<2> &p) {
              return StretchedField::Values{{slope * p[0], slope, 0., 0., 0.}};
            }));
          const StretchedPlate flat = large.stretched(0. * z),
                               bent = large.stretched(z);
          const double taken        = large.dissipated(flat, bent, damping);
          EXPECT_NEAR(taken /
                        (damping *
                         strip.model->section.membrane_stiffness(0, 0) *
                         std::pow(0.5 * slope * slope, 2)),
                      1.,
                      1e-10)
            << type;
          EXPECT_NEAR((large.mean_forces(flat, bent, damping) -
                       large.mean_forces(flat, bent))
                          .dot(z) /
                        taken,
                      1.,
                      1e-10)
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
      const auto matrices =
        std::make_shared<EffectiveStiffness>(model, SolverType::CHOLMOD);
      const double period = 1. / natural_frequencies(*matrices, 1)[0];
      // struck in the shape of its first mode, which it then keeps
      const Eigen::VectorXd load =
        model.n_parts * model.load(pressure_load(*mesh, [](const Point<2> &p) {
          return std::cos(numbers::PI * p[0]) * std::cos(numbers::PI * p[1]);
        }));
      const Eigen::VectorXd at_centre = model.load({{Point<2>(), 1.}});
      TimeParameters        time;
      time.newmark_beta  = 0.25;
      time.newmark_gamma = 0.5;
      time.end_time      = 2. * period;
      time.time_step     = period / 400.;
      const NewmarkScheme scheme(time, ForceIntegration::energy_conserving);
      FullSystem          system(matrices, load);
      const auto          motion = system.motion(scheme);
      double              before = 0., amplitude = 0., first = 0., last = 0.;
      for (unsigned int step = 1; step <= scheme.n_steps; ++step)
        {
          motion->begin_step(0.);
          const double force = step == 1 ? impulse / scheme.dt : 0.;
          while (motion->end_step(force, force))
            ;
          const double w = at_centre.dot(motion->z);
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
  } // namespace
} // namespace PlateImpact
