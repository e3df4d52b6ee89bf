// SPDX-License-Identifier: MIT
//
// Jaw shots, for puzzles where no shot enters cleanly.
// Method: the real path of a launch goes on through jaws, whose contacts are meetings of its route. Its derivatives
// tell which aims beside it lead into which mouth (trace/discover.hpp). Launches across a mouth that is asked for are
// replayed. Launches into a mouth on the way are followed in the same manner, each for the aims up to its neighbours.
// So windows as narrow as rounding allows are seen. A launch that drops is moved within its window: the launches that
// fall at the same place by the same route. Newton's method on the locked path with its jaws moves it until the ball
// falls as fast as asked. Between two launches that drop, one too fast and one too slow, the aim is bisected.
// Worked number: from 1 m a mouth is 7 degrees wide and a tip of it 2. A ball that comes off that tip meets another
// mouth 1 m on from windows of 0.1 degrees, and off a second tip from some of 0.003.
// Cost: a simulation a cell, one for each quarter of a radius across each mouth that it looks into, and so on from
// those that meet its jaws. If the speed is free that is some thousands with no mouth on the way, and several times as
// many with one.
// Guarantee: none; windows are missed where the path bends between two launches more than its derivatives tell.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/propose/forward_map.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/settings.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/solve/newton.hpp"
#include "planners/trace/discover.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::jaw_shots;

class JawShots {
 public:
  JawShots(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found)
      : request_(request),
        budget_(budget),
        found_(found),
        mouths_(aim_points_of(PocketTarget{}, request.problem->boundary)) {}

  /// Runs look after look until there is a shot. So shots by more mouths are searched for only where fewer give none.
  void run() {
    for (const Look& look : looks)
      if (found_.shots.empty() && !done()) all_round(look);
  }

 private:
  bool done() const {
    return budget_.spent() || (!request_.all() && found_.shots.size() >= (request_.first() ? 1 : enough));
  }

  void all_round(const Look& look) {
    look_ = look;
    const Range aims = request_.angle.value_or(whole_turn);
    const int columns = std::max(1, static_cast<int>(std::ceil((aims.high - aims.low) / look.cell.aim)));
    const double half = (aims.high - aims.low) / columns / 2;
    for (const double speed : speeds())
      for (int i = 0; i < columns && !done(); ++i)
        look_into_mouths({{speed, aims.low + half * (2 * i + 1)}, half, look.on_the_way});
  }

  /// Returns the launch speeds to look at. One is enough where it shows the shape of all paths.
  std::vector<double> speeds() const {
    if (request_.one_unknown()) return {request_.fixed_speed()};
    if (is_straight(request_.puzzle().physics)) return {request_.speed.high};
    return speeds_to_try(request_, look_.cell.speed);
  }

  /// Launches at one speed, around a middle aim.
  struct Beam {
    Launch middle;
    double half;            ///< rad to either side
    int on_the_way;         ///< mouths before the one that is asked for
    std::size_t after = 0;  ///< number of meetings so far, the last of them with a jaw
  };

  void look_into_mouths(const Beam& beam) {
    const bool first = beam.after == 0, last = beam.on_the_way == 0;
    const Launch launch{beam.middle.speed, wrap_angle(beam.middle.angle)};
    const std::vector<AimPoint>& aim_points = first && last ? request_.problem->aim_points : mouths_;
    Discovery& found = discoveries_[static_cast<std::size_t>(beam.on_the_way)];
    if (first && last)
      discover(request_, budget_, launch, true, found);
    else
      discover_through_jaws(request_, budget_, launch, beam.half, mouths_, found);
    const Route& route = found.route;
    if (!first && !(route.size() >= beam.after && route[beam.after - 1].with.kind == ContactKind::jaw)) return;
    for (const Passage& p : found.passages) {
      const AimPoint& mouth = aim_points[p.aim_point];
      if (p.meetings < beam.after || too_slow(p.linear)) continue;
      if (last && !may_end(std::span(route).first(p.meetings), mouth)) continue;
      if (last)
        across(beam, {p, mouth, whole(mouth, p, beyond_at_last)}, first ? look_.apart : apart_at_last);
      else
        for (const Range& offsets : beside_opening(mouth, p)) across(beam, {p, mouth, offsets}, look_.apart);
    }
  }

  /// Lines of travel that lead between the ends of two rails, by their offsets [m] (geometry/opening.hpp).
  struct Mouth {
    const Passage& passage;
    const AimPoint& aim_point;
    Range offsets;
  };

  /// Sends launches along these lines, evenly spaced, as far as the beam contains them.
  void across(const Beam& beam, const Mouth& mouth, double apart) {
    const Linear& l = mouth.passage.linear;
    const double exact = mouth.aim_point.exact_offset(mouth.passage.along, 0),
                 diagonal = request_.problem->boundary.diagonal;
    const auto aim = [&](double offset) {
      return beam.middle.angle + ((exact - offset) / diagonal - l.r[0]) / l.by_aim(0);
    };
    const auto [from, to] = std::minmax({aim(mouth.offsets.low), aim(mouth.offsets.high)});
    const double low = std::max(from, beam.middle.angle - beam.half);
    const double high = std::min(to, beam.middle.angle + beam.half);
    if (!(low < high)) return;
    const double metres = (high - low) * std::abs(l.by_aim(0)) * diagonal;
    const int launches = 1 + static_cast<int>(metres / (apart * request_.puzzle().ball.body.radius));
    const double half = (high - low) / launches / 2;
    const auto launch = [&](int i) { return Launch{beam.middle.speed, low + half * (2 * i + 1)}; };
    if (beam.on_the_way == 0) return fall(launches, launch);
    for (int i = 0; i < launches && !done(); ++i)
      look_into_mouths({launch(i), half, beam.on_the_way - 1, mouth.passage.meetings + 1});
  }

  /// Returns the offsets from the end of one rail to that of the other, and so many radii beyond.
  Range whole(const AimPoint& aim_point, const Passage& p, double more) const {
    Range out{forever, -forever};
    for (const Circle& tip : request_.problem->boundary.jaws[static_cast<std::size_t>(aim_point.taken_by.index)].tips) {
      const Contact rail = tip.before.kind == ContactKind::rail ? tip.before : tip.after;
      const Vec2d end = tip.centre + request_.problem->boundary.line(rail)->normal * tip.radius;
      const double offset = cross(p.along, end - aim_point.at);
      out = {std::min(out.low, offset), std::max(out.high, offset)};
    }
    more *= request_.puzzle().ball.body.radius;
    return {out.low - more, out.high + more};
  }

  /// Returns the offsets at which a ball meets jaws, on both sides of those that lead straight in.
  std::array<Range, 2> beside_opening(const AimPoint& aim_point, const Passage& p) const {
    const Range all = whole(aim_point, p, beyond);
    const Gap<double> gap = aim_point.gap(p.along, 0);
    const double more = beyond * request_.puzzle().ball.body.radius;
    return {Range{all.low, std::min(all.high, gap.low + more)}, Range{std::max(all.low, gap.high - more), all.high}};
  }

  /// Returns whether the ball may fall into this mouth after these meetings.
  bool may_end(std::span<const Meeting> route, const AimPoint& mouth) const {
    return bounces_of(route) >= request_.cushions().min &&
           std::ranges::count(request_.problem->aim_points, mouth.taken_by, &AimPoint::taken_by) > 0;
  }

  /// Returns whether the ball passes slower than asked, by more than a cell.
  bool too_slow(const Linear& l) const {
    return !request_.one_unknown() && request_.arrival->fixed() && -l.r[1] > look_.cell.speed * l.by_speed(1);
  }

  /// A launch that drops, and the speed at which it does.
  struct Dropped {
    Launch launch;
    double arrival;  ///< m/s
    Route route;
    AimPoint aim_point;
  };

  /// Keeps the shots among evenly spaced launches.
  template <class LaunchOf>
  void fall(int launches, const LaunchOf& launch_of) {
    std::optional<Dropped> before;
    for (int i = 0; i < launches && !done(); ++i) {
      auto here = drop(launch_of(i));
      if (here && !(before && keep_between(*before, *here))) keep_along(*here);
      before = std::move(here);
    }
  }

  std::optional<Dropped> drop(const Launch& launch) {
    if (budget_.spent() || launch.speed < request_.speed.low || launch.speed > request_.speed.high) return {};
    const Replay r = replay(request_, budget_, launch, Goal::of(request_, Demand::made));
    if (!r.made) return {};
    const ShotPath& path = r.path;
    return Dropped{launch, path.arrival.speed, route_by(path.touches_jaws ? path.met : path.cushions),
                   request_.problem->nearest_aim_point(path.arrival.at)};
  }

  /// Returns how much faster than asked the ball drops [m/s]; below 0 if it is too slow.
  double excess(const Dropped& d) const {
    if (request_.one_unknown() || (d.arrival >= request_.arrival->low && d.arrival <= request_.arrival->high)) return 0;
    const double fine = tolerance::exact_speed * std::max(1.0, request_.asked) / 4, by = d.arrival - request_.asked;
    return std::abs(by) < fine ? 0 : by;
  }

  bool keep(const Dropped& d) {
    return excess(d) == 0 &&
           certify(request_, budget_, found_, d.launch, bounces_of(d.route), word::partition, Demand::off_centre);
  }

  /// Bisects the aim between two launches that drop, if one is too fast and the other too slow.
  bool keep_between(Dropped a, Dropped b) {
    while (excess(a) * excess(b) < 0) {
      const double aim = arithmetic_mean(a.launch.angle, b.launch.angle);
      if (aim == a.launch.angle || aim == b.launch.angle) return false;
      auto middle = drop({a.launch.speed, aim});
      if (!middle) return false;
      (excess(*middle) * excess(a) > 0 ? a : b) = std::move(*middle);
    }
    return keep(a) || keep(b);
  }

  /// Moves a launch within its window until it drops as fast as asked. Steps that lead out of the window are shortened.
  bool keep_along(Dropped at) {
    for (int i = 0; i < settings::most_steps && excess(at) != 0; ++i) {
      auto l = linearise({request_, at.route, at.aim_point}, budget_, at.launch);
      if (!l) return false;
      l->r[0] = 0;  // the place where it falls stays as it is
      const auto step = newton_step(*l, false);
      if (!step) return false;
      double by = 1 / std::max(1.0, size_of(*step, farthest));
      const auto moved = [&] {
        return drop({at.launch.speed * std::exp(by * (*step)[1]), at.launch.angle + by * (*step)[0]});
      };
      auto next = moved();
      for (int k = 0; !next && k < most_shortened; ++k) by /= 2, next = moved();
      if (!next) return false;
      at = std::move(*next);
    }
    return keep(at);
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  std::vector<AimPoint> mouths_;
  Look look_{};
  std::array<Discovery, looks.back().on_the_way + 1> discoveries_{};
};

}  // namespace

void jaw_shots(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.problem->drops() && !request.problem->boundary.jaws.empty()) JawShots(request, budget, found).run();
}

}  // namespace bankshot::planning::propose
