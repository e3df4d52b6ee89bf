// SPDX-License-Identifier: MIT
//
// Shots by which the cue ball sends another on: two searches of one ball, put together.
// Method: the other ball alone, from where it stands, has a launch for each of its routes, as images and Newton's
// method find them; its direction gives the ghost, where the cue ball must be when they touch, and its speed the
// normal speed that the struck one must have there. Images lead the cue ball through the ghost at that normal speed,
// so that no cosine of the cut is left; what throw turns the other ball by, the ghost is turned back. From there
// Newton's method on the whole chain, with derivatives through the contact. In a combination it is the last ball that
// is looked at alone, and what leads through its ghost is the chain of those before it, found in the same way.
// Cost: some ten simulations a leg, twenty a chain. Guarantee: none beyond the proof; a root is found where its seed
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
    for (const Leg& leg : legs(request_, budget_, chain_, images, known)) {
      if (stop::enough_seeds(request_, budget_, found_)) return;
      if (is_worth(leg, norm(last_.at_rest.at - request_.puzzle().ball.at))) join_all(leg);
      if (is_settled(leg)) known.push_back(leg.alone);
    }
  }

 private:
  /// Whether a cue ball that rolls so far [m] to the object ball may pot it as often as the question needs. An error of
  /// aim turns the object ball by the distance over where the balls touch; English and cushions may halve that.
  bool is_worth(const Leg& leg, double distance) const {
    if (request_.likelier <= 0 || by_ || !(leg.spread > 0) || !leg.aim_point.drops()) return true;
    const double turned = request_.puzzle().noise.angle * distance / norm(ghost({1, 0}) - last_.at_rest.at);
    const double beside = least_turned * turned * leg.spread;
    return std::erf(leg.aim_point.reach / (beside * std::sqrt(2.0))) > request_.likelier;
  }

  /// With all that leads through the ghost: images, and in a combination the chains of the balls before.
  void join_all(const Leg& leg) {
    const SearchRequest at_ghost = to_ghost_.at(ghost(direction(leg.launch().angle)));  // corrections move the place
    if (!by_) return each_image(leg, at_ghost);
    SearchResult starts;
    chains(to_ghost_.at(at_ghost.problem->aim_points.front().at, normal_speed(leg.launch().speed)), budget_, starts);
    for (const Candidate& candidate : starts.candidates) {
      if (stop::enough_seeds(request_, budget_, found_)) return;
      if (!has_candidate(leg, candidate.route)) join(leg, candidate.route, candidate.launch);
    }
  }

  /// A route that has a root needs no other image.
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
        const SearchRequest& own =
            to_ghost_.at(at_ghost.problem->aim_points.front().at, normal_speed(leg.launch().speed));
        const auto speed =
            speed_at({own, route, own.problem->aim_points.front()}, budget_, image->angle, image->distance);
        if (speed && join(leg, route, {*speed, image->angle})) settled.insert(std::move(route));
      }
      if (straight || (request_.route && !found_.shots.empty())) return;
    }
  }

  /// Straight at the ghost, and from before it.
  bool may_hit(const Leg& leg, double angle) const {
    return request_.spin.masse != 0 || dot(direction(angle), direction(leg.launch().angle)) >= least_cosine;
  }

  /// At any arrival speed.
  bool is_settled(const Leg& leg) const {
    if (!hit_straight(request_, chain_)) return false;
    const Vec2d way = last_.at_rest.at - request_.puzzle().ball.at;
    return has_candidate(leg, {}) || dot(way, direction(leg.launch().angle)) < least_settled * norm(way);
  }

  /// Of another arrival speed, or found just now.
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

  /// Where the ball before the last is when it sends that along n.
  Vec2d ghost(const Vec2d& n) const {
    return last_.at_rest.at - n * touching_distance(body_before(), last_.at_rest.body);
  }
  const Body& body_before() const { return by_ ? by_->at_rest.body : request_.puzzle().ball.body; }

  /// The normal speed that gives the last ball a speed.
  double normal_speed(double speed) const {
    const double m1 = body_before().mass, m2 = last_.at_rest.body.mass;
    return speed * (m1 + m2) / ((1 + collisions(request_.puzzle().physics).restitution) * m1);
  }

  /// By a route through the ghost, from a launch near it: corrected, and from there the root of the whole.
  bool join(const Leg& leg, const Route& route, Launch seed) {
    double turn = 0, asked = normal_speed(leg.launch().speed);
    for (int i = 0; i < settings::most_steps; ++i) {
      const Vec2d n = direction(leg.launch().angle + turn);
      const SearchRequest& own = to_ghost_.at(ghost(n), asked);
      const Branch aim{own, route, own.problem->aim_points.front()};
      const auto root = newton(aim, budget_, seed, settings::wide);
      if (!root) return false;
      seed = root.launch;
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
      certify_root(aim, budget_, found_, root.launch, word::unfold);
      return true;
    }
    return false;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  const Objects::Chain& chain_;
  const Objects::Object& last_;
  const Objects::Object* by_;  ///< the ball before the last; null: the struck one
  ToPlace to_ghost_;
};

}  // namespace

void chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  KnownLegs none;
  chains_again(request, budget, found, none);
}

void chains_again(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, KnownLegs& known) {
  for (const Objects::Chain& chain : request.problem->objects->chains)
    if (!is_hidden(request, chain)) Chains(request, budget, found, chain).run(known[&chain]);
}

}  // namespace bankshot::planning::propose
