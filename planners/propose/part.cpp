// SPDX-License-Identifier: MIT
#include "planners/propose/part.hpp"

#include <algorithm>
#include <utility>

#include "planners/propose/settings.hpp"

namespace bankshot::planning::propose {
namespace {

/// Returns the puzzle without the balls that are gone. `struck`: the number of the ball that is launched.
Part without(const Puzzle& p, int struck, const std::vector<int>& gone) {
  Part out{p, {struck}};
  out.puzzle.others.clear();
  for (int k = 1; k <= static_cast<int>(p.others.size()); ++k) {
    if (std::ranges::count(gone, k) > 0) continue;
    out.puzzle.others.push_back(p.others[static_cast<std::size_t>(k) - 1]);
    out.numbers.push_back(k);
  }
  return out;
}

/// Sets the bounds for a search to a place, at any speed that may be of use.
void aim_at_place(Puzzle& p, const SearchRequest& whole) {
  p.arrive = Range{0, whole.speed.high};
  p.speed = {whole.speed.low * settings::slowest_of_fastest, whole.speed.high};
}

Vec2d& place_of(Target& target) {
  if (auto* const point = std::get_if<PointTarget>(&target)) return point->at;
  return std::get<PointTarget>(std::get<ObjectBallTarget>(target).then.target).at;
}

std::vector<int> numbers_of(const Objects::Chain& chain) {
  std::vector<int> out;
  for (const Objects::Object* ball : chain.balls) out.push_back(ball->ball);
  return out;
}

}  // namespace

Route Part::whole(const Route& route) const {
  Route out = route;
  for (Meeting& m : out) {
    m.ball = whole(m.ball);
    if (m.with.kind == ContactKind::ball) m.with = Contact::ball(whole(m.with.index));
  }
  return out;
}

Part by_itself(const SearchRequest& whole, const CushionRule& cushions) {
  Part out{whole.puzzle(), {0}};
  out.puzzle.others.clear();
  out.puzzle.target = PointTarget{};
  out.puzzle.cushions = cushions;
  aim_at_place(out.puzzle, whole);
  return out;
}

Part before_last(const SearchRequest& whole, const Objects::Chain& chain) {
  if (chain.balls.size() == 1) return by_itself(whole, whole.cushions());
  const Then& then = *whole.problem->then();
  Part out = without(whole.puzzle(), 0, {chain.balls.back()->ball});
  const auto number = [&](int ball) {
    return static_cast<int>(std::ranges::find(out.numbers, ball) - out.numbers.begin());
  };
  Then before{PointTarget{}, then.links.back().cushions, {then.links.begin(), then.links.end() - 1}};
  for (Link& link : before.links) link.ball = number(link.ball);
  out.puzzle.target = ObjectBallTarget{.balls = {number(chain.balls.front()->ball)}, .then = std::move(before)};
  aim_at_place(out.puzzle, whole);
  return out;
}

Part last_alone(const SearchRequest& whole, const Objects::Chain& chain) {
  const Puzzle& p = whole.puzzle();
  const Objects::Object& last = *chain.balls.back();
  Part out = without(Puzzle{.table = p.table, .physics = p.physics, .ball = last.at_rest, .others = p.others},
                     last.ball, numbers_of(chain));
  const Then& then = *whole.problem->then();
  out.puzzle.target = std::visit([](const auto& t) { return Target(t); }, then.target);
  out.puzzle.cushions = whole.object_cushions;
  aim_at_place(out.puzzle, whole);
  out.puzzle.speed.low = whole.speed.high * settings::slowest_of_fastest;
  if (is_ideal(p.physics))
    out.puzzle.arrive.reset();
  else if (whole.arrival)
    out.puzzle.arrive = whole.arrival;
  out.puzzle.prefer = p.prefer;
  out.puzzle.budget = p.budget;
  return out;
}

ToPlace::ToPlace(const SearchRequest& whole, Part part, std::optional<double> pinned)
    : part_(std::move(part)), request_(part_.puzzle, Wanted::starts) {
  request_.spin = whole.spin;
  request_.pinned = pinned;
}

const SearchRequest& ToPlace::at(const Vec2d& place, double speed) {
  place_of(part_.puzzle.target) = place;
  auto moved = std::make_shared<Problem>(*request_.problem);
  moved->aim_points.front().at = place;
  request_.problem = std::move(moved);
  request_.asked = speed;
  return request_;
}

}  // namespace bankshot::planning::propose
