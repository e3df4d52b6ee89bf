// SPDX-License-Identifier: MIT
//
// Planner `sweep`: follow the aim once around the circle. Where a path's shape does not depend on
// its speed (`ideal`, `rolling`) this is a search in one dimension, which sees what no image can:
// bounces on reflex vertices, cushions without rebound.
// Method: trace a fan of aims; between two neighbours that meet different cushions bisect down to
// rounding, between two that meet the same ones look for a change of side of the target and bisect
// to it. Cost: about 5,000 traces. Guarantee: none; a sequence narrower than the fan's spacing that
// lies between two equal neighbours is missed.
#include <algorithm>
#include <cmath>

#include "bankshot/simulate/simulator.hpp"
#include "planners/methods/methods.hpp"
#include "planners/proof/prove.hpp"
#include "planners/steps/parts.hpp"

namespace bankshot::planning {
namespace {

constexpr int fan = 2048;
constexpr double finest = 1e-14;       // rad; neighbours nearer than this differ only by rounding
constexpr double widest_turn = 0.995;  // cosine between a leg's directions at two neighbours

/// On which side of each aim point each leg passes.
struct Sample {
  double angle;
  std::vector<Contact> contacts;
  struct Side {
    double lateral;
    bool ahead;
  };
  std::vector<Side> sides{};        ///< leg by leg, aim point by aim point
  std::vector<Vec2d> directions{};  ///< of the legs
};

class Sweep {
 public:
  explicit Sweep(Search& s) : s_(s) {}

  void run() {
    const Range around = aims();
    Sample before = sample(around.low);
    for (int i = 1; i <= fan && !s_.spent() && !s_.satisfied(); ++i) {
      Sample after = sample(around.low + (around.high - around.low) * i / fan);
      between(before, after);
      before = std::move(after);
    }
  }

  /// Where nothing reaches the target's centre.
  void beside_centre() {
    const Range around = aims();
    reach_part(s_, around, around.low, fan + 1, Goal::of(s_), "sweep");
  }

 private:
  Range aims() const { return s_.puzzle.angle.value_or(Range{0, radians(360)}); }

  Sample sample(double angle) {
    Sample out{.angle = angle, .contacts = {}};
    Simulator sim(s_.boundary, Ideal{}, Mirror{restitution(s_.puzzle.physics)},
                  State<double>{s_.puzzle.ball.at, direction(wrap_angle(angle))});
    SpeedAccount account(deceleration(s_.puzzle.physics));
    for (;;) {
      const State<double> leg = sim.state();
      out.directions.push_back(leg.velocity / norm(leg.velocity));
      for (const Vec2d& target : s_.aim_points()) {
        const Vec2d d = target - leg.at;
        out.sides.push_back({cross(leg.velocity, d), dot(leg.velocity, d) > 0});
      }
      if (static_cast<int>(out.contacts.size()) == s_.puzzle.cushions.max) break;
      const Event e = sim.step();
      account.add(sim.arc(), sim.travelled());
      if (e.final() || account.beyond(s_.puzzle.speed.high)) break;
      out.contacts.push_back(e.contact);
    }
    s_.spend(out.contacts.size());
    return out;
  }

  void between(const Sample& a, const Sample& b) {
    if (s_.spent()) return;
    const std::size_t points = s_.aim_points().size();
    const std::size_t most = std::min(a.sides.size(), b.sides.size());
    const auto differ = std::mismatch(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end());
    const auto same = static_cast<std::size_t>(differ.first - a.contacts.begin());
    for (std::size_t k = static_cast<std::size_t>(s_.puzzle.cushions.min); k <= same; ++k)
      for (std::size_t p = 0; p < points; ++p) {
        const std::size_t i = k * points + p;
        if (i < most && (a.sides[i].ahead || b.sides[i].ahead) && (a.sides[i].lateral > 0) != (b.sides[i].lateral > 0))
          root(a, b, i, static_cast<int>(k));
      }
    if ((a.contacts == b.contacts && !turns_far(a, b)) || b.angle - a.angle < finest) return;
    const Sample middle = sample(a.angle + (b.angle - a.angle) / 2);
    if (!(middle.angle > a.angle && middle.angle < b.angle)) return;
    between(a, middle);
    between(middle, b);
  }

  /// A reflex vertex turns a leg through a wide angle within a narrow one of the aim: too far to
  /// see a change of side from its two ends.
  static bool turns_far(const Sample& a, const Sample& b) {
    for (std::size_t k = 0; k < std::min(a.directions.size(), b.directions.size()); ++k)
      if (dot(a.directions[k], b.directions[k]) < widest_turn) return true;
    return false;
  }

  void root(const Sample& a, const Sample& b, std::size_t i, int bounces) {
    double low = a.angle, high = b.angle;
    const bool side = a.sides[i].lateral > 0;
    while (!s_.spent()) {
      const double middle = low + (high - low) / 2;
      if (!(middle > low && middle < high)) break;
      const Sample m = sample(middle);
      if (i >= m.sides.size()) return;
      ((m.sides[i].lateral > 0) == side ? low : high) = middle;
    }
    certify_aim(s_, wrap_angle(low), bounces, "sweep");
  }

  Search& s_;
};

/// Paths with more bounces bend the map more.
Spacing complete_spacing(const Search& s) {
  constexpr int plain = 3;  // bounces for which the usual cells leave nothing out
  const double finer = static_cast<double>(plain) / std::max(plain, s.puzzle.cushions.max);
  constexpr Spacing usual{};
  return s.all ? Spacing{usual.aim * finer, usual.speed * finer} : usual;
}

}  // namespace

void sweep(Search& s) {
  if (!is_straight(s.puzzle.physics)) return map(s, complete_spacing(s));
  Sweep sweep(s);
  sweep.run();
  if (s.shots.empty()) sweep.beside_centre();
}

}  // namespace bankshot::planning
