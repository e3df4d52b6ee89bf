// SPDX-License-Identifier: MIT
//
// What happened to the ball: the events of the simulator.
#pragma once

#include "bankshot/geometry/contact.hpp"

namespace bankshot {

enum class EventKind { cushion, pocket, slide_to_roll, rest, horizon };

struct Event {
  EventKind kind = EventKind::horizon;
  Contact contact{};          ///< that a cushion event bounced off, or the pocket
  bool same_instant = false;  ///< the second of two cushions met at once
  /// True when the ball moves no more: at rest, pocketed, or stopped at the horizon.
  bool final() const { return kind != EventKind::cushion && kind != EventKind::slide_to_roll; }
};

}  // namespace bankshot
