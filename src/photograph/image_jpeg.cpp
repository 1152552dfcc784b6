// JPEG by libjpeg, which leaves a damaged file by longjmp (no destructors lie on its
// way). A truncated file makes libjpeg warn and invent the rest; here that is an error.
#include <csetjmp>
#include <cstdio>
#include <cstring>
// jpeglib.h needs cstdio to be included before it.
#include <jerror.h>
#include <jpeglib.h>

#include "photograph/image_decode.hpp"

namespace fabricsh::photograph {

namespace {

// A file of a few bytes can ask for thousands of scans over an image of any size.
constexpr int most_scans = 500;
constexpr long most_memory = 1L << 30;

struct JpegReader {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf back{};
  char why[JMSG_LENGTH_MAX] = "";
  std::vector<std::uint8_t> row;

  JpegReader() = default;
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
};

JpegReader& job_of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

extern "C" {

[[noreturn]] void jpeg_failed(j_common_ptr jpeg) {
  JpegReader& job = job_of(jpeg);
  jpeg->err->format_message(jpeg, job.why);
  std::longjmp(job.back, 1);
}

// Harmless warnings about files from cameras: markers of other programs, a few bytes of padding at the end.
bool harmless(const jpeg_error_mgr& said) {
  constexpr int end_of_image = 0xd9, padding = 16;
  return said.msg_code == JWRN_ADOBE_XFORM || said.msg_code == JWRN_JFIF_MAJOR ||
         (said.msg_code == JWRN_EXTRANEOUS_DATA && said.msg_parm.i[0] <= padding &&
          said.msg_parm.i[1] == end_of_image);
}

void jpeg_message(j_common_ptr jpeg, int level) {
  if (level < 0 && !harmless(*jpeg->err)) jpeg_failed(jpeg);
}

void jpeg_watch(j_common_ptr jpeg) {
  if (jpeg->is_decompressor && reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans) {
    std::strcpy(job_of(jpeg).why, "too many scans");
    std::longjmp(job_of(jpeg).back, 1);
  }
}
}

bool begin(JpegReader& job, const Encoded& file) {
  job.jpeg.err = jpeg_std_error(&job.errors);
  job.errors.error_exit = jpeg_failed;
  job.errors.emit_message = jpeg_message;
  job.jpeg.client_data = &job;
  if (setjmp(job.back) != 0) return false;
  jpeg_create_decompress(&job.jpeg);
  job.jpeg.mem->max_memory_to_use = most_memory;
  job.progress.progress_monitor = jpeg_watch;
  job.jpeg.progress = &job.progress;
  jpeg_mem_src(&job.jpeg, reinterpret_cast<const unsigned char*>(file.bytes.data()),
               static_cast<unsigned long>(file.bytes.size()));
  jpeg_read_header(&job.jpeg, TRUE);
  return true;
}

// Grey images are decoded as they are, all others as red, green and blue.
bool start(JpegReader& job) {
  if (setjmp(job.back) != 0) return false;
  const auto space = job.jpeg.jpeg_color_space;
  if (space == JCS_CMYK || space == JCS_YCCK) {
    std::strcpy(job.why, "four inks instead of grey or colours");
    return false;
  }
  job.jpeg.out_color_space = space == JCS_GRAYSCALE ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_start_decompress(&job.jpeg);
  return true;
}

bool read_row(JpegReader& job) {
  if (setjmp(job.back) != 0) return false;
  JSAMPROW row = job.row.data();
  return jpeg_read_scanlines(&job.jpeg, &row, 1) == 1;
}

bool finish(JpegReader& job) {
  if (setjmp(job.back) != 0) return false;
  return jpeg_finish_decompress(&job.jpeg) == TRUE;
}

}  // namespace

Image decode_jpeg(const Encoded& file) {
  JpegReader job;
  if (!begin(job, file)) damaged(file, job.why);
  Image image = image_of_size(file, job.jpeg.image_width, job.jpeg.image_height,
                              static_cast<std::uint64_t>(job.jpeg.num_components));
  if (!start(job)) damaged(file, job.why);
  job.row.resize(static_cast<std::size_t>(job.jpeg.output_width) * job.jpeg.output_components);
  for (int row = 0; row < image.height; ++row) {
    if (!read_row(job)) damaged(file, job.why);
    fill_row(image, row, job.row.data(), job.jpeg.output_components, 8);
  }
  if (!finish(job)) damaged(file, job.why);
  return image;
}

}  // namespace fabricsh::photograph
