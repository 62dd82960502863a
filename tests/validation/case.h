// A validation case: numbers of the engine beside numbers that do not come from it.
//
// A case says where its reference comes from (a closed form written for this suite, a published table, another
// program), what other tools have published for it, and how near is near enough. The cases of each section are a table
// in a file of their own (cie171.cpp, direct.cpp, ...); sections.h lists the sections, page.h writes
// docs/validation.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace goniolux::validation {

/// One number of a case. `halfWidth` 0: calculated without chance.
struct Number {
  std::string what;  ///< which one: "A", "rho 0.9, face centre"
  double reference = 0;
  double ours = 0, halfWidth = 0;
  double uncertainty = 0;  ///< of the reference, absolute
};

struct Case {
  std::string id, title;  ///< "1.2", "CIE 171, 5.3: area source"
  std::string unit;       ///< of the numbers; "" for ratios
  std::string scene;      ///< what is calculated, in a sentence
  std::string source;     ///< of the reference
  std::string others;     ///< what other tools published; "" where nothing is known
  /// Relative. Of a number without chance: how far it may be off. Of one with an interval: how wide that may be.
  double tolerance = 0;
  double scale = 0;           ///< numbers whose reference is smaller than this are judged as if it were this
  bool takesMinutes = false;  ///< left to script/validation
  std::function<std::vector<Number>()> calculate;
  /// What is wrong in the program, where the case is known to fail: it turns red on the day it passes.
  std::string knownDefect = "";
};

struct Section {
  std::string title, introduction;
  std::vector<Case> cases;
};

enum class NumberVerdict { right, outside, wrong };
/// Without chance: right within the tolerance, else wrong. With an interval: right when the interval (the reference's
/// uncertainty added) holds the reference, wrong when twice that does not or when the interval is wider than the
/// tolerance, else outside, which chance allows now and then.
NumberVerdict verdictOf(const Number& number, const Case& of);

struct Verdict {
  std::size_t right = 0, outside = 0, wrong = 0;
  double largest = 0;        ///< deviation, relative to the reference or the case's scale
  double widest = 0;         ///< interval's half-width, relative likewise
  bool byChance = false;     ///< some numbers have intervals
  bool withinChance = true;  ///< no more numbers outside than 95 % intervals leave (99 times in 100)
  [[nodiscard]] bool passed() const { return wrong == 0 && withinChance && right > 0; }
};
Verdict verdictOf(const std::vector<Number>& numbers, const Case& of);

/// Deviation of a number from its reference, relative to the reference or the case's scale.
double deviationOf(const Number& number, const Case& of);

}  // namespace goniolux::validation
