// The arrays of a .vtu file: text, base64 or raw bytes, compressed or not.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "format/source.hpp"

namespace fabricsh::format {

struct VtuEncoding {
  bool big_endian = false;
  bool long_header = false;  // numbers in the headers of arrays take 8 bytes instead of 4
  std::string compressor;    // empty, or the name of VTK's compressor class
};

// The location and type of the values of one array.
struct VtuStored {
  enum class Encoding { ascii, base64, raw } form = Encoding::ascii;
  std::string_view bytes;
  std::string type;  // Int8 ... UInt64, Float32, Float64
};

class VtuDecoder {
 public:
  VtuDecoder(const Source& source, VtuEncoding encoding);
  // All values of the array. Error: text that is not a number, or sizes that do not match the bytes.
  std::vector<std::int64_t> integers(const VtuStored& stored);
  std::vector<double> reals(const VtuStored& stored);

 private:
  template <class T>
  std::vector<T> values(const VtuStored& stored);
  std::string payload(std::string_view stored);          // the bytes of the numbers, from base64 or raw
  std::string inflated(std::string_view stored);         // the same of compressed blocks
  std::uint64_t header(std::string_view& stored) const;  // takes the next number of a header off the front
  void count_bytes(std::uint64_t bytes);                 // error: more than the budget

  const Source& source_;
  VtuEncoding encoding_;
  std::uint64_t ratio_;   // the largest possible ratio of this compression
  std::uint64_t budget_;  // bytes of arrays that may still be decoded from this file
};

bool is_integer_type(std::string_view type);

// Decoding ends at the first character outside base64; padding may occur between parts encoded separately.
std::string decode_base64(std::string_view text);

}  // namespace fabricsh::format
