// SPDX-License-Identifier: MIT
//
// The tables of keys: what each row says of its values agrees with its own example.
#include <algorithm>
#include <set>
#include <string>

#include "io/format/answer_keys.hpp"
#include "io/format/key.hpp"
#include "io/format/objects.hpp"
#include "io/format/puzzle_keys.hpp"
#include "io/format/recording_keys.hpp"
#include "io/format/shot_keys.hpp"
#include "io/json/document.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::format;

namespace {

constexpr std::string_view documents[] = {"puzzle", "shot", "answer", "recording", "play"};

/// Calls `f` with each object and key of all documents, once each.
template <class F>
void each_key(const F& f) {
  std::set<const Object*> seen;
  for (const std::string_view document : documents)
    for (const Object* object : objects_of(document))
      if (seen.insert(object).second)
        for (const Key& key : object->keys) f(*object, key);
}

bool inside(const Bounds& b, double v) { return v >= b.low && v <= b.high && !(b.open && v == b.low); }

/// Returns whether a value fits one alternative of a type. Objects and names are checked by other tests.
bool fits(std::string_view type, const Key& key, const Json& v) {
  if (type == "any" || type.find('{') != std::string_view::npos) return true;
  if (type == "null") return v.is_null();
  if (type == "boolean") return v.is_boolean();
  if (type == "never") return v.is_boolean() && !v.get<bool>();
  if (type == "string") return v.is_string();
  if (type == "number") return v.is_number() && inside(key.bounds, v.get<double>());
  if (type == "whole") return v.is_number_integer() && inside(key.bounds, v.get<double>());
  if (type == "word") return v.is_string() && std::ranges::count(key.words, v.get<std::string>()) == 1;
  const auto numbers = [&](std::size_t n, bool null_too) {
    return v.is_array() && v.size() == n && std::ranges::all_of(v, [&](const Json& x) {
             return (null_too && x.is_null()) || (x.is_number() && inside(key.bounds, x.get<double>()));
           });
  };
  if (type == "point" || type == "pair") return numbers(2, false);
  if (type == "place") return numbers(3, false);
  if (type == "sides") return numbers(2, true);
  if (type == "range") return (v.is_number() && inside(key.bounds, v.get<double>())) || numbers(2, false);
  if (type.starts_with('[')) {
    const auto inner = alternatives(type.substr(1, type.size() - 2));
    return v.is_array() && std::ranges::all_of(v, [&](const Json& x) {
             return std::ranges::any_of(inner, [&](std::string_view one) { return fits(one, key, x); });
           });
  }
  if (type.starts_with('<')) {
    const auto inner = type.substr(1, type.size() - 2);
    return v.is_object() && std::ranges::all_of(v, [&](const Json& x) { return fits(inner, key, x); });
  }
  FAIL("no test knows the type " << type);
  return false;
}

}  // namespace

TEST_CASE("each example has a type of its key, within its bounds and words") {
  int checked = 0;
  each_key([&](const Object& object, const Key& key) {
    if (key.type == later || key.example.empty()) return;
    INFO(object.name << "." << key.name << " = " << key.example);
    const Json example = parse_document(key.example);
    const auto types = alternatives(key.type);
    CHECK(std::ranges::any_of(types, [&](std::string_view type) { return fits(type, key, example); }));
    ++checked;
  });
  CHECK(checked > 100);
}

TEST_CASE("words stand where a word is asked, bounds have an inside, and names occur once") {
  each_key([&](const Object& object, const Key& key) {
    INFO(object.name << "." << key.name);
    const auto types = alternatives(key.type);
    const bool takes_word = std::ranges::count(types, "word") + std::ranges::count(types, "[word]") > 0;
    CHECK(takes_word == !key.words.empty());
    CHECK(key.bounds.low < key.bounds.high);
    CHECK(std::ranges::count(object.keys, key.name, &Key::name) == 1);
    CHECK(std::ranges::count(object.unread, key.name, &Key::name) <=
          (&object == &launch || object.name == "shot" ? 1 : 0));
  });
}

TEST_CASE("a document comes first, and each object that it may hold once") {
  for (const std::string_view document : documents) {
    const auto objects = objects_of(document);
    CHECK(objects.front()->name == document);
    CHECK(std::set<const Object*>(objects.begin(), objects.end()).size() == objects.size());
  }
  const auto holds = [](std::string_view document, const Object& object) {
    return std::ranges::count(objects_of(document), &object) == 1;
  };
  CHECK(holds("puzzle", noise));
  CHECK(holds("answer", arrival));
  CHECK(holds("shot", launch));
  CHECK(holds("recording", puzzle));
  CHECK(!holds("puzzle", arrival));
}

TEST_CASE("a type splits into its alternatives") {
  using Types = std::vector<std::string_view>;
  CHECK(alternatives("number") == Types{"number"});
  CHECK(alternatives("whole | [string] | {count}") == Types{"whole", "[string]", "{count}"});
}

TEST_CASE("a row is found by its name while compiling") {
  static_assert(launch["speed"].bounds.low == 0);
  static_assert(recording["sigma"].bounds.open);
  static_assert(until["cushions"].bounds.high == 1000000);
  static_assert(puzzle["target"].fallback == required);
  CHECK(answer_shot["success"].bounds.high == 1);
}
