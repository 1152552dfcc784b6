// The calls by which a deck has driven a run, and what it has read of the run between them. A checkpoint
// stores both, so that a restarted deck, which passes over the calls made before the checkpoint, reads what
// it read then.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::script {

enum class CallKind : std::uint8_t { solve, advance, step, reach, restore };

// A call, with its target time.
struct Drive {
  CallKind made = CallKind::solve;
  double target = 0;       // s; of advance(), and for the progress of others
  std::uint64_t from = 0;  // number of steps before it
  void keep(Archive& archive) { archive(made, target, from); }
  bool same(const Drive& other) const {
    return made == other.made && (made != CallKind::advance || target == other.target);
  }
  std::string words() const;  // "advance(0.5)"
};

struct FailedCall {
  std::int64_t call = 0;
  bool numerical = false;
  std::string message;
  double time = 0;
  std::int64_t element = -1;
  std::string yarn, why;
  std::string value;  // a value raised by a hook, packed as a table with one entry; empty: there is a message
  void keep(Archive& archive) { archive(call, numerical, message, time, element, yarn, why, value); }
};

// Values by key, up to a total size.
class Notes {
 public:
  static constexpr std::size_t most_bytes = std::size_t{32} << 20;

  const std::string* find(const std::string& key) const {
    const auto found = notes_.find(key);
    return found == notes_.end() ? nullptr : &found->second;
  }
  // False: there is no room for it, and from now on for none, so that what is missing is the end.
  bool put(const std::string& key, std::string value);
  bool full() const { return full_; }
  void keep(Archive& archive);

 private:
  std::map<std::string, std::string> notes_;
  std::size_t bytes_ = 0;
  bool full_ = false;
};

struct Calls {
  std::int64_t count = 0;    // including the present one
  std::int64_t changes = 0;  // of settings or by stop() since the last call
  std::vector<Drive> made;   // all of them, in their order
  std::vector<FailedCall> failed;
  // Whether a call after this one has returned to a snapshot.
  bool restored_after(std::int64_t call) const;
  Notes read;    // results, by the moment and the expression
  Notes tables;  // kept tables at the ends of calls that changed them
  void keep(Archive& archive) {
    archive.section("calls", [&] { archive(count, made, failed, read, tables); });
  }
};

}  // namespace fabricsh::script
