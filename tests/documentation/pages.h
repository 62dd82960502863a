// The pages of the documentation: the Markdown files of the repository.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace goniolux::test {

/// Where a finding stands: "docs/interface.md:12".
struct Place {
  std::filesystem::path page;  ///< absolute
  int line = 0;
};
std::string toString(const Place& place);

/// README.md, CHANGELOG.md and everything below docs/ and projects/.
std::vector<std::filesystem::path> pages();

struct Command {
  Place place;
  std::vector<std::string> words;  ///< as a shell would part them; quotes taken off
};

/// The lines of the page's ```sh blocks, without the assignments before a command and the comment after it.
std::vector<Command> commandsOf(const std::filesystem::path& page);

struct Link {
  Place place;
  std::string target;
};

/// The targets of [text](target) and ![text](target) outside code.
std::vector<Link> linksOf(const std::filesystem::path& page);

}  // namespace goniolux::test
