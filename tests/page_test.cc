// Pages of plots and tables: what is in the file, without a browser.
#include <deal.II/base/utilities.h>

#include "plate_impact/base/text.h"
#include "plate_impact/output/report.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace PlateImpact
{
  namespace
  {
    void
    remove_all(std::string       &text,
               const std::string &begin,
               const std::string &end)
    {
      for (std::size_t at; (at = text.find(begin)) != text.npos;)
        text.erase(at, text.find(end, at + begin.size()) + end.size() - at);
    }



    /// References that would need a network: all that are not in comments of
    /// licences and no names of XML.
    unsigned int
    n_references(std::string page)
    {
      remove_all(page, "/*!", "*/");
      remove_all(page, "http://www.w3.org/2000/", "svg");
      const std::regex reference("https?://|src=|@import|url\\(");
      return std::distance(std::sregex_iterator(page.begin(),
                                                page.end(),
                                                reference),
                           std::sregex_iterator());
    }



    TEST(Page, NumbersHaveSixDigitsAndGapsAreNull)
    {
      EXPECT_EQ(
        numbers_on_page(
          {1. / 3., std::nan(""), 1e-30, 0., -1234567., 2.99999996e-5, 1e300})
          .dump(),
        "[0.333333,null,1e-30,0.0,-1234570.0,3e-05,1e+300]");
    }



    TEST(Page, TextStaysText)
    {
      const std::string evil = "</script><script>alert(1)</script>&\"<b>";
      const std::string html = page({evil, evil, evil}, {{"evil", evil}});
      EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
      EXPECT_EQ(html.find("<b>"), std::string::npos);
      EXPECT_NE(html.find("\"evil\":\"\\u003c/script>"), std::string::npos);
      EXPECT_NE(html.find("<title>&lt;/script&gt;"), std::string::npos);
    }



    TEST(Page, BytesThatAreNoTextAreReplaced)
    {
      const std::string html = page({}, {{"name", "\xff"}});
      EXPECT_NE(html.find("{\"name\":\"\uFFFD\"}"), std::string::npos);
    }



    TEST(Page, UnitsGetPrefixesThatReadWell)
    {
      const auto text = [](const double value, const std::string &unit) {
        return PrefixedUnit(unit, value).text(value);
      };
      EXPECT_EQ(text(3.43e-5, "s"), "34.3 µs");
      EXPECT_EQ(text(1301.14, "N"), "1301 N");
      EXPECT_EQ(text(23456.7, "N"), "23460 N");
      EXPECT_EQ(text(234567., "N"), "234.6 kN");
      EXPECT_EQ(text(2.1e11, "Pa"), "210 GPa");
      EXPECT_EQ(text(1e-3, "m"), "1 mm");
      EXPECT_EQ(text(-0.25, "m"), "-250 mm");
      EXPECT_EQ(text(0., "m"), "0 m");
      EXPECT_EQ(text(1e-30, "s"), "1e-18 ps");
      EXPECT_EQ(PrefixedUnit("m", std::nan("")).name, "m");
      EXPECT_EQ(percentage(0.0246771), "2.468 %");
    }



    TEST(Page, MassesAreInGramsBelowOneKilogram)
    {
      const auto words = [](const std::string &mass) {
        return scene_in_words(
          read_scene(SCENES "/drop-weight.prm", {"Impactor/Mass=" + mass})
            .parameters);
      };
      EXPECT_NE(words("5").find(" mass 5 kg "), std::string::npos);
      EXPECT_NE(words("2000").find(" mass 2000 kg "), std::string::npos);
      EXPECT_NE(words("0.25").find(" mass 250 g "), std::string::npos);
    }



    TEST(Page, ResultsHaveTheDigitsThatTheirErrorLeaves)
    {
      EXPECT_EQ(with_error(1390.104, 0.0967, "N"), "1390.10 N ± 0.10 N");
      EXPECT_EQ(with_error(1395.31, 6.39, "N"), "1395 N ± 7 N");
      EXPECT_EQ(with_error(1404.85, 745., "N"), "1405 N ± 745 N");
      EXPECT_EQ(with_error(2.5e5, 1e3, "N"), "250.0 kN ± 1.0 kN");
      EXPECT_EQ(with_error(0.0123, 1e-5, "N"), "12.300 mN ± 0.010 mN");
      EXPECT_EQ(with_error(1390.104, 0., "N"), "1390 N");
      EXPECT_EQ(deviation(1.0056, 1.), "+0.56 %");
      EXPECT_EQ(deviation(0.9, 1.), "-10 %");
      EXPECT_EQ(deviation(1265.19, 1.), "1270 times");
      EXPECT_EQ(deviation(0.25, 1.), "0.25 times");
    }



    /// report.html of a run.
    class ReportPage : public Program
    {
    protected:
      nlohmann::json
      report(const std::string &scene, const std::string &more)
      {
        EXPECT_EQ(run(scene, more), 0) << err;
        return study_of("report.html");
      }
    };

    const std::string quick = " --set 'Time/Time step=1e-6' ";



    TEST_F(ReportPage, HoldsTheNumbersOfTheSummaryAndNeedsNoNetwork)
    {
      const nlohmann::json study = report(main_scene, quick);
      const std::string    page  = text(results() / "report.html");
      EXPECT_EQ(n_references(page), 0u);
      EXPECT_LT(page.size(), 3e6);
      EXPECT_EQ(study["summary"], summary());
      // the force in words for those without scripts
      const double peak = last_cycle()["peak_force"];
      const double error =
        peak * last_cycle()["peak_force_error_bar"].get<double>();
      EXPECT_NE(page.find("<noscript><p class=\"notice\">Peak force " +
                          with_error(peak, error, "N") +
                          " (mesh, step) ± 5 N (model, from comparisons): "
                          "target met. Within the limits of the model, elastic "
                          "contact assumed."),
                std::string::npos);
      const nlohmann::json cycles = summary()["cycles"];
      ASSERT_EQ(study["histories"].size(), cycles.size());
      for (unsigned int i = 0; i < cycles.size(); ++i)
        {
          const std::vector<double> values = study["histories"][i]["force"];
          EXPECT_EQ(values.size(), 81u);
          expect_near(*std::max_element(values.begin(), values.end()),
                      cycles[i]["peak_force"],
                      1e-5);
        }
      ASSERT_EQ(study["meshes"].size(), cycles.size());
      for (unsigned int i = 0; i < cycles.size(); ++i)
        {
          const nlohmann::json &mesh = study["meshes"][i];
          EXPECT_EQ(mesh["fields"].size(), 7u);
          EXPECT_EQ(mesh["cells"].size(), 4 * cycles[i]["cells"].get<int>());
          for (const auto &field : mesh["fields"])
            EXPECT_EQ(field["values"].size(), cycles[i]["cells"]);
        }
      EXPECT_EQ(study["film"]["cells"], last_cycle()["cells"]);
    }



    TEST_F(ReportPage, FilmShowsTheDeflectionUnderTheLoad)
    {
      const nlohmann::json film =
        report(main_scene, "--set 'Time/Time step=2e-7'")["film"];
      EXPECT_GE(film["times"].size(), 40u);
      // the deflection under the load is what the contact law sees, averaged
      // over a patch that is small beside the dent
      expect_near(32767. * film["deflectionUnit"].get<double>(),
                  last_cycle()["max_plate_displacement"],
                  0.01);
    }



    TEST_F(ReportPage, FilmShowsTheLargestForceAtTheEnd)
    {
      // the force rises to the last step, and four samples make a frame
      const nlohmann::json film =
        report(main_scene,
               "--set 'Time/Time step=2e-8' --set 'Time/End time=1.612e-5' "
               "--set Adaptivity/Strategy=none")["film"];
      const auto forces = film["forces"].get<std::vector<double>>();
      EXPECT_EQ(forces.size(), film["times"].size());
      expect_near(*std::max_element(forces.begin(), forces.end()),
                  last_cycle()["peak_force"],
                  1e-6);
    }



    /// The name and unit of its fields, a mesh having xi' before them.
    std::vector<std::string>
    names_of(const nlohmann::json &fields, const std::size_t begin = 0)
    {
      std::vector<std::string> names;
      for (std::size_t k = begin; k < fields.size(); ++k)
        names.push_back(fields[k]["name"].get<std::string>() + ", " +
                        fields[k]["unit"].get<std::string>());
      return names;
    }



    TEST_F(ReportPage, FilmHasStressesAtItsNodes)
    {
      const nlohmann::json study = report(main_scene, quick);
      const nlohmann::json mesh = study["meshes"].back(), film = study["film"];
      ASSERT_EQ(names_of(film["fields"]), names_of(mesh["fields"], 1));
      ASSERT_EQ(film["nodesPerSide"], 3);
      const unsigned int n_cells = film["cells"];
      const auto         forces  = film["forces"].get<std::vector<double>>();
      const std::size_t  peak =
        std::max_element(forces.begin(), forces.end()) - forces.begin();
      // the middle of nine nodes is where the mesh has its values
      for (std::size_t k = 0; k < film["fields"].size(); ++k)
        {
          const nlohmann::json            &field   = film["fields"][k];
          const double                     largest = field["largest"];
          const std::vector<unsigned char> roots =
            dealii::Utilities::decode_base64(field["values"]);
          ASSERT_EQ(roots.size(), 9 * n_cells * forces.size());
          for (unsigned int cell = 0; cell < n_cells; ++cell)
            {
              const double root = static_cast<signed char>(
                roots[9 * (peak * n_cells + cell) + 4]);
              const double expected = mesh["fields"][k + 1]["values"][cell];
              EXPECT_NEAR(root / 127.,
                          std::copysign(std::sqrt(std::abs(expected) / largest),
                                        expected),
                          0.005)
                << field["name"] << ", cell " << cell;
            }
        }
    }



    TEST_F(ReportPage, LinesShowRawAndRecoveredStresses)
    {
      const nlohmann::json study    = report(main_scene, quick);
      const nlohmann::json stresses = study["stresses"],
                           fields   = study["meshes"][0]["fields"];
      ASSERT_EQ(stresses.size(), 2u); // of the first mesh and the last
      EXPECT_EQ(stresses[1]["cycle"], last_cycle()["cycle"]);
      ASSERT_EQ(names_of(stresses[0]["fields"]), names_of(fields, 1));
      ASSERT_EQ(stresses[0]["lines"].size(), 3u);
      const nlohmann::json &diagonal = stresses[0]["lines"][2];
      const auto distances = diagonal["distance"].get<std::vector<double>>();
      ASSERT_EQ(distances.size(), 30u); // three cells, nine points and a gap
      const double quarter = 0.1 * std::sqrt(2.);
      expect_near(distances[28], quarter, 1e-5);
      for (std::size_t k = 0; k < stresses[0]["fields"].size(); ++k)
        {
          const nlohmann::json &raw    = diagonal["raw"][k],
                               &smooth = diagonal["recovered"][k];
          const double largest         = fields[k + 1]["values"][0];
          // the fifth of nine points is the centre of the cell
          for (const unsigned int cell : {0, 4, 8})
            EXPECT_NEAR(smooth[10 * (cell / 4) + 4].get<double>(),
                        fields[k + 1]["values"][cell].get<double>(),
                        1e-4 * std::abs(largest))
              << fields[k + 1]["name"] << ", cell " << cell;
          EXPECT_TRUE(raw[9].is_null() && smooth[9].is_null());
          // from one cell to the next: what is recovered on equal cells has no
          // jump, what is not has
          EXPECT_NEAR(smooth[8].get<double>(),
                      smooth[10].get<double>(),
                      1e-3 * std::abs(largest));
          EXPECT_GT(std::abs(raw[8].get<double>() - raw[10].get<double>()),
                    0.05 * std::abs(largest));
        }
    }



    TEST_F(ReportPage, LeavesOutWhatTheSceneDoesNotHave)
    {
      const nlohmann::json still =
        report(main_scene, quick + "--set Impactor/Shape=none");
      for (const std::string name : {"histories", "errors", "stresses", "film"})
        EXPECT_TRUE(still[name].empty()) << name;
      EXPECT_FALSE(still.contains("expected"));
      EXPECT_NE(text(results() / "report.html")
                  .find("<noscript><p class=\"notice\">Nothing strikes"),
                std::string::npos);
    }



    TEST_F(ReportPage, LongHistoriesAreThinnedAndKeepThePeak)
    {
      const std::vector<double> force =
        report(main_scene,
               "--set 'Time/Time step=1e-8' --set "
               "Adaptivity/Strategy=none")["histories"][0]["force"];
      EXPECT_LT(force.size(), 1500u);
      expect_near(*std::max_element(force.begin(), force.end()),
                  last_cycle()["peak_force"],
                  1e-5);
    }
  } // namespace
} // namespace PlateImpact
