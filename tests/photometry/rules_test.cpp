// The page docs/methods/photometry.md is the list of rules: every rule in the sources stands there, and no other.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "core/document.h"
#include "photometry/rules.h"

namespace goniolux::photometry {
namespace {

const std::filesystem::path root = GONIOLUX_SOURCE_DIR;

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) found.insert((*i)[1]);
  return found;
}

// Rules are the lower-case, hyphenated literals of the readers.
TEST(Rules, OfTheReadersAreThoseOfTheDocumentation) {
  std::set<std::string> used;
  for (const auto& entry : std::filesystem::directory_iterator(root / "src" / "photometry")) {
    if (entry.path().extension() != ".cpp") continue;
    used.merge(matches(core::readFile(entry.path().string()), std::regex("\"([a-z]+[a-z0-9]*(?:-[a-z0-9]+)+)\"")));
  }
  const std::string page = core::readFile((root / "docs" / "methods" / "photometry.md").string());
  const std::string tables = page.substr(page.find("## Rules"), page.find("## Strict") - page.find("## Rules"));
  EXPECT_EQ(matches(tables, std::regex("`([a-z]+[a-z0-9]*(?:-[a-z0-9]+)+)`")), used);
  EXPECT_GT(used.size(), 30u);
  const std::string strict = page.substr(page.find("## Strict"), page.find("## Openings") - page.find("## Strict"));
  const auto& departures = departureRules();
  EXPECT_EQ(matches(strict, std::regex("`([a-z]+[a-z0-9]*(?:-[a-z0-9]+)+)`")),
            std::set<std::string>(departures.begin(), departures.end()));
}

}  // namespace
}  // namespace goniolux::photometry
