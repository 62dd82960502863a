// One program per target: GONIOLUX_FUZZ_TARGET is its name.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const goniolux::fuzz::Target& target = goniolux::fuzz::targetNamed(GONIOLUX_FUZZ_TARGET);
  (void)target.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
