// SPDX-License-Identifier: MIT
#include "io/format/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bankshot/scene/table.hpp"
#include "io/format/objects.hpp"
#include "io/format/puzzle_keys.hpp"
#include "io/json/document.hpp"

namespace bankshot::format {
namespace {

Json reference(std::string_view object) { return {{"$ref", fmt::format("#/$defs/{}", object)}}; }

Json numbers(const Bounds& b, const char* type) {
  Json j{{"type", type}};
  if (std::isfinite(b.low)) j[b.open ? "exclusiveMinimum" : "minimum"] = b.low;
  if (std::isfinite(b.high)) j["maximum"] = b.high;
  return j;
}

Json list_of(Json items, int size) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", size}, {"maxItems", size}};
}

Json any_of(std::vector<Json> types) {
  if (types.size() == 1) return std::move(types.front());
  return {{"anyOf", std::move(types)}};
}

Json schema_of(const Key& key, std::string_view type);

/// Returns the schema of one alternative of a type.
Json one_of(const Key& key, std::string_view type) {
  Json number = numbers(key.bounds, "number"), free{{"type", "number"}};
  if (type.starts_with('[')) return {{"type", "array"}, {"items", schema_of(key, type.substr(1, type.size() - 2))}};
  if (type.starts_with('{')) return reference(type.substr(1, type.size() - 2));
  if (type.starts_with('<'))
    return {{"type", "object"}, {"additionalProperties", one_of(key, type.substr(1, type.size() - 2))}};
  if (type == "any") return Json::object();
  if (type == "never") return {{"const", false}};
  if (type == "number") return number;
  if (type == "whole") return numbers(key.bounds, "integer");
  if (type == "pair") return list_of(number, 2);
  if (type == "range") return any_of({number, list_of(number, 2)});
  if (type == "sides") return list_of(Json{{"type", {"number", "null"}}}, 2);
  if (type == "point") return list_of(free, 2);
  if (type == "place") return list_of(free, 3);
  if (type == "word") return {{"enum", key.words}};
  return {{"type", type}};
}

Json schema_of(const Key& key, std::string_view type) {
  std::vector<Json> types;
  for (const std::string_view one : alternatives(type)) types.push_back(one_of(key, one));
  return any_of(std::move(types));
}

Json member(const Key& key) {
  Json j = schema_of(key, key.type);
  if (!key.meaning.empty())
    j["description"] = key.unit.empty() ? std::string(key.meaning) : fmt::format("{} [{}]", key.meaning, key.unit);
  if (const Json fallback = Json::parse(key.fallback, nullptr, false); !fallback.is_discarded())
    j["default"] = fallback;
  if (!key.example.empty()) j["examples"] = Json::array({Json::parse(key.example)});
  return j;
}

Json definition(const Object& object) {
  Json j{{"type", "object"}, {"description", object.meaning}, {"properties", Json::object()}};
  Json needed = Json::array();
  for (const Key& key : object.keys) {
    if (key.type == later) continue;
    j["properties"][std::string(key.name)] = member(key);
    if (key.fallback == required) needed.push_back(key.name);
  }
  for (const Key& key : object.unread)
    if (key.type != later) j["properties"].emplace(std::string(key.name), true);
  if (!needed.empty()) j["required"] = std::move(needed);
  j["additionalProperties"] = false;
  return j;
}

std::string type_words(const Key& key, std::string_view type);

/// Describes one alternative of a type in words, with links to objects.
std::string in_words(const Key& key, std::string_view type) {
  const std::string inner(type.substr(std::min<std::size_t>(type.size(), 1), type.size() - 2));
  if (type.starts_with('[')) return "list of " + (inner == "string" ? "strings" : type_words(key, inner));
  if (type.starts_with('{')) return fmt::format("[{}](#{})", inner, inner);
  if (type.starts_with('<')) return "by name a " + in_words(key, inner);
  if (type == "whole") return "whole number";
  if (type == "never") return "`false`";
  if (type == "pair") return "`[a, b]`";
  if (type == "range") return "number or `[low, high]`";
  if (type == "sides") return "`[down, up]`";
  if (type == "point") return "`[x, y]`";
  if (type == "place") return "`[t, x, y]`";
  if (type == "any") return "anything";
  if (type != "word") return std::string(type);
  std::string words;
  for (const std::string_view word : key.words) words += fmt::format("{}`{}`", words.empty() ? "" : " ", word);
  return words;
}

std::string type_words(const Key& key, std::string_view type) {
  std::string words;
  for (const std::string_view one : alternatives(type)) words += (words.empty() ? "" : " or ") + in_words(key, one);
  return words;
}

std::string bounds_in_words(const Bounds& b) {
  if (std::isfinite(b.high)) return b.low == b.high ? "" : fmt::format(", {:g} to {:g}", b.low, b.high);
  if (!std::isfinite(b.low)) return "";
  return b.open ? fmt::format(", more than {:g}", b.low) : fmt::format(", at least {:g}", b.low);
}

std::string row(const Key& key) {
  const bool json = !Json::parse(key.fallback, nullptr, false).is_discarded();
  const std::string fallback = json ? fmt::format("`{}`", key.fallback) : std::string(key.fallback);
  return fmt::format("| `{}` | {}{} | {} | {} | `{}` | {} |\n", key.name, type_words(key, key.type),
                     bounds_in_words(key.bounds), key.unit, fallback, key.example, key.meaning);
}

/// Returns the Markdown table of the preset tables.
std::string presets() {
  std::string out =
      "### tables\n\n| name | length × width, m | mouth of a corner, middle pocket, m | radius, m, and mass, kg, of "
      "the "
      "ball | height of the noses, m |\n|---|---|---|---|---|\n";
  for (const TablePreset& t : table_presets())
    out += fmt::format("| `{}` | {} × {} | {} | {}, {} | {:.4g} |\n", t.name, t.length, t.width,
                       t.mouth ? fmt::format("{}, {}", t.mouth->corner, t.mouth->middle) : "no pockets", t.body.radius,
                       t.body.mass, t.nose());
  return out + "\n";
}

/// Returns the Markdown table of the cushion laws.
std::string cushion_laws() {
  std::string out = "### cushion laws\n\n| model | law | source |\n|---|---|---|\n";
  for (const CushionModel& model : cushion_registry)
    if (model.in_files) out += fmt::format("| `{}` | {} | {} |\n", model.key, model.about, model.source);
  return out + "\n";
}

}  // namespace

std::span<const std::string_view> documents() {
  static constexpr std::string_view names[] = {"puzzle", "shot", "answer", "recording", "play"};
  return names;
}

std::string schema(std::string_view document) {
  const std::vector<const Object*> objects = objects_of(document);
  Json j{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", fmt::format("bankshot {}", document)}};
  j.update(definition(*objects.front()));
  j["$defs"] = Json::object();
  for (std::size_t i = 1; i < objects.size(); ++i) j["$defs"][std::string(objects[i]->name)] = definition(*objects[i]);
  return j.dump(2) + "\n";
}

std::string markdown(std::string_view document) {
  std::string out;
  const auto told_before = document == puzzle.name ? std::vector<const Object*>{} : objects_of(puzzle.name);
  for (const Object* object : objects_of(document)) {
    if (std::ranges::find(told_before, object) != told_before.end()) continue;
    out +=
        fmt::format("{} {}\n\n{}\n\n| key | value | unit | default | example | meaning |\n|---|---|---|---|---|---|\n",
                    object->name == document ? "##" : "###", object->name, object->meaning);
    for (const Key& key : object->keys)
      if (key.type != later) out += row(key);
    out += "\n";
  }
  return document == puzzle.name ? out + presets() + cushion_laws() : out;
}

}  // namespace bankshot::format
