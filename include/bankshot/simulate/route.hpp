// SPDX-License-Identifier: MIT
//
// What happens on the way, in order: which ball meets what. A path that is told its route (simulate/locked.hpp) stays
// smooth where the real one jumps from one cushion to another.
//   one ball by two cushions: {cue, bottom} {cue, right}
//   a bank: {cue, ball 8} {8, bottom}
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "bankshot/geometry/contact.hpp"

namespace bankshot {

struct Meeting {
  int ball = 0;  ///< 0 is the ball that is struck
  Contact with{};
  friend auto operator<=>(const Meeting&, const Meeting&) = default;
};

using Route = std::vector<Meeting>;

/// The struck ball meets these, and no other ball moves.
inline Route route_by(std::span<const Contact> contacts) {
  Route route;
  route.reserve(contacts.size());
  for (const Contact& contact : contacts) route.push_back({0, contact});
  return route;
}

/// What a ball meets, in order, but for other balls.
inline std::vector<Contact> contacts_of(std::span<const Meeting> route, int ball = 0) {
  std::vector<Contact> contacts;
  contacts.reserve(route.size());
  for (const Meeting& meeting : route)
    if (meeting.ball == ball && meeting.with.kind != ContactKind::ball) contacts.push_back(meeting.with);
  return contacts;
}

/// How often the struck ball bounces off cushions; jaws are none.
inline int bounces_of(std::span<const Meeting> route) {
  int bounces = 0;
  for (const Meeting& meeting : route)
    bounces += meeting.ball == 0 && meeting.with.kind != ContactKind::ball && meeting.with.kind != ContactKind::jaw;
  return bounces;
}

}  // namespace bankshot
