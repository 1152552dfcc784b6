#include "format/vtu_data.hpp"

#include <vtkCallbackCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

namespace fabricsh::format {

namespace {

// The largest possible compression ratio: deflate 1032, LZ4 255, LZMA some thousands for constant data.
std::uint64_t most_ratio(const std::string& compressor) {
  if (compressor == "vtkZLibDataCompressor") return 1040;
  if (compressor == "vtkLZ4DataCompressor") return 256;
  return compressor == "vtkLZMADataCompressor" ? 8000 : 1;
}

vtkSmartPointer<vtkDataCompressor> compressor_of(const std::string& name) {
  if (name == "vtkZLibDataCompressor") return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return nullptr;
}

template <class Stored, class T>
std::vector<T> converted(const std::string& bytes, bool swapped) {
  Source source("", bytes);
  source.swap_bytes(swapped);
  std::vector<T> values(bytes.size() / sizeof(Stored));
  for (T& value : values) value = static_cast<T>(source.raw<Stored>("a value"));
  return values;
}

std::size_t size_of(std::string_view type) {
  if (type.ends_with("64")) return 8;
  if (type.ends_with("32")) return 4;
  return type.ends_with("16") ? 2 : 1;
}

template <class T>
std::vector<T> converted(std::string_view type, const std::string& bytes, bool swapped) {
  if (type == "Int8") return converted<std::int8_t, T>(bytes, swapped);
  if (type == "UInt8") return converted<std::uint8_t, T>(bytes, swapped);
  if (type == "Int16") return converted<std::int16_t, T>(bytes, swapped);
  if (type == "UInt16") return converted<std::uint16_t, T>(bytes, swapped);
  if (type == "Int32") return converted<std::int32_t, T>(bytes, swapped);
  if (type == "UInt32") return converted<std::uint32_t, T>(bytes, swapped);
  if (type == "Int64") return converted<std::int64_t, T>(bytes, swapped);
  if (type == "UInt64") return converted<std::uint64_t, T>(bytes, swapped);
  if constexpr (std::is_same_v<T, double>) {
    if (type == "Float32") return converted<float, T>(bytes, swapped);
    if (type == "Float64") return converted<double, T>(bytes, swapped);
  }
  return {};
}

template <class T>
std::vector<T> words(const Source& source, std::string_view text) {
  Source list("", text);
  std::vector<T> values;
  for (auto word = list.word_or_none(); !word.empty(); word = list.word_or_none()) {
    values.emplace_back();
    if (!parse(word, values.back()))
      source.fail(std::string("expected ") + (std::is_same_v<T, double> ? "a number" : "a whole number") +
                  ", got " + in_quotes(word));
  }
  return values;
}

// VTK would print its error messages; the caller throws an Error instead.
std::size_t uncompress(vtkDataCompressor* compressor, std::string_view in, char* out, std::size_t size) {
  vtkNew<vtkCallbackCommand> quiet;
  compressor->AddObserver("ErrorEvent", quiet);
  compressor->AddObserver("WarningEvent", quiet);
  return compressor->Uncompress(reinterpret_cast<const unsigned char*>(in.data()), in.size(),
                                reinterpret_cast<unsigned char*>(out), size);
}

int sextet(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

bool is_integer_type(std::string_view type) {
  for (const char* known : {"Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64"})
    if (type == known) return true;
  return false;
}

std::string decode_base64(std::string_view text) {
  std::string bytes;
  unsigned group = 0;
  int filled = 0;
  for (const char c : text) {
    if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
    if (c == '=') {  // the rest of the group of four is padding; more groups may follow
      group = 0;
      filled = 0;
      continue;
    }
    const int value = sextet(c);
    if (value < 0) break;
    group = group << 6 | static_cast<unsigned>(value);
    // The second, third and fourth character of a group each complete a byte.
    if (++filled >= 2) bytes += static_cast<char>(group >> (6 - 2 * (filled - 1)) & 0xFFu);
    if (filled == 4) group = 0, filled = 0;
  }
  return bytes;
}

VtuDecoder::VtuDecoder(const Source& source, VtuEncoding encoding)
    : source_(source), encoding_(std::move(encoding)), ratio_(most_ratio(encoding_.compressor)) {
  if (!encoding_.compressor.empty() && compressor_of(encoding_.compressor) == nullptr)
    source_.fail("unknown compressor " + in_quotes(encoding_.compressor));
  budget_ = ratio_ * source.size();
}

void VtuDecoder::count_bytes(std::uint64_t bytes) {
  if (bytes > budget_) source_.fail("the arrays claim more bytes than a file of this size can hold");
  budget_ -= bytes;
}

std::uint64_t VtuDecoder::header(std::string_view& stored) const {
  const std::size_t size = encoding_.long_header ? 8 : 4;
  if (stored.size() < size) source_.fail("the file ends within the header of an array");
  Source number("", stored.substr(0, size));
  number.swap_bytes(encoding_.big_endian);
  stored.remove_prefix(size);
  return encoding_.long_header ? number.raw<std::uint64_t>("") : number.raw<std::uint32_t>("");
}

// Layout: [number of bytes][bytes].
std::string VtuDecoder::payload(std::string_view stored) {
  if (!encoding_.compressor.empty()) return inflated(stored);
  const std::uint64_t bytes = header(stored);
  if (bytes > stored.size())
    source_.fail("an array claims " + std::to_string(bytes) + " bytes, but only " +
                 std::to_string(stored.size()) + " follow");
  count_bytes(bytes);
  return std::string(stored.substr(0, bytes));
}

// Layout: [blocks][size of a block][size of the last one, 0: full][compressed size of each block][blocks].
std::string VtuDecoder::inflated(std::string_view stored) {
  const std::uint64_t blocks = header(stored), size = header(stored), last = header(stored);
  const std::size_t each = encoding_.long_header ? 8 : 4;
  if (blocks > stored.size() / each)
    source_.fail("an array claims " + std::to_string(blocks) + " compressed blocks");
  if (last > size) source_.fail("the last block of an array claims to be larger than the others");
  std::vector<std::uint64_t> sizes(blocks);
  for (auto& compressed : sizes) compressed = header(stored);
  const auto compressor = compressor_of(encoding_.compressor);
  std::string bytes;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t wanted = b + 1 == blocks && last != 0 ? last : size;
    if (sizes[b] > stored.size()) source_.fail("the file ends within a compressed block");
    if (wanted / ratio_ > sizes[b]) source_.fail("a compressed block claims more bytes than it can hold");
    count_bytes(wanted);
    const std::size_t before = bytes.size();
    bytes.resize(before + wanted);
    if (wanted > 0 &&
        uncompress(compressor, stored.substr(0, sizes[b]), bytes.data() + before, wanted) != wanted)
      source_.fail("a compressed block is damaged");
    stored.remove_prefix(sizes[b]);
  }
  return bytes;
}

template <class T>
std::vector<T> VtuDecoder::values(const VtuStored& stored) {
  if (stored.form == VtuStored::Encoding::ascii) return words<T>(source_, stored.bytes);
  const std::string bytes =
      stored.form == VtuStored::Encoding::raw ? payload(stored.bytes) : payload(decode_base64(stored.bytes));
  if (bytes.size() % size_of(stored.type) != 0)
    source_.fail("an array of " + stored.type + " has " + std::to_string(bytes.size()) + " bytes");
  return converted<T>(stored.type, bytes, encoding_.big_endian);
}

std::vector<std::int64_t> VtuDecoder::integers(const VtuStored& stored) {
  if (!is_integer_type(stored.type))
    source_.fail("expected an array of integers, got " + in_quotes(stored.type));
  return values<std::int64_t>(stored);
}

std::vector<double> VtuDecoder::reals(const VtuStored& stored) {
  if (!is_integer_type(stored.type) && stored.type != "Float32" && stored.type != "Float64")
    source_.fail("expected an array of numbers, got " + in_quotes(stored.type));
  return values<double>(stored);
}

}  // namespace fabricsh::format
