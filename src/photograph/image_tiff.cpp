// TIFF by libtiff, from memory. Grey and colour rows of 8 or 16 bits are
// read as they are; all other forms (tiles, palettes, fewer bits, other
// colour spaces) are converted by libtiff to 8 bits of red, green and blue.
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include "photograph/image_decode.hpp"

namespace fabricsh::photograph {

namespace {

struct TiffBytes {
  std::string_view bytes;
  std::uint64_t at = 0;
  char why[160] = "";
};

TiffBytes& memory_of(thandle_t handle) { return *static_cast<TiffBytes*>(handle); }

extern "C" {

tmsize_t tiff_read(thandle_t handle, void* to, tmsize_t count) {
  TiffBytes& m = memory_of(handle);
  const std::uint64_t left = m.at < m.bytes.size() ? m.bytes.size() - m.at : 0;
  const auto taken = std::min<std::uint64_t>(left, count > 0 ? static_cast<std::uint64_t>(count) : 0);
  std::memcpy(to, m.bytes.data() + std::min<std::uint64_t>(m.at, m.bytes.size()), taken);
  m.at += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t tiff_write(thandle_t, void*, tmsize_t) { return 0; }

toff_t tiff_seek(thandle_t handle, toff_t offset, int whence) {
  TiffBytes& m = memory_of(handle);
  const std::uint64_t from = whence == SEEK_CUR ? m.at : whence == SEEK_END ? m.bytes.size() : 0;
  return m.at = from + offset;
}

int tiff_close(thandle_t) { return 0; }
toff_t tiff_size(thandle_t handle) { return memory_of(handle).bytes.size(); }

// libtiff passes the handle with which the file was opened.
void tiff_failed(thandle_t handle, const char*, const char* format, va_list values) {
  if (handle == nullptr) return;
  TiffBytes& m = memory_of(handle);
  if (m.why[0] == '\0') std::vsnprintf(m.why, sizeof m.why, format, values);
}
}

struct Closer {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, Closer>;

[[noreturn]] void trouble(const Encoded& file, const TiffBytes& m) {
  damaged(file, m.why[0] != '\0' ? m.why : "libtiff can't read it");
}

std::uint32_t tag(TIFF* tiff, std::uint32_t name, std::uint32_t fallback) {
  // libtiff hands out tags of two and of four bytes in the type in which they are stored.
  if (name == TIFFTAG_IMAGEWIDTH || name == TIFFTAG_IMAGELENGTH) {
    std::uint32_t value = fallback;
    return TIFFGetField(tiff, name, &value) == 1 ? value : fallback;
  }
  std::uint16_t value = 0;
  return TIFFGetFieldDefaulted(tiff, name, &value) == 1 ? value : fallback;
}

bool known_packing(std::uint32_t packing) {
  constexpr std::uint32_t known[] = {COMPRESSION_NONE,      COMPRESSION_CCITTRLE,      COMPRESSION_CCITTFAX3,
                                     COMPRESSION_CCITTFAX4, COMPRESSION_LZW,           COMPRESSION_JPEG,
                                     COMPRESSION_PACKBITS,  COMPRESSION_ADOBE_DEFLATE, COMPRESSION_DEFLATE};
  return std::find(std::begin(known), std::end(known), packing) != std::end(known);
}

struct TiffLayout {
  std::uint32_t width, height, bits, channels, meaning, layout, sample;
};

// Whether rows can be read as they are stored.
bool plain(TIFF* tiff, const TiffLayout& f) {
  const bool grey = f.meaning == PHOTOMETRIC_MINISBLACK || f.meaning == PHOTOMETRIC_MINISWHITE;
  const bool colours = f.meaning == PHOTOMETRIC_RGB && (f.channels == 3 || f.channels == 4);
  return (f.bits == 8 || f.bits == 16) && f.layout == PLANARCONFIG_CONTIG && f.sample == SAMPLEFORMAT_UINT &&
         ((grey && f.channels <= 2) || colours) && TIFFIsTiled(tiff) == 0;
}

void read_plain(const Encoded& file, const TiffBytes& m, TIFF* tiff, const TiffLayout& f, Image& image) {
  const std::size_t needed = std::size_t{f.width} * f.channels * f.bits / 8;
  const tmsize_t line = TIFFScanlineSize(tiff);
  if (line < 0 || static_cast<std::size_t>(line) < needed) trouble(file, m);
  std::vector<std::uint8_t> samples(static_cast<std::size_t>(line));
  for (int row = 0; row < image.height; ++row) {
    if (TIFFReadScanline(tiff, samples.data(), static_cast<std::uint32_t>(row)) != 1) trouble(file, m);
    fill_row(image, row, samples.data(), static_cast<int>(f.channels), static_cast<int>(f.bits));
  }
  if (f.meaning == PHOTOMETRIC_MINISWHITE)
    for (float& pixel : image.pixels) pixel = 1 - pixel;
}

void read_converted(const Encoded& file, TiffBytes& m, TIFF* tiff, Image& image) {
  char why[1024] = "";
  if (TIFFRGBAImageOK(tiff, why) != 1) refused(file, std::string("its form is not read: ") + why);
  std::vector<std::uint32_t> raster(image.pixels.size());
  if (TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(image.width),
                                static_cast<std::uint32_t>(image.height), raster.data(), ORIENTATION_TOPLEFT,
                                1) != 1 ||
      m.why[0] != '\0')
    trouble(file, m);
  std::vector<std::uint8_t> samples(3 * static_cast<std::size_t>(image.width));
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::uint32_t pixel = raster[static_cast<std::size_t>(row) * image.width + column];
      std::uint8_t* to = &samples[3 * static_cast<std::size_t>(column)];
      to[0] = TIFFGetR(pixel), to[1] = TIFFGetG(pixel), to[2] = TIFFGetB(pixel);
    }
    fill_row(image, row, samples.data(), 3, 8);
  }
}

}  // namespace

Image decode_tiff(const Encoded& file) {
  TIFFSetErrorHandler(nullptr);  // libtiff must print nothing
  TIFFSetWarningHandler(nullptr);
  TIFFSetErrorHandlerExt(tiff_failed);
  TiffBytes m{file.bytes, 0, ""};
  const Tiff tiff(TIFFClientOpen(file.name.c_str(), "rm", &m, tiff_read, tiff_write, tiff_seek, tiff_close,
                                 tiff_size, nullptr, nullptr));
  if (!tiff) trouble(file, m);
  const TiffLayout f{
      tag(tiff.get(), TIFFTAG_IMAGEWIDTH, 0),       tag(tiff.get(), TIFFTAG_IMAGELENGTH, 0),
      tag(tiff.get(), TIFFTAG_BITSPERSAMPLE, 0),    tag(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 0),
      tag(tiff.get(), TIFFTAG_PHOTOMETRIC, 0xffff), tag(tiff.get(), TIFFTAG_PLANARCONFIG, 0),
      tag(tiff.get(), TIFFTAG_SAMPLEFORMAT, 0)};
  if (!known_packing(tag(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_NONE)))
    refused(file, "its compression is not read; save it uncompressed, or as PNG");
  const bool rows = plain(tiff.get(), f);
  Image image = image_of_size(file, f.width, f.height, rows ? f.channels * f.bits / 8 : 1);
  if (rows)
    read_plain(file, m, tiff.get(), f, image);
  else
    read_converted(file, m, tiff.get(), image);
  return image;
}

}  // namespace fabricsh::photograph
