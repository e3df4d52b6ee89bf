// SPDX-License-Identifier: MIT
//
// A contact names what a ball can meet, by kind and index. A ball bounces off rails, off vertices that point into the
// table, off the jaws of pockets and off other balls; a pocket captures it. The Boundary (boundary.hpp) knows the shape
// of each contact: code should ask it for the line or rim instead of switching on the kind.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bankshot {

struct Table;

/// The order of the kinds sorts lists of contacts. The type is as wide as the index, so that a contact is copied and
/// compared in registers.
enum class ContactKind : std::int32_t { none, rail, vertex, pocket, jaw, ball };

struct Contact {
  ContactKind kind = ContactKind::none;
  int index = -1;  ///< among the table's cushions, vertices or pockets, or the balls; jaws take four per pocket

  static constexpr Contact rail(int i) { return {ContactKind::rail, i}; }
  static constexpr Contact vertex(int i) { return {ContactKind::vertex, i}; }
  static constexpr Contact pocket(int i) { return {ContactKind::pocket, i}; }
  /// A pocket has four jaw pieces, anticlockwise: tip and facing at the end of one rail, facing and tip of the next.
  static constexpr Contact jaw(int pocket, int piece) { return {ContactKind::jaw, jaws * pocket + piece}; }
  /// Ball 0 is the cue ball.
  static constexpr Contact ball(int i) { return {ContactKind::ball, i}; }
  static constexpr int jaws = 4;
  constexpr int jaw_pocket() const { return index / jaws; }  ///< only for jaws
  constexpr int jaw_piece() const { return index % jaws; }   ///< only for jaws

  /// Returns false for `none`.
  constexpr explicit operator bool() const { return kind != ContactKind::none; }
  friend constexpr auto operator<=>(const Contact&, const Contact&) = default;
};

/// Returns the name of a contact in puzzles and answers: that of the cushion or pocket (also for its jaws), or `v<i>`.
/// A ball is "ball 2", because the table does not know its name; no contact is "none".
std::string contact_name(const Table& table, Contact contact);

/// Finds the cushion or vertex with this name, if there is one.
std::optional<Contact> find_cushion(const Table& table, std::string_view name);

}  // namespace bankshot
