// Reading the members of a device file: checks and complaints with their place.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "spectrum/colorimetry.h"

namespace goniolux::display {

class DeviceSection {
 public:
  explicit DeviceSection(core::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void complain(const core::Value& at, const char* rule, std::string message) const;
  /// Complains about every key that is not known.
  void checkKeys(const core::Value& object, const std::vector<std::string>& known) const;
  /// The member, which must be there and of this kind ("must be `what`"); nullptr otherwise, after a complaint.
  const core::Value* member(const core::Value& object, const char* key, core::Value::Kind kind, const char* what) const;
  std::string text(const core::Value& object, const char* key) const;
  spectrum::Chromaticity chromaticity(const core::Value& object, const char* key) const;
  double number(const core::Value& object, const char* key, double standard, double minimum, double maximum) const;
  [[nodiscard]] bool hasErrors() const { return diagnostics_.hasErrors(); }

 private:
  core::Diagnostics& diagnostics_;
};

struct Device;
/// The part of a device file whose "kind" is "film-recorder" (docs/methods/display.md).
void readFilm(const core::Value& root, const DeviceSection& section, Device& device);

}  // namespace goniolux::display
