// A reader of sewing patterns (PARSER) on any bytes: pieces whose lines are closed and finite, or an Error.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "format/pattern.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fabricsh;
  try {
    for (const auto& piece :
         format::PARSER("fuzz", {reinterpret_cast<const char*>(data), size}, 1e-3, nullptr))
      for (const auto& side : piece.panel.outline)
        if (!std::isfinite(side.curve.length()) || !side.curve.start().allFinite()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
