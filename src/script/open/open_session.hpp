// A session with the module fabric: all bindings, the library of lua/fabric, and the sandbox of --safe.
#pragma once
#include "script/session/session.hpp"

namespace fabricsh::script {

class OpenSession : public Session {
 public:
  explicit OpenSession(SessionOptions options);
};

}  // namespace fabricsh::script
