// SPDX-License-Identifier: MIT
#include "planners/propose/falls.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planners/propose/settings.hpp"
#include "planners/solve/made_as_asked.hpp"
#include "planners/solve/newton.hpp"
#include "planners/stop.hpp"
#include "planners/verify/certify.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning::propose {

using namespace settings::contact_windows;

void Falls::bring_to_speed(const std::set<Route>& made) {
  const SearchRequest brought = to_bring();
  const auto off = [&](const Fall& f) { return std::abs(std::log(f.arrived / brought.asked)); };
  auto all = std::exchange(falls_, {});
  for (auto& [route, falls] : all) {
    if (made.contains(route)) continue;
    if (!request_.one_unknown()) std::ranges::sort(falls, {}, off);
    for (const Fall& fall : falls) {
      if (stop::one_found(request_, budget_, found_)) return;
      const Launch at{fall.launch.speed, wrap_angle(fall.launch.angle)};
      if (!replay(brought, budget_, at, Goal::of(brought, Demand::made)).made) continue;
      if ((request_.stop && keep(at, bounces_of(fall.route))) || beside(fall) || by_replays(brought, fall)) break;
    }
  }
}

/// Returns the request to which falls are brought. A ball that is to rest at a point is brought to pass it slowly, so
/// that it rests half the reach beyond.
SearchRequest Falls::to_bring() const {
  if (!request_.stop) return request_;
  SearchRequest passing = request_;
  passing.stop = false;
  passing.asked = std::sqrt(deceleration(request_.puzzle().physics) * request_.problem->aim_points.front().reach);
  passing.arrival = Range{passing.asked, passing.asked};
  return passing;
}

bool Falls::keep(const Launch& launch, int bounces) {
  return certify(request_, budget_, found_, launch, bounces, step_, Demand::off_centre);
}

/// Brings a fall to the speed asked, on the line on which the ball fell.
bool Falls::beside(const Fall& fall) {
  if (!fall.aim_point->captures()) return false;
  AimPoint aim_point = *fall.aim_point;
  aim_point.cuts = Cuts{fall.right, fall.right, fall.right};
  const auto there = newton({request_, fall.route, aim_point}, budget_, fall.launch, settings::wide);
  return there && keep(*there, bounces_of(fall.route));
}

/// Brings a fall to the speed asked by replays that keep the cut of the last ball. It is for falls to which no locked
/// path leads, for example along a rail.
bool Falls::by_replays(const SearchRequest& brought, const Fall& fall) {
  const auto made = made_as_asked(brought, budget_, fall.launch, turn_of(fall));
  return made && keep(made->launch, made->replay.bounces());
}

/// Returns the turn of the aim [rad per ln speed] that keeps the cut of the last ball.
double Falls::turn_of(const Fall& fall) {
  const int last = path_.last();
  const auto touch = std::ranges::find(fall.route, path_.contact_with(last), &Meeting::with);
  const Route before(fall.route.begin(), touch);
  const auto left = [&](double log_speed, double angle) {
    return path_.left_of(before, last - 1, path_.next_of(last - 1),
                         {fall.launch.speed * (1 + log_speed), fall.launch.angle + angle});
  };
  const auto here = left(0, 0), faster = left(settings::alike, 0), turned = left(0, settings::alike);
  if (!here || !faster || !turned || *turned == *here) return 0;
  return -(*faster - *here) / (*turned - *here);
}

}  // namespace bankshot::planning::propose
