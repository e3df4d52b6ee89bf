// SPDX-License-Identifier: MIT
//
// The table of keys that objects of a file may hold. The readers use it to check keys and bounds of numbers, `bankshot
// schema` prints it as a JSON Schema, and docs/format.md shows it. It has one row per key:
//   {"radius", "number", "m", "the preset's ball", "0.03", "half its diameter", at_least(0)}
// A type is a word, or several alternatives separated by " | ":
// clang-format off
//   any null boolean string       as in JSON
//   number whole                  within the bounds of the key
//   pair                          [a, b] within the bounds
//   range                         a number or a pair, low end first
//   sides                         a pair that may hold null
//   point place                   [x, y]; [t, x, y]
//   word                          one of the key's words
//   never                         nothing but `false`
//   [T] {name} <T>                a list of T; an object of that name; T of each of several, by name
//   later                         part of the format, but not supported yet
// clang-format on
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>

namespace bankshot::format {

/// Numbers from `low` to `high`; if `open`, `low` itself is excluded.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool open = false;
};

constexpr Bounds at_least(double low) { return {.low = low}; }
constexpr Bounds between(double low, double high) { return {low, high}; }
inline constexpr Bounds positive{.low = 0, .open = true};

/// The default of a key that must be present.
inline constexpr std::string_view required = "required";
/// The type of a key that is not supported yet.
inline constexpr std::string_view later = "later";

struct Key {
  std::string_view name, type;
  std::string_view unit{};
  std::string_view fallback{};  ///< meaning of a missing key: JSON, words or `required`
  std::string_view example{};   ///< JSON
  std::string_view meaning{};
  Bounds bounds{};
  std::span<const std::string_view> words{};
};

/// A short text put together at compile time, for rows that hold a name from elsewhere.
struct Text {
  char letters[64]{};
  std::size_t size = 0;

  consteval Text(std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts)
      for (const char letter : part) letters[size++] = letter;
  }
  constexpr operator std::string_view() const { return {letters, size}; }
};

struct Object {
  std::string_view name, meaning;
  std::span<const Key> keys;
  std::span<const Key> unread{};  ///< keys that are allowed but not read

  /// Returns the row of a key; an unknown name does not compile.
  consteval const Key& operator[](std::string_view wanted) const {
    for (const Key& key : keys)
      if (key.name == wanted) return key;
    throw "this object has no such key";
  }
};

}  // namespace bankshot::format
