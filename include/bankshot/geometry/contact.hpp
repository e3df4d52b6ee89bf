// SPDX-License-Identifier: MIT
//
// What a ball can meet, as a value: which kind of thing, and which of them. It bounces off a rail along the
// rail's line, off a vertex that points into the table, off the jaws of a pocket and off other balls; a pocket takes
// it. What shape a contact has, the Boundary says (boundary.hpp): ask that for its line or its rim rather than a
// contact for its kind.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bankshot {

struct Table;

/// In the order of lists of contacts. As wide as the index: a contact is copied and compared in registers.
enum class ContactKind : std::int32_t { none, rail, vertex, pocket, jaw, ball };

struct Contact {
  ContactKind kind = ContactKind::none;
  int index = -1;  ///< among the table's cushions, vertices, pockets or the balls; of jaws four to a pocket

  static constexpr Contact rail(int i) { return {ContactKind::rail, i}; }
  static constexpr Contact vertex(int i) { return {ContactKind::vertex, i}; }
  static constexpr Contact pocket(int i) { return {ContactKind::pocket, i}; }
  /// Of a pocket's four pieces, anticlockwise: tip and facing at the end of one rail, facing and tip of the next.
  static constexpr Contact jaw(int pocket, int piece) { return {ContactKind::jaw, jaws * pocket + piece}; }
  /// 0 is the ball that is struck.
  static constexpr Contact ball(int i) { return {ContactKind::ball, i}; }
  static constexpr int jaws = 4;
  constexpr int jaw_pocket() const { return index / jaws; }  ///< of a jaw
  constexpr int jaw_piece() const { return index % jaws; }   ///< of a jaw

  /// False of none.
  constexpr explicit operator bool() const { return kind != ContactKind::none; }
  friend constexpr auto operator<=>(const Contact&, const Contact&) = default;
};

/// The name of a contact in puzzles and answers: the cushion's, `v<i>`, the pocket's, also of
/// its jaws; "ball 2" of a ball, whose name the table does not know; "none" of none.
std::string contact_name(const Table& table, Contact contact);

/// The cushion or vertex with this name; none where there is none.
std::optional<Contact> find_cushion(const Table& table, std::string_view name);

}  // namespace bankshot
