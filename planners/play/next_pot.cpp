// SPDX-License-Identifier: MIT
#include "planners/play/next_pot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "planners/play/settings.hpp"
#include "planners/verify/in_sight.hpp"

namespace bankshot::planning::play {

using namespace settings::next_pot;

NextPot::NextPot(const Puzzle& puzzle, const PocketTarget& pockets) : puzzle_(puzzle) {
  const Boundary boundary(puzzle.table, puzzle.ball.body);
  if (puzzle.table.pockets.empty()) return;
  for (const AimPoint& point : aim_points_of(Target{pockets}, boundary)) {
    const Pocket& pocket = puzzle.table.pockets[static_cast<std::size_t>(point.taken_by.index)];
    const Vec2d middle = point.opening.first + point.opening.last;
    const bool corner = std::ranges::any_of(puzzle.table.vertices,
                                            [&](const Vec2d& v) { return norm(v - pocket.place()) < pocket.half(); });
    mouths_.push_back({point, norm(middle) > 0 ? -middle / norm(middle) : Vec2d{}, corner, !boundary.jaws.empty()});
  }
}

double NextPot::Mouth::wider(const Vec2d& way) const {
  if (!jaws) return 0;
  const double cosine = std::clamp(dot(way, into), -1.0, 1.0);
  if (!corner) return off_middle_jaws * cosine;
  const double to_rail = std::abs(radians(45.0) - std::acos(cosine));
  return off_jaws + along_rail * std::max(0.0, 1 - to_rail / guided);
}

const Body& NextPot::body(int ball) const {
  return ball == 0 ? puzzle_.ball.body : puzzle_.others[static_cast<std::size_t>(ball) - 1].body;
}

std::vector<NextPot::Best> NextPot::pots(const PottingOrder& order,
                                         std::span<const std::optional<Vec2d>> places) const {
  if (!places[0]) return {{}};
  for (const std::vector<int>& group : order) {
    std::vector<Best> out;
    bool some = false;
    for (const int ball : group) {
      if (!places[static_cast<std::size_t>(ball)]) continue;
      some = true;
      for (const Mouth& mouth : mouths_)
        if (const Best one = pot(mouth, ball, places); one.forgives > 0) out.push_back(one);
    }
    if (!some) continue;
    if (out.empty()) return {{}};
    std::ranges::stable_sort(out, std::greater(), &Best::forgives);
    for (Best& one : out) one.chance = std::erf(one.forgives / std::sqrt(2.0));
    return out;
  }
  return {{1}};
}

NextPot::Best NextPot::pot(const Mouth& to, int ball, std::span<const std::optional<Vec2d>> places) const {
  const AimPoint& mouth = to.point;
  const Vec2d cue = *places[0], at = *places[static_cast<std::size_t>(ball)];
  Vec2d way = mouth.at - at;
  const double distance = norm(way);
  if (!(distance > 0)) return {};
  way = way / distance;
  Gap<double> gap = mouth.gap(way, 0);
  if (!(gap.low < gap.high)) return {};
  // The line to the middle of the gap; a second look, from the direction that it has.
  const auto towards = [&](double offset) {
    const Vec2d line = mouth.at + perpendicular(way) * offset - at;
    return line / norm(line);
  };
  way = towards((gap.low + gap.high) / 2);
  gap = mouth.gap(way, (gap.low + gap.high) / 2);
  const double touching = touching_distance(body(0), body(ball));
  const Vec2d ghost = at - way * touching, run = ghost - cue;
  const double reach = norm(run), cosine = reach > 0 ? dot(run, way) / reach : 1;
  if (cosine < thinnest) return {};
  if (is_blocked(cue, ghost, 0, ball, places) || is_blocked(at, mouth.at - way * mouth.reach, ball, ball, places))
    return {};
  const double deviation = puzzle_.noise.angle * reach * distance / (touching * cosine);
  const double half = (gap.high - gap.low) / 2 + to.wider(way);
  constexpr double surely = 100;
  const double forgives = deviation > 0 ? std::min(half / deviation, surely) : surely;
  return {0, ball, mouth.taken_by.index, forgives, reach > 0 ? run / reach : way};
}

bool NextPot::is_blocked(const Vec2d& from, const Vec2d& to, int ball, int by,
                         std::span<const std::optional<Vec2d>> places) const {
  for (std::size_t k = 1; k < places.size(); ++k) {
    const int other = static_cast<int>(k);
    if (!places[k] || other == ball || other == by) continue;
    const double touching = touching_distance(body(ball), body(other));
    if (square_to_segment(*places[k], from, to) < touching * touching) return true;
  }
  return false;
}

bool can_be_hit(const Puzzle& puzzle, int ball, std::span<const std::optional<Vec2d>> places) {
  const auto circle = [&](int k) {
    const Body& body = puzzle.others[static_cast<std::size_t>(k) - 1].body;
    return Circle{*places[static_cast<std::size_t>(k)], touching_distance(puzzle.ball.body, body)};
  };
  if (!places[0] || !places[static_cast<std::size_t>(ball)]) return false;
  std::vector<Circle> others;
  for (int k = 1; k < static_cast<int>(places.size()); ++k)
    if (k != ball && places[static_cast<std::size_t>(k)]) others.push_back(circle(k));
  return in_sight(*places[0], circle(ball), others);
}

}  // namespace bankshot::planning::play
