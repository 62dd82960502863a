// Words and numbers of the report: texts in the reader's language, quantities in the reader's units.
#pragma once

#include <string>

#include "core/estimate.h"
#include "report/report.h"

namespace goniolux::report {

class Words {
 public:
  Words(Language language, Units units) : german_(language == Language::german), imperial_(units == Units::imperial) {}

  /// The text in the reader's language; `english` is the key. A text without a translation stays as it is.
  [[nodiscard]] std::string operator()(const std::string& english) const;
  [[nodiscard]] bool hasTranslation(const std::string& english) const;
  /// A sentence of the calculation with numbers and names in it ("wavelengths between 7 spectral samples: …").
  [[nodiscard]] std::string sentence(const std::string& english) const;

  /// A number with a fixed count of decimals, with the language's decimal sign and thousands apart.
  [[nodiscard]] std::string number(double value, int decimals) const;
  /// "551.5 ± 1.7" in the reader's units; without the unit's name.
  [[nodiscard]] std::string estimate(const core::Estimate& e, const std::string& unit) const;
  /// A value without its half-width, with three significant digits.
  [[nodiscard]] std::string value(double value, const std::string& unit) const;
  /// "lx" or "fc", and so on: the name of the reader's unit for `metric`.
  [[nodiscard]] std::string unitName(const std::string& metric) const;
  /// What the reader's unit measures of one metric unit: fc per lx, ft per m.
  [[nodiscard]] double factor(const std::string& metric) const;
  [[nodiscard]] std::string length(double metres, int decimals = 2) const;

  [[nodiscard]] bool german() const { return german_; }
  [[nodiscard]] bool imperial() const { return imperial_; }

 private:
  bool german_, imperial_;
};

/// The key of a limit as a reader knows it: "mean_lx" is "Mean illuminance".
std::string limitName(const std::string& key);
/// The unit of a limit's key: "lx", or "" for numbers.
std::string limitUnit(const std::string& key);

}  // namespace goniolux::report
