// SPDX-License-Identifier: MIT
//
// A JSON value together with its path, so that each error message names the place, the value and the
// rule. Private to the readers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/scene/puzzle.hpp"
#include "io/format/key.hpp"
#include "io/json/document.hpp"

namespace bankshot {

/// The metres in one unit of a document's lengths, and in one of its positions along x and y.
struct Units {
  double length = 1;
  Vec2d position{1, 1};
};
inline constexpr Units metres{};

class Reader {
 public:
  /// `units` must outlive this. Error messages quote values as the document has them.
  explicit Reader(const Json& value, std::string path = "", const Units& units = metres)
      : value_(&value), path_(std::move(path)), units_(&units) {}

  [[noreturn]] void fail(const std::string& rule) const;

  bool is_object() const { return value_->is_object(); }
  bool is_array() const { return value_->is_array(); }
  bool is_string() const { return value_->is_string(); }
  bool is_number() const { return value_->is_number(); }
  bool is_null() const { return value_->is_null(); }

  double number() const;
  double positive() const;
  double at_least(double low) const;
  double number(const format::Bounds& bounds) const;
  int integer(int low, int high) const;
  int integer(const format::Bounds& bounds) const;  ///< a whole number within the bounds
  long count() const;                               ///< a whole number, at least 0
  bool boolean() const;
  std::string text() const;
  Vec2d point() const;                                ///< m; a position in the document's unit
  double length(const format::Bounds& bounds) const;  ///< m; a length in the document's unit, within the bounds
  Vec2d pair(const format::Bounds& bounds) const;     ///< both numbers within the bounds
  Range range() const;                                ///< a number or [low, high]
  /// One of the words; returns its index.
  std::size_t word(std::string_view what, std::span<const std::string_view> words) const;

  std::vector<Reader> items() const;
  std::vector<std::pair<std::string, Reader>> members() const;  ///< members of an object, by name
  std::size_t size() const { return value_->size(); }

  const Units& units() const { return *units_; }

  /// Return a member of an object. If it is missing, `find` returns none and `need` throws, with `advice`.
  std::optional<Reader> find(const std::string& key) const;
  Reader need(const std::string& key, const std::string& advice = "") const;
  /// Throws if there is a key that the object does not have; the message suggests the most similar one.
  void only(const format::Object& object) const;
  /// Returns the number of a required key, as `read` does.
  double need(const format::Key& key) const;
  /// Sets `value` if a number is given for this key. A length in metres is read in the document's unit.
  void read(const format::Key& key, double& value) const;

 private:
  /// Returns the number of a key: a length, or as it stands.
  double number_of(const format::Key& key) const;

  const Json* value_;
  std::string path_;
  const Units* units_;
};

/// Returns a "did you mean" with the word most similar to `wrong`; empty if no word is similar.
std::string suggestion(std::string_view wrong, std::span<const std::string_view> words);

/// Returns "; known are ..." with the allowed words, and the suggestion for `wrong`.
std::string known_words(std::string_view wrong, std::span<const std::string_view> words);

}  // namespace bankshot
