// SPDX-License-Identifier: MIT
//
// Tests on random impacts the properties that every cushion model must have: a law that breaks one of them makes
// simulations or plans wrong. A cushion is any type with bounce(body, State<double>&, normal), such as Mirror,
// CustomCushion or a user's own.
//
//   for (const Promise& p : try_promises(cushion, body)) std::puts(p.kept() ? "kept" : p.what);
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

/// Returns the energy of a ball of mass 1 [m²/s²]: ½ v² + ⅕ R² ω².
inline double energy_of(const State<double>& s, double radius) {
  const Vec3<double>& w = s.spin;
  return dot(s.velocity, s.velocity) / 2 + radius * radius * (w.x * w.x + w.y * w.y + w.z * w.z) / 5;
}

/// Returns |v| + R |ω| [m/s], the scale to which differences of states are compared.
inline double scale_of(const State<double>& s, double radius) {
  return norm(s.velocity) + radius * std::hypot(s.spin.x, s.spin.y, s.spin.z);
}

/// Returns the difference of velocities plus R times the difference of spins [m/s].
inline double difference(const State<double>& a, const State<double>& b, double radius) {
  return norm(a.velocity - b.velocity) +
         radius * std::hypot(a.spin.x - b.spin.x, a.spin.y - b.spin.y, a.spin.z - b.spin.z);
}

/// Returns the mirror image of a state. The mirror is parallel to y, across a cushion that runs along x; spin is an
/// axial vector.
inline State<double> mirrored(const State<double>& s) {
  return {{-s.at.x, s.at.y}, {-s.velocity.x, s.velocity.y}, {s.spin.x, -s.spin.y, -s.spin.z}};
}

inline Vec2d turned(const Vec2d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

inline State<double> turned(const State<double>& s, double angle) {
  const Vec2d w = turned(Vec2d{s.spin.x, s.spin.y}, angle);
  return {turned(s.at, angle), turned(s.velocity, angle), {w.x, w.y, s.spin.z}};
}

template <class Cushion>
State<double> bounced(const Cushion& cushion, const Body& body, State<double> s, const Vec2d& normal = {0, 1}) {
  cushion.bounce(body, s, normal);
  return s;
}

struct Promise {
  const char* what;
  double allowed;
  double worst = 0;        ///< worst value of all impacts
  State<double> impact{};  ///< the worst impact, on a cushion that runs along x below the ball
  bool kept() const { return worst <= allowed; }
};

/// Tests random impacts over four decades of speed with any spin. The same seed gives the same impacts.
template <class Cushion>
std::array<Promise, 5> try_promises(const Cushion& cushion, const Body& body, int impacts = 5000,
                                    std::uint64_t seed = 1) {
  const double radius = body.radius;
  constexpr double rounding = 1e-12;
  std::array<Promise, 5> all{{{"energy after over energy before", 1 + rounding},
                              {"speed on into the cushion, of the whole", 0},
                              {"metres the centre moves", 0},
                              {"difference in a mirror, of the whole", rounding},
                              {"difference on a turned cushion, of the whole", rounding}}};
  std::mt19937_64 engine(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  for (int i = 0; i < impacts; ++i) {
    const double v = std::pow(10, uniform(-3, 1)), w = v / radius, full = 2 * std::acos(-1.0),
                 heading = uniform(full / 2, full);
    const State<double> s{{uniform(-1, 1), uniform(-1, 1)},
                          {v * std::cos(heading), v * std::sin(heading)},
                          {w * uniform(-2, 2), w * uniform(-2, 2), w * uniform(-2, 2)}};
    const State<double> e = bounced(cushion, body, s);
    const double angle = uniform(0, full), scale = scale_of(s, radius);
    const double found[] = {
        energy_of(e, radius) / energy_of(s, radius), std::max(0.0, -e.velocity.y) / scale, norm(e.at - s.at),
        difference(bounced(cushion, body, mirrored(s)), mirrored(e), radius) / scale,
        difference(bounced(cushion, body, turned(s, angle), turned(Vec2d{0, 1}, angle)), turned(e, angle), radius) /
            scale};
    for (std::size_t k = 0; k < all.size(); ++k)
      if (!(found[k] <= all[k].worst)) all[k].worst = found[k], all[k].impact = s;
  }
  return all;
}

}  // namespace bankshot
