#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/version.hpp"
#include "catch.hpp"
#include "system/paths.hpp"

using namespace fabricsh;
namespace fs = std::filesystem;

namespace {

// An environment variable, set for the life of this object.
struct Environment {
  Environment(const char* name, const std::string& value) : name(name) { setenv(name, value.c_str(), 1); }
  ~Environment() { unsetenv(name); }
  const char* name;
};

}  // namespace

TEST_CASE("a program in its build tree finds the source tree", "[base]") {
  CHECK(fs::exists(program_path()));
  REQUIRE_FALSE(data_roots().empty());
  CHECK(fs::equivalent(data_roots().back(), FABRICSH_SOURCE_DIR));
  CHECK(fs::equivalent(data_file("src/LAYERS"), FABRICSH_SOURCE_DIR "/src/LAYERS"));
  CHECK(data_file("share/cards/no such card.lua").empty());
}

TEST_CASE("FABRICSH_HOME comes first, and only where it exists", "[base]") {
  {
    const Environment home("FABRICSH_HOME", fs::temp_directory_path().string());
    CHECK(fs::equivalent(data_roots().front(), fs::temp_directory_path()));
    CHECK(data_roots().size() > 1);
  }
  const Environment home("FABRICSH_HOME", "/no/such/folder");
  CHECK(fs::equivalent(data_roots().front(), FABRICSH_SOURCE_DIR));
}

TEST_CASE("the version is three numbers", "[base]") {
  int major = -1, minor = -1, patch = -1, length = -1;
  CHECK(std::sscanf(version().c_str(), "%d.%d.%d%n", &major, &minor, &patch, &length) == 3);
  CHECK(length == static_cast<int>(version().size()));
  CHECK_FALSE(build_kind().empty());
  CHECK_FALSE(compiler().empty());
}
