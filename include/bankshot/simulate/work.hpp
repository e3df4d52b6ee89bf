// SPDX-License-Identifier: MIT
//
// The work of simulations, counted alike by all of them. Unlike a number of simulations, it compares searches whose
// paths differ in length, and unlike time it is the same on every machine.
#pragma once

namespace bankshot {

struct Work {
  long arcs = 0;     ///< each is moved along once, after one search for the event that ends it
  long impacts = 0;  ///< bounces, and contacts of two balls

  Work& operator+=(const Work& more) {
    arcs += more.arcs;
    impacts += more.impacts;
    return *this;
  }
  friend Work operator+(Work a, const Work& b) { return a += b; }
  friend bool operator==(const Work&, const Work&) = default;
};

}  // namespace bankshot
