// An option of a verb that takes a text.
#pragma once

#include "core/parameter.h"

namespace goniolux::pipeline {

/// `standard`: what holds without the option, as the help says it; "": nothing.
inline core::Parameter textOption(const char* key, const char* title, const char* standard, const char* help,
                                  bool required) {
  core::Parameter p;
  p.key = key;
  p.title = title;
  p.kind = core::ParameterKind::text;
  p.defaultText = standard;
  p.help = help;
  p.required = required;
  return p;
}

}  // namespace goniolux::pipeline
