// Warnings, notices and progress go through a sink that the program installs: no room below app and repl
// prints. The sink is handed down explicitly (no globals).
#pragma once
#include <functional>
#include <set>
#include <string>

namespace fabricsh {

// Where warnings and notices go. once(key, text) says a thing a single time in the life of this object.
class Notices {
 public:
  using Sink = std::function<void(const std::string& text)>;
  explicit Notices(Sink sink = {}) : sink_(std::move(sink)) {}
  void say(const std::string& text) const {
    if (sink_) sink_(text);
  }
  void once(const std::string& key, const std::string& text) {
    if (said_.insert(key).second) say(text);
  }

 private:
  Sink sink_;
  std::set<std::string> said_;
};

}  // namespace fabricsh
