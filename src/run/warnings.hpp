// Warnings of a run on how far its results can be trusted: a word for each kind, which a batch can look for.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/archive.hpp"

namespace fabricsh::run {

struct Warning {
  std::string code;           // of a WarningKind
  std::string text;           // one line
  double time = 0;            // s, of the run when it was said
  std::int64_t element = -1;  // numbered from 0; -1: no particular element
  bool serious = false;       // the results from here on are not to be trusted
  void keep(Archive& archive) { archive(code, text, time, element, serious); }
};

struct WarningKind {
  const char* code;
  const char* sentence;  // when it is said
  bool serious = false;
};

// All kinds; share/doc/warnings.md explains each.
std::span<const WarningKind> warning_kinds();
// Assert: there is such a kind.
const WarningKind& warning_kind(std::string_view code);

}  // namespace fabricsh::run
