// Damaged photometric files by the thousand: the repository's own files, mutated by a fixed random sequence. A reader
// may read or refuse (InputError with a message), nothing else; and at once. The libFuzzer kind of test, bounded and
// the same on every run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/document.h"
#include "photometry/metrics.h"
#include "photometry/photometric_file.h"

namespace goniolux::photometry {
namespace {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : generator_(seed) {}

  std::string mutated(const std::string& seed) {
    std::string text = seed;
    const std::size_t rounds = 1 + below(4);
    for (std::size_t i = 0; i < rounds && !text.empty(); ++i) mutateOnce(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : generator_() % n; }

  void mutateOnce(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(7)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(40));
        break;
      case 2:
        text.insert(at, text.substr(below(text.size()), 1 + below(60)));
        break;
      case 3:
        text.resize(at);
        break;
      default:
        replaceWord(text, at);  // numbers are where readers go wrong
    }
  }

  void replaceWord(std::string& text, std::size_t at) {
    static const std::array<const char*, 20> words{
        "0", "-1", "1",   "nan", "inf", "1e300", "1e-300", "-0",  "1000000000", "99999999999999999999",
        "",  "x",  "1,5", "0.5", "360", "400",   "-90",    "2 2", "TILT=NONE",  "4294967297"};
    const std::string blanks = " \r\n\t";
    std::size_t begin = at, end = at;
    while (begin > 0 && blanks.find(text[begin - 1]) == std::string::npos) --begin;
    while (end < text.size() && blanks.find(text[end]) == std::string::npos) ++end;
    text.replace(begin, end - begin, words[below(words.size())]);
  }

  std::mt19937 generator_;
};

// Whatever was read can be used: finite everywhere, and no larger than the file that it came from.
void expectUsable(const PhotometricFile& file, std::size_t bytes) {
  const TabulatedDistribution& d = *file.distribution;
  ASSERT_TRUE(std::isfinite(d.flux()) && d.flux() >= 0);
  ASSERT_LE(d.forwardFlux(), d.flux() * (1 + 1e-9));
  ASSERT_LE(d.horizontalAngles().size() * d.verticalAngles().size(), bytes);
  for (const core::Vec3& direction :
       {core::Vec3(0, 0, 1), core::Vec3(0, 0, -1), core::Vec3(1, 0, 0), core::Vec3(-0.48, 0.6, 0.64)}) {
    const double intensity = d.intensity(direction);
    ASSERT_TRUE(std::isfinite(intensity) && intensity >= 0 && intensity <= d.maximumIntensity() * (1 + 1e-12));
  }
  ASSERT_EQ(intensityPeak(d).intensity_cd, d.maximumIntensity());
  (void)fullWidth(d, PrincipalPlane::c0_180, 0.5);
}

TEST(Mutations, OfTheOwnFilesAreReadOrRefusedAtOnce) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "luminaires")) {
    if (entry.path().extension() == ".ies" || entry.path().extension() == ".ldt") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  int read = 0, refused = 0;
  std::chrono::steady_clock::duration slowest{};
  constexpr int perFile = 500;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const std::string seed = core::readFile(paths[p].string());
    Mutator mutator(static_cast<unsigned>(p) + 1);
    for (int i = 0; i < perFile; ++i) {
      const std::string text = mutator.mutated(seed);
      const auto begin = std::chrono::steady_clock::now();
      try {
        const PhotometricFile file = readPhotometry(text, paths[p].filename().string());
        expectUsable(file, text.size());
        ++read;
      } catch (const core::InputError& error) {
        ASSERT_FALSE(error.diagnostics().all().empty());
        ASSERT_FALSE(error.diagnostics().all().back().message.empty());
        ++refused;
      }
      slowest = std::max(slowest, std::chrono::steady_clock::now() - begin);
      if (HasFatalFailure()) FAIL() << paths[p] << ", mutation " << i;
    }
  }
  EXPECT_LT(slowest, std::chrono::seconds(1));
  // Both happen often, or the mutations are too tame or too wild to test anything.
  EXPECT_GT(read, perFile);
  EXPECT_GT(refused, perFile);
}

}  // namespace
}  // namespace goniolux::photometry
