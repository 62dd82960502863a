// A small project in a folder of its own, and what reading it says.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "project/project.h"
#include "support/temporary_folder.h"

namespace goniolux::test {

/// The smallest complete project: a room, a luminaire, a grid. `Fixture::with` replaces or adds whole sections.
class ProjectFixture : public testing::Test {
 protected:
  static std::string minimal() {
    return "{\n"
           "  \"format\": \"goniolux-project\", \"version\": 1,\n"
           "  \"materials\": { \"grey\": { \"model\": \"lambert\", \"diffuse\": 0.5 } },\n"
           "  \"objects\": [ { \"name\": \"room\", \"shape\": \"box\", \"min\": [0,0,0], \"max\": [6,4,3], "
           "\"facing\": \"inward\", \"material\": \"grey\" } ],\n"
           "  \"luminaires\": [ { \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": "
           "[3,2,2] } ],\n"
           "  \"grids\": [ { \"name\": \"work plane\", \"origin\": [0,0,0.8], \"u\": [6,0,0], \"v\": [0,4,0], "
           "\"counts\": [3,2] } ]\n"
           "}\n";
  }

  /// The minimal project with `from` (which must occur) replaced by `to`.
  static std::string changed(const std::string& from, const std::string& to) {
    std::string text = minimal();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }
  /// The minimal project with a section added at its end (line 7).
  static std::string with(const std::string& section) { return changed("\n}\n", ",\n  " + section + "\n}\n"); }

  project::Project read(const std::string& text, const project::Overrides& overrides = {}) {
    folder_.write("project.json", text);
    return project::readProject(folder_.path().string(), overrides);
  }

  /// Everything that reading says, one line each, without the folder: "project.json:3:5: error: …"; "" when all is
  /// well.
  std::string errors(const std::string& text, const project::Overrides& overrides = {}) {
    std::string message;
    try {
      read(text, overrides);
    } catch (const core::InputError& error) {
      message = error.what();
    }
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at; (at = message.find(folder)) != std::string::npos;) message.erase(at, folder.size());
    return message;
  }

  /// Reading `text` fails with a message that holds `words`, at the place in the text where `at` first occurs ("" =
  /// any).
  void expectError(const std::string& text, const std::string& at, const std::string& words,
                   const project::Overrides& overrides = {}) {
    const std::string message = errors(text, overrides);
    EXPECT_NE(message.find(words), std::string::npos) << "got: " << message << "\nfor: " << text;
    if (at.empty()) return;
    const std::size_t offset = text.find(at);
    ASSERT_NE(offset, std::string::npos) << at;
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n') + 1;
    const std::size_t column = offset - (text.rfind('\n', offset) + 1) + 1;  // npos + 1 == 0: the first line
    const std::string place = "project.json:" + std::to_string(line) + ":" + std::to_string(column) + ": error: ";
    EXPECT_NE(message.find(place), std::string::npos) << "expected " << place << "\ngot: " << message;
  }

  TemporaryFolder folder_;
};

}  // namespace goniolux::test
