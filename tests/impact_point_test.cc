// Plates struck off their centre: what symmetry leaves is meshed.
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
    class ImpactPoint : public Program
    {};



    PlateParameters
    struck_at(const double x, const double y)
    {
      PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.05);
      plate.impact_point    = {{x, y}};
      return plate;
    }



    TEST_F(ImpactPoint, CellsOfASizeAreAsFewAsItAllows)
    {
      const auto longest = [](const PlateParameters             &plate,
                              const std::array<unsigned int, 2> &n,
                              const unsigned int                 d) {
        const auto mesh   = make_plate_mesh(plate, n);
        double     length = 0.;
        for (const auto &face : mesh->active_face_iterators())
          if (std::abs(face->vertex(1)[1 - d] - face->vertex(0)[1 - d]) < 1e-9)
            length = std::max(length, face->measure());
        return length;
      };
      for (const PlateParameters &plate :
           {struck_at(0., 0.), struck_at(0.2, 0.), struck_at(-0.31, 0.17)})
        for (const double size : {0.4, 0.125, 0.0501})
          {
            const auto n = n_cells_of_size(plate, {{size, size}});
            for (unsigned int d = 0; d < 2; ++d)
              {
                EXPECT_LE(longest(plate, n, d), size * (1. + 1e-9));
                auto fewer = n;
                if (--fewer[d] > 0)
                  {
                    EXPECT_GT(longest(plate, fewer, d), size);
                  }
              }
          }
    }



    TEST_F(ImpactPoint, DecidesWhatIsMeshed)
    {
      struct Case
      {
        double       x, y, parts;
        unsigned int n_symmetric;
      };
      for (const Case &c : {Case{0., 0., 4., 2},
                            Case{0.2, 0., 2., 1},
                            Case{0., -0.3, 2., 1},
                            Case{0.2, 0.1, 1., 0}})
        {
          const PlateParameters plate = struck_at(c.x, c.y);
          const auto            mesh  = make_plate_mesh(plate, {{5, 4}});
          const PlateElement    element(ElementType::MITC9);
          PlateDiscretization   model(*mesh, element, plate);
          EXPECT_EQ(model.n_parts, c.parts);
          EXPECT_EQ(geometry_of(plate).is_symmetric[0] +
                      geometry_of(plate).is_symmetric[1],
                    c.n_symmetric);
          double area                 = 0.;
          bool   has_vertex_at_impact = false;
          for (const auto &cell : mesh->active_cell_iterators())
            {
              area += cell->measure();
              for (const unsigned int v : cell->vertex_indices())
                has_vertex_at_impact =
                  has_vertex_at_impact || cell->vertex(v).norm() < 1e-12;
            }
          EXPECT_NEAR(area * c.parts, 1., 1e-12);
          EXPECT_TRUE(has_vertex_at_impact);

          // the whole force, wherever its points lie
          ContactParameters contact = {};
          contact.load_distribution = LoadShape::Hertz_disc;
          contact.patch_radius      = 0.1;
          double weight             = 0.;
          for (const LoadPoint &point :
               on_meshed_part(make_load_distribution(contact, 0.), plate))
            weight += point.weight;
          EXPECT_NEAR(weight, 1., 1e-12);
        }
    }



    TEST_F(ImpactPoint, MassIsThatOfTheWholePlate)
    {
      const PlateElement element(ElementType::MITC9);
      for (const auto &[x, y] :
           {std::pair{0., 0.}, std::pair{0.2, 0.}, std::pair{0.2, -0.1}})
        {
          PlateParameters plate    = struck_at(x, y);
          plate.supports           = {{"", EdgeSupport::free}};
          const auto          mesh = make_plate_mesh(plate, {{3, 3}});
          PlateDiscretization model(*mesh, element, plate);
          model.assemble();
          const Eigen::VectorXd rigid =
            interpolate(model, Field([](const Point<2> &) -> Field::Values {
                          return {{1., 0., 0.}};
                        }));
          EXPECT_NEAR(rigid.dot(multiply(model.mass(), rigid)),
                      model.section.mass_per_area,
                      1e-12);
        }
    }



    TEST_F(ImpactPoint, AgreesWithTheSeriesOffTheCentre)
    {
      const auto entry = reference("domain_cases.json")[0];
      ASSERT_EQ(entry["name"], "square_steel_off_centre");
      const std::string scene =
        "--set 'Plate/Support=simply supported' --set Plate/Thickness=0.004 "
        "--set 'Plate/Impact point=0.05, 0.03' --set 'Contact/Local "
        "response=half-space' --set 'Contact/Patch radius=0.001' --set "
        "'Time/Time step=2e-7' --set 'Time/End time=4e-4' --set "
        "'Output/Natural frequencies=1' ";
      const auto last = last_with(scene);
      expect_near(last["peak_force"], entry["contacts"][0]["peak_force"], 3e-3);
      expect_near(last["first_contact_end"], entry["contacts"][0]["end"], 1e-2);
      expect_near(last["impulse"], entry["contacts"][0]["impulse"], 1e-2);
      EXPECT_EQ(last["number_of_contacts"], entry["contacts"].size());
      expect_near(last["natural_frequencies"][0],
                  entry["first_frequency_hz"],
                  1e-3);
    }



    TEST_F(ImpactPoint, SceneOffTheCentre)
    {
      ASSERT_EQ(run(SCENES "/off-centre.prm"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "target reached");
      const auto last = last_cycle();
      EXPECT_LT(last["peak_force_error_bar"], 1e-3);
      expect_near(last["peak_force"], 856.99, 1e-3);
      // before waves are back cells far away need not see them
      EXPECT_LT(last["cells"], 600);
      // watched until the ball leaves
      EXPECT_EQ(last["number_of_contacts"], 1);
    }



    TEST_F(ImpactPoint, ImagesHaveTheSameForce)
    {
      const std::string at  = "--set 'Plate/Impact point=";
      const double      one = last_with(at + "0.05, 0.03'")["peak_force"];
      for (const std::string point : {"-0.05, 0.03'", "0.03, -0.05'"})
        expect_near(last_with(at + point)["peak_force"], one, 1e-6);
      // before the edges are felt, the place does not matter
      expect_near(last_with(at + "0.02, 0'")["peak_force"], one, 1e-4);
      // the same by every way of making meshes
      for (const std::string way : {"--set Adaptivity/Strategy=remeshing",
                                    "--set Adaptivity/Strategy=graded",
                                    "--set 'Adaptivity/Goal=peak force'",
                                    "--set 'Time/Integrator=Newmark'"})
        expect_near(last_with(at + "0.05, 0.03' " + way)["peak_force"],
                    one,
                    5e-4);
    }



    TEST_F(ImpactPoint, CylindersStrikeOffTheCentre)
    {
      const std::string cylinder =
        "--set Impactor/Shape=cylinder --set Impactor/Length=0.03 ";
      const double centre = last_with(cylinder)["peak_force"];
      expect_near(last_with(
                    cylinder +
                    "--set 'Plate/Impact point=0.01, 0.01'")["peak_force"],
                  centre,
                  2e-3);
    }



    TEST_F(ImpactPoint, NearAnEdgeTheLayerIsNoMoreThatOfAWholePlate)
    {
      last_with("--set 'Plate/Impact point=0.09, 0'");
      EXPECT_NE(err.find("from an edge"), std::string::npos) << err;
      last_with("--set 'Plate/Impact point=0.05, 0'");
      EXPECT_EQ(err.find("from an edge"), std::string::npos) << err;
    }



    TEST_F(ImpactPoint, FieldsAreThoseOfTheWholePlate)
    {
      const std::string fields     = "--set 'Output/Field samples=1' --set "
                                     "'Adaptivity/Maximum cycles=1' ";
      const auto        n_cells_of = [this] {
        const std::string vtu  = text(results() / "fields_0.vtu");
        const auto        from = vtu.find("NumberOfCells=\"") + 15;
        return std::stoi(vtu.substr(from));
      };
      // nine cells with four quadrilaterals each
      last_with(fields);
      EXPECT_EQ(n_cells_of(), 4 * 4 * 9);
      last_with(fields + "--set 'Plate/Impact point=0, 0.02'");
      EXPECT_EQ(n_cells_of(), 2 * 4 * 9);
      last_with(fields + "--set 'Plate/Impact point=0.02, 0.02'");
      EXPECT_EQ(n_cells_of(), 4 * 9);
    }
  } // namespace
} // namespace PlateImpact
