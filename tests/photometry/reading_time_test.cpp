// Reading, checking and integrating a typical file takes under 5 ms of CPU time: the median of many, which a busy
// machine does not move.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/document.h"
#include "core/parallel.h"
#include "photometry/photometric_file.h"

namespace goniolux::photometry {
namespace {

TEST(ReadingTime, OfATypicalFileIsBelowFiveMilliseconds) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizers make everything slower";
#endif
  const std::string name = std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/track-spot.ies";  // 49 planes of 81 angles
  const std::string bytes = core::readFile(name);
  std::vector<double> seconds;
  for (int i = 0; i < 51; ++i) {
    const double begin = core::processCpuSeconds();
    const PhotometricFile file = readPhotometry(bytes, name);
    seconds.push_back(core::processCpuSeconds() - begin);
    ASSERT_GT(file.distribution->flux(), 0);
  }
  std::nth_element(seconds.begin(), seconds.begin() + 25, seconds.end());
  RecordProperty("milliseconds", std::to_string(1000 * seconds[25]));
  EXPECT_LT(seconds[25], 0.005);
}

}  // namespace
}  // namespace goniolux::photometry
