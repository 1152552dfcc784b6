#include "script/show/transcript.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/version.hpp"
#include "system/atomic.hpp"
#include "system/gate.hpp"

namespace fabricsh::script {

void Transcript::start(const std::string& path) {
  const system::Gate& gate = system::Gate::of_process();
  gate.writing(path);  // if writing is not permitted, the error is raised before anything else
  if (path != path_ && gate.exists(path))
    throw Error("'" + path + "' exists already; take another name, or remove it");
  ++changes_;
  const std::string before = std::exchange(path_, path);
  try {
    write();
  } catch (const Error&) {
    path_ = before;
    throw;
  }
}

void Transcript::end() {
  ++changes_;
  path_.clear();
}

void Transcript::add(const std::string& text) {
  body_ += text;
  if (!path_.empty()) write();
}

// Only names that no other code uses are local, so that the typed text means the same as at the prompt.
std::string Transcript::deck() const {
  return "-- A session of fabricsh " + std::string(version()) +
         ", saved as a deck: it does again what was typed.\n"
         "local fabric = require \"fabric\"; fabric.globals()\n"
         "local function _show(...) if select(\"#\", ...) > 0 then print(...) end end\n\n" +
         body_;
}

void Transcript::write() const { system::write_file(path_, deck()); }

}  // namespace fabricsh::script
