#include <limits>

#include "catch.hpp"
#include "format/json.hpp"

using fabricsh::format::Json;

TEST_CASE("plain values", "[files]") {
  CHECK(Json().text() == "null\n");
  CHECK(Json(true).text() == "true\n");
  CHECK(Json(-3).text() == "-3\n");
  CHECK(Json(std::size_t{7}).text() == "7\n");
  CHECK(Json(0.1).text() == "0.1\n");
  CHECK(Json(1e-300).text() == "1e-300\n");
  CHECK(Json(std::numeric_limits<double>::infinity()).text() == "null\n");
  CHECK(Json("x").text() == "\"x\"\n");
}

TEST_CASE("members keep their order, a second value its place", "[files]") {
  Json run = Json::object();
  run.set("version", "0.1.0").set("threads", 1).set("arguments", std::vector<std::string>{"a", "b"});
  run.set("threads", 2);
  CHECK(run.text() ==
        "{\n  \"version\": \"0.1.0\",\n  \"threads\": 2,\n  \"arguments\": [\"a\", \"b\"]\n}\n");
}

TEST_CASE("nesting", "[files]") {
  Json list = Json::array();
  list.push(Json::object().set("a", 1)).push(Json::array());
  CHECK(list.text() == "[\n  {\n    \"a\": 1\n  },\n  []\n]\n");
  CHECK(Json::object().text() == "{}\n");
}

TEST_CASE("text is escaped", "[files]") {
  CHECK(Json("a\"b\\c\nd\te\x01").text() == "\"a\\\"b\\\\c\\nd\\te\\u0001\"\n");
  CHECK(Json("\xC3\xA9\xE2\x82\xAC\xF0\x9F\xA7\xB5").text() == "\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\xA7\xB5\"\n");
}

TEST_CASE("bytes that are not UTF-8 are replaced", "[files]") {
  const std::string lost = "\xEF\xBF\xBD";
  CHECK(Json("a\xE9z").text() == "\"a" + lost + "z\"\n");
  CHECK(Json("\xC0\x80").text() == "\"" + lost + lost + "\"\n");
  CHECK(Json("\xED\xA0\x80").text() == "\"" + lost + lost + lost + "\"\n");
  CHECK(Json("cut \xE2\x82").text() == "\"cut " + lost + lost + "\"\n");
}
