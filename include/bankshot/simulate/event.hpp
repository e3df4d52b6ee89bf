// SPDX-License-Identifier: MIT
//
// Kinds of events, in one list: those of the simulator, those of a record, and the ends of a shot.
#pragma once

#include "bankshot/geometry/contact.hpp"

namespace bankshot {

/// `horizon`: the time or event that was asked for is reached. Only a record has `start` and, last of all, `end`. As
/// the end of a shot, `end` means that there were too many events.
enum class EventKind { cushion, jaw, ball, pocket, slide_to_roll, rest, horizon, start, end };

/// Returns true for a bounce off a cushion or a jaw.
constexpr bool is_bounce(EventKind kind) { return kind == EventKind::cushion || kind == EventKind::jaw; }
/// Returns the kind of a bounce off this contact.
constexpr EventKind bounce_off(Contact contact) {
  return contact.kind == ContactKind::jaw ? EventKind::jaw : EventKind::cushion;
}

struct Event {
  EventKind kind = EventKind::horizon;
  Contact contact{};          ///< met by the ball: cushion, jaw, pocket or another ball
  bool same_instant = false;  ///< the second of two cushions met at once
  /// Returns true if the ball moves no more: at rest, pocketed, or stopped at the horizon.
  bool final() const { return !bounces() && kind != EventKind::slide_to_roll; }
  bool bounces() const { return is_bounce(kind); }
};

/// Words for a kind of event: its type in JSON, the reason of a shot's end in JSON, and plain text for a person.
struct EventWords {
  const char *type, *reason, *plain;
};
const EventWords& words(EventKind kind);

}  // namespace bankshot
