// SectionReader: one object of the project file, read against its table of keys (format.h). Every fault is reported
// where it stands, and reading goes on: a getter returns nothing when the key is absent or its value was refused.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/document.h"
#include "core/vector.h"
#include "project/format.h"
#include "project/reading.h"

namespace goniolux::project {

class SectionReader {
 public:
  /// Checks that `value` is an object, that it has the required keys, and no key that `section` does not know.
  /// `section` must outlive this object.
  SectionReader(const core::Value& value, const Section& section, Reading& reading);

  /// False when the value is no object: nothing can be read from it.
  [[nodiscard]] bool isObject() const { return value_.isObject(); }
  [[nodiscard]] const core::Value& value() const { return value_; }
  [[nodiscard]] bool has(const std::string& key) const { return value_.find(key) != nullptr; }
  /// The value of a key of the table as it is, or nullptr when absent.
  [[nodiscard]] const core::Value* find(const std::string& key) const;

  std::optional<double> number(const std::string& key);
  std::optional<int> integer(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<std::string> choice(const std::string& key);
  std::optional<double> length(const std::string& key);         ///< m
  std::optional<core::Vec3> point(const std::string& key);      ///< m
  std::optional<core::Vec3> direction(const std::string& key);  ///< unit
  std::optional<std::vector<core::Vec3>> points(const std::string& key);
  std::optional<std::vector<core::Vec3>> directions(const std::string& key);
  std::optional<std::array<int, 2>> counts(const std::string& key);
  std::optional<double> percentage(const std::string& key);  ///< fraction: "2 %" = 0.02

  /// True when a value was refused, so that what is missing needs no second message.
  [[nodiscard]] bool failed() const { return failed_; }
  /// An error at a key's value, or at the section itself when the key is absent.
  void refuse(const std::string& key, const std::string& rule, const std::string& message);

 private:
  const Key& known(const std::string& key) const;
  void checkKeys();

  const core::Value& value_;
  const Section& section_;
  Reading& reading_;
  bool failed_ = false;
};

/// Single values, for lists and for keys that may have several forms. Limits and the name in messages come from `key`.
std::optional<double> readNumber(const core::Value& value, const Key& key, Reading& reading);
std::optional<core::Vec3> readVector(const core::Value& value, const Key& key, Reading& reading);
std::optional<core::Vec3> readPoint(const core::Value& value, const Key& key, Reading& reading);      ///< m
std::optional<core::Vec3> readDirection(const core::Value& value, const Key& key, Reading& reading);  ///< unit
std::optional<std::string> readText(const core::Value& value, const Key& key, Reading& reading);
/// [[x, y], …]
std::optional<std::vector<core::Vec2>> readPairs(const core::Value& value, const Key& key, Reading& reading);
/// "2 %" or 0.02; nothing when the text is no percentage above 0 and below 100.
std::optional<double> fractionFromText(const std::string& text);

}  // namespace goniolux::project
