#include "app/cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "app/cli/common_options.h"

namespace goniolux::app {
namespace {

using core::Parameter;

constexpr std::size_t lineWidth = 100;

// Words filled up to the line's width; every line but the first begins after `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string out;
  std::size_t column = indent;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column > indent && column + 1 + word.size() > lineWidth) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
  }
  return out;
}

std::string table(const std::vector<HelpRow>& rows) {
  std::size_t width = 0;
  for (const HelpRow& row : rows) width = std::max(width, row.name.size());
  std::string out;
  for (const HelpRow& row : rows) out += fmt::format("  {:<{}}  {}\n", row.name, width, wrapped(row.text, width + 4));
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string details(const Parameter& parameter, std::string text) {
  if (!parameter.unit.empty()) text += fmt::format(" [{}]", parameter.unit);
  if (parameter.required) text += " (required)";
  if (!parameter.defaultText.empty()) text += fmt::format(" (default: {})", parameter.defaultText);
  return text;
}

// What stands for the option's value in a usage line: --view VIEW, --device FILE, --exposure N.
std::string valueName(const Parameter& parameter) {
  switch (parameter.kind) {
    case core::ParameterKind::number:
    case core::ParameterKind::length:
      return "N";
    case core::ParameterKind::file:
      return "FILE";
    default:
      return upper(parameter.key);
  }
}

std::string inputText(const pipeline::Stage& stage) {
  if (stage.inputName.empty()) return "";
  return " " + stage.inputName + (stage.manyInputs ? "..." : "");
}

HelpRow ownRow(const Parameter& parameter) {
  std::string text = parameter.title;
  if (!text.empty() && !parameter.help.empty()) text += "; ";
  text += parameter.help;
  const std::string value = parameter.kind == core::ParameterKind::boolean ? "" : " " + valueName(parameter);
  const std::string name =
      parameter.key.size() == 1 ? fmt::format("-{} N", parameter.key) : fmt::format("    --{}{}", parameter.key, value);
  return {name, details(parameter, text)};
}

HelpRow commonRow(const CommonOption& option) {
  const Parameter& parameter = option.parameter;
  const std::string letter = option.letter ? fmt::format("-{}, ", option.letter) : std::string(4, ' ');
  const std::string value = option.isFlag ? "" : " " + parameter.title;
  return {letter + "--" + parameter.key + value, details(parameter, parameter.help)};
}

}  // namespace

std::vector<HelpRow> ownOptionRows(const pipeline::Stage& stage) {
  std::vector<HelpRow> rows;
  for (const Parameter& parameter : stage.options) rows.push_back(ownRow(parameter));
  return rows;
}

std::vector<HelpRow> commonOptionRows(const pipeline::Stage& stage) {
  std::vector<HelpRow> rows;
  for (const CommonOption& option : commonOptions())
    if (applies(option, stage)) rows.push_back(commonRow(option));
  return rows;
}

std::string programHelp() {
  std::vector<HelpRow> verbs;
  for (const pipeline::Stage& stage : pipeline::stages())
    verbs.push_back({stage.name + inputText(stage), capitalised(stage.title)});
  return fmt::format(
      "goniolux {}: lighting-design analysis in which every number has an interval that holds\n\n"
      "usage: goniolux VERB INPUT [options]\n\nverbs:\n{}\n"
      "  goniolux VERB --help    describes a verb and its options\n"
      "  goniolux --version      prints the version\n"
      "  goniolux --man [VERB]   prints a manual page (roff)\n"
      "  goniolux --completion SHELL   prints what bash, zsh or fish need to complete verbs and options\n\n"
      "exit codes: 0 done; 1 a requirement failed; 2 bad input or usage, nothing written; 3 could not finish\n",
      GONIOLUX_VERSION, table(verbs));
}

std::string verbHelp(const pipeline::Stage& stage) {
  std::string required;
  for (const Parameter& parameter : stage.options)
    if (parameter.required) required += fmt::format(" --{} {}", parameter.key, valueName(parameter));
  const std::vector<HelpRow> own = ownOptionRows(stage), common = commonOptionRows(stage);

  std::string out = fmt::format("usage: goniolux {}{}{} [options]\n\n{}.\n", stage.name, inputText(stage), required,
                                capitalised(stage.title));
  if (!stage.help.empty()) out += wrapped(stage.help, 0) + "\n";
  if (!own.empty()) out += "\noptions of this verb:\n" + table(own);
  return out + "\ncommon options:\n" + table(common);
}

}  // namespace goniolux::app
