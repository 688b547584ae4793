// Pages of plots and tables: what is in the file, without a browser.
#include "plate_impact/base/text.h"
#include "plate_impact/page/page.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace PlateImpact
{
  namespace
  {
    std::string
    written(const Page &page)
    {
      std::ostringstream out;
      page.write(out);
      return out.str();
    }



    /// The JSON block of a page.
    nlohmann::json
    data_of(const std::string &page)
    {
      const std::string begin =
        "<script type=\"application/json\" id=\"data\">";
      const std::size_t first = page.find(begin) + begin.size();
      return nlohmann::json::parse(
        page.substr(first, page.find("</script>", first) - first));
    }



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



    TEST(Page, StoresNumbersOnceAndGapsAsNull)
    {
      const std::vector<double> x = {1., 2., 3.};
      Page                      page("title", "lead");
      page.plots({{"plot",
                   "caption",
                   {"x [m]", true},
                   {"y"},
                   {{"a", x, {1. / 3., std::nan(""), 1e-30}},
                    {"b", x, x, 3, Style::dashed}},
                   {}}});
      const nlohmann::json data = data_of(written(page));
      EXPECT_EQ(data["arrays"].size(), 2u);
      const nlohmann::json &series = data["plots"][0]["series"];
      EXPECT_EQ(series[0]["x"], series[1]["y"]);
      EXPECT_EQ(series[1]["style"], "dashed");
      EXPECT_EQ(data["plots"][0]["x"]["logarithmic"], true);
      EXPECT_EQ(data["arrays"][1],
                nlohmann::json::parse("[0.333333,null,1e-30]"));
    }



    TEST(Page, TextStaysText)
    {
      const std::string evil = "</script><script>alert(1)</script>&\"<b>";
      Page              page(evil, evil);
      page.section(evil);
      page.notice(evil);
      page.facts({{evil, evil, evil}});
      page.table({{evil}, {{evil, evil}}, true});
      page.preformatted(evil);
      page.plots({{evil, evil, {evil}, {evil}, {{evil, {}, {}}}, {evil}}});
      page.embed("evil", evil);
      const std::string html = written(page);
      EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
      EXPECT_EQ(html.find("<b>"), std::string::npos);
      EXPECT_EQ(data_of(html)["evil"], evil);
    }



    TEST(Page, BytesThatAreNoTextAreReplaced)
    {
      Page page("\xff", "");
      page.embed("name", "\xff");
      EXPECT_EQ(data_of(written(page))["name"], "\uFFFD");
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
      EXPECT_EQ(PrefixedUnit("m", std::nan("")).name(), "m");
      EXPECT_EQ(percentage(0.0246771), "2.468 %");
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
      std::string
      report(const std::string &scene, const std::string &more)
      {
        EXPECT_EQ(run(scene, more), 0) << err;
        return text(results() / "report.html");
      }
    };

    const std::string quick = " --set 'Time/Time step=1e-6' ";



    TEST_F(ReportPage, HoldsTheNumbersOfTheSummaryAndNeedsNoNetwork)
    {
      const std::string page = report(main_scene, quick);
      EXPECT_EQ(n_references(page), 0u);
      EXPECT_LT(page.size(), 3e6);
      const nlohmann::json data = data_of(page);
      EXPECT_EQ(data["summary"], summary());
      // the force as the page tells it and as it plots it
      const double peak = last_cycle()["peak_force"];
      const double error =
        peak * last_cycle()["peak_force_error_bar"].get<double>();
      EXPECT_NE(page.find(">" + with_error(peak, error, "N") + "<"),
                std::string::npos);
      const nlohmann::json &force  = data["plots"][0];
      const nlohmann::json  cycles = summary()["cycles"];
      EXPECT_NE(page.find("class=\"verdict good\""), std::string::npos);
      // and its mark at the peak of the last
      ASSERT_EQ(force["series"].size(), cycles.size() + 1);
      const std::vector<double> mark =
        data["arrays"][force["series"].back()["y"].get<int>()];
      ASSERT_EQ(mark.size(), 1u);
      EXPECT_NEAR(mark[0] / peak, 1., 1e-5);
      for (unsigned int i = 0; i < cycles.size(); ++i)
        {
          const std::vector<double> values =
            data["arrays"][force["series"][i]["y"].get<int>()];
          EXPECT_EQ(values.size(), 81u);
          expect_near(*std::max_element(values.begin(), values.end()),
                      cycles[i]["peak_force"],
                      1e-5);
        }
      EXPECT_EQ(data["meshes"][0].size(), cycles.size());
      EXPECT_EQ(data["meshes"][0][0]["fields"].size(), 7u);
      EXPECT_EQ(data["film"]["cells"], last_cycle()["cells"]);
    }



    TEST_F(ReportPage, FilmShowsTheDeflectionUnderTheLoad)
    {
      const nlohmann::json film =
        data_of(report(main_scene, "--set 'Time/Time step=2e-7'"))["film"];
      EXPECT_GE(film["times"].size(), 40u);
      // the deflection under the load is what the contact law sees, averaged
      // over a patch that is small beside the dent
      expect_near(32767. * film["deflectionUnit"].get<double>(),
                  last_cycle()["max_plate_displacement"],
                  0.01);
    }



    TEST_F(ReportPage, LeavesOutWhatTheSceneDoesNotHave)
    {
      const std::string still =
        report(main_scene, quick + "--set Impactor/Shape=none");
      for (const std::string name : {"Zener", "Histories", "In time", "η"})
        EXPECT_EQ(still.find(">" + name), std::string::npos) << name;
      EXPECT_FALSE(data_of(still).contains("film"));
      const std::string single =
        report(main_scene, quick + "--set Adaptivity/Strategy=none");
      EXPECT_EQ(single.find("change in the last cycle"), std::string::npos);
      EXPECT_NE(single.find("Zener"), std::string::npos);
    }



    TEST_F(ReportPage, LongHistoriesAreThinnedAndKeepThePeak)
    {
      const nlohmann::json data =
        data_of(report(main_scene,
                       "--set 'Time/Time step=1e-8' --set "
                       "Adaptivity/Strategy=none"));
      const std::vector<double> force =
        data["arrays"][data["plots"][0]["series"][0]["y"].get<int>()];
      EXPECT_LT(force.size(), 1500u);
      expect_near(*std::max_element(force.begin(), force.end()),
                  last_cycle()["peak_force"],
                  1e-5);
    }
  } // namespace
} // namespace PlateImpact
