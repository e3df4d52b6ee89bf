// SPDX-License-Identifier: MIT
//
// Planner `sweep`: follows the aim once around the circle. If a path's shape does not depend on its speed (`ideal`,
// `rolling`), this is a search in one dimension. It sees what no image can: bounces on reflex vertices, cushions
// without rebound. Otherwise it is a partition of aim and speed (forward_map.cpp).
// Method: trace a fan of aims. Between two neighbours that meet different cushions bisect down to rounding. Between two
// that meet the same ones look for a change of side of the target and bisect to it.
// Cost: about 5,000 traces. Guarantee: none; a route narrower than the fan's spacing that lies between two equal
// neighbours is missed.
#include <algorithm>
#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "planners/methods/methods.hpp"
#include "planners/propose/aim.hpp"
#include "planners/propose/window.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

using namespace settings::sweep;

/// The sides on which the legs of one aim pass each aim point.
struct Sample {
  double angle;
  std::vector<Contact> contacts;
  struct Side {
    double lateral;
    bool ahead;
  };
  std::vector<Side> sides{};        ///< leg by leg, aim point by aim point
  std::vector<Vec2d> directions{};  ///< directions of the legs
};

class Sweep {
 public:
  Sweep(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found)
      : request_(request), budget_(budget), found_(found) {}

  void run() {
    const Range around = request_.angle.value_or(whole_turn);
    Sample before = sample(around.low);
    for (int i = 1; i <= fan && !stop::over(request_, budget_, found_); ++i) {
      Sample after = sample(around.low + (around.high - around.low) * i / fan);
      between(before, after);
      before = std::move(after);
    }
    // Nothing reaches the target's centre, but parts of the target may lie open beside it.
    if (found_.shots.empty())
      reach_part(request_, budget_, found_, around, around.low, fan + 1, Goal::of(request_), word::partition);
  }

 private:
  Sample sample(double angle) {
    Sample out{.angle = angle, .contacts = {}};
    Simulator sim(request_.problem->boundary, Ideal{}, Mirror{restitution(request_.puzzle().physics)},
                  State<double>{request_.puzzle().ball.at, direction(wrap_angle(angle))});
    SpeedAccount account(deceleration(request_.puzzle().physics));
    for (;;) {
      const State<double> leg = sim.state();
      out.directions.push_back(leg.velocity / norm(leg.velocity));
      for (const AimPoint& aim_point : request_.problem->aim_points) {
        const Vec2d d = aim_point.at - leg.at, u = out.directions.back();
        out.sides.push_back({aim_point.exact_offset(u, -cross(u, d)) + cross(u, d), dot(u, d) > 0});
      }
      if (static_cast<int>(out.contacts.size()) == request_.cushions().max) break;
      const Event e = sim.step();
      account.add(sim.arc(), sim.travelled());
      if (e.kind != EventKind::cushion || account.beyond(request_.speed.high)) break;
      out.contacts.push_back(e.contact);
    }
    budget_.charge(out.contacts.size());
    budget_.work() += sim.work();
    return out;
  }

  void between(const Sample& a, const Sample& b) {
    if (budget_.spent()) return;
    const std::size_t aim_points = request_.problem->aim_points.size();
    const std::size_t most = std::min(a.sides.size(), b.sides.size());
    const auto differ = std::mismatch(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end());
    const auto same = static_cast<std::size_t>(differ.first - a.contacts.begin());
    for (std::size_t k = static_cast<std::size_t>(request_.cushions().min); k <= same; ++k)
      for (std::size_t p = 0; p < aim_points; ++p) {
        const std::size_t i = k * aim_points + p;
        if (i < most && (a.sides[i].ahead || b.sides[i].ahead) && (a.sides[i].lateral > 0) != (b.sides[i].lateral > 0))
          root(a, b, i, static_cast<int>(k));
      }
    if ((a.contacts == b.contacts && !turns_far(a, b)) || b.angle - a.angle < settings::rounding) return;
    const Sample middle = sample(a.angle + (b.angle - a.angle) / 2);
    if (!(middle.angle > a.angle && middle.angle < b.angle)) return;
    between(a, middle);
    between(middle, b);
  }

  /// Returns whether a leg turns too far between two aims to see a change of side from them. A reflex vertex turns a
  /// leg through a wide angle within a narrow one of the aim.
  static bool turns_far(const Sample& a, const Sample& b) {
    for (std::size_t k = 0; k < std::min(a.directions.size(), b.directions.size()); ++k)
      if (dot(a.directions[k], b.directions[k]) < widest_turn) return true;
    return false;
  }

  void root(const Sample& a, const Sample& b, std::size_t i, int bounces) {
    double low = a.angle, high = b.angle;
    const bool side = a.sides[i].lateral > 0;
    bool lost = false;
    bisect(
        low, high, [&](double, double) { return !lost && !budget_.spent(); },
        [&](double angle) {
          const Sample m = sample(angle);
          lost = i >= m.sides.size();
          return !lost && (m.sides[i].lateral > 0) == side;
        });
    if (!lost && !budget_.spent()) certify_aim(request_, budget_, found_, wrap_angle(low), bounces, word::partition);
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
};

}  // namespace

void sweep(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (!is_straight(request.puzzle().physics))
    return propose::partition(request, budget, found, propose::usual_spacing(request));
  Sweep(request, budget, found).run();
}

}  // namespace bankshot::planning::methods
