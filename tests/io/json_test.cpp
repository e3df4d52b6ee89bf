// SPDX-License-Identifier: MIT
//
// JSON text: parsed without loss, read with the path of what is wrong, and written with the shortest decimals.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "bankshot/numbers/random.hpp"
#include "io/format/scene_keys.hpp"
#include "io/json/document.hpp"
#include "io/json/reader.hpp"
#include "io/json/writer.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using Catch::Contains;

namespace {

/// Returns what is wrong: "path: reason", with the line before it if there is one; empty if nothing is.
std::string wrong(const std::function<void()>& read) {
  try {
    read();
  } catch (const InvalidInput& e) {
    return (e.line > 0 ? std::to_string(e.line) + " " : "") + e.path + ": " + e.what();
  }
  return "";
}

std::string wrong_text(std::string_view text) {
  return wrong([&] { parse_document(text); });
}

}  // namespace

TEST_CASE("text that is no JSON is refused with its line, a key that stands twice with its path") {
  CHECK_THAT(wrong_text(""), Contains("the document is empty"));
  CHECK_THAT(wrong_text("{\n\"a\": 1,\n\"b\": nope}"), Catch::StartsWith("3 : not JSON at 'nope'"));
  CHECK_THAT(wrong_text("{\"a\": 1e999}"), Contains("the number 1e999 is too large"));
  CHECK_THAT(wrong_text(std::string("[1,\n\0]", 6)), Catch::StartsWith("2 : not JSON: there is a zero byte"));
  CHECK(wrong_text(R"({"a": [0, {"b": 1, "b": 2}]})") == "/a/1/b: this key stands twice in one object");
  CHECK(wrong_text(std::string(64, '[') + std::string(64, ']')).empty());
  CHECK_THAT(wrong_text(std::string(65, '[') + std::string(65, ']')), Contains("nested deeper than 64 levels"));
}

TEST_CASE("an identifier comes back as it was written, even out of broken text") {
  const auto id_of = [](std::string_view text) {
    std::string id;
    parse_document(text, &id);
    return id;
  };
  CHECK(id_of(R"({"id": 1.0})") == "1.0");
  CHECK(id_of(R"({"id": -7, "a": {"id": 3}})") == "-7");
  CHECK(id_of(R"({"a": {"id": 3}, "id": "x\"y"})") == R"("x\"y")");
  CHECK(id_of(R"([{"id": 3}])").empty());
  CHECK(find_id(R"({"id": 1.50, "a": nope)") == "1.50");
  CHECK(find_id(R"({"id": 1, "id": 2})").empty());  // ambiguous
  CHECK(find_id(R"({"a": {"id": 1}})").empty());
}

TEST_CASE("every double is written with the shortest decimals that read back to it") {
  Random r(90);
  for (int i = 0; i < 2000; ++i) {
    const double v = r.uniform(-1, 1) * std::pow(10.0, r.integer(-300, 300));
    REQUIRE(parse_document(write_json(Json::array({v})))[0].get<double>() == v);
    JsonWriter w;
    w.number(v);
    REQUIRE(w.take() == write_json(Json(v)));
  }
  CHECK(write_json(Json(0.1)) == "0.1");
  CHECK(write_json(Json(-0.0)) == "0");
  CHECK(write_json(Json(std::numeric_limits<double>::infinity())) == "null");
}

TEST_CASE("keys keep their order, and an identifier comes first") {
  const Json j{{"b", 1}, {"a", {true, nullptr}}};
  CHECK(write_json(j) == R"({"b":1,"a":[true,null]})");
  CHECK(write_json("7", j) == R"({"id":7,"b":1,"a":[true,null]})");
  CHECK(write_json("", j) == write_json(j));
  CHECK(write_json("7", Json::object()) == R"({"id":7})");
}

TEST_CASE("a quotation is on one line and of a readable length, between whole characters") {
  CHECK(quote(Json("a\nb")) == R"("a\nb")");
  CHECK(quote_key("a\nb") == R"(a\nb)");
  const std::string cut = quote(Json(std::string(100, 'x')));
  CHECK(cut == fmt::format("\"{}…", std::string(59, 'x')));
  std::string umlauts;
  for (int i = 0; i < 50; ++i) umlauts += "ü";
  CHECK(quote_key(umlauts) == fmt::format("{}…", umlauts.substr(0, 60)));  // 60 bytes are 30 characters
}

TEST_CASE("the writer puts commas between values, and escapes what JSON must") {
  JsonWriter w;
  w.open('{');
  w.number("a", 0.5);
  w.key("b");
  w.open('[');
  w.integer(1);
  w.null();
  w.open('[');
  w.close(']');
  w.close(']');
  w.string("c", "say \"hi\"\n");
  w.name("ö\"");
  w.raw("{}");
  w.boolean("d", false);
  w.number("e", std::nan(""));
  w.close('}');
  const std::string text = w.take();
  CHECK(text == R"({"a":0.5,"b":[1,null,[]],"c":"say \"hi\"\n","ö\"":{},"d":false,"e":null})");
  CHECK(parse_document(text)["c"] == "say \"hi\"\n");
}

TEST_CASE("a reader names the place, the value and the rule") {
  const Json doc = parse_document(R"({"n": -2.5, "whole": 3, "list": [1, "two"], "range": [2, 1], "yes": true})");
  const Reader r(doc, "/top");
  const auto wrong_of = [&](const std::string& key, const std::function<void(const Reader&)>& read) {
    return wrong([&] { read(r.need(key)); });
  };
  CHECK(r.need("n").number() == -2.5);
  CHECK(r.need("whole").integer(0, 3) == 3);
  CHECK(r.need("whole").count() == 3);
  CHECK(r.need("yes").boolean());
  CHECK(wrong_of("n", [](const Reader& v) { v.positive(); }) == "/top/n: -2.5 must be greater than 0");
  CHECK(wrong_of("n", [](const Reader& v) { v.at_least(-2); }) == "/top/n: -2.5 must be at least -2");
  CHECK(wrong_of("n", [](const Reader& v) { v.number(format::between(0, 1)); }) ==
        "/top/n: -2.5 must be between 0 and 1");
  CHECK(wrong_of("n", [](const Reader& v) { v.integer(-9, 9); }) == "/top/n: -2.5 must be a whole number");
  CHECK(wrong_of("whole", [](const Reader& v) { v.integer(4, 9); }) == "/top/whole: 3 must be between 4 and 9");
  CHECK(wrong_of("whole", [](const Reader& v) { v.text(); }) == "/top/whole: 3 must be a string");
  CHECK(wrong_of("list", [](const Reader& v) { v.point(); }) == R"(/top/list/1: "two" must be a number)");
  CHECK(wrong_of("range", [](const Reader& v) { v.range(); }) == "/top/range: [2,1] must have its lower end first");
  CHECK(wrong([&] { r.need("missing"); }) == "/top/missing: this key is required");
  CHECK(!r.find("missing"));
  const Range fixed = r.need("whole").range();
  CHECK((fixed.low == 3 && fixed.high == 3));
}

TEST_CASE("bounds are closed, but for those that say they are open") {
  const auto takes = [](double v, const format::Bounds& bounds) {
    const Json j = v;
    return wrong([&] { Reader(j).number(bounds); }).empty();
  };
  CHECK(takes(0, format::at_least(0)));
  CHECK(!takes(-1e-300, format::at_least(0)));
  CHECK(!takes(0, format::positive));
  CHECK(takes(1e-300, format::positive));
  CHECK(takes(1, format::between(0, 1)));
  CHECK(!takes(1.5, format::between(0, 1)));
  CHECK(takes(-1e300, {}));
}

TEST_CASE("an unknown key is refused with the nearest known one") {
  const Json doc{{"name", "a"}, {"at", {0, 0}}, {"raduis", 1}};
  CHECK(wrong([&] { Reader(doc).only(format::pocket); }) == R"(/raduis: this key is unknown; did you mean "radius"?)");
  const Json right{{"name", "a"}, {"at", {0, 0}}, {"radius", 1}};
  CHECK(wrong([&] { Reader(right).only(format::pocket); }).empty());
  CHECK(Reader(right).need(format::pocket["radius"]) == 1);
  double radius = 7;
  Reader(doc).read(format::pocket["radius"], radius);
  CHECK(radius == 7);
}

TEST_CASE("a suggestion is as near as a typing error") {
  constexpr std::string_view words[] = {"bottom", "right", "top", "left"};
  CHECK(suggestion("botom", words) == R"(; did you mean "bottom"?)");
  CHECK(suggestion("rihgt", words) == R"(; did you mean "right"?)");  // two letters exchanged are one error
  CHECK(suggestion("ceiling", words).empty());
  CHECK(suggestion(std::string(41, 't'), words).empty());
  CHECK(suggestion("a", {}).empty());
  CHECK(known_words("ceiling", words) == "; known are bottom, right, top, left");
  const Json word = "lfet";
  CHECK_THAT(wrong([&] { Reader(word).word("cushion", words); }), Contains(R"(is no cushion; known are)"));
  const Json left = "left";
  CHECK(Reader(left).word("cushion", words) == 3);
}
