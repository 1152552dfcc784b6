// An open file of the operating system, closed with its owner.
#pragma once
#include <string_view>
#include <utility>

namespace fabricsh::system {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  // Writes all bytes. Returns 0 or the system's reason.
  int write(std::string_view bytes) const;

 private:
  int number_;
};

}  // namespace fabricsh::system
