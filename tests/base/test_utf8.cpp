// Names that every file format can hold.
#include "base/utf8.hpp"
#include "catch.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace std::string_literals;

TEST_CASE("plain text is UTF-8 without control characters") {
  for (const std::string text : {"", "left edge",
                                 "gr\xC3\xB6\xC3\x9F"
                                 "e",
                                 "\xE5\xB8\x83", "\xF0\x9F\xA7\xB5", "a & <b>", "\xEF\xBF\xBD"}) {
    INFO(text);
    CHECK(is_plain(text));
    CHECK(made_plain(text) == text);
  }
  for (const std::string& text : {"a\0b"s, "edge \x1B one"s, "two\nlines"s, "a\tb"s, "\x7F"s,
                                  "gr\xF6\xDF"
                                  "e"s,
                                  "\xC0\x80"s, "\xED\xA0\x80"s, "\xEF\xBF\xBE"s, "\xEF\xBF\xBF"s,
                                  "\xF4\x90\x80\x80"s, "cut \xE5\xB8"s}) {
    CHECK_FALSE(is_plain(text));
    CHECK(is_plain(made_plain(text)));
  }
  CHECK(made_plain("gr\xF6\xDF"
                   "e \x1B") ==
        "gr\xC3\xB6\xC3\x9F"
        "e  ");  // as Latin-1
  CHECK(made_plain("\xEF\xBF\xBE") == " ");
}

TEST_CASE("a name that is not plain is refused with what it is for") {
  CHECK(message_of([] { want_plain("a\nb\xFF", "set"); }) ==
        "set: expected a name in UTF-8 without control characters, got 'a?b?'");
  CHECK_NOTHROW(want_plain("\xC3\xA4rmel", "set"));
}
