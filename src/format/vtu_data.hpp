// The arrays of a .vtu file: text, base64 or raw bytes, compressed or not.
#pragma once
#include <string>
#include <vector>

#include "format/source.hpp"

namespace fabricsh::format {

struct VtuEncoding {
  bool big_endian = false;
  bool long_header = false;  // numbers of the headers take 8 bytes instead of 4
  std::string compressor;    // empty, or the name of VTK's class
};

// Where the values of one array are.
struct VtuStored {
  enum class Form { ascii, base64, raw } form = Form::ascii;
  std::string_view bytes;
  std::string type;  // Int8 ... UInt64, Float32, Float64
};

class VtuDecoder {
 public:
  VtuDecoder(const Source& source, VtuEncoding encoding);
  // All values of the array. Error: text that is no number, sizes that the bytes do not bear out.
  std::vector<std::int64_t> integers(const VtuStored& stored);
  std::vector<double> reals(const VtuStored& stored);

 private:
  template <class T>
  std::vector<T> values(const VtuStored& stored);
  std::string payload(std::string_view stored);
  std::string inflated(std::string_view stored);
  std::uint64_t header(std::string_view& stored) const;
  void spend(std::uint64_t bytes);

  const Source& source_;
  VtuEncoding encoding_;
  std::uint64_t ratio_;   // the most that the compression can do
  std::uint64_t budget_;  // bytes of arrays that this file can still hold
};

bool is_integer_type(std::string_view type);

// Characters that are not base64 end it; padding may stand between parts that were encoded one by one.
std::string decode_base64(std::string_view text);

}  // namespace fabricsh::format
