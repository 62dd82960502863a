// Part of a page that is written from data: between the lines <!-- NAME begins --> and <!-- NAME ends -->. The test
// that expects it also writes it, when asked to: GONIOLUX_UPDATE_PAGES=1.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/temporary_folder.h"

namespace goniolux::test {

inline void expectGeneratedBlock(const std::filesystem::path& page, const std::string& name,
                                 const std::string& generated) {
  const std::string text = contentOf(page);
  const std::string begin = "<!-- " + name + " begins -->\n", end = "<!-- " + name + " ends -->\n";
  const std::size_t beginAt = text.find(begin), to = text.find(end);
  ASSERT_NE(beginAt, std::string::npos) << page << " has no line " << begin;
  ASSERT_NE(to, std::string::npos) << page << " has no line " << end;
  const std::size_t from = beginAt + begin.size();
  if (std::getenv("GONIOLUX_UPDATE_PAGES") != nullptr) {
    std::ofstream(page, std::ios::binary) << text.substr(0, from) + generated + text.substr(to);
    GTEST_SKIP() << "the part was written anew";
  }
  const std::string written = text.substr(from, to - from);
  if (written == generated) return;
  std::istringstream is(written), shouldBe(generated);
  std::string line, expected;
  int number = static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(from), '\n'));
  do {
    ++number;
    line.clear();
    expected.clear();
  } while (std::getline(is, line) && std::getline(shouldBe, expected) && line == expected);
  ADD_FAILURE() << page.string() << ':' << number << ": what this is written from has changed\n  is:        " << line
                << "\n  should be: " << expected << "\nwrite it anew: GONIOLUX_UPDATE_PAGES=1 script/test";
}

}  // namespace goniolux::test
