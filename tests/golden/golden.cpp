// SPDX-License-Identifier: MIT
//
// The end states of 12,000 shots, hashed (FNV-1a over their bits). The hash is the same at every optimization level,
// with every compiler, on every machine. The program is built three times, at -O0, -O2 and -O3 -march=native. Shots
// start from vectors, and the only function of the C library in use is the square root, which is exact. mathavan2010
// and friction by speed take logarithms. Their hash is printed beside: it is the same at every level, but not on every
// machine.
//   golden         prints both hashes; fails if the first differs from the one below
#include <bit>
#include <cstdint>
#include <cstdio>

#include "bankshot/contact/custom.hpp"
#include "bankshot/contact/han2005.hpp"
#include "bankshot/contact/mathavan2010.hpp"
#include "bankshot/contact/mirror.hpp"
#include "bankshot/motion/ideal.hpp"
#include "bankshot/motion/rolling.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace {

using namespace bankshot;

constexpr std::uint64_t expected = 0x020a37d6337189fc;  // hash of the shots without logarithms

class Hash {
 public:
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) state_ = (state_ ^ (bits & 0xff)) * 0x100000001b3;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// Returns a rectangle with or without pockets, or a table with a reflex vertex.
Table table(int i) {
  if (i % 2) return polygon_table({{0, 0}, {2.4, 0}, {2.4, 0.7}, {1.3, 0.9}, {1.1, 1.4}, {0, 1.2}});
  Table t = rectangle_table(2.54, 1.27);
  if (i % 4 == 0) t.pockets = six_pockets(t, {0.116, 0.129});
  return t;
}

template <class Motion, class Cushion>
void shoot(Hash& hash, const Motion& motion, const Cushion& cushion, int shots = 2000) {
  constexpr int most_events = 12;
  Random r(7);
  const Boundary boundaries[] = {{table(0), {}}, {table(1), {}}, {table(2), {}}};
  for (int i = 0; i < shots; ++i) {
    const Boundary& boundary = boundaries[i % 3];
    State<double> s{{r.uniform(0.1, 1), r.uniform(0.1, 1)}, {r.uniform(-4, 4), r.uniform(-4, 4)}, {}};
    s.spin = {r.uniform(-90, 90), r.uniform(-90, 90), r.uniform(-90, 90)};
    Simulator sim(boundary, motion, cushion, s);
    Event e = sim.step();
    for (int k = 1; k < most_events && !e.final(); ++k) e = sim.step();
    hash.add(static_cast<std::uint64_t>(e.contact.index + 1));
    const State<double>& end = sim.state();
    for (const double x :
         {end.at.x, end.at.y, end.velocity.x, end.velocity.y, end.spin.x, end.spin.y, end.spin.z, sim.time()})
      hash.add(x);
  }
}

}  // namespace

int main() {
  const CushionLawOf soft([](const Body& body, InCushionFrame<double>& f) {
    f.vn *= -0.8;
    const double grip = -0.2 * (f.vt + body.radius * f.wz);
    f.vt += grip;
    f.wz += 2.5 * grip / body.radius;
  });
  Hash own, with_library;
  shoot(own, Ideal{}, Mirror{1});
  shoot(own, Rolling{}, Mirror{});
  shoot(own, SlideRoll{}, Mirror{{0.9, -0.02}});
  shoot(own, SlideRoll{}, Han2005{});
  shoot(own, SlideRoll{.rolling_friction = 0.02}, Han2005{.restitution = {0.9, -0.03}, .friction = 0.14});
  shoot(own, SlideRoll{}, CustomCushion{&soft});
  constexpr int few = 200;  // these shots take a hundred times as long
  shoot(with_library, SlideRoll{}, Mathavan2010{}, few);
  shoot(with_library, SlideRoll{.rolling_friction = {0.008, 0.01}}, Han2005{});
  std::printf("own arithmetic 0x%016llx, with the C library's logarithm 0x%016llx\n",
              static_cast<unsigned long long>(own.value()), static_cast<unsigned long long>(with_library.value()));
  return own.value() == expected ? 0 : 1;
}
