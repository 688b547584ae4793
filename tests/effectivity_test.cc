// The estimator against the known solution of a static plate.
#include <deal.II/fe/mapping_q1.h>

#include "plate_impact/estimator/stress_recovery.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    // Navier's solution: simply supported plate of side 1 in the unit quadrant
    // of half side 1/2 under q = cos(pi x) cos(pi y), in Mindlin's theory
    struct NavierPlate
    {
      explicit NavierPlate(const PlateSection &section)
        : section(section)
      {
        const double D = section.bending_stiffness(0, 0), pi = numbers::PI;
        rotation = 1. / (4. * D * pi * pi * pi);
        deflection_amplitude =
          rotation / pi + 1. / (2. * pi * pi * section.mean_shear_stiffness());
      }

      Resultants
      resultants(const Point<2> &p) const
      {
        const double pi = numbers::PI, cx = std::cos(pi * p[0]),
                     cy = std::cos(pi * p[1]), sx = std::sin(pi * p[0]),
                     sy = std::sin(pi * p[1]);
        const Eigen::Vector3d curvatures(-pi * rotation * cx * cy,
                                         -pi * rotation * cx * cy,
                                         2. * pi * rotation * sx * sy);
        Resultants            r;
        r.head<3>()        = section.bending_stiffness * curvatures;
        const double shear = section.mean_shear_stiffness() *
          (rotation - pi * deflection_amplitude);
        r.tail<2>() << shear * sx * cy, shear * cx * sy;
        return r;
      }

      const PlateSection section;
      double             rotation, deflection_amplitude;
    };



    /// The unknowns under that pressure.
    Eigen::VectorXd
    pressed(const PlateDiscretization &model)
    {
      return solve_static(model,
                          model.load(
                            pressure_load(model.mesh(), [](const Point<2> &p) {
                              return std::cos(numbers::PI * p[0]) *
                                std::cos(numbers::PI * p[1]);
                            })));
    }



    struct Effectivity
    {
      double overall, smallest_of_cells, largest_of_cells;

      /// Errors in the energy norm over the norm of the solution: of the
      /// elements, and of what is recovered from them.
      double of_elements, of_recovery;
    };



    /// Solves the static plate, recovers its stress resultants, estimates the
    /// error from what the recovery changes, and compares with Navier.
    Effectivity
    effectivity(const ElementType element_name, const Triangulation<2> &mesh)
    {
      const PlateParameters plate =
        unit_plate(EdgeSupport::simply_supported, 0.05);
      const PlateElement  element(element_name);
      PlateDiscretization model(mesh, element, plate, 1.);
      model.assemble();
      const Eigen::VectorXd z = pressed(model);
      MeshEstimator         estimator(model);
      estimator.add_samples({1.}, z);
      const ErrorEstimate estimate = estimator.estimate();

      const NavierPlate     exact(model.section);
      const MappingQ1<2>    mapping;
      const Quadrature<2>  &quadrature = element.quadrature;
      const StressRecovery  recovery(mesh);
      const Eigen::MatrixXd recovered =
        recovered_resultants(model, recovery, z, quadrature.get_points())
          .front();
      std::vector<double> e2(mesh.n_active_cells(), 0.);
      double              total_e2 = 0., total_u2 = 0., recovered_e2 = 0.;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const unsigned int    c      = cell->active_cell_index();
          const Eigen::VectorXd values = model.cell_values(c, z);
          const Eigen::VectorXd strains =
            model.shape(c).at_quadrature.linear * values;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              Resultants r;
              r.head<3>() =
                model.section.bending_stiffness * strains.segment<3>(5 * q);
              r.tail<2>() =
                model.section.shear_stiffness * strains.segment<2>(5 * q + 3);
              const Resultants right = exact.resultants(
                mapping.transform_unit_to_real_cell(cell, quadrature.point(q)));
              const Resultants e = right - r;
              const Resultants e_recovered =
                right - recovered.col(quadrature.size() * c + q);
              const double weight = model.shape(c).weights[q];
              const auto   root   = model.section.root_of_compliance();
              e2[c] += weight * (root * e).squaredNorm();
              recovered_e2 += weight * (root * e_recovered).squaredNorm();
              total_u2 += weight * (root * r).squaredNorm();
            }
          total_e2 += e2[c];
        }

      // eta_i of one sample is half of ||e||_i / ||u||: invert to ||e||_i
      const double true_eta = std::sqrt(total_e2 / (total_e2 + total_u2));
      const double norm     = std::sqrt(total_e2 + total_u2);
      Effectivity  result{estimate.eta / true_eta,
                         1e9,
                         0.,
                         true_eta,
                         std::sqrt(recovered_e2) / norm};
      const double u = std::sqrt(total_u2 / (1. - estimate.eta * estimate.eta));
      for (unsigned int c = 0; c < e2.size(); ++c)
        {
          const double ratio =
            2. * estimate.element_errors[c] * u / std::sqrt(e2[c]);
          result.smallest_of_cells = std::min(result.smallest_of_cells, ratio);
          result.largest_of_cells  = std::max(result.largest_of_cells, ratio);
        }
      return result;
    }



    TEST(EnergyNormEstimator, EffectivityOnUniformMeshes)
    {
      PlateParameters plate = unit_plate(EdgeSupport::simply_supported, 0.05);
      for (const ElementType name : all_elements())
        for (const unsigned int n : {8, 16})
          {
            const auto mesh   = make_plate_mesh(plate, {{n, n}});
            const auto result = effectivity(name, *mesh);
            record(fmt::format("{}/{}", n, word_for(name)), result.overall);
            EXPECT_GT(result.overall, 0.9) << name << ' ' << n;
            EXPECT_LT(result.overall, 1.1) << name << ' ' << n;
          }
    }



    TEST(EnergyNormEstimator, EffectivityOnUnstructuredMeshes)
    {
      PlateParameters plate = unit_plate(EdgeSupport::simply_supported, 0.05);
      for (const ElementType name : all_elements())
        for (const double fine : {0.02, 0.05})
          {
            const auto mesh = make_plate_mesh(plate, {{6, 6}});
            remesh(*mesh, fine, 0.1);
            const auto result = effectivity(name, *mesh);
            record(fmt::format("{}/{}", fine, word_for(name)), result.overall);
            EXPECT_GT(result.overall, 0.9) << name << ' ' << fine;
            EXPECT_LT(result.overall, 1.1) << name << ' ' << fine;
            EXPECT_GT(result.smallest_of_cells, 0.5) << name << ' ' << fine;
            EXPECT_LT(result.largest_of_cells, 2.) << name << ' ' << fine;
          }
    }



    TEST(EnergyNormEstimator, EffectivityWithHangingNodes)
    {
      PlateParameters plate = unit_plate(EdgeSupport::simply_supported, 0.05);
      for (const ElementType name : all_elements())
        {
          const auto mesh = make_plate_mesh(plate, {{6, 6}});
          for (const auto &cell : mesh->active_cell_iterators())
            if (cell->center().norm() < 0.25)
              cell->set_refine_flag();
          mesh->execute_coarsening_and_refinement();
          const auto result = effectivity(name, *mesh);
          record(word_for(name), result.overall);
          EXPECT_GT(result.overall, 0.9) << name;
          EXPECT_LT(result.overall, 1.1) << name;
          EXPECT_GT(result.smallest_of_cells, 0.7) << name;
          EXPECT_LT(result.largest_of_cells, 2.) << name;
        }
    }


    // Lesson 0 of the course: what recovery gains on the elements, and what the
    // estimate makes of it.
    TEST(EnergyNormEstimator, LessonZero)
    {
      const PlateParameters plate =
        unit_plate(EdgeSupport::simply_supported, 0.05);
      fmt::print("cells  error of the elements  of the recovery  estimated\n");
      double before = 2.;
      for (const unsigned int n : {2, 4, 8, 16})
        {
          const auto        mesh      = make_plate_mesh(plate, {{n, n}});
          const Effectivity found     = effectivity(ElementType::MITC9, *mesh);
          const double      estimated = found.overall * found.of_elements;
          fmt::print("{:5}{:22.3f} %{:15.3f} %{:9.3f} %\n",
                     n * n,
                     100. * found.of_elements,
                     100. * found.of_recovery,
                     100. * estimated);
          record(fmt::format("elements/{}", n), found.of_elements);
          record(fmt::format("recovery/{}", n), found.of_recovery);
          record(fmt::format("estimated/{}", n), estimated);
          // on all but the coarsest mesh the recovery is better, and the more
          // so the finer the mesh is
          const double gain = found.of_recovery / found.of_elements;
          EXPECT_LT(gain, before) << n;
          before = gain;
        }
      EXPECT_LT(before, 0.2);
    }



    /// Numbers for a picture, one after the other.
    void
    record_all(const std::string &name, const std::vector<double> &values)
    {
      ::testing::Test::RecordProperty(name,
                                      fmt::format("{}",
                                                  fmt::join(values, " ")));
    }



    // The picture of lesson 0: one patch, along a line through its samples.
    TEST(EnergyNormEstimator, LessonZeroPatch)
    {
      const PlateParameters plate =
        unit_plate(EdgeSupport::simply_supported, 0.05);
      const auto          mesh = make_plate_mesh(plate, {{4, 4}});
      const PlateElement  element(ElementType::MITC9);
      PlateDiscretization model(*mesh, element, plate, 1.);
      model.assemble();
      const Eigen::VectorXd z = pressed(model);
      const NavierPlate     exact(model.section);
      const StressRecovery  recovery(*mesh);
      const auto            patch =
        std::find_if(recovery.patches.begin(),
                     recovery.patches.end(),
                     [](const StressRecovery::Patch &one) {
                       return one.centre.distance({0.25, 0.25}) < 1e-9;
                     });
      ASSERT_NE(patch, recovery.patches.end());
      ASSERT_EQ(patch->images.size(), 4u);

      constexpr unsigned int      Q_x       = 3;
      const auto                  stiffness = model.section.stiffness();
      std::vector<RowMajorMatrix> samples(mesh->n_active_cells());
      for (unsigned int cell = 0; cell < samples.size(); ++cell)
        samples[cell] = resultants_at(model,
                                      cell,
                                      stiffness,
                                      model.shape(cell).at_samples,
                                      z);
      const RowMajorMatrix a = patch->coefficients(samples, 5);

      // the cells to the left and to the right, at the lower of the samples
      const double        place = 0.5 + 0.5 / std::sqrt(3.);
      const MappingQ1<2>  mapping;
      std::vector<double> x, raw, fitted, right, sample_x, sample_values,
        corners;
      double raw_error = 0., sample_error = 0., fitted_error = 0.;
      for (const StressRecovery::Image &image : patch->images)
        {
          const auto cell = std::next(mesh->begin_active(), image.cell);
          for (const unsigned int v : {0, 3})
            for (const unsigned int d : {0, 1})
              corners.push_back(cell->vertex(v)[d]);
          if (cell->center()[1] > 0.25)
            continue;
          const auto add = [&](const Point<2> &unit, const bool is_sample) {
            const Point<2> point =
              mapping.transform_unit_to_real_cell(cell, unit);
            const double at_point =
              resultants_at(model,
                            image.cell,
                            stiffness,
                            element.strains_at(cell, {unit}),
                            z)(0, Q_x);
            const double fit = (patch->polynomial(point) * a)[Q_x];
            const double is  = exact.resultants(point)[Q_x];
            if (is_sample)
              {
                sample_x.push_back(point[0]);
                sample_values.push_back(at_point);
                sample_error = std::max(sample_error, std::abs(at_point - is));
                return;
              }
            x.push_back(point[0]);
            raw.push_back(at_point);
            fitted.push_back(fit);
            right.push_back(is);
            raw_error    = std::max(raw_error, std::abs(at_point - is));
            fitted_error = std::max(fitted_error, std::abs(fit - is));
          };
          for (unsigned int i = 0; i <= 20; ++i)
            add({i / 20., place}, false);
          for (const double s : {1. - place, place})
            add({s, place}, true);
        }
      record_all("corners", corners);
      record_all("y", {0.125 + 0.125 * place});
      record_all("x", x);
      record_all("raw", raw);
      record_all("fitted", fitted);
      record_all("exact", right);
      record_all("sample_x", sample_x);
      record_all("samples", sample_values);
      // the samples are where the elements are right, and the fit follows them
      EXPECT_LT(sample_error, 0.2 * raw_error);
      EXPECT_LT(fitted_error, 0.5 * raw_error);
    }
  } // namespace
} // namespace PlateImpact
