// The readers of photographs on any bytes: an image of as many pixels as it says, or an Error. The format is
// that of the first byte.
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "photograph/image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fabricsh;
  if (size == 0) return 0;
  const char* name = data[0] == 0x89   ? "fuzz.png"
                     : data[0] == 0xff ? "fuzz.jpg"
                     : data[0] == 'B'  ? "fuzz.bmp"
                                       : "fuzz.tif";
  try {
    const photograph::Image image =
        photograph::parse_image(name, {reinterpret_cast<const char*>(data), size});
    if (image.width < 1 || image.pixels.size() != static_cast<std::size_t>(image.width) * image.height)
      std::abort();
    for (const float pixel : image.pixels)
      if (!(pixel >= 0 && pixel <= 1)) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
