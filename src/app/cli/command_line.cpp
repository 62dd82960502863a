#include "app/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "app/cli/common_options.h"
#include "core/closest_name.h"

namespace goniolux::app {
namespace {

using core::Parameter;
using core::ParameterKind;
using pipeline::Stage;

[[noreturn]] void usageError(const std::string& message) {
  throw core::InputError({"goniolux", 0, 0}, "usage", message);
}

const Stage& stageNamed(const std::string& verb) {
  std::vector<std::string> names;
  for (const Stage& stage : pipeline::stages()) {
    if (stage.name == verb) return stage;
    names.push_back(stage.name);
  }
  const std::string close = core::closestName(verb, names);
  usageError(fmt::format("there is no verb '{}'; {}", verb,
                         close.empty()
                             ? "goniolux --help lists the verbs"
                             : fmt::format("did you mean 'goniolux {}'? goniolux --help lists the verbs", close)));
}

// Everything is taken as text first, so that each message can name the option, what was found and what is expected.
struct Texts {
  std::vector<std::string> inputs;
  std::map<std::string, std::vector<std::string>> options;  // by key
  std::map<std::string, bool> flags;
};

// An option's value is one argument; only --set may be repeated.
void addOption(CLI::App& parser, const std::string& names, const std::string& key, Texts& texts) {
  CLI::Option* option = parser.add_option(names, texts.options[key]);
  option->expected(1)->take_all();
  option->allow_extra_args(false);
}

// A key of one letter is a short option: -j.
std::string dashed(const std::string& key) {
  return (key.size() == 1 ? "-" : "--") + key;
}

std::vector<std::string> optionNames(const Stage& stage) {
  std::vector<std::string> names;
  for (const Parameter& parameter : stage.options) names.push_back(dashed(parameter.key));
  for (const CommonOption& option : commonOptions())
    if (applies(option, stage)) names.push_back("--" + option.parameter.key);
  return names;
}

// What CLI11 did not recognise: an option of another verb or a misspelt one.
void refuseUnknownOptions(const Stage& stage, const std::vector<std::string>& remaining) {
  for (const std::string& argument : remaining) {
    if (argument == "--") continue;  // what ends the options; CLI11 hands it over as well
    const std::string name = argument.substr(0, argument.find('='));
    for (const CommonOption& option : commonOptions())
      if (name == "--" + option.parameter.key)
        usageError(
            fmt::format("{} steers a calculation from a project, which 'goniolux {}' does not make; leave it out", name,
                        stage.name));
    const std::string close = core::closestName(name, optionNames(stage));
    usageError(fmt::format("'goniolux {}' has no option {}; {}goniolux {} --help lists the options", stage.name, name,
                           close.empty() ? "" : fmt::format("did you mean '{}'? ", close), stage.name));
  }
}

void checkInputCount(const Stage& stage, const std::vector<std::string>& inputs) {
  if (!stage.inputName.empty() && inputs.empty())
    usageError(fmt::format("'goniolux {0}' needs {1}; goniolux {0} --help says more", stage.name,
                           stage.manyInputs ? "one " + stage.inputName + " or more" : "a " + stage.inputName));
  const std::size_t most = stage.inputName.empty() ? 0 : 1;
  if (!stage.manyInputs && inputs.size() > most)
    usageError(fmt::format("'goniolux {}' takes {}; leave out '{}'", stage.name,
                           most == 0 ? "no input" : "one " + stage.inputName, inputs[most]));
}

double toNumber(const std::string& option, const Parameter& parameter, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value))
    usageError(fmt::format("{} needs a number{}, not '{}'", option,
                           parameter.unit.empty() ? "" : " in " + parameter.unit, text));
  const bool tooSmall = value < parameter.minimum || (value == parameter.minimum && !parameter.minimumIsAllowed);
  if (tooSmall)
    usageError(fmt::format("{} must be {} {}; found {}", option, parameter.minimumIsAllowed ? "at least" : "above",
                           parameter.minimum, text));
  if (value > parameter.maximum)
    usageError(fmt::format("{} must be at most {}; found {}", option, parameter.maximum, text));
  return value;
}

std::uint64_t toCount(const std::string& option, std::uint64_t minimum, std::uint64_t maximum,
                      const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < minimum || value > maximum)
    usageError(fmt::format("{} needs a whole number from {} to {}, not '{}'", option, minimum, maximum, text));
  return value;
}

// The text of an option that was given once; nothing when it was not given.
std::optional<std::string> only(const Texts& texts, const std::string& key) {
  const auto found = texts.options.find(key);
  if (found == texts.options.end() || found->second.empty()) return std::nullopt;
  if (found->second.size() > 1)
    usageError(fmt::format("--{} is given {} times; give it once", key, found->second.size()));
  if (found->second.front().empty()) usageError(fmt::format("--{} is empty; give it a value or leave it out", key));
  return found->second.front();
}

void readCommonOptions(const Texts& texts, CommandLine& line) {
  pipeline::CommonOptions& common = line.request.common;
  common.output = only(texts, "output");
  common.accuracy = only(texts, "accuracy");
  common.solver = only(texts, "solver");
  common.spectral = only(texts, "spectral");
  common.scene = only(texts, "scene");
  // Seeds travel through JSON documents, whose numbers are exact up to 2^53.
  if (const auto text = only(texts, "seed")) common.seed = toCount("--seed", 0, std::uint64_t{1} << 53, *text);
  if (const auto text = only(texts, "threads")) line.threads = static_cast<int>(toCount("--threads", 1, 1024, *text));
  if (const auto text = only(texts, "time-limit")) {
    Parameter seconds;
    seconds.unit = "s";
    seconds.minimum = 0;
    seconds.minimumIsAllowed = false;
    common.timeLimit_s = toNumber("--time-limit", seconds, *text);
  }
  if (const auto set = texts.options.find("set"); set != texts.options.end()) common.set = set->second;
  for (const std::string& assignment : common.set)
    if (assignment.find('=') == std::string::npos || assignment.front() == '=')
      usageError(fmt::format("--set needs KEY=VALUE, not '{}'; for example --set tree.cutoff=0.01", assignment));
}

void readOwnOptions(const Stage& stage, const Texts& texts, CommandLine& line) {
  for (const Parameter& parameter : stage.options) {
    const std::string option = dashed(parameter.key);
    if (parameter.kind == ParameterKind::boolean) {
      if (const auto given = texts.flags.find(parameter.key); given != texts.flags.end() && given->second)
        line.request.options[parameter.key] = "true";
      continue;
    }
    const auto text = only(texts, parameter.key);
    if (text) {
      if (parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::length)
        toNumber(option, parameter, *text);
      line.request.options[parameter.key] = *text;
    } else if (parameter.required) {
      usageError(fmt::format("'goniolux {}' needs {} ({}); goniolux {} --help says more", stage.name, option,
                             parameter.title, stage.name));
    }
  }
}

CommandLine parseVerb(const Stage& stage, const std::vector<std::string>& arguments) {
  CLI::App parser;
  parser.set_help_flag();
  parser.allow_extras();
  Texts texts;
  parser.add_option("inputs", texts.inputs);
  for (const Parameter& parameter : stage.options) {
    if (parameter.kind == ParameterKind::boolean)
      parser.add_flag(dashed(parameter.key), texts.flags[parameter.key]);
    else
      addOption(parser, dashed(parameter.key), parameter.key, texts);
  }
  for (const CommonOption& option : commonOptions()) {
    if (!applies(option, stage)) continue;
    const std::string& key = option.parameter.key;
    const std::string names = (option.letter ? fmt::format("-{},", option.letter) : "") + "--" + key;
    if (option.isFlag)
      parser.add_flag(names, texts.flags[key]);
    else
      addOption(parser, names, key, texts);
  }

  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // the order that CLI11's parse wants
  try {
    parser.parse(reversed);
  } catch (const CLI::ParseError& error) {
    usageError(fmt::format("{}; goniolux {} --help lists the options", error.what(), stage.name));
  }

  CommandLine line;
  line.stage = &stage;
  line.json = texts.flags["json"];
  line.quiet = texts.flags["quiet"];
  if (texts.flags["help"]) {
    line.action = CommandLine::Action::printHelp;
    return line;
  }
  refuseUnknownOptions(stage, parser.remaining());
  checkInputCount(stage, texts.inputs);
  line.request.inputs = texts.inputs;
  readCommonOptions(texts, line);
  readOwnOptions(stage, texts, line);
  return line;
}

}  // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  CommandLine line;
  line.action = CommandLine::Action::printHelp;
  if (arguments.empty()) usageError("no verb is given; goniolux --help lists the verbs");
  const std::string& first = arguments.front();
  if (first == "--version") {
    line.action = CommandLine::Action::printVersion;
    return line;
  }
  if (first == "--man" || first == "--completion" || first == "--verbs") {
    line.action = first == "--man"     ? CommandLine::Action::printManual
                  : first == "--verbs" ? CommandLine::Action::printVerbs
                                       : CommandLine::Action::printCompletion;
    if (first == "--man" && arguments.size() > 1) line.stage = &stageNamed(arguments[1]);
    if (first == "--completion") line.shell = arguments.size() > 1 ? arguments[1] : "";
    return line;
  }
  if (first == "--help" || first == "-h" || first == "help") {
    if (first == "help" && arguments.size() > 1) line.stage = &stageNamed(arguments[1]);
    return line;
  }
  if (first.starts_with('-'))
    usageError(fmt::format("the verb comes first: goniolux VERB {} …; goniolux --help lists the verbs", first));
  return parseVerb(stageNamed(first), {arguments.begin() + 1, arguments.end()});
}

}  // namespace goniolux::app
