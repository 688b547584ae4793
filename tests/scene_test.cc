#include "mutation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/scene/scene_file.h"
#include "plate_impact/scene/scene_reader.h"
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace PlateImpact
{
  namespace
  {
    /// Whether a section compares unequal when any of its entries differs.
    template <typename Section>
    void
    expect_all_compared(const std::string &name, Section Parameters::*section)
    {
      SceneReader    reader;
      const Section &present = reader.parameters.*section;
      for (Entry &entry : reader.entries.all)
        {
          if (entry.section() != name)
            continue;
          const Section     before     = present;
          const std::string value      = entry.value;
          bool              is_changed = false;
          for (const std::string other : {"0.47",
                                          "0.9",
                                          "cylinder",
                                          "Hertz",
                                          "Sun",
                                          "half-space",
                                          "point",
                                          "Newmark",
                                          "collocation",
                                          "Yang-Sun",
                                          "3",
                                          "true",
                                          "false"})
            if (!is_changed && entry.value != other)
              is_changed = entry.set(other, "test");
          ASSERT_TRUE(is_changed) << entry.path;
          EXPECT_TRUE(before < present || present < before) << entry.path;
          entry.set(value, "test");
          EXPECT_FALSE(before < present || present < before) << entry.path;
        }
    }



    TEST(Parameters, SectionsCompareEveryEntry)
    {
      expect_all_compared("Impactor", &Parameters::impactor);
      expect_all_compared("Contact", &Parameters::contact);
      expect_all_compared("Time", &Parameters::time);
    }



    class SceneText
    {
    public:
      explicit SceneText(const std::string &text)
        : path(new_scene_path())
      {
        std::ofstream(path) << text;
      }

      ~SceneText()
      {
        std::filesystem::remove(path);
      }

      Scene
      read(const std::vector<std::string> &overrides = {}) const
      {
        return read_scene(path, overrides);
      }

      /// The message that it is refused with, its path replaced.
      std::string
      refusal(const std::vector<std::string> &overrides = {}) const
      {
        try
          {
            read(overrides);
          }
        catch (const InputError &error)
          {
            std::string text = error.what();
            for (std::size_t at; (at = text.find(path)) != std::string::npos;)
              text.replace(at, path.size(), "scene");
            return text;
          }
        return "accepted";
      }

    private:
      const std::string path;
    };



    TEST(Scene, EmptySceneIsTheSteelCase)
    {
      const Parameters p = SceneText("").read().parameters;
      EXPECT_EQ(p.plate.thickness, 0.008);
      EXPECT_DOUBLE_EQ(p.plate.shear_correction_factor, 5. / 6.);
      EXPECT_EQ(p.discretization.initial_cells[1], 3u);
      EXPECT_NEAR(p.impactor.mass, 0.0326725636, 1e-9);
      // what the program chooses: h sqrt(nu / (1 - nu)), a quarter of it
      EXPECT_DOUBLE_EQ(p.contact.patch_radius, 0.008 * std::sqrt(0.3 / 0.7));
      EXPECT_EQ(p.adaptivity.minimum_cell_size, 0.25 * p.contact.patch_radius);
    }



    TEST(Scene, HalfSpacesChooseTheContactRadius)
    {
      // Hertz's radius at Zener's peak
      const Parameters p = SceneText("").read({"Contact/Law=Sun"}).parameters;
      EXPECT_NEAR(p.contact.patch_radius, 0.454e-3, 1e-6);
      EXPECT_EQ(p.adaptivity.minimum_cell_size, 0.25 * p.contact.patch_radius);
    }



    TEST(Scene, WhatIsNotGivenOfTheContactFits)
    {
      const auto contact = [](const std::vector<std::string> &changes) {
        return SceneText("").read(changes).parameters.contact;
      };
      EXPECT_EQ(contact({}).law, ForceLaw::Hertz);
      EXPECT_EQ(contact({}).local_response, LocalResponse::layer);
      for (const std::string change : {"Contact/Law=Sun",
                                       "Contact/Load distribution=point",
                                       "Contact/Local response=half-space"})
        EXPECT_EQ(contact({change}).local_response, LocalResponse::half_space)
          << change;
      const std::string cylinder = "Impactor/Shape=cylinder";
      EXPECT_EQ(contact({cylinder}).law, ForceLaw::line);
      EXPECT_EQ(contact({cylinder}).load_distribution, LoadShape::strip);
      EXPECT_EQ(contact({cylinder}).local_response, LocalResponse::layer);
      EXPECT_EQ(
        contact({cylinder, "Contact/Load distribution=line"}).local_response,
        LocalResponse::half_space);
      // what is given stands
      EXPECT_EQ(SceneText("").refusal(
                  {"Contact/Law=Sun", "Contact/Local response=layer"}),
                "--set: Contact/Local response = layer does not fit the law "
                "Sun, which does not use the true compliance of the plate's "
                "material; expected Law = Hertz, or Local response = "
                "half-space");
      EXPECT_EQ(SceneText("").refusal({"Contact/Load distribution=point",
                                       "Contact/Local response=layer"}),
                "--set: Contact/Local response = layer needs a load patch; "
                "expected Load distribution = Hertz disc, uniform disc or "
                "strip, or Local response = half-space");
    }



    TEST(Scene, MinimumSizeUnderAPointLoadIsAQuarterOfTheThickness)
    {
      const Parameters p =
        SceneText("").read({"Contact/Load distribution=point"}).parameters;
      EXPECT_EQ(p.adaptivity.minimum_cell_size, 0.002);
    }



    TEST(Scene, PublicInterfaceIsAcceptedWithItsValues)
    {
      // the default element has changed since the interface was agreed on
      const Scene scene =
        read_scene(std::string(TEST_DATA) + "/reference/scene-interface.prm",
                   {"Discretization/Element=MITC9",
                    "Time/Integrator=Ritz vectors"});
      EXPECT_EQ(scene.text, SceneText("").read().text);
    }



    TEST(Scene, TextRepeatsTheRun)
    {
      const Scene scene = SceneText("subsection Plate\n"
                                    "set Thickness = 0.0123456789012345\nend\n")
                            .read();
      EXPECT_EQ(SceneText(scene.text).read().text, scene.text);
      EXPECT_EQ(SceneText(scene.text).read().parameters.plate.thickness,
                0.0123456789012345);
    }



    TEST(Scene, DefaultsAreAValidScene)
    {
      const std::string text = SceneReader().entries.text(true);
      EXPECT_EQ(SceneText(text).read().text, SceneText("").read().text);
    }



    TEST(Scene, BrokenOnesAreRefusedWithTheSentencesExpected)
    {
      // tests/broken/NAME.prm; expected.txt has NAME and the sentences of each
      const std::filesystem::path directory =
        std::filesystem::path(TEST_DATA) / "broken";
      std::set<std::string> scenes;
      for (const auto &entry : std::filesystem::directory_iterator(directory))
        if (entry.path().extension() == ".prm")
          scenes.insert(entry.path().string());
      EXPECT_GE(scenes.size(), 60u);

      std::ostringstream actual, expected;
      for (const std::string &scene : scenes)
        {
          const std::string name = std::filesystem::path(scene).stem();
          actual << name << '\n';
          try
            {
              read_scene(scene, {});
              ADD_FAILURE() << scene << " is accepted";
            }
          catch (const InputError &error)
            {
              std::istringstream lines(error.what());
              for (std::string line; std::getline(lines, line);)
                {
                  ASSERT_EQ(line.compare(0, scene.size() + 1, scene + ":"), 0)
                    << line;
                  actual << "  " << line.substr(scene.size() + 1) << '\n';
                }
            }
        }
      expected << std::ifstream(directory / "expected.txt").rdbuf();
      EXPECT_EQ(actual.str(), expected.str());
    }



    struct Mistake
    {
      std::string scene, expected;
    };

    class SceneMistake : public testing::TestWithParam<Mistake>
    {};

    TEST_P(SceneMistake, IsToldInOneSentence)
    {
      EXPECT_EQ(SceneText(GetParam().scene).refusal(), GetParam().expected);
    }

    std::string
    in_section(const std::string &section, const std::string &line)
    {
      return "subsection " + section + "\n" + line + "\nend\n";
    }

    INSTANTIATE_TEST_SUITE_P(
      Scene,
      SceneMistake,
      testing::Values(
        Mistake{
          in_section("Plate", "set Thicknes = 1"),
          "scene:2: there is no entry 'Thicknes' in section Plate; did you "
          "mean 'Thickness'?"},
        Mistake{in_section("Plate", "set Velocity = 1"),
                "scene:2: there is no entry 'Velocity' in section Plate; it "
                "belongs to section Impactor"},
        Mistake{in_section("Plat", "set Thickness = 1"),
                "scene:1: there is no section 'Plat'; did you mean 'Plate'?"},
        Mistake{
          in_section("Plate", "set Thickness = -1"),
          "scene:2: Plate/Thickness = -1 is not allowed; expected a number "
          "above 0"},
        Mistake{
          in_section("Plate", "set Thickness ="),
          "scene:2: Plate/Thickness = (nothing) is not allowed; expected a "
          "number above 0"},
        Mistake{in_section("Plate", "set Thickness = 1e400"),
                "scene:2: Plate/Thickness = 1e400 is not allowed; expected a "
                "number above 0"},
        Mistake{
          in_section("Plate", "set Thickness = nan"),
          "scene:2: Plate/Thickness = nan is not allowed; expected a number "
          "above 0"},
        Mistake{in_section("Plate", "set Thickness = 8 mm"),
                "scene:2: Plate/Thickness = 8 mm is not allowed; expected a "
                "number above 0; write 0.008, in m"},
        Mistake{
          in_section("Plate", "set Poisson's ratio = 0.5"),
          "scene:2: Plate/Poisson's ratio = 0.5 is not allowed; expected a "
          "number above -1 and below 0.5"},
        Mistake{in_section("Plate", "set Side lengths = 0.2"),
                "scene:2: Plate/Side lengths = 0.2 is not allowed; expected 2 "
                "values separated by commas, each: a number above 0"},
        Mistake{
          in_section("Plate", "set Support = glued"),
          "scene:2: Plate/Support = glued is not allowed; expected 1 to 2 "
          "values separated by commas, each: clamped | simply supported | "
          "soft simply supported | free; or, for an outline from a file, "
          "pairs edge: word"},
        Mistake{
          in_section("Discretization", "set Initial cells = 3, 2.5"),
          "scene:2: Discretization/Initial cells = 3, 2.5 is not allowed; "
          "expected 2 values separated by commas, each: a whole number "
          "from 1 to 10000"},
        Mistake{"set Thickness = 1\n",
                "scene:1: 'Thickness' is set outside of any subsection"},
        Mistake{"subsection Plate\nset Thickness = 0.01\nset Thickness = "
                "0.02\nend\n",
                "scene:3: Plate/Thickness is set twice, first in line 2"},
        Mistake{"subsection Plate\nset Thickness = 0.01\n",
                "scene:2: the file ends within subsection Plate; an 'end' is "
                "missing"},
        Mistake{
          "# title\rsubsection Plate\r set Thickness = 0.004\rend\r",
          "scene:1: this line holds control characters; a scene is a text "
          "file"},
        Mistake{in_section("Plate", "set Side lengths = 0.01, 0.01"),
                "scene:2: Plate/Thickness = 0.008 m is too thick for a plate "
                "theory; expected at most half the shorter side, 0.005 m"},
        Mistake{"end\n", "scene:1: 'end' without a 'subsection' before it"},
        Mistake{
          "Plate.Thickness: 1\n",
          "scene:1: 'Plate.Thickness: 1' is not understood; a line is "
          "'subsection NAME', 'set ENTRY = VALUE', 'end' or a comment after "
          "'#'"},
        Mistake{in_section("Plate", "set Thickness = 0.15"),
                "scene:2: Plate/Thickness = 0.15 m is too thick for a plate "
                "theory; expected at most half the shorter side, 0.1 m"},
        Mistake{
          in_section("Contact", "set Patch radius = 0.11"),
          "scene:2: Contact/Patch radius = 0.11 m reaches beyond the plate; "
          "expected at most the distance to the nearest edge, 0.1 m"},
        Mistake{
          in_section("Time", "set Time step = 1e-4"),
          "scene:2: Time/Time step = 1e-4 s is longer than End time, 8e-05 "
          "s"},
        Mistake{
          in_section("Time", "set Newmark gamma = 0.6"),
          "scene:2: Time/Newmark beta = 0.25 is below half of Newmark "
          "gamma, so that the scheme is unstable on fine meshes; expected "
          "at least 0.3\n"
          "scene:2: Contact/Integration = energy conserving needs Newmark "
          "beta = 0.25 and Newmark gamma = 0.5, which alone conserve "
          "energy; with others set Integration = collocation"},
        Mistake{
          in_section("Impactor", "set Shape = cylinder") +
            in_section("Contact",
                       "set Law = Hertz\nset Load distribution = point"),
          "scene:5: Contact/Law = Hertz is a law of spheres; expected line "
          "for a cylinder\n"
          "scene:6: Contact/Load distribution = point does not fit a "
          "cylinder; expected line or strip"},
        Mistake{
          in_section("Adaptivity", "set Goal = peak force") +
            in_section("Contact", "set Load distribution = point") +
            in_section("Time", "set Newmark beta = 0.3"),
          "scene:2: Adaptivity/Goal = peak force has no meaning under a point "
          "load, whose peak force does not converge under refinement; expected "
          "Load distribution = Hertz disc or uniform disc, or Goal = energy "
          "norm\n"
          "scene:2: Adaptivity/Goal = peak force needs Newmark beta = 0.25 and "
          "Newmark gamma = 0.5; with others there is no error bar, set Goal = "
          "energy norm\n"
          "scene:8: Contact/Integration = energy conserving needs Newmark beta "
          "= 0.25 and Newmark gamma = 0.5, which alone conserve energy; with "
          "others set Integration = collocation"},
        Mistake{
          in_section("Sweep", "set Values 1 = 1, 2"),
          "scene:2: Sweep/Values 1 = 1, 2 has no Sweep/Entry 1 to go with"},
        Mistake{
          "subsection Plate\nset Thicknes = 1\nset Density = "
          "0\nend\nsubsection Time\nset End time = soon\nend\n",
          "scene:2: there is no entry 'Thicknes' in section Plate; did you "
          "mean 'Thickness'?\n"
          "scene:3: Plate/Density = 0 is not allowed; expected a number "
          "above 0\n"
          "scene:6: Time/End time = soon is not allowed; expected a number "
          "not below 0"}));



    TEST(Scene, AnyBytesAreAcceptedOrRefusedWithSentences)
    {
      Mutation     mutation(TEST_DATA "/broken", 2);
      unsigned int n_accepted = 0;
      for (unsigned int n = 0; n < 400; ++n)
        {
          const std::string content = mutation.next();
          const std::string refusal = SceneText(content).refusal();
          n_accepted += refusal == "accepted";
          // a mistake a line, without deal.II's traces
          EXPECT_EQ(refusal.find("Stacktrace"), std::string::npos) << content;
          EXPECT_EQ(refusal.find("\n\n"), std::string::npos) << content;
          EXPECT_FALSE(refusal.empty()) << content;
        }
      EXPECT_LT(n_accepted, 300u);
    }
  } // namespace
} // namespace PlateImpact
