// SPDX-License-Identifier: MIT
//
// A route: the ordered list of what balls meet. A path that follows a given route (simulate/locked.hpp) stays smooth
// where the real one jumps from one cushion to another.
//   cue ball off two cushions: {cue, bottom} {cue, right}
//   a bank: {cue, ball 8} {8, bottom}
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "bankshot/geometry/contact.hpp"

namespace bankshot {

struct Meeting {
  int ball = 0;  ///< 0 is the cue ball
  Contact with{};
  friend auto operator<=>(const Meeting&, const Meeting&) = default;
};

using Route = std::vector<Meeting>;

/// Returns the route of a cue ball that meets these contacts, while no other ball moves.
inline Route route_by(std::span<const Contact> contacts) {
  Route route;
  route.reserve(contacts.size());
  for (const Contact& contact : contacts) route.push_back({0, contact});
  return route;
}

/// Returns what a ball meets, in order, except other balls.
inline std::vector<Contact> contacts_of(std::span<const Meeting> route, int ball = 0) {
  std::vector<Contact> contacts;
  contacts.reserve(route.size());
  for (const Meeting& meeting : route)
    if (meeting.ball == ball && meeting.with.kind != ContactKind::ball) contacts.push_back(meeting.with);
  return contacts;
}

/// Returns how often the cue ball bounces off cushions. Jaws do not count.
inline int bounces_of(std::span<const Meeting> route) {
  int bounces = 0;
  for (const Meeting& meeting : route)
    bounces += meeting.ball == 0 && meeting.with.kind != ContactKind::ball && meeting.with.kind != ContactKind::jaw;
  return bounces;
}

}  // namespace bankshot
