// SPDX-License-Identifier: MIT
//
// Compares the times at which two balls meet with the roots of the same quartic in 50 digits, in seven families. No
// meeting is lost or invented, and its time is exact to the rounding of the gap over the speed of approach.
#include "bankshot/detail/roots/meeting.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

enum class Family {
  wide,       ///< anything
  close,      ///< almost touching
  clustered,  ///< slow passes, where all four roots crowd together
  graze,      ///< the least gap is 1e-16 to 1e-6 m of either sign
  bent,       ///< no speed of approach and almost no acceleration at the nearest place
  scales,     ///< tables and speeds of any size
  equal       ///< accelerations that are equal or nearly equal
};
constexpr Family families[] = {Family::wide, Family::close,  Family::clustered, Family::graze,
                               Family::bent, Family::scales, Family::equal};
constexpr const char* names[] = {"wide", "close", "clustered", "graze", "bent", "scales", "equal"};

struct Case {
  Vec2d d, v, a;
  double reach, limit;
};

Vec2d any(Random& r, double size) {
  const double way = r.uniform(0, 6.28);
  return {size * std::cos(way), size * std::sin(way)};
}

Case draw(Random& r, Family family) {
  Case c{{}, any(r, r.log_uniform(1e-3, 10)), any(r, r.uniform(0, 4)), 0.057, r.log_uniform(1e-3, 5)};
  double scale = 1;
  if (family == Family::scales) {
    scale = r.log_uniform(1e-3, 1e3);
    c.v = any(r, scale * r.log_uniform(1e-6, 30));
    c.a = any(r, r.log_uniform(1e-6, 4));
    c.reach *= scale;
  }
  double gap = scale * r.uniform(0.01, 2);
  if (family == Family::close) gap = r.log_uniform(1e-12, 1e-3);
  if (family == Family::clustered)
    c.v = any(r, r.log_uniform(1e-6, 1e-2)), c.a = any(r, r.log_uniform(1e-6, 1e-2)), gap = r.log_uniform(1e-6, 1e-2);
  if (family == Family::equal) c.a = any(r, r.chance(0.3) ? 0 : r.log_uniform(1e-18, 1e-6));
  c.d = any(r, c.reach + gap);
  if (r.chance(0.6)) c.v = c.d * (-norm(c.v) / norm(c.d)) + any(r, 0.2 * norm(c.v));
  if (family == Family::graze || family == Family::bent) {
    // Backwards from the nearest place, where the gap is almost 0.
    const double after = r.log_uniform(1e-2, 2), least = (r.chance(0.5) ? 1 : -1) * r.log_uniform(1e-16, 1e-6);
    const Vec2d n = any(r, 1);
    c.v = perpendicular(n) * r.log_uniform(1e-2, 5);
    if (family == Family::bent)
      c.a = n * (-dot(c.v, c.v) / c.reach * (1 + r.uniform(-1, 1) * r.log_uniform(1e-9, 1e-2)));
    c.d = n * (c.reach + least) - c.v * after + c.a * (after * after / 2);
    c.v = c.v - c.a * after;
    c.limit = 2 * after;
  }
  return c;
}

/// |d + v t + a t²/2|² − reach², in 50 digits.
struct Quartic {
  std::vector<Exact> c;
  explicit Quartic(const Case& k) {
    const Vec2<Exact> d = to<Exact>(k.d), v = to<Exact>(k.v), a = to<Exact>(k.a);
    const Exact reach(k.reach);
    c = {dot(d, d) - reach * reach, 2 * dot(d, v), dot(v, v) + dot(d, a), dot(v, a), dot(a, a) / 4};
  }
  explicit Quartic(std::vector<Exact> of) : c(std::move(of)) {}
  Exact operator()(const Exact& t) const {
    Exact sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
    return sum;
  }
  /// Returns the sign changes in [0, limit], in order; bisects between the sign changes of the derivative.
  std::vector<Exact> changes(const Exact& limit) const {
    std::vector<Exact> ends{0};
    if (c.size() > 2) {
      std::vector<Exact> slope;
      for (std::size_t i = 1; i < c.size(); ++i) slope.push_back(c[i] * i);
      const auto more = Quartic(slope).changes(limit);
      ends.insert(ends.end(), more.begin(), more.end());
    }
    ends.push_back(limit);
    std::vector<Exact> out;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      Exact low = ends[i], high = ends[i + 1];
      const bool up = (*this)(high) > 0;
      if (((*this)(low) > 0) == up) continue;
      for (int k = 0; k < 150; ++k) {
        const Exact middle = (low + high) / 2;
        (((*this)(middle) > 0) == up ? high : low) = middle;
      }
      out.push_back(high);
    }
    return out;
  }
};

detail::Apart<double> apart_of(const Case& c) {
  const Arc<double> still{{0, 0}, {0, 0}, {0, 0}, forever};
  Arc<double> moves{c.d, c.v, c.a, forever};
  moves.bends = true;
  return {still, 0, moves, 0};
}

double found_by(const Case& c) {
  return detail::first_meeting(apart_of(c), c.reach, c.limit, detail::Rounding<double>{0, 0});
}

}  // namespace

TEST_CASE("meetings of two balls are those of 50 digits: none lost, none made up", "[heavy]") {
  constexpr std::uint64_t seed = 61;
  constexpr double unit = 0x1p-53, most = 16;
  Random r(seed);
  for (const Family family : families) {
    int met = 0, missed = 0, undecided = 0;
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const Case c = draw(r, family);
      const Quartic f(c);
      if (!(f(0) > 0)) continue;
      INFO(names[static_cast<int>(family)] << " number " << i << " of seed " << seed);
      // The least gap: how far it falls below 0, or how near it comes to 0.
      const std::vector<Exact> roots = f.changes(c.limit);
      const auto gap = [&](const Exact& t) { return (f(t) / (2 * Exact(c.reach))).convert_to<double>(); };
      const double size = norm(c.d) + norm(c.v) * c.limit + norm(c.a) * c.limit * c.limit,
                   rounding = most * unit * size;
      std::vector<Exact> slope;
      for (std::size_t k = 1; k < f.c.size(); ++k) slope.push_back(f.c[k] * k);
      double least = std::min(gap(0), gap(c.limit));
      for (const Exact& t : Quartic(slope).changes(c.limit)) least = std::min(least, gap(t));
      const double t = found_by(c);
      if (std::abs(least) <= rounding || std::abs(gap(c.limit)) <= rounding) {
        ++undecided;
        continue;
      }
      REQUIRE((t < forever) == !roots.empty());
      if (roots.empty()) {
        ++missed;
        continue;
      }
      ++met;
      // A rounding error of the gap moves the time by as long as the gap takes to fall by that error.
      const double off = std::abs(gap(t));
      const bool first = Exact(t) < roots.front() || roots.size() < 2 || Exact(t) < (roots[0] + roots[1]) / 2;
      REQUIRE(first);
      worst = std::max(worst, off / (unit * (size + norm(c.v + c.a * t) * c.limit)));
      REQUIRE(off <= rounding + most * unit * norm(c.v + c.a * t) * c.limit);
    }
    std::printf("%s: %d meet, %d do not, %d undecided; gap off by %.2f units\n", names[static_cast<int>(family)], met,
                missed, undecided, worst);
    CHECK(met > 50);
    CHECK(undecided < 600);
  }
}

namespace {

bool excluded_until(const Case& c, double limit) {
  const detail::Apart<double> p = apart_of(c);
  return detail::cannot_meet(p.at, p.velocity, p.bend, c.reach, limit, detail::Rounding<double>{0, 0});
}

}  // namespace

TEST_CASE("no pair that the bound excludes is found to meet") {
  constexpr std::uint64_t seed = 62;
  Random r(seed);
  for (const Family family : families) {
    int excluded = 0;
    for (int i = 0; i < 20000; ++i) {
      const Case c = draw(r, family);
      INFO(names[static_cast<int>(family)] << " number " << i << " of seed " << seed);
      // Also tests limits at the meeting and just after it, where the bound must not exclude it, and a short limit.
      const double t = found_by(c);
      for (const double limit : {c.limit, t, t * (1 + 1e-7), c.limit / 10}) {
        if (!(limit < forever) || !excluded_until(c, limit)) continue;
        ++excluded;
        REQUIRE(detail::first_meeting(apart_of(c), c.reach, limit, detail::Rounding<double>{0, 0}) == forever);
      }
    }
    std::printf("%s: %d excluded\n", names[static_cast<int>(family)], excluded);
    CHECK(excluded > 1000);
  }
}
