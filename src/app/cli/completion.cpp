#include "app/cli/completion.h"

#include <fmt/format.h>

#include <vector>

#include "app/cli/common_options.h"
#include "core/diagnostics.h"

namespace goniolux::app {
namespace {

using core::Parameter;
using pipeline::Stage;

struct Option {
  std::string name;  ///< without dashes
  std::string help;
  bool isFlag = false;
};

std::vector<Option> optionsOf(const Stage& stage) {
  std::vector<Option> options;
  for (const Parameter& p : stage.options)
    options.push_back({p.key, p.title.empty() ? p.help : p.title, p.kind == core::ParameterKind::boolean});
  for (const CommonOption& option : commonOptions())
    if (applies(option, stage)) options.push_back({option.parameter.key, option.parameter.help, option.isFlag});
  return options;
}

std::string dashed(const std::string& name) {
  return (name.size() == 1 ? "-" : "--") + name;
}

/// Inside single quotes of a shell; `more`: further characters that mean something there.
std::string quoted(const std::string& text, const std::string& more = "") {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (more.find(c) != std::string::npos)
      result += std::string("\\") + c;
    else
      result += c;
  }
  return result;
}

std::string bash() {
  std::string verbs, cases;
  for (const Stage& stage : pipeline::stages()) {
    verbs += stage.name + " ";
    std::string words;
    for (const Option& option : optionsOf(stage)) words += dashed(option.name) + " ";
    cases += fmt::format("    {}) words='{}' ;;\n", stage.name, words);
  }
  return fmt::format(R"(# goniolux: completion for bash
_goniolux() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{}--help --version' -- "$current")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $current in
    -*) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
  esac
}}
complete -o filenames -F _goniolux goniolux
)",
                     verbs, cases);
}

std::string zsh() {
  std::string verbs, cases;
  for (const Stage& stage : pipeline::stages()) {
    verbs += fmt::format("    '{}:{}'\n", stage.name, quoted(stage.title, ":"));
    std::string words;
    for (const Option& option : optionsOf(stage))
      words += fmt::format(" '{}[{}]{}'", dashed(option.name), quoted(option.help, "[]:"),
                           option.isFlag ? "" : ":" + option.name + ":_files");
    cases += fmt::format("    {}) _arguments{} '*:input:_files' ;;\n", stage.name, words);
  }
  return fmt::format(
      "#compdef goniolux\n_goniolux() {{\n  local -a verbs\n  verbs=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n    _describe verb verbs\n    return\n  fi\n"
      "  shift words\n  (( CURRENT-- ))\n  case $words[1] in\n{}  esac\n}}\n_goniolux \"$@\"\n",
      verbs, cases);
}

std::string fish() {
  std::string text = "# goniolux: completion for fish\n";
  for (const Stage& stage : pipeline::stages()) {
    text += fmt::format("complete -c goniolux -n __fish_use_subcommand -f -a {} -d '{}'\n", stage.name,
                        quoted(stage.title));
    for (const Option& option : optionsOf(stage))
      text += fmt::format("complete -c goniolux -n '__fish_seen_subcommand_from {}' {} {}{} -d '{}'\n", stage.name,
                          option.name.size() == 1 ? "-s" : "-l", option.name, option.isFlag ? "" : " -r",
                          quoted(option.help));
  }
  return text;
}

}  // namespace

std::string completionFor(const std::string& shell) {
  if (shell == "bash") return bash();
  if (shell == "zsh") return zsh();
  if (shell == "fish") return fish();
  throw core::InputError({"goniolux", 0, 0}, "usage",
                         fmt::format("--completion \"{}\": take bash, zsh or fish", shell));
}

}  // namespace goniolux::app
