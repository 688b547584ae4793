// The reader of the grammar of scenes, free of deal.II: runs under sanitizers.
#include "mutation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/scene_file.h"

#include <gtest/gtest.h>

#include <sstream>

namespace PlateImpact
{
  namespace
  {
    TEST(SceneFile, TakesAssignmentsApart)
    {
      std::istringstream in("\xEF\xBB\xBFsubsection Plate # the target\r\n"
                            "\tset  Thickness   =  0.01   # [m]\r\n"
                            "  set Support = clamped, simply supported\n"
                            "end\n");
      const SceneFile    file = scan_scene(in, "a.prm");
      EXPECT_TRUE(file.mistakes.empty());
      ASSERT_EQ(file.assignments.size(), 2u);
      EXPECT_EQ(file.assignments[0].path(), "Plate/Thickness");
      EXPECT_EQ(file.assignments[0].value, "0.01");
      EXPECT_EQ(file.assignments[0].origin, "a.prm:2");
      EXPECT_EQ(file.assignments[1].value, "clamped, simply supported");
    }



    TEST(SceneFile, ClosestNameIsOfferedForTyposOnly)
    {
      const std::vector<std::string> names = {"Thickness",
                                              "Density",
                                              "Support"};
      EXPECT_EQ(closest_name("Thicknes", names), "Thickness");
      EXPECT_EQ(closest_name("density", names), "Density");
      EXPECT_EQ(closest_name("Colour", names), "");
    }



    TEST(SceneFile, OverridesAreSectionSlashEntryEqualsValue)
    {
      const Assignment a = parse_override("Time/End time = 1e-4");
      EXPECT_EQ(a.path(), "Time/End time");
      EXPECT_EQ(a.value, "1e-4");
      EXPECT_THROW(parse_override("End time=1"), InputError);
      EXPECT_THROW(parse_override("Time/End time"), InputError);
    }



    TEST(SceneFile, AnyBytesAreReadOrRefusedLineByLine)
    {
      Mutation mutation(TEST_DATA "/broken", 1);
      for (unsigned int n = 0; n < 20000; ++n)
        {
          const std::string  text = mutation.next();
          std::istringstream in(text);
          const SceneFile    file = scan_scene(in, "a.prm");
          for (const std::string &mistake : file.mistakes)
            EXPECT_EQ(mistake.rfind("a.prm:", 0), 0u) << mistake;
          for (const Assignment &assignment : file.assignments)
            {
              EXPECT_NE(assignment.section, "");
              EXPECT_NE(assignment.entry, "");
              closest_name(assignment.entry, {"Thickness", "Side lengths"});
            }
          try
            {
              const Assignment a = parse_override(text);
              EXPECT_NE(a.section, "");
              EXPECT_NE(a.entry, "");
            }
          catch (const InputError &)
            {}
        }
    }
  } // namespace
} // namespace PlateImpact
