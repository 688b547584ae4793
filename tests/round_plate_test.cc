// Round plates: their cells and edges, struck at the centre and off it.
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/plate_model.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    class RoundPlate : public Program
    {};



    TEST_F(RoundPlate, CellsOfASizeAreAsFewAsItAllowsOnACircle)
    {
      for (const double x : {0., 0.2})
        {
          PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.05);
          plate.impact_point    = {{x, 0.}};
          plate.outline.shape   = PlateOutline::circle;
          const auto mesh_of    = [&](const unsigned int n_cells) {
            return make_plate_mesh(plate, {{n_cells, 1}});
          };
          const auto longest = [&](const unsigned int n_cells) {
            const auto lengths = longest_extents(*mesh_of(n_cells));
            return std::max(lengths[0], lengths[1]);
          };
          for (const double size : {0.4, 0.3, 0.1, 0.051, 0.02})
            {
              const auto [wanted, one] = n_cells_of_size(plate, {{size, size}});
              EXPECT_EQ(one, 1);
              EXPECT_LE(longest(wanted), 1.02 * size * (1. + 1e-9));
              // the mesh before among those that there are
              unsigned int fewer = 0, n_cells = 0;
              while (n_cells < wanted)
                {
                  fewer   = n_cells;
                  n_cells = mesh_of(n_cells + 1)->n_active_cells();
                }
              EXPECT_EQ(n_cells, wanted);
              // half the size is no less than halved cells
              const double half = 0.5 * longest(wanted);
              EXPECT_EQ(n_cells_of_size(plate, {{half, half}})[0], 4 * wanted);
              if (fewer > 0)
                {
                  EXPECT_GT(longest(fewer), 1.02 * size);
                }
            }
        }
    }



    /// Waves from the centre of a circle run across cells that are longer along
    /// the edge, and equal along a radius.
    TEST_F(RoundPlate, ACircleHasTheMostCellsAlongARadius)
    {
      for (const double y : {0., 0.2})
        for (const unsigned int n : {1, 4, 8})
          {
            PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.05);
            plate.impact_point    = {{0., y}};
            plate.outline.shape   = PlateOutline::circle;
            const unsigned int quarters = y > 0. ? 2 : 1;
            const auto mesh = make_plate_mesh(plate, {{quarters * 5 * n, n}});
            EXPECT_EQ(mesh->n_active_cells(), quarters * 5 * n * n);
            unsigned int n_along = 0;
            for (const auto &face : mesh->active_face_iterators())
              if (face->at_boundary() && face->boundary_id() == symmetry_x)
                {
                  ++n_along;
                  EXPECT_NEAR(face->measure(), 0.5 / (3. * n), 1e-9);
                }
            EXPECT_EQ(n_along, quarters * 3 * n);
            const double mean =
              std::sqrt(GridTools::volume(*mesh) / mesh->n_active_cells());
            for (const auto &cell : mesh->active_cell_iterators())
              {
                EXPECT_GT(cell->measure(), 0.3 * mean * mean);
                EXPECT_GT(cell->minimum_vertex_distance(), 0.4 * mean);
              }
          }
    }



    const std::string circle = "--set Plate/Outline=circle ";

    TEST_F(RoundPlate, ClampedCircleAgreesWithRadialElements)
    {
      const auto entry = reference("domain_cases.json")[1];
      ASSERT_EQ(entry["name"], "circle_steel_clamped");
      const auto last =
        last_with(circle +
                  "--set Plate/Thickness=0.004 --set 'Contact/Local "
                  "response=half-space' --set 'Contact/Patch radius=0.001' "
                  "--set 'Time/Time step=2e-7' --set 'Time/End time=6e-4' "
                  "--set 'Output/Natural frequencies=1'");
      expect_near(last["peak_force"], entry["contacts"][0]["peak_force"], 1e-3);
      expect_near(last["first_contact_end"], entry["contacts"][0]["end"], 1e-3);
      expect_near(last["impulse"], entry["contacts"][0]["impulse"], 1e-3);
      expect_near(last["final_impactor_velocity"],
                  entry["velocity_at_end"],
                  1e-3);
      expect_near(last["natural_frequencies"][0],
                  entry["first_frequency_hz"],
                  2e-4);
    }



    /// Lambda^2 of a round thin plate with n nodal diameters, the root of its
    /// characteristic equation near a guess (Leissa 1969, Vibration of Plates,
    /// NASA SP-160, eqs. 2.2 and 2.5).
    double
    characteristic(const EdgeSupport  support,
                   const double       poissons_ratio,
                   const unsigned int n,
                   const double       guess)
    {
      const auto residual = [&](const double l) {
        const double J = std::cyl_bessel_j(n, l), I = std::cyl_bessel_i(n, l),
                     J1      = std::cyl_bessel_j(n + 1, l),
                     I1      = std::cyl_bessel_i(n + 1, l);
        const double clamped = J1 * I + I1 * J;
        return support == EdgeSupport::clamped ?
          clamped :
          clamped - 2. * l / (1. - poissons_ratio) * J * I;
      };
      double low = 0.97 * std::sqrt(guess), high = 1.03 * std::sqrt(guess);
      EXPECT_LT(residual(low) * residual(high), 0.);
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double middle = 0.5 * (low + high);
          (residual(low) * residual(middle) <= 0. ? high : low) = middle;
        }
      return low * low;
    }



    TEST_F(RoundPlate, RoundEdgesAreNoPolygons)
    {
      // the lowest of motions that mirror in both planes of symmetry: without
      // and with two nodal diameters
      for (const EdgeSupport support :
           {EdgeSupport::clamped, EdgeSupport::simply_supported})
        {
          PlateParameters plate = unit_plate(support, 0.002);
          plate.outline.shape   = PlateOutline::circle;
          plate.side_lengths    = {{2., 2.}};
          plate.poissons_ratio  = 0.3;
          PlateModel          struck(plate,
                            {ElementType::MITC9, {{8, 8}}, SolverType::CHOLMOD},
                            make_plate_mesh(plate, {{8, 8}}));
          const PlateSection &section = struck.discretization().section;
          const double        unit =
            std::sqrt(section.bending_stiffness(0, 0) / section.mass_per_area) /
            (2. * numbers::PI);
          const auto frequencies = struck.natural_frequencies(2);
          ASSERT_EQ(frequencies.size(), 2u);
          for (const unsigned int mode : {0, 1})
            {
              const double exact = characteristic(support,
                                                  plate.poissons_ratio,
                                                  2 * mode,
                                                  frequencies[mode] / unit);
              EXPECT_NEAR(frequencies[mode] / unit / exact, 1., 1e-3)
                << int(support) << ' ' << mode;
            }
        }
    }



    TEST_F(RoundPlate, SceneOfARoundPlate)
    {
      ASSERT_EQ(run(SCENES "/round-plate.prm"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      EXPECT_LT(last_cycle()["peak_force_error_bar"], 1e-3);
      // before the edges are felt, that of any plate so thin
      expect_near(last_cycle()["peak_force"], 856.99, 1e-3);
    }



    TEST_F(RoundPlate, CirclesAreStruckAnywhere)
    {
      const double one =
        last_with(circle + "--set 'Plate/Impact point=0.05, 0'")["peak_force"];
      EXPECT_LT(last_cycle()["discretization_error"], 0.05);
      // turned, it is the same plate
      expect_near(last_with(
                    circle +
                    "--set 'Plate/Impact point=0.03, -0.04'")["peak_force"],
                  one,
                  1e-9);
      for (const std::string way :
           {"--set 'Plate/Impact point=0.03, 0.04' --set 'Adaptivity/Goal=peak "
            "force'",
            "--set 'Plate/Impact point=0.03, 0.04' --set 'Plate/Support=simply "
            "supported' --set Adaptivity/Strategy=graded",
            "--set 'Plate/Support=free'"})
        expect_near(last_with(circle + way)["peak_force"], one, 5e-4);
      // a cylinder cannot be turned with the plate
      const std::string cylinder =
        "--set Impactor/Shape=cylinder --set Impactor/Length=0.03 ";
      expect_near(last_with(
                    circle + cylinder +
                    "--set 'Plate/Impact point=0.02, 0.02'")["peak_force"],
                  last_with(circle + cylinder)["peak_force"],
                  2e-3);
    }



    TEST_F(RoundPlate, StrategiesAreComparedOnCircles)
    {
      ASSERT_EQ(execute("compare '" + main_scene + "' --output '" +
                        results().string() +
                        "' --set Plate/Outline=circle --set "
                        "Comparison/Elements=MITC9 --set "
                        "'Comparison/Maximum cycles=2' --set "
                        "'Comparison/Strategies=uniform, hanging nodes, "
                        "remeshing'"),
                0)
        << err;
      const auto comparison =
        nlohmann::json::parse(text(results() / "comparison.json"));
      EXPECT_EQ(comparison["curves"].size(), 3u);
      for (const auto &curve : comparison["curves"])
        {
          const bool is_made_anew = curve["strategy"] == "remeshing";
          EXPECT_EQ(curve["end"].get<std::string>().find("rectangles only") !=
                      std::string::npos,
                    is_made_anew);
          if (is_made_anew)
            continue;
          ASSERT_EQ(curve["meshes"].size(), 2u);
          const double effectivity = curve["meshes"].back()["effectivity"];
          EXPECT_GT(effectivity, 0.5);
          EXPECT_LT(effectivity, 2.);
        }
    }
  } // namespace
} // namespace PlateImpact
