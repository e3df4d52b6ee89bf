// SPDX-License-Identifier: MIT
#include "support/legal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::test {
namespace {

/// Counts the bounces of one ball against a rule.
class Bounces {
 public:
  explicit Bounces(const CushionRule* rule) : rule_(rule) {}
  /// Returns false when the rule is broken for good.
  bool add(Contact cushion) {
    const bool known =
        !rule_ || !rule_->sequence || (count_ < rule_->sequence->size() && (*rule_->sequence)[count_] == cushion);
    ++count_;
    return known && (!rule_ || static_cast<int>(count_) <= rule_->max);
  }
  bool enough() const { return !rule_ || static_cast<int>(count_) >= rule_->min; }

 private:
  const CushionRule* rule_;  ///< null: any cushions
  std::size_t count_ = 0;
};

/// Goes through the events of one play.
class Referee {
 public:
  Referee(const Puzzle& p, const Shot& own, const ShotRequest& played)
      : p_(p), own_(own), played_(played), t_(simulate(played)), bounces_(&p.cushions) {
    if (is_ball(p.target)) plan();
    const auto asked = arrival_range(p);
    rests_ = asked && asked->high == 0;
    if (const PointTarget* point = point_of(p.target)) point_ = *point;
  }

  bool legal() {
    if (!reaches()) return false;
    const auto scratch = [](const Record& e) { return e.kind == EventKind::pocket && e.ball == 0; };
    return !is_ball(p_.target) || std::ranges::none_of(t_.events, scratch);
  }

 private:
  enum class Verdict { open, made, failure };

  /// Lists the ball contacts that must happen, in order.
  void plan() {
    if (const int first = first_of_carom(p_.target)) {
      contacts_ = {{0, first}, {0, own_.path.hits.back().ball}};
      return;
    }
    contacts_ = {{0, own_.path.hits.front().ball}};
    const Then* const then = then_of(p_.target);
    if (!then) return;
    int by = own_.path.hits.front().ball;
    for (const Link& link : then->links) contacts_.push_back({std::exchange(by, link.ball), link.ball});
  }

  bool ends_at_contact() const { return !contacts_.empty() && !then_of(p_.target); }
  /// Returns the ball that is on its way to the next ball or to the target.
  int mover() const {
    if (contacts_.empty() || done_ == 0) return 0;
    if (done_ < contacts_.size()) return contacts_[done_].first;
    return ends_at_contact() ? 0 : contacts_.back().second;
  }
  bool all_touched() const { return done_ == contacts_.size(); }

  bool reaches() {
    double from = 0;  // start of the span in which the verdict so far holds [s]
    for (const Record& e : t_.events) {
      if (e.time > from && passes(from, e.time)) return true;
      from = std::max(from, e.time);
      const Verdict verdict = look_at(e);
      if (verdict != Verdict::open) return verdict == Verdict::made;
    }
    return passes(from, std::numeric_limits<double>::infinity());
  }

  Verdict look_at(const Record& e) {
    switch (e.kind) {
      case EventKind::ball:
        return meets(e);
      case EventKind::cushion:
        // A ball that touches a cushion at the instant when it is hit does not bounce there.
        if (e.ball != mover() || (e.ball != 0 && e.time == set_)) return Verdict::open;
        return bounces_.add(e.contact) ? Verdict::open : Verdict::failure;
      case EventKind::pocket:
        if (e.ball == 0 && mover() != 0) return Verdict::failure;
        return e.ball == mover() ? falls(e.contact) : Verdict::open;
      case EventKind::rest:
      case EventKind::end:
        return e.ball == mover() ? stops(e) : Verdict::open;
      default:
        return Verdict::open;
    }
  }

  Verdict meets(const Record& e) {
    if (all_touched()) return Verdict::failure;
    const auto [striker, struck] = contacts_[done_];
    if (std::minmax(e.ball, e.contact.index) != std::minmax(striker, struck)) return Verdict::failure;
    const bool carom = first_of_carom(p_.target) != 0, last = done_ + 1 == contacts_.size();
    if ((!carom || last) && !bounces_.enough()) return Verdict::failure;
    if (last && ends_at_contact()) return within_cut(e) ? Verdict::made : Verdict::failure;
    ++done_;
    set_ = e.time;
    if (carom) return Verdict::open;
    const Then& then = *then_of(p_.target);
    bounces_ = Bounces(all_touched() && then.counts_any_fall() ? nullptr : &then.cushions_of(done_ - 1));
    return Verdict::open;
  }

  bool within_cut(const Record& e) const {
    const BallTarget& asked = *touch_of(p_.target);
    if (asked.any_contact()) return true;
    Vec2d before = start_state(played_).velocity;
    for (const Leg& leg : t_.legs)
      if (leg.ball == 0 && leg.begin < e.time) before = state_on(played_, leg, leg.duration).velocity;
    const Vec2d apart = e.other.at - e.state.at;
    const double cut = std::asin(std::clamp(cross(before, apart) / (norm(before) * norm(apart)), -1.0, 1.0));
    return std::abs(cut - asked.exact_cut()) <= asked.cut_within();
  }

  Verdict falls(Contact pocket) const {
    const PocketTarget* wanted = pocket_of(p_.target);
    if (!wanted || !all_touched() || ends_at_contact() || !bounces_.enough()) return Verdict::failure;
    if (mover() == 0) return !wanted->pocket || *wanted->pocket == pocket.index ? Verdict::made : Verdict::failure;
    const Pocket* own = pocket_reached(p_, own_);
    return own && pocket.index == static_cast<int>(own - p_.table.pockets.data()) ? Verdict::made : Verdict::failure;
  }

  Verdict stops(const Record& e) const {
    const bool there = point_ && rests_ && all_touched() && bounces_.enough() && e.kind == EventKind::rest &&
                       norm(e.state.at - point_->at) <= point_->within;
    return there ? Verdict::made : Verdict::failure;
  }

  /// Returns true when the ball passes over the point between two times; the point need not stop the ball.
  bool passes(double from, double to) const {
    if (!point_ || rests_ || !all_touched() || !bounces_.enough()) return false;
    for (const Leg& leg : t_.legs) {
      if (leg.ball != mover() || leg.begin >= to) continue;
      const double first = std::max(0.0, leg.arc.parameter(from - leg.begin)),
                   last = to < std::numeric_limits<double>::infinity()
                              ? std::min(leg.duration, leg.arc.parameter(to - leg.begin))
                              : leg.duration;
      if (first < last && nearest(leg, first, last) <= point_->within) return true;
    }
    return false;
  }

  /// Returns the least distance from the point [m], by a search on each of a few pieces.
  double nearest(const Leg& leg, double first, double last) const {
    constexpr int pieces = 4, steps = 40;
    const auto off = [&](double at) { return norm(state_on(played_, leg, at).at - point_->at); };
    double best = std::min(off(first), off(last));
    for (int i = 0; i < pieces; ++i) {
      double low = first + (last - first) * i / pieces, high = first + (last - first) * (i + 1) / pieces;
      for (int k = 0; k < steps; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
      }
      best = std::min(best, off((low + high) / 2));
    }
    return best;
  }

  const Puzzle& p_;
  const Shot& own_;
  const ShotRequest& played_;
  Trajectory t_;
  Bounces bounces_;  ///< of the mover
  std::vector<std::pair<int, int>> contacts_{};
  std::size_t done_ = 0;  ///< number of these contacts already made
  double set_ = -1;       ///< time of the last contact made [s]
  bool rests_ = false;
  std::optional<PointTarget> point_{};
};

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform(0, 1))) * std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

/// Moves the balls by the player's errors of position; draws again when balls overlap or leave the table.
bool move_balls(ShotRequest& shot, double by, Random& random) {
  constexpr int patience = 100;
  const auto moved = [&](const Ball& ball) {
    Ball out = ball;
    out.at += Vec2d{normal(random), normal(random)} * by;
    return out;
  };
  const auto apart = [](const Ball& a, const Ball& b) {
    return norm(a.at - b.at) >= touching_distance(a.body, b.body);
  };
  for (int i = 0; i < patience; ++i) {
    std::vector<Ball> balls{moved(shot.ball)};
    for (const Ball& other : shot.others) balls.push_back(moved(other));
    bool good = true;
    for (std::size_t k = 0; k < balls.size() && good; ++k) {
      const Boundary boundary(shot.table, balls[k].body);
      good = boundary.clearance(balls[k].at) >= 0 && !boundary.pocket_around(balls[k].at);
      for (std::size_t j = 0; j < k && good; ++j) good = apart(balls[j], balls[k]);
    }
    if (!good) continue;
    shot.ball = balls.front();
    shot.others.assign(balls.begin() + 1, balls.end());
    return true;
  }
  return false;
}

}  // namespace

bool is_legal(const Puzzle& puzzle, const Shot& shot, const ShotRequest& played) {
  return Referee(puzzle, shot, played).legal();
}

std::optional<ShotRequest> noisy_play(const Puzzle& p, const Shot& shot, Random& random) {
  ShotRequest played{{}, p.table, p.physics, p.ball, p.others, shot.launch, shot.spin, {}};
  const Noise& noise = p.noise;
  played.launch.speed += noise.speed_at(shot.launch.speed) * normal(random);
  played.launch.angle = wrap_angle(shot.launch.angle + noise.angle * normal(random));
  const double side = normal(random), top = normal(random);
  if (!(played.launch.speed > 0)) return {};
  if (carries_spin(p.physics)) {
    played.spin.side += noise.side_of(p.ball.body.radius) * side;
    played.spin.top += noise.top_of(p.ball.body.radius) * top;
  }
  if (noise.at > 0) move_balls(played, noise.at, random);
  return played;
}

double share_of_plays(const Puzzle& puzzle, const Shot& shot, int plays, std::uint64_t seed) {
  Random random(seed);
  int made = 0;
  for (int i = 0; i < plays; ++i)
    if (const auto played = noisy_play(puzzle, shot, random)) made += is_legal(puzzle, shot, *played);
  return static_cast<double>(made) / plays;
}

}  // namespace bankshot::test
