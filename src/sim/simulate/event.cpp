// SPDX-License-Identifier: MIT
#include "bankshot/simulate/event.hpp"

#include <cstddef>

namespace bankshot {

const EventWords& words(EventKind kind) {
  static constexpr EventWords all[] = {{"cushion", "cushion", "cushion"},
                                       {"jaw", "jaw", "jaw"},
                                       {"ball", "ball", "ball"},
                                       {"pocket", "pocketed", "pocket"},
                                       {"slide-to-roll", "slide-to-roll", "slide to roll"},
                                       {"roll-to-rest", "rest", "rest"},
                                       {"end", "until", "end"},
                                       {"start", "start", "launch"},
                                       {"end", "events", "end"}};
  return all[static_cast<std::size_t>(kind)];
}

}  // namespace bankshot
