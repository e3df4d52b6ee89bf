// SPDX-License-Identifier: MIT
//
// Bounces a ball off what it met, by the rail's own law if it has one.
#pragma once

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/geometry/boundary.hpp"

namespace bankshot::detail {

template <class T, class Cushion>
[[gnu::always_inline]] inline void bounce_at(const Boundary& boundary, const Cushion& cushion, Contact contact,
                                             State<T>& s) {
  const Wall* const w = boundary.line(contact);
  if (!w)
    cushion.bounce(boundary.body, s, boundary.normal(contact, s.at));
  else if (const RailCushion* const own = boundary.own_cushion(contact))
    of_rail(*own, cushion).bounce(boundary.body, s, w->normal);
  else
    cushion.bounce(boundary.body, s, w->normal);
}

}  // namespace bankshot::detail
