// Variables without a value: a misspelt name is said, a name whose value is asked for is not.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "script/open/open_session.hpp"

using namespace fabricsh::script;

namespace {

std::vector<std::string> said_by(const std::string& code) {
  const auto file = std::filesystem::temp_directory_path() / ("unset_" + std::to_string(getpid()) + ".lua");
  std::ofstream(file) << code;
  std::vector<std::string> said;
  SessionOptions options;
  options.notice = [&](const std::string& text) { said.push_back(text); };
  OpenSession session(options);
  INFO(code);
  CHECK(luaL_dofile(session.lua(), file.c_str()) == LUA_OK);
  std::filesystem::remove(file);
  for (std::string& text : said) text.erase(0, text.find(".lua:") + 5);
  return said;
}

}  // namespace

TEST_CASE("a variable without a value is said with its line, once") {
  const auto said = said_by(
      "local ball, mu = 1, .3 local function passed() end\n"
      "local between = { ball, 'all', bal }\n"
      "for i = 1, 3 do local t = { friction = m_u } end\n"
      "local same = { twice = twice }\n"
      "print(\n"
      "  last\n"
      ")\n"
      "print(passed(called) or 3)\n"
      "local n = counted -- counted or 3\n");
  REQUIRE(said.size() == 6);
  CHECK(said[0] == "2: the variable 'bal' has no value (misspelt? where none is meant, write bal or nil)");
  CHECK(said[1].starts_with("3: the variable 'm_u'"));
  CHECK(said[2].starts_with("4: the variable 'twice'"));
  CHECK(said[3].find("the variable 'last'") != std::string::npos);
  CHECK(said[4].starts_with("8: the variable 'called'"));
  CHECK(said[5].starts_with("9: the variable 'counted'"));
}

TEST_CASE("where a deck asks for the value, nothing is said") {
  CHECK(said_by("local n = N or 20\n"
                "size = size or 3\n"
                "if DEBUG then print(1) elseif not QUICK then n = 21 end\n"
                "local known, kind = type(jit) == 'table', _G.other\n"
                "if part == nil then part = n end\n"
                "local u = unpack or table.unpack\n"
                "local other, m = _G['named'], ((most) or 3)\n"
                "if (flag) then print(1) elseif (other) == nil then n = 22 end\n"
                "local mode = given -- where there is one\n"
                "  or 'fast'\n"
                "local both =\n"
                "  n and\n"
                "  mine\n"
                "repeat n = n - 1 until stop or n < 0\n")
            .empty());
}
