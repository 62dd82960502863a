#include "scene/view_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goniolux::scene {
namespace {

View viewOf(View::Projection projection) {
  View view;
  view.eye = {1, 2, 1.5};
  view.target = {3, 5, 1};
  view.projection = projection;
  view.verticalFov = projection == View::Projection::perspective ? 50 * core::degree : core::pi;
  view.span = 4;
  view.width = 320;
  view.height = 240;
  return view;
}

// The same rays through every pixel.
TEST(ViewText, EveryProjectionComesBack) {
  using Projection = View::Projection;
  for (const auto projection : {Projection::perspective, Projection::orthographic, Projection::fisheyeEquidistant,
                                Projection::fisheyeEquisolid}) {
    const View view = viewOf(projection);
    const auto back = viewFromText(viewText(view), 320, 240);
    ASSERT_TRUE(back.has_value()) << viewText(view);
    for (const auto& [x, y] : {std::pair(160.0, 120.0), {10.5, 20.5}, {300.0, 200.0}}) {
      const ViewRay a = rayThrough(view, x, y), b = rayThrough(*back, x, y);
      EXPECT_EQ(a.inside, b.inside);
      EXPECT_LT(glm::length(a.direction - b.direction), 1e-7) << viewText(view);
      EXPECT_LT(glm::length(a.origin - b.origin), 1e-7) << viewText(view);
    }
  }
}

TEST(ViewText, SaysWhatRadianceExpectsOfAFisheye) {
  View view = viewOf(View::Projection::fisheyeEquidistant);
  view.width = view.height = 500;
  view.eye = {0, 0, 1.2};
  view.target = {0, 1, 1.2};
  EXPECT_EQ(viewText(view), "-vta -vp 0 0 1.2 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180");
  EXPECT_TRUE(isKnownToRadiance(view));
  EXPECT_FALSE(isKnownToRadiance(viewOf(View::Projection::fisheyeEquisolid)));
}

TEST(ViewText, NonsenseIsNothing) {
  for (const char* text :
       {"", "hello", "-vtv", "-vth -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180",
        "-vtv -vp 0 0 0 -vd 0 0 0 -vu 0 0 1 -vh 50 -vv 50", "-vtv -vp 0 0 x -vd 0 1 0 -vu 0 0 1 -vh 9 -vv 9",
        "-vtv -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 200 -vv 200",
        "-vtv -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 50 -vv 50 -vs 0.5"})
    EXPECT_FALSE(viewFromText(text, 10, 10).has_value()) << text;
}

}  // namespace
}  // namespace goniolux::scene
