#include "spectrum/colour_rendering.h"

#include <gtest/gtest.h>

#include "spectrum/cie_data.h"

namespace goniolux::spectrum {
namespace {

TEST(ColourRendering, IndicesOfTheIlluminantsAreThePublishedOnes) {
  // Ra: recomputed to a tenth, whole numbers as published in CIE 015:2004 and 13.3 (76, 64, 57, 51, 72, 59, 90, 95, 90,
  // 81, 83, 83).
  struct {
    const char* name;
    double ra, r9;
  } constexpr known[] = {{"CIE A", 100, 100},      {"CIE D65", 100, 100},      {"CIE FL1", 75.8, -47},
                         {"CIE FL2", 64.2, -84},   {"CIE FL3", 56.7, -102},    {"CIE FL4", 51.4, -111},
                         {"CIE FL5", 71.7, -68},   {"CIE FL6", 59.0, -105},    {"CIE FL7", 90.2, 61},
                         {"CIE FL8", 95.5, 98},    {"CIE FL9", 90.3, 70},      {"CIE FL10", 81.0, 27},
                         {"CIE FL11", 82.8, 25},   {"CIE FL12", 83.1, 1},      {"CIE HP1", 8.1, -261},
                         {"CIE LED-B3", 84.8, 24}, {"CIE LED-RGB1", 57.1, -34}};
  for (const auto& [name, ra, r9] : known) {
    const auto got = colourRendering(illuminant(name).value());
    EXPECT_NEAR(got.ra, ra, 0.1) << name;
    EXPECT_NEAR(got.special[8], r9, 0.6) << name;  // published as a whole number
  }
}

TEST(ColourRendering, ThermalRadiatorsRenderPerfectly) {
  for (const double kelvin : {1800.0, 2700.0, 4900.0}) {
    const auto got = colourRendering(blackbody(kelvin));
    EXPECT_NEAR(got.ra, 100, 1e-3);
    for (const double each : got.special) EXPECT_NEAR(each, 100, 5e-3);
  }
}

}  // namespace
}  // namespace goniolux::spectrum
