// The page of a terminal: the few escape sequences that an editor of lines needs, on a page without
// bottom.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

class Screen {
 public:
  explicit Screen(std::size_t width) : width_(width) {}

  void take(const std::string& bytes) {
    for (const char c : bytes) take(c);
  }
  // Lines without blanks at their ends; bytes of UTF-8 letters count as one place.
  std::vector<std::string> lines() const {
    std::vector<std::string> out;
    for (const auto& row : rows_) {
      std::string line;
      for (const std::string& place : row) line += place;
      out.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
    }
    return out;
  }

 private:
  using Row = std::vector<std::string>;

  void take(char c) {
    if (!sequence_.empty()) return in_sequence(c);
    if (c == '\033') {
      sequence_ = c;
    } else if (c == '\r') {
      x_ = 0;
    } else if (c == '\n') {
      down();
    } else if (c == '\t') {
      x_ = std::min(width_ - 1, (x_ / 8 + 1) * 8);
    } else if (c == '\b') {
      x_ -= x_ > 0 ? 1 : 0;
    } else if (static_cast<unsigned char>(c) >= 0x80 && static_cast<unsigned char>(c) < 0xC0) {
      here(x_ > 0 ? x_ - 1 : 0) += c;
    } else if (static_cast<unsigned char>(c) >= ' ') {
      put(c);
    }
  }

  void put(char c) {
    if (x_ >= width_) {
      x_ = 0;
      down();
    }
    here(x_++) = std::string(1, c);
  }

  void down() {
    if (++y_ >= rows_.size()) rows_.resize(y_ + 1);
  }

  std::string& here(std::size_t x) {
    Row& row = rows_[y_];
    if (row.size() <= x) row.resize(x + 1, " ");
    return row[x];
  }

  void in_sequence(char c) {
    sequence_ += c;
    if (sequence_.size() == 2 && (c == '[' || c == '(' || c == ')')) return;
    const bool csi = sequence_[1] == '[';
    if (csi && (c < '@' || c > '~')) return;
    if (csi) control(c);
    sequence_.clear();
  }

  std::size_t number(std::size_t otherwise) const {
    const std::string digits = sequence_.substr(2, sequence_.size() - 3);
    return digits.empty() || digits[0] < '0' || digits[0] > '9' ? otherwise : std::stoul(digits);
  }

  void control(char c) {
    Row& row = rows_[y_];
    if (c == 'A') y_ -= std::min(y_, number(1));
    if (c == 'B')
      for (std::size_t n = number(1); n > 0; --n) down();
    if (c == 'C') x_ = std::min(width_ - 1, x_ + number(1));
    if (c == 'D') x_ -= std::min(x_, number(1));
    if ((c == 'K' || c == 'J') && number(0) == 0) row.resize(std::min(row.size(), x_));
    if (c == 'J' && number(0) == 0) rows_.resize(y_ + 1);
    const auto at = static_cast<std::ptrdiff_t>(std::min(x_, row.size()));
    if (c == 'P')
      row.erase(row.begin() + at, row.begin() + at +
                                      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(number(1)),
                                                               row.end() - row.begin() - at));
    if (c == '@') row.insert(row.begin() + at, number(1), " ");
  }

  std::size_t width_, x_ = 0, y_ = 0;
  std::vector<Row> rows_ = std::vector<Row>(1);
  std::string sequence_;
};
