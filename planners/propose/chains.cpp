// SPDX-License-Identifier: MIT
//
// Shots by which the cue ball sets an object ball going: two searches of one ball, put together.
// Method: the object ball, as if alone where it stands, has a launch for each of its routes; images and Newton's method
// find them. Its direction gives the ghost ball: the place of the cue ball when they touch. Its speed gives the normal
// speed that the cue ball must have there. Images lead the cue ball through the ghost ball at that normal speed, so
// that no cosine of the cut is left. The ghost ball is turned back by the angle by which throw turns the object ball.
// From there Newton's method solves the whole chain, with derivatives through the contact. In a combination the last
// ball is searched for alone. The chain of the balls before it leads through its ghost ball, and is found in the same
// way.
// Cost: some ten simulations a leg, twenty a chain. Guarantee: none beyond verification. A root is found where its seed
// leads, and a chain of routes hardly ever has two.
#include <algorithm>
#include <cmath>
#include <set>

#include "bankshot/contact/ball_ball.hpp"
#include "planners/propose/leg.hpp"
#include "planners/propose/part.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/propose/settings.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/solve/newton.hpp"
#include "planners/solve/speed.hpp"
#include "planners/stop.hpp"
#include "planners/trace/arrival.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::chains;

class Chains {
 public:
  Chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Objects::Chain& chain)
      : request_(request),
        budget_(budget),
        found_(found),
        chain_(chain),
        last_(*chain.balls.back()),
        by_(chain.balls.size() > 1 ? chain.balls[chain.balls.size() - 2] : nullptr),
        to_ghost_(request, before_last(request, chain),
                  request.one_unknown() ? std::optional(request.fixed_speed()) : std::nullopt) {}

  void run(std::vector<Candidate>& known) {
    for (const Leg& leg : legs(request_, budget_, chain_, known)) {
      if (stop::enough_seeds(request_, budget_, found_)) return;
      if (is_worth(leg, norm(last_.at_rest.at - request_.puzzle().ball.at))) join_all(leg);
      if (is_settled(leg)) known.push_back(leg.alone);
    }
  }

 private:
  /// Returns whether a cue ball that rolls so far [m] to the object ball may pot it as often as the request needs. An
  /// error of aim grows by that distance over the one between the touching centres. English and cushions may lessen
  /// that.
  bool is_worth(const Leg& leg, double distance) const {
    if (request_.likelier <= 0 || by_ || !(leg.spread > 0) || !leg.aim_point.drops()) return true;
    const double turned = request_.puzzle().noise.angle * distance / norm(ghost({1, 0}) - last_.at_rest.at);
    const double beside = least_turned * turned * leg.spread;
    return std::erf(leg.aim_point.reach / (beside * std::sqrt(2.0))) > request_.likelier;
  }

  /// Joins the leg with all routes through its ghost ball: images, and in a combination the chains of the balls before.
  void join_all(const Leg& leg) {
    // This is a copy, since corrections move the place.
    const SearchRequest at_ghost = to_ghost_.at(ghost(direction(leg.launch().angle)), normal_speed(leg.launch().speed));
    if (!by_) return each_image(leg, at_ghost);
    SearchResult starts;
    KnownLegs none;
    chains(at_ghost, budget_, starts, none);
    for (const Candidate& candidate : starts.candidates) {
      if (stop::enough_seeds(request_, budget_, found_)) return;
      if (!has_candidate(leg, candidate.route)) join(leg, candidate.route, candidate.launch);
    }
  }

  /// Joins the leg with each image of the ghost ball. A route that has a root needs no other image.
  void each_image(const Leg& leg, const SearchRequest& at_ghost) {
    const bool straight = is_straight(request_.puzzle().physics);
    std::set<Route> settled;
    for (const double share : settings::restitution_shares) {
      const double e = share * restitution(request_.puzzle().physics).at_rest;
      Unfolding images(at_ghost, {.parts = !straight, .restitution = e, .keep_routes = true});
      while (const auto image = images.next()) {
        if (stop::enough_seeds(request_, budget_, found_)) return;
        Route route = images.route(*image);
        if (settled.contains(route) || has_candidate(leg, route) || !is_worth(leg, image->distance)) continue;
        if (route.empty() && (share != settings::restitution_shares.front() || !may_hit(leg, image->angle))) continue;
        const auto speed =
            speed_at({at_ghost, route, at_ghost.problem->aim_points.front()}, budget_, image->angle, image->distance);
        if (speed && join(leg, route, {*speed, image->angle})) settled.insert(std::move(route));
      }
      if (straight || (request_.route && !found_.shots.empty())) return;
    }
  }

  /// Returns whether a straight hit on the ghost ball is possible: the cue ball must come from behind it.
  bool may_hit(const Leg& leg, double angle) const {
    return request_.spin.masse != 0 || dot(direction(angle), direction(leg.launch().angle)) >= least_cosine;
  }

  /// Returns whether no other arrival speed needs this leg: its straight hit is found, or no straight hit sends the
  /// ball there.
  bool is_settled(const Leg& leg) const {
    if (!hit_straight(request_, chain_)) return false;
    const Vec2d way = last_.at_rest.at - request_.puzzle().ball.at;
    return has_candidate(leg, {}) || dot(way, direction(leg.launch().angle)) < least_settled * norm(way);
  }

  /// Returns whether the result has a candidate by this route, found at another arrival speed or just now.
  bool has_candidate(const Leg& leg, const Route& before) const {
    if (!request_.starts() || found_.candidates.empty()) return false;
    const Route whole = whole_route(leg, before);
    return std::ranges::any_of(found_.candidates, [&](const Candidate& candidate) {
      return candidate.aim_point == leg.aim_point && candidate.route == whole;
    });
  }
  Route whole_route(const Leg& leg, const Route& before) const {
    return together(chain_, to_ghost_.part().whole(before), leg);
  }

  /// Returns the place of the ball before the last when it sends the last one along n.
  Vec2d ghost(const Vec2d& n) const {
    return last_.at_rest.at - n * touching_distance(body_before(), last_.at_rest.body);
  }
  const Body& body_before() const { return by_ ? by_->at_rest.body : request_.puzzle().ball.body; }

  /// Returns the normal speed of the ball before the last that gives the last ball this speed.
  double normal_speed(double speed) const {
    const double m1 = body_before().mass, m2 = last_.at_rest.body.mass;
    return speed * (m1 + m2) / ((1 + collisions(request_.puzzle().physics).restitution) * m1);
  }

  /// Joins the leg with a route through the ghost ball. `seed` is a launch near that route. It is corrected, and
  /// Newton's method then finds the root of the whole chain.
  bool join(const Leg& leg, const Route& route, Launch seed) {
    double turn = 0, asked = normal_speed(leg.launch().speed);
    for (int i = 0; i < settings::most_steps; ++i) {
      const Vec2d n = direction(leg.launch().angle + turn);
      const SearchRequest& own = to_ghost_.at(ghost(n), asked);
      const Branch aim{own, route, own.problem->aim_points.front()};
      const auto root = newton(aim, budget_, seed, settings::wide);
      if (!root) return false;
      seed = *root;
      budget_.charge(route.size());
      auto arrival = arrival_of(aim, start_of(own, seed), request_.puzzle().physics, budget_.work());
      if (!arrival || !(dot(arrival->heading, n) > 0)) return false;
      const double cosine = dot(arrival->heading, n) / norm(arrival->heading);
      if (cosine < least_cosine) return false;
      State<double> struck = arrival->state, sent{last_.at_rest.at, {}, {}};
      struck.at = ghost(n);
      collisions(request_.puzzle().physics).collide(body_before(), struck, last_.at_rest.body, sent);
      const double off = angle_difference(std::atan2(sent.velocity.y, sent.velocity.x), leg.launch().angle);
      const double normal = dot(arrival->state.velocity, n) * leg.launch().speed / norm(sent.velocity), before = asked;
      asked = normal / cosine;
      if (!request_.one_unknown()) seed.speed *= asked / before;
      turn += off;
      if (i > 0 && std::abs(off) < settings::alike) break;
    }
    const Route whole = whole_route(leg, route);
    const Branch aim{request_, whole, leg.aim_point};
    for (const double faster : faster_seeds) {
      const Launch from{request_.one_unknown() ? request_.fixed_speed() : seed.speed * faster, seed.angle};
      const auto root = newton(aim, budget_, from, settings::wide);
      if (!root) continue;
      certify_root(aim, budget_, found_, *root, word::unfold);
      return true;
    }
    return false;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  const Objects::Chain& chain_;
  const Objects::Object& last_;
  const Objects::Object* by_;  ///< the ball before the last; null: the cue ball
  ToPlace to_ghost_;
};

}  // namespace

void chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, KnownLegs& known) {
  for (const Objects::Chain& chain : request.problem->objects->chains)
    if (!is_hidden(request, chain)) Chains(request, budget, found, chain).run(known[&chain]);
}

}  // namespace bankshot::planning::propose
