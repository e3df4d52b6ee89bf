// SPDX-License-Identifier: MIT
//
// What happened to the ball: the events of the simulator, of a record, and the end of a shot, in one list.
#pragma once

#include "bankshot/geometry/contact.hpp"

namespace bankshot {

/// horizon: no more was asked for. Only a record has `start` and, last of all, `end`; as what ended a shot `end` means
/// that there were too many events.
enum class EventKind { cushion, jaw, ball, pocket, slide_to_roll, rest, horizon, start, end };

/// Off a cushion or a jaw.
constexpr bool is_bounce(EventKind kind) { return kind == EventKind::cushion || kind == EventKind::jaw; }
/// What a bounce off this contact is.
constexpr EventKind bounce_off(Contact contact) {
  return contact.kind == ContactKind::jaw ? EventKind::jaw : EventKind::cushion;
}

struct Event {
  EventKind kind = EventKind::horizon;
  Contact contact{};          ///< that the ball met: cushion, jaw, pocket or another ball
  bool same_instant = false;  ///< the second of two cushions met at once
  /// True when the ball moves no more: at rest, pocketed, or stopped at the horizon.
  bool final() const { return !bounces() && kind != EventKind::slide_to_roll; }
  bool bounces() const { return is_bounce(kind); }
};

/// Its words: the type of an event in JSON, the reason of a shot's end in JSON, and for a person.
struct EventWords {
  const char *type, *reason, *plain;
};
const EventWords& words(EventKind kind);

}  // namespace bankshot
