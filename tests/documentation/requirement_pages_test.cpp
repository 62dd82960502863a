// The table of requirement presets is written from their data.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "project/requirement_presets.h"
#include "support/generated_block.h"

namespace goniolux::test {
namespace {

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:g}", *value) : "";
}

TEST(Reference, ThePresetsAreWrittenFromTheirData) {
  std::string text, standard;
  for (const project::RequirementPreset& p : project::requirementPresets()) {
    if (p.standard != standard) {
      text += fmt::format(
          "{}**{}**\n\n| preset | | clause | mean lx | min lx | U0 | min/max | R_a | UGR | cylindrical lx | wall lx | "
          "ceiling lx | compared with |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
          standard.empty() ? "" : "\n", p.standard);
      standard = p.standard;
    }
    text +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", p.name, p.title, p.clause,
                    cell(p.mean), cell(p.minimum), cell(p.u0), cell(p.ud), cell(p.ra), cell(p.ugr), cell(p.cylindrical),
                    cell(p.wall), cell(p.ceiling), p.comparedWith.empty() ? "**unconfirmed**" : p.comparedWith);
  }
  expectGeneratedBlock(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "docs/requirements.md", "the presets", text);
}

}  // namespace
}  // namespace goniolux::test
