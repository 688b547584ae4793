// The points of a sweep and what they share, as read from a scene.
#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/scene.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace PlateImpact
{

  namespace
  {
    TEST(SweepPlan, ProductChangesTheLastEntryFastest)
    {
      const fs::path path = new_scene_path();
      std::ofstream(path) << "subsection Sweep\n"
                             "set Entry 1 = Plate/Side lengths\n"
                             "set Values 1 = 0.2, 0.2; 0.3, 0.2\n"
                             "set Entry 2 = Impactor/Velocity\n"
                             "set Values 2 = 0.1:0.5:5, 7\nend\n";
      SweepScene scene(path.string(), {}, {});
      fs::remove(path);
      ASSERT_EQ(scene.plan.n_points, 12u);
      using Values = std::vector<std::string>;
      EXPECT_EQ(scene.plan.values(0), (Values{"0.2, 0.2", "0.1"}));
      EXPECT_EQ(scene.plan.values(2), (Values{"0.2, 0.2", "0.3"}));
      EXPECT_EQ(scene.plan.values(11), (Values{"0.3, 0.2", "7"}));
      EXPECT_EQ(scene.point(11).parameters.impactor.velocity, 7.);
      EXPECT_EQ(scene.point(11).parameters.plate.side_lengths[0], 0.3);

      const SweepGroups groups(scene.plan, scene.parameters);
      ASSERT_EQ(groups.groups.size(), 2u);
      EXPECT_EQ(groups.groups[1],
                (std::vector<std::size_t>{6, 7, 8, 9, 10, 11}));
    }



    TEST(SweepPlan, PointsAreCompletedAsRunsAre)
    {
      const fs::path path = new_scene_path();
      std::ofstream(path) << "subsection Sweep\n"
                             "set Entry 1 = Impactor/Radius\n"
                             "set Values 1 = 0.01, -1, 0.02, 0.01\nend\n";
      SweepScene scene(path.string(), {}, {});
      for (const unsigned int point : {0, 2, 3})
        {
          const std::string radius = scene.plan.values(point).front();
          const Scene       expected =
            read_scene(path.string(), {"Impactor/Radius=" + radius});
          const Parameters p = scene.point(point).parameters,
                           q = expected.parameters;
          EXPECT_EQ(p.impactor.mass, q.impactor.mass);
          EXPECT_EQ(p.contact.patch_radius, q.contact.patch_radius);
          EXPECT_EQ(p.adaptivity.minimum_cell_size,
                    q.adaptivity.minimum_cell_size);
        }
      EXPECT_THROW(scene.point(1), InputError);
      fs::remove(path);
    }
  } // namespace
} // namespace PlateImpact
