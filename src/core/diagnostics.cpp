#include "core/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace goniolux::core {
namespace {

std::string join(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (!text.empty()) text += '\n';
    text += toString(diagnostic);
  }
  return text;
}

Diagnostics single(SourcePosition position, std::string rule, std::string message) {
  Diagnostics diagnostics;
  diagnostics.error(std::move(position), std::move(rule), std::move(message));
  return diagnostics;
}

}  // namespace

std::string toString(const Diagnostic& diagnostic) {
  const SourcePosition& at = diagnostic.position;
  std::string place = at.file;
  if (at.line > 0) place += fmt::format(":{}", at.line);
  if (at.line > 0 && at.column > 0) place += fmt::format(":{}", at.column);
  if (!place.empty()) place += ": ";
  const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
  return fmt::format("{}{}: {}", place, severity, diagnostic.message);
}

void Diagnostics::error(SourcePosition position, std::string rule, std::string message) {
  list_.push_back({Severity::error, std::move(position), std::move(rule), std::move(message)});
}

void Diagnostics::warning(SourcePosition position, std::string rule, std::string message) {
  list_.push_back({Severity::warning, std::move(position), std::move(rule), std::move(message)});
}

void Diagnostics::append(const Diagnostics& other) {
  list_.insert(list_.end(), other.list_.begin(), other.list_.end());
}

bool Diagnostics::hasErrors() const {
  return std::any_of(list_.begin(), list_.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

InputError::InputError(Diagnostics diagnostics)
    : std::runtime_error(join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

InputError::InputError(SourcePosition position, std::string rule, std::string message)
    : InputError(single(std::move(position), std::move(rule), std::move(message))) {}

}  // namespace goniolux::core
