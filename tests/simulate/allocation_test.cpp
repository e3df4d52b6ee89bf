// SPDX-License-Identifier: MIT
//
// Checks that nothing is allocated while a shot is simulated (simulator.hpp, property 1), by counting the calls of the
// global operator new.
#include <array>
#include <cstdlib>
#include <new>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/catch.hpp"

namespace {
long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return ++allocations, std::malloc(size ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return ++allocations, std::malloc(size ? size : 1);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }

using namespace bankshot;

namespace {

/// A law as a user would write it: the ball loses a fifth of its normal speed, and side spin changes its tangential
/// speed.
const CushionLawOf user_law([](const Body&, InCushionFrame<double>& f) {
  f.vt -= 0.003 * f.wz;
  f.vn *= -0.8;
  f.wz *= 0.7;
});

template <class T>
State<T> start() {
  return launched(Vec2d{0.5, 0.4}, 0.028575, Vec2<T>{T(4.1), T(2.9)}, LaunchSpin{.top = -0.5, .side = 1, .masse = 0.5});
}

template <class T, class Motion, class Cushion>
void check_shot(const Boundary& boundary, const Motion& motion, const Cushion& cushion) {
  long events = 0;
  const long before = allocations;
  Simulator sim(boundary, motion, cushion, start<T>());
  while (events < 200 && !sim.step().final()) ++events;
  const long spent = allocations - before;
  CHECK(spent == 0);
  CHECK(events > 5);
}

}  // namespace

TEST_CASE("a simulation does not allocate, plain or with derivatives, on any table") {
  using Dual = bankshot::Dual<2>;
  Table pocketed = rectangle_table(2, 1);
  pocketed.pockets = {{"far", {2, 1}, 0.06}};
  for (const Table& table :
       {rectangle_table(2, 1), pocketed, polygon_table({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}})}) {
    const Boundary boundary(table, {0.028575});
    check_shot<double>(boundary, SlideRoll{}, Han2005{});
    check_shot<double>(boundary, SlideRoll{}, Mirror{});
    check_shot<double>(boundary, Rolling{}, Mirror{});
    check_shot<double>(boundary, Ideal{}, Mirror{1});
    check_shot<double>(boundary, SlideRoll{}, Mathavan2010{});
    check_shot<double>(boundary, SlideRoll{}, CustomCushion{&user_law});
    check_shot<double>(boundary, SlideRoll{.rolling_friction = {0.008, 0.004}}, Han2005{});
    check_shot<Dual>(boundary, SlideRoll{}, Han2005{});
    check_shot<Dual>(boundary, SlideRoll{}, Mathavan2010{});
    check_shot<Dual>(boundary, SlideRoll{}, CustomCushion{&user_law});
    check_shot<Dual>(boundary, SlideRoll{.rolling_friction = {0.008, 0.004}}, Han2005{});
  }
}

TEST_CASE("a locked path does not allocate") {
  const Boundary boundary(rectangle_table(2, 1), {0.028575});
  constexpr std::array route{Meeting{0, Contact::rail(1)}, Meeting{0, Contact::rail(2)}, Meeting{0, Contact::rail(3)}};
  const auto check = [&](const auto& motion, const auto& cushion) {
    const long before = allocations;
    const auto path = follow_locked(boundary, motion, cushion, route, start<Dual<2>>());
    const long spent = allocations - before;
    CHECK(spent == 0);
    CHECK(path.end == LockedEnd::complete);
  };
  check(SlideRoll{}, Han2005{});
  check(SlideRoll{}, Mathavan2010{});
  check(SlideRoll{}, CustomCushion{&user_law});
  check(SlideRoll{.rolling_friction = {0.008, 0.004}}, Han2005{});
}

TEST_CASE("the counter counts") {
  const long before = allocations;
  delete new int(1);
  std::vector<int> v(100);
  CHECK(allocations > before);
}
