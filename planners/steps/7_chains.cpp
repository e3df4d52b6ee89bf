// SPDX-License-Identifier: MIT
//
// Shots by which the struck ball sends another on: two searches of one ball, put together.
// Method: the other ball alone, from where it stands, has a launch for each of its routes, as images and Newton's
// method find them; its direction gives the ghost, where the struck ball must be when they touch, and its speed the
// normal speed that the struck one must have there. Images lead the struck ball through the ghost at that normal speed,
// so that no cosine of the cut is left; what throw turns the other ball by, the ghost is turned back. From there
// Newton's method on the whole chain, with derivatives through the contact. Cost: some ten simulations a leg, twenty a
// chain. Guarantee: none beyond the proof; a root is found where its seed leads, and a chain of routes hardly ever has
// two.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/certify.hpp"
#include "planners/images/unfold.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/arrival.hpp"
#include "planners/locked/clearance.hpp"
#include "planners/locked/newton.hpp"
#include "planners/locked/speed.hpp"
#include "planners/proof/replay.hpp"
#include "planners/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::chains;

/// The ball that is sent on, as if it were launched by itself.
struct Leg {
  Launch launch;
  Route route;  ///< its own
  Mark mark;
  bool clear = true;  ///< so launched it arrives: nothing is in the way
};

Puzzle alone(const Question& q, const Objects::Object& object) {
  const Puzzle& p = q.puzzle;
  Puzzle out{.table = p.table, .physics = p.physics, .ball = object.at_rest};
  for (std::size_t i = 0; i < p.others.size(); ++i)
    if (static_cast<int>(i) + 1 != object.ball) out.others.push_back(p.others[i]);
  const Then& then = *q.then();
  out.target = std::visit([](const auto& t) { return Target(t); }, then.target);
  out.cushions = then.cushions;
  out.speed = {q.speed.high * slowest_sent, q.speed.high * fastest_sent};
  if (!is_ideal(p.physics)) out.arrive = q.arrival.value_or(Range{0, fastest_sent * q.speed.high});
  out.prefer = p.prefer;
  out.budget = p.budget;
  return out;
}

using Source = void (*)(const Question&, Ledger&, Findings&);
void from_images(const Question& q, Ledger& ledger, Findings& found) { images(q, ledger, found); }
void from_map(const Question& q, Ledger& ledger, Findings& found) {
  images(q, ledger, found);
  if (q.route) fan(q, ledger, found);
  if (!is_straight(q.puzzle.physics)) map(q, ledger, found, usual_spacing(q));
}

/// By what stands where it does at any speed.
bool is_blocked(Foul foul) { return foul == Foul::hit_ball || foul == Foul::pocketed || foul == Foul::wrong_cushion; }

class Chains {
 public:
  Chains(const Question& q, Ledger& ledger, Findings& found) : q_(q), ledger_(ledger), found_(found) {}

  void run() {
    for (const Objects::Object& object : q_.objects->all)
      for (const Leg& leg : legs(object, from_images)) {
        if (stop::enough_seeds(q_, ledger_, found_)) return;
        if (!leg.clear && !q_.every) continue;
        each_image(object, leg, [&](const Route& route, const Candidate& image) {
          return chain(object, leg, route, image.angle, image.distance);
        });
      }
  }

  void closely() {
    for (const Objects::Object& object : q_.objects->all) {
      std::vector<Leg> all = legs(object, from_map);
      std::stable_partition(all.begin(), all.end(), [](const Leg& leg) { return leg.clear; });
      for (const Leg& leg : all) {
        if (over()) return;
        each_image(object, leg, [&](const Route& route, const Candidate& image) {
          return chain(object, leg, route, image.angle, image.distance);
        });
      }
      std::ranges::move(images_of(object), std::back_inserter(all));
      const std::vector<Lead> to_ball = leads_to(object);
      once_each_pair(object, all, to_ball, [&](const LockedAim& aim, const Range& across) { sweep(aim, across); });
      once_each_pair(object, all, to_ball, [&](const LockedAim& aim, const Range& across) { grid(aim, across); });
      by_replays(object, to_ball);
    }
  }

 private:
  /// `look(chain, aims across the ball)`.
  template <class Look>
  void once_each_pair(const Objects::Object& object, const std::vector<Leg>& legs, const std::vector<Lead>& to_ball,
                      const Look& look) {
    std::set<std::tuple<Route, double, double>> done;
    for (const Leg& leg : legs) {
      if (!done.insert({leg.route, leg.mark.at.x, leg.mark.at.y}).second) continue;
      std::set<Route> looked;
      for (const Lead& lead : to_ball) {
        if (over()) return;
        if (looked.contains(lead.route)) continue;
        const auto across = aims_across(object, lead.route, lead.launch.angle);
        if (!across) continue;
        looked.insert(lead.route);
        const Route whole = together(object, leg, lead.route);
        look({q_, whole, leg.mark}, *across);
      }
    }
  }

  /// At the middle of the ball, by all routes of the struck one that its cushions allow, at one speed.
  std::vector<Lead> leads_to(const Objects::Object& object) {
    const Puzzle to_middle = puzzle_to(object.at_rest.at);
    Question own(to_middle, Wanted::starts);
    own.spin = q_.spin;
    own.pinned = middle_speed();
    Findings starts;
    from_map(own, ledger_, starts);
    return std::move(starts.leads);
  }

  double middle_speed() const {
    return q_.one_unknown() ? q_.fixed_speed()
                            : std::sqrt(std::max(q_.speed.low, q_.speed.high * slowest_swept) * q_.speed.high);
  }

  /// Routes of the other ball that some image has, though no launch by itself may.
  std::vector<Leg> images_of(const Objects::Object& object) {
    const Puzzle own = alone(q_, object);
    const Question all(own, Wanted::starts);
    std::vector<Leg> out;
    const bool straight = is_straight(q_.puzzle.physics);
    for (const double share : settings::restitution_shares) {
      const double e = share * restitution(q_.puzzle.physics).at_rest;
      Unfolding images(all, {.parts = true, .restitution = e, .keep_routes = true});
      while (const auto image = images.next()) {
        Route route = images.route(*image);
        for (Meeting& m : route) m.ball = object.ball;
        Mark mark = all.marks[image->mark];
        mark.ball = object.ball;
        out.push_back({{1, image->angle}, std::move(route), mark});
      }
      if (straight) break;
    }
    return out;
  }

  bool over() const { return stop::over(q_, ledger_, found_) || !(q_.all() || q_.starts() || found_.shots.empty()); }

  /// Where the launch speed of the struck ball is all that is given, that of the other is guessed.
  std::vector<Leg> legs(const Objects::Object& object, const Source& source) {
    const Puzzle own = alone(q_, object);
    const Question all(own, Wanted::starts);
    std::vector<Leg> out;
    const auto look = [&](const Question& one) {
      Findings starts;
      source(one, ledger_, starts);
      for (Lead& lead : starts.leads) {
        if (ledger_.spent()) return;
        const std::vector<Contact> cushions = contacts_of(lead.route);
        const bool clear = !is_blocked(replay(one, ledger_, lead.launch, Goal::along(cushions)).failure.foul);
        for (Meeting& m : lead.route) m.ball = object.ball;
        lead.mark.ball = object.ball;
        out.push_back({lead.launch, std::move(lead.route), lead.mark, clear});
      }
    };
    if (!q_.one_unknown())
      look(all.asking(q_.asked));
    else
      for (const double share : shares_of_speed) look(all.launched_at(share * q_.fixed_speed()));
    return out;
  }

  /// Of the ghost: `from(route, image)` says whether that route needs no other image.
  template <class From>
  void each_image(const Objects::Object& object, const Leg& leg, const From& from) {
    const bool straight = is_straight(q_.puzzle.physics);
    std::set<Route> settled;
    for (const double share : settings::restitution_shares) {
      Puzzle to_ghost = puzzle_to(ghost(object, direction(leg.launch.angle)));
      Question own(to_ghost, Wanted::starts);
      own.spin = q_.spin;
      own.pinned = q_.one_unknown() ? std::optional(q_.fixed_speed()) : std::nullopt;
      const double e = share * restitution(q_.puzzle.physics).at_rest;
      Unfolding images(own, {.parts = !straight, .restitution = e, .keep_routes = true});
      while (const auto image = images.next()) {
        if (stop::enough_seeds(q_, ledger_, found_)) return;
        Route route = images.route(*image);
        if (settled.contains(route)) continue;
        if (from(route, *image)) settled.insert(std::move(route));
      }
      if (straight || (q_.route && !found_.shots.empty())) return;
    }
  }

  Vec2d ghost(const Objects::Object& object, const Vec2d& n) const {
    return object.at_rest.at - n * q_.boundary.rim(Contact::ball(object.ball))->radius;
  }

  Puzzle puzzle_to(const Vec2d& at) const {
    Puzzle p = q_.puzzle;
    p.others.clear();
    p.target = PointTarget{at};
    p.arrive = Range{0, fastest_sent * q_.speed.high};
    p.speed = {q_.speed.low * slowest_sent, q_.speed.high * fastest_sent};
    return p;
  }

  /// The normal speed that gives the other ball a speed.
  double normal_speed(const Objects::Object& object, double speed) const {
    const double m1 = q_.puzzle.ball.body.mass, m2 = object.at_rest.body.mass;
    return speed * (m1 + m2) / ((1 + collisions(q_.puzzle.physics).restitution) * m1);
  }

  /// One image of the ghost, corrected, and from there the root of the whole.
  bool chain(const Objects::Object& object, const Leg& leg, const Route& route, double angle, double length) {
    double turn = 0, normal = normal_speed(object, leg.launch.speed), asked = normal;
    std::optional<Launch> seed;
    for (int i = 0; i < most_corrections; ++i) {
      const Vec2d n = direction(leg.launch.angle + turn);
      const Puzzle to_ghost = puzzle_to(ghost(object, n));
      Question own(to_ghost, Wanted::starts);
      own.spin = q_.spin;
      own.pinned = q_.one_unknown() ? std::optional(q_.fixed_speed()) : std::nullopt;
      own.asked = asked;
      const LockedAim aim{own, route, own.marks.front()};
      if (!seed) {
        const auto speed = speed_at(aim, ledger_, angle, length);
        if (!speed) return false;
        seed = Launch{*speed, angle};
      }
      const auto root = newton(aim, ledger_, *seed, settings::wide);
      if (!root) return false;
      seed = root.launch;
      ledger_.charge(route.size());
      auto arrival = arrival_of(aim, start_of(own, *seed), q_.puzzle.physics);
      if (!arrival || !(dot(arrival->heading, n) > 0)) return false;
      const double cosine = dot(arrival->heading, n) / norm(arrival->heading);
      if (cosine < least_cosine) return false;
      State<double> struck = arrival->state, sent{object.at_rest.at, {}, {}};
      struck.at = ghost(object, n);
      collisions(q_.puzzle.physics).collide(q_.puzzle.ball.body, struck, object.at_rest.body, sent);
      const double off = angle_difference(std::atan2(sent.velocity.y, sent.velocity.x), leg.launch.angle);
      normal = dot(arrival->state.velocity, n) * leg.launch.speed / norm(sent.velocity);
      const double before = asked;
      asked = normal / cosine;
      if (!q_.one_unknown()) seed->speed *= asked / before;
      turn += off;
      if (i > 0 && std::abs(off) < settled_turn) break;
    }
    const Route whole = together(object, leg, route);
    const LockedAim aim{q_, whole, leg.mark};
    for (const double faster : faster_seeds) {
      const Launch from{q_.one_unknown() ? q_.fixed_speed() : seed->speed * faster, seed->angle};
      const auto root = newton(aim, ledger_, from, settings::wide);
      if (!root) continue;
      certify_root(aim, ledger_, found_, root.launch, word::chains);
      return true;
    }
    return false;
  }

  static Route together(const Objects::Object& object, const Leg& leg, Route route) {
    route.push_back({0, Contact::ball(object.ball)});
    route.insert(route.end(), leg.route.begin(), leg.route.end());
    return route;
  }

  /// A launch at an aim, and on which side of the mark it leads the other ball.
  struct Side {
    Launch launch;
    double side = 0;
    double lateral = 0;  ///< m, from the exact line
  };

  std::optional<Side> side_at(const LockedAim& aim, double angle, double guess) {
    if (ledger_.spent()) return {};
    const auto speed = speed_near(aim, ledger_, angle, guess);
    const auto l = speed ? linearise(aim, ledger_, {*speed, angle}) : std::nullopt;
    if (!l) return {};
    return Side{{*speed, angle},
                q_.stop ? l->r[0] * l->by_speed(1) - l->r[1] * l->by_speed(0) : l->r[0],
                std::abs(l->r[0]) * q_.boundary.diagonal};
  }

  /// Evenly in the cut, each at the speed that arrives as asked.
  void sweep(const LockedAim& aim, const Range& across) {
    const double middle = (across.low + across.high) / 2, half = (across.high - across.low) / 2;
    std::optional<Side> last;
    std::vector<Side> beside;
    double guess = middle_speed();
    for (int i = -sweep_steps; i <= sweep_steps && !over(); ++i) {
      const double cut = widest_cut * i / sweep_steps;
      const double to = middle + half * std::sin(cut);
      auto now = side_at(aim, to, guess);
      if (!now) now = side_from_bounds(aim, to);
      if (now) guess = now->launch.speed;
      if (now && last && (now->side > 0) != (last->side > 0)) between(aim, *last, *now);
      last = now;
      if (now && !q_.starts() && now->lateral < 2 * aim.mark.reach) beside.push_back(*now);
    }
    make_beside(aim, beside);
  }

  /// Whether it arrives as fast as asked, or as the launch speed lets it.
  bool as_fast(const Replay& r) const {
    if (q_.one_unknown() || q_.stop) return true;
    const double fine = tolerance::exact_speed * std::max(1.0, q_.asked) / 4;
    return std::abs(r.arrival.speed - q_.asked) <= fine;
  }

  /// Launches that are made by whatever they meet, where no root leads along it: aims across the ball at speeds between
  /// the bounds, each corrected by secants of the squared speeds until it arrives as fast as asked.
  void by_replays(const Objects::Object& object, const std::vector<Lead>& to_ball) {
    std::set<Route> looked;
    const double slowest = std::max(q_.speed.low, q_.speed.high * settings::slowest_of_fastest);
    const int rows = q_.one_unknown() ? 1 : grid_rows;
    for (const Lead& lead : to_ball) {
      if (looked.contains(lead.route)) continue;
      const auto across = aims_across(object, lead.route, lead.launch.angle);
      if (!across) continue;
      looked.insert(lead.route);
      const double half = (across->high - across->low) / 2, middle = across->low + half;
      for (int i = -sweep_steps; i <= sweep_steps; ++i)
        for (int k = 0; k < rows; ++k) {
          if (over()) return;
          const double share = rows > 1 ? static_cast<double>(k) / (rows - 1) : 0;
          correct({rows > 1 ? slowest * std::pow(q_.speed.high / slowest, share) : q_.fixed_speed(),
                   middle + half * std::sin(widest_cut * i / sweep_steps)});
        }
    }
  }

  void correct(Launch at) {
    const Goal goal = Goal::of(q_, Demand::made);
    const auto follow = [&] { return replay(q_, ledger_, {at.speed, wrap_angle(at.angle)}, goal); };
    const auto square = [](double x) { return x * x; };
    Replay r = follow();
    double slope = square(r.arrival.speed / at.speed);
    for (int n = 0; n < most_secants && r.made && !as_fast(r) && slope > 0 && !ledger_.spent(); ++n) {
      const double before = square(at.speed), arrived = square(r.arrival.speed);
      at.speed *= std::sqrt(1 + std::clamp((square(q_.asked) - arrived) / (slope * before), -0.5, 1.0));
      r = follow();
      const double grown = (square(r.arrival.speed) - arrived) / (square(at.speed) - before);
      if (grown > 0) slope = grown;
    }
    if (!r.made || !as_fast(r) || ledger_.spent()) return;
    certify(q_, ledger_, found_, {at.speed, wrap_angle(at.angle)}, r.bounces, word::chains, Demand::off_centre);
  }

  /// Where Newton's method does not come to the speed that arrives as asked.
  std::optional<Side> side_from_bounds(const LockedAim& aim, double angle) {
    const auto speed = speed_at(aim, ledger_, angle, q_.boundary.diagonal);
    return speed ? side_at(aim, angle, *speed) : std::nullopt;
  }

  /// Aims across the ball at speeds between the bounds: roots that the derivatives of one of them predict nearby.
  void grid(const LockedAim& aim, const Range& across) {
    const double half = (across.high - across.low) / 2, middle = across.low + half;
    const double slowest = std::max(q_.speed.low, q_.speed.high * settings::slowest_of_fastest);
    const int rows = q_.one_unknown() ? 1 : grid_rows;
    const double step_speed = rows > 1 ? std::log(q_.speed.high / slowest) / (rows - 1) : 1,
                 step_aim = half / grid_steps;
    for (int i = -grid_steps; i <= grid_steps; ++i)
      for (int k = 0; k < rows; ++k) {
        if (over()) return;
        const Launch node{rows > 1 ? slowest * std::exp(k * step_speed) : q_.fixed_speed(),
                          middle + half * std::sin(widest_cut * i / grid_steps)};
        const auto l = linearise(aim, ledger_, node);
        const auto step = l ? newton_step(*l, q_.one_unknown()) : std::nullopt;
        if (!step || !(std::abs((*step)[0]) < grid_reach * step_aim && std::abs((*step)[1]) < grid_reach * step_speed))
          continue;
        const Launch from{node.speed * std::exp((*step)[1]), node.angle + (*step)[0]};
        const auto root = newton(aim, ledger_, from, {grid_reach * step_aim, grid_reach * step_speed});
        if (root) certify_root(aim, ledger_, found_, root.launch, word::chains);
      }
  }

  /// Where the exact line needs a launch that no bound allows, or is blocked, others lead in beside it.
  void make_beside(const LockedAim& aim, std::vector<Side>& launches) {
    std::ranges::sort(launches, {}, &Side::lateral);
    for (const Side& s : launches) {
      if (over()) return;
      if (!q_.speed.contains(s.launch.speed) || !(clearance(aim, ledger_, s.launch).value_or(-1) > 0)) continue;
      certify(q_, ledger_, found_, {s.launch.speed, wrap_angle(s.launch.angle)}, bounces_of(aim.route), word::chains,
              Demand::off_centre);
    }
  }

  /// At the middle of the ball, and as far as the first order says it goes, at a speed in the middle of the bounds.
  std::optional<Range> aims_across(const Objects::Object& object, const Route& route, double angle) {
    const double reach = q_.boundary.rim(Contact::ball(object.ball))->radius;
    if (route.empty()) {
      const Vec2d way = object.at_rest.at - q_.puzzle.ball.at;
      const double half = std::asin(std::min(1.0, reach / norm(way))), to = std::atan2(way.y, way.x);
      return Range{to - half, to + half};
    }
    const Puzzle to_middle = puzzle_to(object.at_rest.at);
    Question own(to_middle, Wanted::starts);
    own.spin = q_.spin;
    own.pinned = middle_speed();
    const LockedAim aim{own, route, own.marks.front()};
    const auto root = newton(aim, ledger_, {*own.pinned, angle}, settings::wide);
    const auto l = root ? linearise(aim, ledger_, root.launch) : std::nullopt;
    if (!l || l->by_aim(0) == 0) return {};
    const double half = std::min(widest_aims, sweep_beyond * reach / std::abs(l->by_aim(0) * q_.boundary.diagonal));
    return Range{root.launch.angle - half, root.launch.angle + half};
  }

  void between(const LockedAim& aim, const Side& a, const Side& b) {
    double low = a.launch.angle, high = b.launch.angle;
    Launch at = a.launch;
    int left = sweep_halvings;
    bisect(
        low, high, [&](double, double) { return left-- > 0; },
        [&](double angle) {
          const auto middle = side_at(aim, angle, at.speed);
          if (middle) at = middle->launch;
          return middle && (middle->side > 0) == (a.side > 0);
        });
    const auto root = newton(aim, ledger_, at, settings::wide);
    if (root) certify_root(aim, ledger_, found_, root.launch, word::chains);
  }

  const Question& q_;
  Ledger& ledger_;
  Findings& found_;
};

}  // namespace

void chains(const Question& q, Ledger& ledger, Findings& found) { Chains(q, ledger, found).run(); }
void chains_closely(const Question& q, Ledger& ledger, Findings& found) { Chains(q, ledger, found).closely(); }

}  // namespace bankshot::planning::steps
