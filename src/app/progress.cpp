#include "app/progress.hpp"

#include <sys/ioctl.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fabricsh::app {

namespace {

constexpr double kRedraw = 0.1, kFirstBar = 0.3;  // s, on a terminal
constexpr double kFirstLine = 2, kNextLine = 10;  // s, in a log
constexpr double kTimeFraction = 0.01;            // fraction of the time that the ledger may take

int columns_of(std::FILE* stream) {
  winsize size{};
  return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string duration_text(double seconds) {
  char text[64];
  const auto s = static_cast<long long>(std::min(std::round(seconds), 1e15));
  if (s < 60)
    std::snprintf(text, sizeof text, "%lld s", s);
  else if (s < 3600)
    std::snprintf(text, sizeof text, "%lld min %02lld s", s / 60, s % 60);
  else
    std::snprintf(text, sizeof text, "%lld h %02lld min", s / 3600, s / 60 % 60);
  return text;
}

std::string progress_text(const script::RunProgress& p, double ledger_error) {
  char text[200];
  std::snprintf(text, sizeof text, "t = %.4g of %.4g s, step %zu", p.time, p.duration, p.steps);
  std::string line = text;
  if (p.iterations > 0) line += ", " + std::to_string(p.iterations) + " iterations";
  std::snprintf(text, sizeof text, ", ledger %.1e, ", ledger_error);
  line += text + duration_text(p.elapsed);
  if (p.remaining >= 0) line += ", " + duration_text(p.remaining) + " left";
  return line;
}

std::string bar_text(double fraction, int width) {
  if (width < 6) return {};
  const int inner = width - 3;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * inner);
  std::string bar = "[" + std::string(static_cast<std::size_t>(full), '=');
  if (full < inner) bar += '>';
  bar.resize(static_cast<std::size_t>(inner + 1), ' ');
  return bar + "] ";
}

// The ledger's error, updated so seldom that it takes no more than that fraction of the time.
double ProgressLine::ledger(const script::RunProgress& p) {
  if (asked_ >= 0 && p.elapsed < asked_ + dear_ / kTimeFraction) return error_;
  const auto start = std::chrono::steady_clock::now();
  error_ = p.ledger_error();
  dear_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  asked_ = p.elapsed;
  return error_;
}

void ProgressLine::show(const script::RunProgress& p) {
  if (p.run != run_) {
    run_ = p.run;
    next_ = 0;
    asked_ = -1;
  }
  if (p.elapsed < (next_ > 0 ? next_ : terminal_ ? kFirstBar : kFirstLine)) return;
  next_ = p.elapsed + (terminal_ ? kRedraw : kNextLine);
  const std::string text = progress_text(p, ledger(p));
  if (!terminal_) {
    std::fprintf(stream_, "%s\n", text.c_str());
  } else {
    const int width = columns_of(stream_) - 1;
    const int room = std::min(30, width - static_cast<int>(text.size()));
    const std::string line = bar_text(p.duration > 0 ? p.time / p.duration : 0, room) + text;
    std::fprintf(stream_, "\r%.*s\033[K", width, line.c_str());
    drawn_ = true;
  }
  std::fflush(stream_);
}

void ProgressLine::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stream_);
  std::fflush(stream_);
  drawn_ = false;
}

}  // namespace fabricsh::app
