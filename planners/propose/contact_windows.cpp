// SPDX-License-Identifier: MIT
//
// A chain or a carom, followed forwards. At one launch speed the aims by which a ball is touched along one route form a
// window. The next ball is touched from windows inside it, and the last passes its aim point on one side or the other.
// Method: at each of several speeds, aims evenly in the cut across a window are followed through the contact and on, as
// if no other ball stood there. Each leg of the ball that was touched passes the next one at some offset, which is
// continuous along a route. So false position finds where a window begins and ends, and where the last ball is on its
// exact line. From there Newton's method solves the whole chain for the arrival speed asked. Balls that fell without
// such a root (rolling along a rail into a pocket, say) are brought to that speed as they are. Narrow windows exist at
// few speeds, and other speeds do not show them. So where nothing is found the speeds between are followed too, down to
// 1/64 of the range. Speeds that are followed at all are followed along all routes that have roots, since the first
// need not be the best.
// Cost: two simulations an aim, some 100 aims a speed, window and ball. Guarantee: none beyond verification; a route
// narrower than the step of aims between two others is passed over.
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "planners/propose/chain_path.hpp"
#include "planners/propose/falls.hpp"
#include "planners/propose/leg.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/propose/settings.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/solve/newton.hpp"
#include "planners/stop.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::contact_windows;

class ContactWindows {
 public:
  ContactWindows(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found,
                 const Objects::Chain& chain)
      : request_(request),
        budget_(budget),
        found_(found),
        path_(request, budget, chain),
        step_(request.problem->carom() ? word::partition : word::unfold),
        falls_(request, budget, found, path_, step_),
        at_speed_(request) {
    for (const Shot& shot : found.shots) made_.insert(route_of(shot));
  }

  /// Searches at launch speeds that divide the bounds into `fine` parts, evenly in their logarithm. Those of `coarse`
  /// parts are known and left out; 0: none is known. Wide steps come first, since one root is mostly enough. If the
  /// speed is given, more aims are followed instead.
  void run(int coarse, int fine) {
    if (request_.one_unknown() || request_.speed.fixed()) {
      finer_ = static_cast<int>(std::sqrt(fine));
      return look({request_.fixed_speed()});
    }
    if (coarse == 0) look({speed_at(0), speed_at(1)});
    for (int parts = std::max(coarse, 1); parts < fine && !stop::one_found(request_, budget_, found_); parts *= 2)
      look(between(parts));
  }

 private:
  struct Window {
    Route route;  ///< up to the contact with the ball that is touched
    Range aims;
  };
  using Track = std::vector<std::optional<Pass>>;

  bool over() const { return stop::over(request_, budget_, found_); }

  /// Returns the launch speed at a share of the range, evenly in its logarithm.
  double speed_at(double share) const {
    const double slowest = std::max(request_.speed.low, request_.speed.high * settings::slowest_of_fastest);
    return slowest * std::pow(request_.speed.high / slowest, share);
  }

  /// Returns the launch speeds in the middle of each of these parts.
  std::vector<double> between(int parts) const {
    std::vector<double> speeds;
    for (int i = 0; i < parts; ++i) speeds.push_back(speed_at((i + 0.5) / parts));
    return speeds;
  }

  /// Searches at all of these speeds, routes with few cushions first.
  void look(const std::vector<double>& speeds) {
    std::vector<std::pair<double, Window>> windows;
    for (const double speed : speeds) {
      at(speed);
      for (Window& window : to_first()) windows.emplace_back(speed, std::move(window));
    }
    std::ranges::stable_sort(windows, {}, [](const auto& window) { return window.second.route.size(); });
    for (const auto& [speed, window] : windows) {
      if (over()) return;
      at(speed);
      follow(window);
    }
    falls_.bring_to_speed(made_);
  }

  void at(double speed) {
    speed_ = speed;
    if (any_arrival()) at_speed_.pinned = speed;
  }

  Launch launch(double aim) const { return {speed_, aim}; }

  /// Follows a window from the first ball to the aim point.
  void follow(const Window& first) {
    std::vector<Window> windows{first};
    for (int ball = 1; ball < path_.last(); ++ball) {
      std::vector<Window> next;
      for (const Window& window : windows) touching(ball, window.route, across(window, cut_steps * finer_), next);
      windows = std::move(next);
    }
    for (const AimPoint& aim_point : request_.problem->aim_points) {
      if (aim_point.ball != path_.number(path_.last())) continue;
      for (const Window& window : windows)
        if (!over()) roots(aim_point, window.route, across(window, 2 * cut_steps * finer_));
    }
  }

  std::vector<Window> to_first() {
    const Place first = path_.next_of(0);
    std::vector<Window> out;
    if (request_.cushions().max == 0 && request_.spin.masse == 0) {
      const Vec2d way = first.at - request_.puzzle().ball.at;
      const double half = widest * std::asin(std::min(1.0, first.reach / norm(way))), to = std::atan2(way.y, way.x);
      out.push_back({{{0, path_.contact_with(1)}}, {to - half, to + half}});
      return out;
    }
    std::vector<double> fan;
    for (int i = 0; i <= fan_steps * finer_; ++i) fan.push_back(radians(360.0) * i / (fan_steps * finer_));
    touching(0, {}, fan, out);
    return out;
  }

  static std::vector<double> across(const Window& window, int each_way) {
    std::vector<double> aims;
    const double middle = (window.aims.low + window.aims.high) / 2, half = (window.aims.high - window.aims.low) / 2;
    for (int i = -each_way; i <= each_way; ++i)
      aims.push_back(middle + half * std::sin(std::asin(widest) * i / each_way));
    return aims;
  }

  /// Adds the windows from which a ball touches the next one. `tried`: the aims to follow, in order.
  void touching(int ball, const Route& before, const std::vector<double>& tried, std::vector<Window>& out) {
    const Place place = path_.next_of(ball);
    each_track(ball, before, place, tried,
               [&](const Route& route, const std::vector<double>& aims, const Track& track) {
                 Route touched = joined(before, route);
                 const auto left = [&](double aim) { return path_.left_of(touched, ball, place, launch(aim)); };
                 const std::vector<Range> inside = passing(aims, track, widest * place.reach, left);
                 touched.push_back({path_.number(ball), path_.contact_with(ball + 1)});
                 for (const Range& range : inside) out.push_back({touched, range});
               });
  }

  /// Finds the aims at which a track passes within `edge`.
  template <class Left>
  std::vector<Range> passing(const std::vector<double>& aims, const Track& track, double edge, const Left& left) {
    std::vector<Range> out;
    bool open = false;
    double low = 0;
    const auto begin = [&](double aim) { open = true, low = aim; };
    const auto end = [&](double aim) {
      if (std::exchange(open, false)) out.push_back({low, aim});
    };
    for (std::size_t i = 0; i < aims.size(); ++i) {
      if (!track[i]) {
        if (i > 0) end(aims[i - 1]);
        continue;
      }
      const double to = track[i]->left;
      const bool inside = std::abs(to) < edge;
      if (i > 0 && track[i - 1] && (track[i]->ahead || track[i - 1]->ahead)) {
        const double from = track[i - 1]->left;
        const auto at_level = [&](double level) {
          return crossing(aims[i - 1], from - level, aims[i], to - level, [&](double aim) {
            const auto l = left(aim);
            return l ? std::optional(*l - level) : std::nullopt;
          });
        };
        if (const bool was = std::abs(from) < edge; was && !inside) {
          end(at_level(std::copysign(edge, to)));
        } else if (!was && inside) {
          begin(at_level(std::copysign(edge, from)));
        } else if (!was && (from > 0) != (to > 0)) {
          begin(at_level(std::copysign(edge, from)));
          end(at_level(std::copysign(edge, to)));
        }
      }
      if (inside && !open && track[i]->ahead) begin(aims[i]);
    }
    if (!aims.empty()) end(aims.back());
    return out;
  }

  /// Returns the aim between two at which `value` is 0, near enough for Newton's method.
  template <class Value>
  double crossing(double a, double at_a, double b, double at_b, const Value& value) {
    const double enough = settled * (std::abs(at_a) + std::abs(at_b));
    return false_position(a, at_a, b, at_b, enough, settings::patience, value);
  }

  /// Finds the aims that put the last ball on its exact line, and from there the launches that arrive as fast as asked.
  void roots(const AimPoint& aim_point, const Route& before, const std::vector<double>& tried) {
    const Place place{aim_point.at, aim_point.reach, &aim_point};
    each_track(path_.last(), before, place, tried,
               [&](const Route& route, const std::vector<double>& aims, const Track& track) {
                 const Route whole = joined(before, route);
                 for (std::size_t i = 1; i < aims.size(); ++i) {
                   const auto &a = track[i - 1], &b = track[i];
                   if (over()) return;
                   if (!a || !b || (a->left > 0) == (b->left > 0) || !(a->ahead || b->ahead)) continue;
                   root(aim_point, whole, crossing(aims[i - 1], a->left, aims[i], b->left, [&](double aim) {
                          return path_.left_of(whole, path_.last(), place, launch(aim));
                        }));
                 }
               });
  }

  void root(const AimPoint& aim_point, const Route& route, double at) {
    if (any_arrival() && made_.contains(route)) return;
    const SearchRequest& own = any_arrival() ? at_speed_ : request_;
    const Branch aim{own, route, aim_point};
    const auto l = linearise(aim, budget_, launch(at));
    const auto step = l ? newton_step(*l, own.one_unknown()) : std::nullopt;
    if (!step || !(std::abs((*step)[1]) < settings::wide.far * settings::wide.step_speed)) return;
    std::vector<Launch>& known = roots_[route];
    const auto found = newton(aim, budget_, launch(at), settings::wide);
    if (!found) return;
    if (std::ranges::any_of(known, [&](const Launch& k) { return alike(k, *found); })) return;
    known.push_back(*found);
    if (certify_root(aim, budget_, found_, *found, step_)) made_.insert(route);
  }

  /// Returns whether any arrival speed of a range will do; then the launch speed need not change.
  bool any_arrival() const {
    return request_.problem->carom() && !request_.one_unknown() && !request_.arrival->fixed();
  }

  /// Calls `look(route, aims, track)` for each route that some aim has. Neighbouring aims get their passes from the
  /// locked path.
  template <class Look>
  void each_track(int ball, const Route& before, const Place& place, const std::vector<double>& tried,
                  const Look& look) {
    std::vector<double> aims;
    std::map<Route, Track> tracks;
    for (const double aim : tried) {
      if (over()) break;
      const Followed followed = path_.follow(ball, before, place, launch(aim));
      for (const Fall& fall : followed.falls) falls_.remember(fall);
      for (const auto& [route, pass] : followed.passes) {
        Track& track = tracks[route];
        track.resize(aims.size());
        track.push_back(pass);
      }
      aims.push_back(aim);
    }
    for (auto& [route, track] : tracks) {
      track.resize(aims.size());
      const Track real = track;
      const Route whole = joined(before, route);
      for (std::size_t i = 0; i < aims.size(); ++i)
        if (!real[i] && ((i > 0 && real[i - 1]) || (i + 1 < aims.size() && real[i + 1])))
          track[i] = path_.locked_pass(whole, ball, place, launch(aims[i]));
      look(route, aims, track);
    }
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  ChainPath path_;
  std::string_view step_;
  Falls falls_;
  SearchRequest at_speed_;  ///< the request at the current launch speed
  double speed_ = 0;        ///< m/s; the current launch speed
  int finer_ = 1;           ///< factor on the number of aims
  std::map<Route, std::vector<Launch>> roots_{};
  std::set<Route> made_{};  ///< routes that have a shot on the exact line
};

}  // namespace

void caroms(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  ContactWindows(request, budget, found, request.problem->objects->chains.front()).run(0, few_rows);
}

void contact_windows(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  for (const Objects::Chain& chain : request.problem->objects->chains) {
    if (is_hidden(request, chain)) continue;
    ContactWindows(request, budget, found, chain).run(request.problem->carom() ? few_rows : 0, rows);
    partial_targets(request, budget, found);
  }
}

}  // namespace bankshot::planning::propose
