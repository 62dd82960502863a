// What is fuzzed: each reader of files that come from elsewhere, as a function of bytes. libFuzzer drives them
// (script/fuzz); the test suite drives them with its own mutations (reader_mutations_test.cpp).
//
// A target returns when the bytes were read or refused with a reason. It ends the process on anything else: a result
// that cannot be used, a refusal without reason, or an exception other than core::InputError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace goniolux::fuzz {

enum class Outcome { read, refused };

struct Target {
  const char* name;
  std::vector<std::string_view> seedExtensions;  ///< of the files in luminaires/ and materials/ that are its seeds
  Outcome (*run)(std::string_view bytes);
  int inputs = 8000;  ///< of the bounded run in the test suite
};
const std::vector<Target>& targets();

/// The target of that name; ends the process when there is none.
const Target& targetNamed(std::string_view name);

}  // namespace goniolux::fuzz
