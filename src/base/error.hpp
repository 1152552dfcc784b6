// Two of the three kinds of failure as exceptions; the third, a bug, is an assert.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace fabricsh {

// A deck error: the user asked for something impossible. The script room puts deck:line
// in front of the message, which reads "call: field 'x': expected ..., got ...".
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A numerical failure that cutting the step did not cure; it says where it occurred and what to try.
class NumericalFailure : public std::runtime_error {
 public:
  NumericalFailure(const std::string& message, double time, std::int64_t element = -1, std::string yarn = {})
      : std::runtime_error(message), time(time), element(element), yarn(std::move(yarn)) {}
  double time;           // s, the last committed time
  std::int64_t element;  // numbered from 0; -1: no particular element
  std::string yarn;      // "warp", "weft", "shear" or empty
  std::string why;       // a report of several lines; may be empty
};

}  // namespace fabricsh
