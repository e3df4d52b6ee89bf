// SPDX-License-Identifier: MIT
#include "io/json/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace bankshot {
namespace {

/// Returns the number of letters to insert, delete, change, or swap with the next.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& here = rows[i][j] = std::max(i, j);
      if (i == 0 || j == 0) continue;
      here = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) here = std::min(here, rows[i - 2][j - 2] + 1);
    }
  return rows.back().back();
}

}  // namespace

std::string suggestion(std::string_view wrong, std::span<const std::string_view> words) {
  constexpr std::size_t longest = 40;  // longer words are hardly typing errors, and the distance is costly
  if (wrong.size() > longest) return "";
  const auto best = std::min_element(words.begin(), words.end(),
                                     [&](auto a, auto b) { return edit_distance(wrong, a) < edit_distance(wrong, b); });
  if (best == words.end() || edit_distance(wrong, *best) > 1 + best->size() / 3) return "";
  return fmt::format("; did you mean \"{}\"?", *best);
}

std::string known_words(std::string_view wrong, std::span<const std::string_view> words) {
  constexpr std::size_t most = 16;  // a polygon may have thousands of cushions
  const auto shown = words.first(std::min(words.size(), most));
  std::string more;
  if (shown.size() < words.size()) more = fmt::format(" and {} more", words.size() - shown.size());
  return fmt::format("; known are {}{}{}", fmt::join(shown, ", "), more, suggestion(wrong, words));
}

void Reader::fail(const std::string& rule) const { throw InvalidInput(path_, quote(*value_) + " " + rule); }

double Reader::number() const {
  if (!value_->is_number()) fail("must be a number");
  return value_->get<double>();
}

double Reader::positive() const {
  const double v = number();
  if (!(v > 0)) fail("must be greater than 0");
  return v;
}

double Reader::at_least(double low) const {
  const double v = number();
  if (!(v >= low)) fail(fmt::format("must be at least {}", low));
  return v;
}

double Reader::number(const format::Bounds& b) const {
  if (std::isfinite(b.high)) {
    const double v = number();
    if (!(v >= b.low && v <= b.high)) fail(fmt::format("must be between {} and {}", b.low, b.high));
    return v;
  }
  if (b.open) return positive();
  return std::isfinite(b.low) ? at_least(b.low) : number();
}

int Reader::integer(int low, int high) const {
  const double v = number();
  if (v != std::floor(v)) fail("must be a whole number");
  if (v < low || v > high) fail(fmt::format("must be between {} and {}", low, high));
  return static_cast<int>(v);
}

int Reader::integer(const format::Bounds& b) const {
  return integer(static_cast<int>(b.low), static_cast<int>(b.high));
}

long Reader::count() const {
  constexpr double most = 0x1p53;  // beyond this, a double does not hold every whole number
  const double v = number();
  if (v != std::floor(v) || v < 0 || v > most) fail("must be a whole number, at least 0");
  return static_cast<long>(v);
}

bool Reader::boolean() const {
  if (!value_->is_boolean()) fail("must be true or false");
  return value_->get<bool>();
}

std::string Reader::text() const {
  if (!value_->is_string()) fail("must be a string");
  return value_->get<std::string>();
}

Vec2d Reader::point() const {
  const Vec2d p = pair({});
  return {p.x * units_->position.x, p.y * units_->position.y};
}

double Reader::length(const format::Bounds& bounds) const { return number(bounds) * units_->length; }

Vec2d Reader::pair(const format::Bounds& bounds) const {
  if (!is_array() || size() != 2) fail("must be a pair of numbers [x, y]");
  const auto xy = items();
  return {xy[0].number(bounds), xy[1].number(bounds)};
}

Range Reader::range() const {
  if (is_number()) return {number(), number()};
  if (!is_array() || size() != 2) fail("must be a number or a pair [low, high]");
  const auto ends = items();
  const Range r{ends[0].number(), ends[1].number()};
  if (r.low > r.high) fail("must have its lower end first");
  return r;
}

std::size_t Reader::word(std::string_view what, std::span<const std::string_view> words) const {
  if (!value_->is_string()) fail("must be a string" + known_words({}, words));
  const std::string w = text();
  const auto it = std::find(words.begin(), words.end(), w);
  if (it == words.end()) fail(fmt::format("is no {}{}", what, known_words(w, words)));
  return static_cast<std::size_t>(it - words.begin());
}

std::vector<Reader> Reader::items() const {
  if (!is_array()) fail("must be a list");
  std::vector<Reader> out;
  for (std::size_t i = 0; i < value_->size(); ++i)
    out.emplace_back((*value_)[i], path_ + "/" + std::to_string(i), *units_);
  return out;
}

std::vector<std::pair<std::string, Reader>> Reader::members() const {
  if (!is_object()) fail("must be an object");
  std::vector<std::pair<std::string, Reader>> out;
  for (const auto& [name, member] : value_->items())
    out.emplace_back(name, Reader(member, path_ + "/" + name, *units_));
  return out;
}

std::optional<Reader> Reader::find(const std::string& key) const {
  if (!is_object()) fail("must be an object");
  const auto it = value_->find(key);
  if (it == value_->end()) return {};
  return Reader(*it, path_ + "/" + key, *units_);
}

Reader Reader::need(const std::string& key, const std::string& advice) const {
  if (auto r = find(key)) return *r;
  throw InvalidInput(path_ + "/" + key, "this key is required" + advice);
}

void Reader::only(const format::Object& object) const {
  const auto supported = [&] {
    std::vector<std::string_view> names;
    for (const format::Key& key : object.keys)
      if (key.type != format::later) names.push_back(key.name);
    return names;
  };
  const auto stands_in = [](std::string_view name, std::span<const format::Key> keys) {
    return std::find_if(keys.begin(), keys.end(), [&](const format::Key& key) { return key.name == name; });
  };
  if (!is_object()) fail(fmt::format("must be an object with these keys: {}", fmt::join(supported(), ", ")));
  for (const auto& [key, value] : value_->items()) {
    const auto known = stands_in(key, object.keys);
    if (known != object.keys.end() && known->type != format::later) continue;
    if (known != object.keys.end()) Reader(value, path_ + "/" + key).fail("is not supported yet");
    if (stands_in(key, object.unread) != object.unread.end()) continue;
    const std::vector<std::string_view> words = supported();
    const std::string near = suggestion(key, words);
    throw InvalidInput(path_ + "/" + quote_key(key),
                       "this key is unknown" + (near.empty() ? known_words(key, words) : near));
  }
}

double Reader::number_of(const format::Key& key) const {
  return key.unit == "m" ? length(key.bounds) : number(key.bounds);
}

double Reader::need(const format::Key& key) const { return need(std::string(key.name)).number_of(key); }

void Reader::read(const format::Key& key, double& value) const {
  if (const auto v = find(std::string(key.name))) value = v->number_of(key);
}

}  // namespace bankshot
