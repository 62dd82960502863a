#include "app/cli/common_options.h"

#include <utility>

namespace goniolux::app {
namespace {

using core::Parameter;
using core::ParameterKind;

Parameter text(std::string key, std::string title, std::string help) {
  Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = std::move(title);
  parameter.kind = ParameterKind::text;
  parameter.help = std::move(help);
  return parameter;
}

Parameter number(std::string key, std::string unit, double minimum, bool minimumIsAllowed, std::string help) {
  Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = "N";
  parameter.unit = std::move(unit);
  parameter.kind = ParameterKind::number;
  parameter.minimum = minimum;
  parameter.minimumIsAllowed = minimumIsAllowed;
  parameter.help = std::move(help);
  return parameter;
}

}  // namespace

const std::vector<CommonOption>& commonOptions() {
  static const std::vector<CommonOption> list = {
      {text("output", "PATH", "folder or file to write"), 'o', false, false},
      {text("accuracy", "P", "accuracy to reach, for example \"1 %\""), 0, false, true},
      {text("scene", "NAME", "lighting scene of the project"), 0, false, true},
      {text("solver", "NAME", "solver to use instead of the project's choice"), 0, false, true},
      {text("spectral", "SCHEME:N", "spectral sampling scheme and number of samples"), 0, false, true},
      {text("set", "KEY=VALUE", "any key of the project's settings, for example tree.cutoff=0.01; may be repeated"), 0,
       false, true},
      {number("time-limit", "s", 0, false, "stop after this time and say what was reached"), 0, false, true},
      {number("seed", "", 0, true, "seed of the random numbers: the same seed gives the same bytes"), 0, false, false},
      {number("threads", "", 1, true, "threads to use; never changes a result (default: all processors)"), 0, false,
       false},
      {text("json", "", "print one JSON document on standard output and nothing else there"), 0, true, false},
      {text("quiet", "", "print errors and warnings only"), 'q', true, false},
      {text("help", "", "print this help"), 'h', true, false},
  };
  return list;
}

bool applies(const CommonOption& option, const pipeline::Stage& stage) {
  return !option.needsProject || stage.inputName == "PROJECT";
}

}  // namespace goniolux::app
