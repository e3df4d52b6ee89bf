// SPDX-License-Identifier: MIT
#include "truth/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "truth/arrival.hpp"

namespace bankshot::truth {
namespace {

/// Two bounces closer than this are one instant for a run in double [s].
constexpr double one_instant = 1e-12;

/// Returns true if the contacts have the required order. Two at one instant match in either order.
bool same_order(const std::vector<Contact>& asked, const std::vector<const TruthEvent*>& met) {
  if (asked.size() != met.size()) return false;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (met[i]->contact == asked[i]) continue;
    const bool swapped = i + 1 < asked.size() && met[i + 1]->time - met[i]->time <= one_instant &&
                         met[i]->contact == asked[i + 1] && met[i + 1]->contact == asked[i];
    if (!swapped) return false;
    ++i;
  }
  return true;
}

/// Judges a path event by event. After the cue ball has hit an object ball, the object ball is judged.
class Judge {
 public:
  Judge(const Scene& scene, const Goal& goal)
      : scene_(scene),
        puzzle_(scene.puzzle),
        goal_(goal),
        first_(touched_first(puzzle_.target)),
        touches_(touch_of(puzzle_.target)),
        off_(first_of_carom(puzzle_.target)),
        then_(then_of(puzzle_.target)),
        point_(point_of(puzzle_.target)),
        pocket_(pocket_of(puzzle_.target)),
        within_(point_ ? point_->within + goal.slack : 0) {
    if (goal.counts && !goal.counts->path.hits.empty()) own_ = goal.counts;
    if (own_ && pocket_) own_pocket_ = pocket_reached(puzzle_, *own_);
    note_order();
  }

  Arrived run(const Path& path) {
    for (const TruthEvent& e : path.events)
      if (then_ && !hit_ ? ends_before_hit(e) : ends(e)) return std::move(out_);
    fails(does("passes by the target", "sends it past the target"));
    return std::move(out_);
  }

 private:
  /// Returns the words for the cue ball, or those for the object ball that it hits.
  std::string_view does(std::string_view itself, std::string_view another) const { return then_ ? another : itself; }
  std::string name(const TruthEvent& e) const { return contact_name(puzzle_, e.contact); }

  bool fails(std::string_view why) {
    if (!found_) out_.why = why;
    return true;
  }

  void note_order() { out_.in_order = !goal_.sequence || same_order(*goal_.sequence, met_); }

  /// Handles an event of the cue ball on its way to an object ball. Returns true if the path ends.
  bool ends_before_hit(const TruthEvent& e) {
    if (e.ball != 0 || e.kind == EventKind::slide_to_roll) return false;
    if (e.kind == EventKind::jaw) {
      touched_jaw_ = true;
      return false;
    }
    if (e.kind == EventKind::cushion) {
      if (bounces_in_place(e)) return fails("bounces where it stands");
      if (static_cast<int>(met_.size()) == goal_.max) return fails(fmt::format("meets {} before the ball", name(e)));
      met_.push_back(&e);
      out_.cushions.push_back(e.contact);
      return false;
    }
    if (e.kind != EventKind::ball) return fails("touches no ball");
    note_order();
    const int ball = e.contact.index;
    const bool wanted = std::ranges::count(first_, ball) > 0 && !(goal_.then && goal_.then->front().ball != ball) &&
                        !(own_ && own_->path.hits.front().ball != ball);
    if (!wanted || static_cast<int>(met_.size()) < goal_.min) return fails(fmt::format("runs into {}", name(e)));
    return sets_going(e, ball);
  }

  bool sets_going(const TruthEvent& e, int ball) {
    hit_ = &e;
    out_.hits.push_back({ball, e.passing});
    if (off_ != 0) return false;
    out_.ball = ball;
    out_.then.push_back({ball, {}});
    met_.clear();
    return false;
  }
  /// Returns the number of the moving object ball, from 0.
  std::size_t nth() const { return out_.then.size() - 1; }

  /// Returns true if the pot counts by any rails.
  bool any_fall() const { return goal_.counts && then_ && all_set() && then_->counts_any_fall(); }
  bool own_pocket(Contact pocket) const {
    return !own_pocket_ || &puzzle_.table.pockets[static_cast<std::size_t>(pocket.index)] == own_pocket_;
  }

  /// Returns true if the arriving ball has made the required bounces.
  bool counts() const {
    const auto in_turn = [&](const std::vector<Contact>& asked) { return same_order(asked, met_); };
    if (!then_) return static_cast<int>(met_.size()) >= goal_.min && out_.in_order;
    if (any_fall()) return true;
    if (goal_.then) return in_turn((*goal_.then)[nth()].cushions);
    const CushionRule& rule = then_->cushions_of(nth());
    return static_cast<int>(met_.size()) >= rule.min && (!rule.sequence || in_turn(*rule.sequence));
  }
  int most() const {
    if (!then_) return goal_.max;
    if (any_fall()) return max_cushions;
    return goal_.then ? static_cast<int>((*goal_.then)[nth()].cushions.size()) : then_->cushions_of(nth()).max;
  }
  bool all_set() const { return !then_ || nth() == then_->links.size(); }
  /// Returns true if the moving ball hits the next ball of the combination.
  bool is_next(const TruthEvent& e) const {
    if (!then_ || all_set()) return false;
    return e.ball == out_.ball && e.contact == Contact::ball(then_->links[nth()].ball);
  }

  bool ends(const TruthEvent& e) {
    if (e.ball == out_.ball) look_at_pass(e);
    if (e.kind == EventKind::ball) return meets(e);
    if (e.ball != out_.ball) return false;
    switch (e.kind) {
      case EventKind::cushion:
        return bounces(e);
      case EventKind::jaw: {
        const int of = e.contact.jaw_pocket();
        if (pocket_ && !jaw_ && pocket_->pocket.value_or(of) == of) jaw_ = &e;
        touched_jaw_ = true;
        return false;
      }
      case EventKind::slide_to_roll:
        return false;
      case EventKind::pocket:
        if (!pocket_ || (pocket_->pocket && Contact::pocket(*pocket_->pocket) != e.contact) || !all_set() ||
            !counts() || !own_pocket(e.contact))
          return fails(fmt::format("{} pocket {}", does("falls into", "sends it into"), name(e)));
        return taken(e, jaw_ ? *jaw_ : e);
      case EventKind::rest:
        return rests(e);
      default:
        return fails("passes by the target");
    }
  }

  /// Takes note of a pass by the point. Of several passes, the one nearest to the claimed time counts.
  void look_at_pass(const TruthEvent& e) {
    const bool whole_arc = !then_ || e.kind == EventKind::slide_to_roll;
    if (!point_ || scene_.stops || !whole_arc || !all_set() || !counts() || e.passing.miss > within_) return;
    if (found_ && !(std::abs(e.passing.time - goal_.time) < std::abs(out_.time - goal_.time))) return;
    at_point(e.passing);
    found_ = true;
  }

  bool bounces(const TruthEvent& e) {
    if (e.ball == 0 && bounces_in_place(e)) return fails("bounces where it stands");
    if (then_ && !(e.time > hit_->time)) return false;  // bounces off a cushion it touches at the instant of the hit
    if (static_cast<int>(met_.size()) == most() || found_)
      return fails(fmt::format("{} {} before the target", does("meets", "sends it to"), name(e)));
    met_.push_back(&e);
    (then_ ? out_.then.back().cushions : out_.cushions).push_back(e.contact);
    if (!then_) note_order();
    return false;
  }

  /// Returns true for a forbidden bounce without travel at the start. A ball in a corner may bounce twice in place; a
  /// point ball in a vertex may not bounce at all.
  bool bounces_in_place(const TruthEvent& e) {
    constexpr std::size_t of_a_corner = 2;
    at_start_ = at_start_ && norm(e.state.at - puzzle_.ball.at) <= scene_.boundary.touch;
    return at_start_ && (is_in_vertex() || met_.size() == of_a_corner);
  }
  bool is_in_vertex() const {
    const auto there = [&](const Vec2d& vertex) { return norm(vertex - puzzle_.ball.at) <= scene_.boundary.touch; };
    return puzzle_.ball.body.radius == 0 && std::ranges::any_of(puzzle_.table.vertices, there);
  }

  bool meets(const TruthEvent& e) {
    if (is_next(e)) return counts() ? sets_going(e, then_->links[nth()].ball) : fails("meets the next ball too soon");
    if (then_) return fails(fmt::format("touches {}", name(e)));
    if (off_ != 0 && !hit_ && e.contact.index == off_) return sets_going(e, off_);
    if ((off_ != 0 && !hit_) || e.ball != 0) return fails(fmt::format("touches {}", name(e)));
    if (!touches_ || std::ranges::count(touches_->balls, e.contact.index) == 0 || !counts() ||
        (own_ && own_->path.hits.back().ball != e.contact.index))
      return fails(fmt::format("runs into {}", name(e)));
    taken(e, e);
    out_.speed = e.passing.speed;
    out_.hits.push_back({e.contact.index, e.passing});
    const double reach = scene_.boundary.rim(e.contact)->radius, most = radians(90.0);
    const auto offset = [&](double at) { return -reach * std::sin(std::clamp(at, -most, most)); };
    const double cut = touches_->exact_cut(), within = touches_->cut_within();
    const double low = offset(cut + within), high = offset(cut - within);
    if (out_.offset < low - goal_.slack || out_.offset > high + goal_.slack)
      out_.why = fmt::format("meets {} at another cut", name(e));
    return true;
  }

  bool rests(const TruthEvent& e) {
    if (!scene_.stops || !all_set() || !counts())
      return fails(does("stops before the target", "sends it not as far as the target"));
    const double miss = norm((e.state.at - point_->at) + e.at_rest);
    if (miss > within_)
      return fails(fmt::format("{} {:.6g} m from the target", does("stops", "sends it to rest"), miss));
    at_point({.time = e.time, .speed = 0, .at = e.state.at, .velocity = {}, .miss = miss});
    return true;
  }

  void at_point(const Passing& p) {
    out_.why = "";
    out_.time = p.time, out_.speed = p.speed, out_.passed = p.miss, out_.at = p.at;
    out_.touches_jaws = touched_jaw_;
  }

  /// Records the capture at event `e`; `line` is the event whose line of travel counts.
  bool taken(const TruthEvent& e, const TruthEvent& line) {
    out_.why = "";
    out_.time = e.time, out_.speed = norm(e.state.velocity), out_.at = e.state.at;
    out_.touches_jaws = touched_jaw_;
    const Circle& rim = *scene_.boundary_of(e.ball).rim(e.contact);
    out_.taken_by = e.contact;
    out_.offset = -line.passing.lateral;
    out_.heading = line.passing.velocity;
    if (rim.radius > 0) out_.incidence = std::sqrt(std::max(1 - std::pow(e.passing.lateral / rim.radius, 2), 1e-12));
    return true;
  }

  const Scene& scene_;
  const Puzzle& puzzle_;
  const Goal& goal_;
  std::vector<int> first_;  ///< balls one of which the cue ball must touch first
  const BallTarget* touches_;
  int off_;  ///< the first ball of a carom; 0 if there is none
  const Then* then_;
  const PointTarget* point_;
  const PocketTarget* pocket_;
  const Shot* own_ = nullptr;  ///< the shot whose ball and pocket alone count
  const Pocket* own_pocket_ = nullptr;
  double within_;                         ///< m
  std::vector<const TruthEvent*> met_{};  ///< bounces: of the cue ball up to its hit, then of the moving object ball
  const TruthEvent* hit_ = nullptr;       ///< the last hit before the target
  const TruthEvent* jaw_ = nullptr;       ///< the first contact with a jaw of the target pocket
  bool touched_jaw_ = false;              ///< a jaw of any pocket was touched
  bool found_ = false;                    ///< a pass by the point was found
  bool at_start_ = true;                  ///< the cue ball has bounced only at its start
  Arrived out_{};
};

}  // namespace

Arrived judge(const Scene& scene, const Path& path, const Goal& goal) { return Judge(scene, goal).run(path); }

}  // namespace bankshot::truth
