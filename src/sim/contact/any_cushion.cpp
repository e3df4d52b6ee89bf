// SPDX-License-Identifier: MIT
#include "bankshot/contact/any_cushion.hpp"

namespace bankshot {

template void AnyCushion::bounce(const Body&, State<double>&, const Vec2<double>&) const;
template void AnyCushion::bounce(const Body&, State<Dual<2>>&, const Vec2<double>&) const;
template void AnyCushion::bounce(const Body&, State<Dual<2>>&, const Vec2<Dual<2>>&) const;

}  // namespace bankshot
