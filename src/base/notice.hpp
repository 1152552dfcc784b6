// Warnings, notices and progress go to a sink that the program installs, because no room
// below app and repl may print. The sink is passed as an argument; there are no globals.
#pragma once
#include <functional>
#include <set>
#include <string>

namespace fabricsh {

// Where warnings and notices go. once(key, text) shows the text for a key only once; remark() says, once,
// what something was taken for or how it goes, which nobody needs who wants quiet.
class Notices {
 public:
  using Sink = std::function<void(const std::string& text)>;
  explicit Notices(Sink sink = {}, bool quiet = false) : sink_(std::move(sink)), quiet_(quiet) {}
  void say(const std::string& text) const {
    if (sink_) sink_(text);
  }
  void once(const std::string& key, const std::string& text) {
    if (said_.insert(key).second) say(text);
  }
  void remark(const std::string& text) {
    if (!quiet_) once(text, text);
  }

 private:
  Sink sink_;
  bool quiet_;
  std::set<std::string> said_;
};

}  // namespace fabricsh
