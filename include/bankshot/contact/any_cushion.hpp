// SPDX-License-Identifier: MIT
//
// A cushion of any law, chosen at each bounce. Simulations with the usual law do not use it; those with any other law
// of spin do, and those of leaning tables. Callers are so compiled once for all of them.
#pragma once

#include <variant>

#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/contact/custom.hpp"
#include "bankshot/contact/han2005.hpp"
#include "bankshot/contact/mathavan2010.hpp"
#include "bankshot/contact/mirror.hpp"
#include "bankshot/contact/rail_cushion.hpp"
#include "bankshot/contact/stronge.hpp"
#include "bankshot/numbers/dual.hpp"

namespace bankshot {

struct AnyCushion {
  CushionVariant law;

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
};

template <class T, class N>
void AnyCushion::bounce(const Body& body, State<T>& s, const Vec2<N>& away) const {
  std::visit([&](const auto& cushion) { cushion.bounce(body, s, away); }, law);
}

// All laws together are long to compile: the common scalars are compiled once, in the library.
extern template void AnyCushion::bounce(const Body&, State<double>&, const Vec2<double>&) const;
extern template void AnyCushion::bounce(const Body&, State<Dual<2>>&, const Vec2<double>&) const;
extern template void AnyCushion::bounce(const Body&, State<Dual<2>>&, const Vec2<Dual<2>>&) const;

/// Returns the law of a rail with its own coefficients.
inline AnyCushion of_rail(const RailCushion& rail, const AnyCushion& cushion) {
  return {std::visit([&](const auto& law) -> CushionVariant { return rail.of(law); }, cushion.law)};
}
template <class Cushion>
Cushion of_rail(const RailCushion& rail, const Cushion& cushion) {
  return rail.of(cushion);
}

}  // namespace bankshot
