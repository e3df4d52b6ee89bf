// SPDX-License-Identifier: MIT
//
// A shot: a launch verified by replay in the plain simulator, with its evidence and its robustness.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

struct Arrival {
  double time = 0;   ///< s since the launch
  double speed = 0;  ///< m/s
  Vec2d at{};        ///< centre of the ball [m]
};

/// The changes of aim and of speed, down and up, with which the same cushions still make the shot while the other
/// number is fixed. No value means that no such change breaks the shot.
struct Margin {
  std::array<std::optional<double>, 2> angle;  ///< rad, [<= 0, >= 0]
  std::array<std::optional<double>, 2> speed;  ///< m/s, [<= 0, >= 0]
};

/// The state just before a ball hits another.
struct Hit {
  int ball = 0;      ///< number of the ball that is hit, from 1
  double cut = 0;    ///< rad; see BallTarget
  double speed = 0;  ///< m/s
  Vec2d at{};        ///< centre of the hitting ball [m]
  int after = 0;     ///< number of cushions that the hitting ball had met
};

/// The path of an object ball, or a combination link.
struct ObjectBallPath {
  int ball = 0;                     ///< number of the ball, from 1
  std::vector<Contact> cushions{};  ///< cushions that this ball meets, in order
};

/// The effect of a wrong coefficient of the table.
struct Sensitivity {
  std::string coefficient;  ///< its path in `physics`, such as "cushion.height"; "tilt.x" and "tilt.y" are the table's
  double by;                ///< m that the arrival moves per unit of the coefficient; arrival as in by_angle
};

/// The motion of the balls of a shot, up to the target and after it.
struct ShotPath {
  std::vector<Contact> cushions{};      ///< cushion contacts of the cue ball in order
  Arrival arrival{};                    ///< arrival of the ball that reaches the target
  std::vector<Hit> hits{};              ///< hits in order, up to the target
  std::vector<ObjectBallPath> then{};   ///< object balls in order; the last one arrives. Empty: the cue ball arrives
  bool touches_jaws = false;            ///< it touches the jaws of a pocket (jaw shot)
  std::vector<Contact> met{};           ///< for a jaw shot: jaws and cushions in order
  int jaws = 0;                         ///< jaw contacts of all balls of the shot before the target
  bool cushion_stick = false;           ///< a cushion law left the ball moving into the cushion; it stayed there
  bool scratch = false;                 ///< the cue ball falls into a pocket after it has touched the target ball
  std::optional<int> scratch_pocket{};  ///< the pocket of the scratch
  std::optional<Vec2d> cue_rests{};     ///< m; otherwise where the cue ball rests at the end; for shots with hits

  /// Returns the number of contacts with cushions and jaws of all balls of the shot before the target.
  int contacts() const;
};

/// The spread of the places in which the cue ball comes to rest in plays that make the target: the principal axes of
/// their covariance.
struct Spread {
  Vec2d at{};                     ///< m; their mean
  std::array<double, 2> sigma{};  ///< m; standard deviations along the axes, the larger first
  double angle = 0;               ///< rad; of the first axis, anticlockwise from +x
};

/// The best straight pot of the next ball, to an estimate by geometry.
struct NextBall {
  int ball = 0;        ///< k stands for the k-th of `others`, from 1
  int pocket = 0;      ///< of the table
  double success = 0;  ///< probability of the pot
};

/// The leave of a shot, if the puzzle asks for one.
struct ShotLeave {
  Vec2d at{};                       ///< m; where the cue ball comes to rest
  double miss = 0;                  ///< m; from the place asked for, or from the region; 0 if neither is asked for
  double success = 0;               ///< probability that the target is made and the cue ball stops as asked
  std::vector<Contact> cushions{};  ///< cushions that the cue ball meets after its last contact with a ball
  std::optional<Spread> spread{};   ///< none if fewer than three plays make the target
  std::optional<NextBall> next{};   ///< from where the cue ball stops, if a next ball is asked for and can be potted
};

/// The evidence of the replay: how exactly it makes the target, and how errors of the launch move the arrival.
struct Verification {
  double miss = 0;          ///< m, from the replay: to the point, or from the exact line of a pocket or ball
  double offset = 0;        ///< m; offset of the line of travel into a pocket (geometry/opening.hpp)
  bool off_centre = false;  ///< it is made off the exact line or point
  double condition = 0;     ///< m of arrival per rad of aim or per unit of relative speed; the larger.
  /// Number of guaranteed decimal digits of the arrival, relative to the table's diagonal; none: nine or more. 0:
  /// rounding decides how often the ball bounces at its target.
  std::optional<int> digits{};
  /// Derivatives of the arrival. The arrival is the point of rest, or else the point of the line of travel that is
  /// closest to the target; that point moves only across the line.
  Vec2d by_angle{};  ///< m/rad
  Vec2d by_speed{};  ///< m per m/s
};

/// The success of the shot in the hands of the player, and the errors that it forgives.
struct Robustness {
  /// First-order margin in standard deviations of the player. It ranks shots if success is not computed.
  double first_order = 0;
  double success_estimate = 0;  ///< to first order, from one simulation (planners/evaluate/first_order.hpp)
  std::optional<Margin> margin{};
  std::optional<double> success{};         ///< probability that the shot is made under the puzzle's noise
  std::optional<double> value{};           ///< success minus `cost_of` the shot
  std::vector<Sensitivity> sensitivity{};  ///< filled if it was requested
};

/// The origin of a shot.
struct Provenance {
  std::string planner{};  ///< the step that proposed it
  long simulations = 0;   ///< simulations spent until this shot was verified
  bool moved = false;     ///< it was moved off its exact root to increase the value
};

struct Shot {
  std::optional<Vec2d> placed{};  ///< m; with ball in hand, where the cue ball is placed
  Launch launch{};
  LaunchSpin spin{};
  ShotPath path{};
  Verification verification{};
  Robustness robustness{};
  Provenance provenance{};
  std::optional<ShotLeave> leave{};
  bool safety = false;  ///< of a game: it pots no ball, and leaves the opponent little

  /// Returns the number of the ball that reaches the target; 0 is the cue ball.
  int arriving() const { return path.then.empty() ? 0 : path.then.back().ball; }
};

/// Returns the cost of a shot; its value is success minus this cost. The cost is 0.005 per contact, 0.004 per m/s of
/// the launch, and 0.02 per ball radius of tip offset. A soft and simple shot therefore wins among shots of about equal
/// success.
double cost_of(const Shot& shot);
/// Returns the part of the cost that depends on the launch alone.
double cost_of(const Launch& launch, const LaunchSpin& spin);
/// The part of it for cushions and jaws.
double cost_of_contacts(int contacts);

/// Returns the fullness of a hit: the fraction of the hit ball that the hitting ball covers, seen along its line of
/// travel. A full hit is 1, a half-ball hit 0.5. The value is (a + b − d) / 2b. Here a is the radius of the hitting
/// ball, b that of the hit ball, and d the distance of the line of travel from the hit ball's centre. The argument
/// `by` is the number of the hitting ball; 0 is the cue ball.
double fullness(const Puzzle& puzzle, const Hit& hit, int by = 0);

/// Returns true if the cue may strike the cue ball twice, which the rules forbid: the cue ball nearly touches the first
/// object ball without being frozen to it, and the hit is fairly full.
bool may_double_hit(const Puzzle& puzzle, const Shot& shot);

/// Returns true if the player makes the shot less than once in a hundred tries. Returns false in `ideal` physics, for a
/// player without errors, and if success is not known.
bool is_hopeless(const Puzzle& puzzle, const Shot& shot);

/// Returns warnings for the player, such as a likely miscue or a likely double hit. The list is usually empty.
std::vector<std::string> warnings(const Puzzle& puzzle, const Shot& shot);

/// Returns the puzzle as a shot plays it: if the order of a carom is free, in the order of this shot; if it is a safety
/// of a game, with the target and leave of a safety.
Puzzle as_played(const Puzzle& puzzle, const Shot& shot);

/// Returns the shot as a `simulate` request that ends when the ball reaches its target.
ShotRequest as_request(const Puzzle& puzzle, const Shot& shot);
/// Returns the path of the cue ball up to that moment.
Trajectory path_of(const Puzzle& puzzle, const Shot& shot);

/// Returns the pocket that takes the ball of a made shot; null if no pocket does.
const Pocket* pocket_reached(const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot
