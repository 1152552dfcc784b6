// The message of an action that fails, and a check on its words.
#pragma once
#include <functional>
#include <string>

#include "base/error.hpp"
#include "catch.hpp"

namespace fabricsh {

// The text of the Error that act raises, or "no error".
inline std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

inline void says(const std::string& message, const std::string& part) {
  INFO("message: " << message << "\n  expected: " << part);
  CHECK(message.find(part) != std::string::npos);
}

}  // namespace fabricsh
