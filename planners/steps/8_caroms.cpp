// SPDX-License-Identifier: MIT
//
// Off one ball onto another.
// Method: for each route by which the cue ball comes to the first, aims across that ball at a few speeds are
// followed through the contact and on, as if no other ball stood there. Each leg after the contact passes the second
// ball on one side; where the side changes between two aims by the same cushions, Newton's method with derivatives
// through the contact leads to the exact line, and where a leg touches it without that, the launch is tried as it is.
// Routes with few cushions before the first ball come first. Cost: a simulation a launch, some 650 launches an
// approach. Guarantee: none beyond the proof; two roots between two aims are passed over.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/certify.hpp"
#include "planners/locked/newton.hpp"
#include "planners/locked/real_legs.hpp"
#include "planners/start.hpp"
#include "planners/steps/bands.hpp"
#include "planners/steps/made_as_asked.hpp"
#include "planners/steps/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/steps/sweeps.hpp"
#include "planners/steps/to_ball.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::steps {
namespace {

/// A leg of the cue ball after it has touched the first, and how it passes the second.
struct SidePass {
  Launch launch;
  double distance;  ///< m, from centre to centre at the closest
  bool left;        ///< the second is on the left of the line of travel
};
using Passes = std::map<Route, SidePass>;

class Caroms {
 public:
  Caroms(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Grid& grid, Step starts)
      : request_(request),
        budget_(budget),
        found_(found),
        grid_(grid),
        starts_(starts),
        first_(*request.problem->objects->chains.front().balls.front()),
        aim_point_(request.problem->aim_points.front()),
        to_first_(request.puzzle().table, request.puzzle().ball.body, request.puzzle().others, all_but_first()) {}

  void run() {
    const CushionRule& rule = request_.cushions();
    for (int n = 0; n <= rule.max; ++n) {
      if (one_is_enough())
        return found_.add_note(
            fmt::format("shots with {} or more cushions before the first ball were not looked for", n));
      for (const Approach& approach : approaches(request_, budget_, first_, before_first(n), starts_)) {
        if (stop::over(request_, budget_, found_)) return;
        look_across(approach);
      }
    }
  }

 private:
  bool one_is_enough() const { return !request_.all() && !request_.starts() && !found_.shots.empty(); }

  std::vector<int> all_but_first() const {
    std::vector<int> out;
    for (int k = 1; k <= static_cast<int>(request_.puzzle().others.size()); ++k)
      if (k != first_.ball) out.push_back(k);
    return out;
  }

  /// So many cushions of those asked.
  CushionRule before_first(int n) const {
    const auto& asked = request_.cushions().sequence;
    return asked ? CushionRule::in_order({asked->begin(), asked->begin() + n}) : CushionRule::exactly(n);
  }

  /// They begin the cushions that are asked in order.
  bool in_turn(const std::vector<Contact>& cushions) const {
    const auto& asked = request_.cushions().sequence;
    return !asked || (cushions.size() <= asked->size() && std::equal(cushions.begin(), cushions.end(), asked->begin()));
  }

  void look_across(const Approach& approach) {
    std::map<int, Passes> before;
    std::map<Route, std::vector<SidePass>> touching;
    each_launch(request_, approach.across, grid_, [&](const Launch& launch, int speed) {
      if (stop::over(request_, budget_, found_)) return true;
      Passes now = follow(launch);
      for (const auto& [route, pass] : now) {
        const auto last = before[speed].find(route);
        const bool crossed = last != before[speed].end() && last->second.left != pass.left;
        if (pass.distance < aim_point_.reach) touching[route].push_back(pass);
        if (crossed && root(route, closer(last->second, pass))) rooted_.insert(route);
      }
      before[speed] = std::move(now);
      return false;
    });
    for (auto& [route, passes] : touching)
      if (!rooted_.contains(route)) touch(route, passes);
  }

  static const Launch& closer(const SidePass& a, const SidePass& b) {
    return a.distance < b.distance ? a.launch : b.launch;
  }

  /// Its legs after the first ball, by their routes.
  Passes follow(const Launch& launch) {
    Passes out;
    Route route;
    with_physics(request_.puzzle().physics, [&](const auto& motion, const auto& cushion) {
      Simulator sim(to_first_, motion, cushion, start_of(request_, launch));
      bool touches = false;
      each_leg(
          sim, budget_.work(), [] { return true; },
          [&](const Event& e) {
            touches = e.kind == EventKind::ball;
            return !touches && goes_on(e, route);
          });
      if (!touches) return;
      State<double> struck = sim.state(), other{first_.at_rest.at, {}, {}};
      collisions(request_.puzzle().physics).collide(request_.puzzle().ball.body, struck, first_.at_rest.body, other);
      route.push_back({0, Contact::ball(first_.ball)});
      go_on(motion, cushion, struck, launch, route, out);
    });
    budget_.charge(route.size());
    return out;
  }

  template <class Motion, class Cushion>
  void go_on(const Motion& motion, const Cushion& cushion, const State<double>& struck, const Launch& launch,
             Route& route, Passes& out) {
    Simulator sim(request_.problem->alone(), motion, cushion, struck);
    SidePass pass{launch, forever, false};
    const auto begins = [&] {
      pass.distance = forever, pass.left = false;
      return true;
    };
    const auto look = [&](const Arc<double>& arc, double travelled) {
      const double t = detail::closest_time(arc, travelled, aim_point_.at);
      const Vec2d off = aim_point_.at - arc.position(t);
      if (norm(off) < pass.distance) pass.distance = norm(off), pass.left = is_left(arc.velocity_at(t), off);
    };
    const auto ends = [&](const Event& e) {
      if (bounces_of(route) >= request_.cushions().min) out.emplace(route, pass);
      return goes_on(e, route);
    };
    each_leg(sim, budget_.work(), begins, ends, look);
  }

  /// Of the exact line, from a ball that moves so with the second this far off.
  bool is_left(const Vec2d& velocity, const Vec2d& off) const {
    return cross(velocity, off) + aim_point_.cuts->exact * norm(velocity) > 0;
  }

  /// After this event, which is noted: with no more bounces than are asked, and in their order.
  bool goes_on(const Event& e, Route& route) const {
    if (e.kind != EventKind::cushion || bounces_of(route) == request_.cushions().max) return false;
    route.push_back({0, e.contact});
    return in_turn(contacts_of(route));
  }

  /// At the speed of the launch, and from there as fast at the target as asked.
  bool root(const Route& route, const Launch& from) {
    const SearchRequest at_speed = request_.launched_at(from.speed);
    const Branch fixed{at_speed, route, aim_point_};
    auto found = newton(fixed, budget_, from, settings::wide);
    if (!found) return false;
    if (!request_.one_unknown() && request_.arrival->fixed()) {
      const Branch free{request_, route, aim_point_};
      found = newton(free, budget_, found.launch, settings::wide);
      if (!found) return false;
      return keep(free, found.launch);
    }
    return keep(fixed, found.launch);
  }

  bool keep(const Branch& aim, const Launch& root) {
    const auto l = linearise(aim, budget_, root);
    int& alike = kept_[{Route(aim.route.begin(), aim.route.end()), l && l->by_aim(0) > 0}];
    if (alike == settings::caroms::most_alike && !(request_.all() && !request_.starts())) return true;
    const bool kept = certify_root(aim, budget_, found_, root, word::caroms) || request_.starts();
    alike += kept;
    return kept;
  }

  /// Where no two aims are on either side: from the closest, or beside the exact line as one of them is.
  void touch(const Route& route, std::vector<SidePass>& passes) {
    std::ranges::sort(passes, {}, &SidePass::distance);
    if (root(route, passes.front().launch)) return void(rooted_.insert(route));
    if (request_.starts()) return;
    for (const SidePass& pass : passes) {
      if (one_is_enough() || stop::over(request_, budget_, found_)) return;
      const auto made = made_as_asked(request_, budget_, pass.launch);
      if (made &&
          certify(request_, budget_, found_, made->launch, made->replay.bounces, word::caroms, Demand::off_centre))
        return void(rooted_.insert(route));
    }
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  const Grid grid_;
  const Step starts_;
  const Objects::Object& first_;
  const AimPoint& aim_point_;
  const Boundary to_first_;  ///< with the first ball alone
  std::map<std::pair<Route, bool>, int> kept_{};
  std::set<Route> rooted_{};
};

}  // namespace

void caroms(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  using namespace settings::caroms;
  Caroms(request, budget, found, {aims, speeds}, images).run();
}

void caroms_closely(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Parts& parts) {
  using namespace settings::caroms;
  bands(request, budget, found, request.problem->objects->chains.front());
  parts.climb(request, budget, found);
  if (sweeps_over(request, budget, found)) return;
  Caroms(request, budget, found, {close_aims, close_speeds}, starts_by_map).run();
  parts.climb(request, budget, found);
}

}  // namespace bankshot::planning::steps
