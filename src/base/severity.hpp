// The severity of a finding of a check.
#pragma once

namespace fabricsh {

enum class Severity { note, warning, error };

inline const char* name(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

}  // namespace fabricsh
