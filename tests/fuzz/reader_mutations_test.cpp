// Damaged files by the thousand: the repository's own files, mutated by a fixed random sequence. A reader may read or
// refuse (InputError with a message), nothing else; and at once. The libFuzzer kind of test, bounded and the same on
// every run; script/fuzz runs the same targets by the million under libFuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <random>
#include <string>

#include "core/document.h"
#include "fuzz/targets.h"

namespace goniolux::fuzz {
namespace {

namespace fs = std::filesystem;

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
    const std::string blanks = " \r\n\t<>\"";
    std::size_t begin = at, end = at;
    while (begin > 0 && blanks.find(text[begin - 1]) == std::string::npos) --begin;
    while (end < text.size() && blanks.find(text[end]) == std::string::npos) ++end;
    text.replace(begin, end - begin, words[below(words.size())]);
  }

  std::mt19937 generator_;
};

std::vector<std::string> seedsOf(const Target& target) {
  std::vector<fs::path> paths;
  for (const char* folder : {"luminaires", "materials", "tests/fuzz/seeds"}) {
    const fs::path place = fs::path(GONIOLUX_SOURCE_DIR) / folder;
    if (!fs::is_directory(place)) continue;
    for (const auto& entry : fs::directory_iterator(place)) {
      const std::string extension = entry.path().extension().string();
      const auto& wanted = target.seedExtensions;
      if (std::find(wanted.begin(), wanted.end(), extension) != wanted.end()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> seeds;
  for (const fs::path& path : paths) {
    std::string bytes = core::readFile(path.string());
    if (bytes.size() <= 65536) seeds.push_back(std::move(bytes));
  }
  return seeds;
}

class Reader : public testing::TestWithParam<Target> {};

TEST_P(Reader, ReadsOrRefusesDamagedFilesAtOnce) {
  const Target& target = GetParam();
  const std::vector<std::string> seeds = seedsOf(target);
  ASSERT_FALSE(seeds.empty()) << "no seed for " << target.name;
  int read = 0, refused = 0;
  std::chrono::steady_clock::duration slowest{};
  Mutator mutator(20);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < target.inputs && std::chrono::steady_clock::now() - start < std::chrono::seconds(8); ++i) {
    const std::string text = mutator.mutated(seeds[static_cast<std::size_t>(i) % seeds.size()]);
    const auto begin = std::chrono::steady_clock::now();
    (target.run(text) == Outcome::read ? read : refused) += 1;
    slowest = std::max(slowest, std::chrono::steady_clock::now() - begin);
  }
  EXPECT_LT(slowest, std::chrono::seconds(1));
  // Both happen often, or the mutations are too tame or too wild to test anything. On a busy machine a reader of meshes
  // sees some two hundred inputs only.
  EXPECT_GT(read, 20);
  EXPECT_GT(refused, 20);
}

INSTANTIATE_TEST_SUITE_P(Every, Reader, testing::ValuesIn(targets()),
                         [](const auto& each) { return std::string(each.param.name); });

// A file that declares a thousand million angles is refused at once, before memory is asked for.
TEST(Reader, RefusesCountsThatTheFileCannotHold) {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* counts : {"1000000000 1", "1 1000000000", "100000 100000", "3 999999999"}) {
    const std::string text =
        std::string("IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 ") + counts + " 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 70 0\n";
    EXPECT_EQ(targetNamed("lm63").run(text), Outcome::refused) << counts;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(100));
}

}  // namespace
}  // namespace goniolux::fuzz
