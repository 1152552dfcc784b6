// PNG by libpng, which leaves a damaged file by longjmp: the
// functions between contain no object that needs a destructor.
#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstring>

#include "base/error.hpp"
#include "photograph/image_decode.hpp"

namespace fabricsh::photograph {

namespace {

struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  const char* bytes = nullptr;
  std::size_t left = 0;
  char why[120] = "not enough memory";
  png_uint_32 width = 0, height = 0;
  int bits = 0, channels = 0;
  std::size_t row_bytes = 0;
  std::vector<std::uint8_t> samples;
  std::vector<png_bytep> rows;

  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

extern "C" {

[[noreturn]] void png_failed(png_structp png, png_const_charp why) {
  auto& job = *static_cast<PngReader*>(png_get_error_ptr(png));
  std::strncpy(job.why, why, sizeof job.why - 1);
  png_longjmp(png, 1);
}

void png_quiet(png_structp, png_const_charp) {}

void png_take(png_structp png, png_bytep to, std::size_t count) {
  auto& job = *static_cast<PngReader*>(png_get_io_ptr(png));
  if (count > job.left) png_error(png, "the file ends within it");
  std::memcpy(to, job.bytes, count);
  job.bytes += count;
  job.left -= count;
}
}

// Reads the size and sets the form of the rows: 8 or 16 bits, no palette. False: see job.why.
bool read_head(PngReader& job) {
  if (setjmp(png_jmpbuf(job.png)) != 0) return false;
  png_set_read_fn(job.png, &job, png_take);
  png_read_info(job.png, job.info);
  png_set_expand(job.png);
  if (std::endian::native == std::endian::little) png_set_swap(job.png);
  png_set_interlace_handling(job.png);
  png_read_update_info(job.png, job.info);
  job.width = png_get_image_width(job.png, job.info);
  job.height = png_get_image_height(job.png, job.info);
  job.bits = png_get_bit_depth(job.png, job.info);
  job.channels = png_get_channels(job.png, job.info);
  job.row_bytes = png_get_rowbytes(job.png, job.info);
  return true;
}

bool read_rows(PngReader& job) {
  if (setjmp(png_jmpbuf(job.png)) != 0) return false;
  png_read_image(job.png, job.rows.data());
  png_read_end(job.png, nullptr);
  return true;
}

}  // namespace

Image decode_png(const Encoded& file) {
  PngReader job;
  job.bytes = file.bytes.data();
  job.left = file.bytes.size();
  job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, png_failed, png_quiet);
  if (job.png != nullptr) job.info = png_create_info_struct(job.png);
  if (job.info == nullptr || !read_head(job)) damaged(file, job.why);
  Image image = image_of_size(file, job.width, job.height, job.row_bytes / job.width);
  job.samples.resize(job.row_bytes * job.height);
  for (png_uint_32 row = 0; row < job.height; ++row) job.rows.push_back(&job.samples[row * job.row_bytes]);
  if (!read_rows(job)) damaged(file, job.why);
  for (int row = 0; row < image.height; ++row)
    fill_row(image, row, job.rows[static_cast<std::size_t>(row)], job.channels, job.bits);
  return image;
}

namespace {

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;
  std::vector<std::uint8_t> samples;
  std::vector<png_bytep> rows;

  PngWriter() = default;
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

extern "C" {

void png_give(png_structp png, png_bytep from, std::size_t count) {
  static_cast<PngWriter*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(from), count);
}

void png_flushed(png_structp) {}
}

bool write_grey(PngWriter& job, const Image& image) {
  if (setjmp(png_jmpbuf(job.png)) != 0) return false;
  png_set_write_fn(job.png, &job, png_give, png_flushed);
  png_set_compression_level(job.png, 5);
  png_set_IHDR(job.png, job.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(job.png, job.info);
  png_write_image(job.png, job.rows.data());
  png_write_end(job.png, job.info);
  return true;
}

}  // namespace

std::string png_of(const Image& image) {
  PngWriter job;
  for (const float value : image.pixels)
    job.samples.push_back(
        static_cast<std::uint8_t>(std::clamp(std::round(255.0 * static_cast<double>(value)), 0.0, 255.0)));
  for (int row = 0; row < image.height; ++row)
    job.rows.push_back(&job.samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width)]);
  job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, png_quiet);
  if (job.png != nullptr) job.info = png_create_info_struct(job.png);
  if (job.info == nullptr || !write_grey(job, image)) throw Error("image: not enough memory to write it");
  return std::move(job.bytes);
}

}  // namespace fabricsh::photograph
