// SPDX-License-Identifier: MIT
//
// Puzzles and shot requests as data. Units are SI and radians; scene/json.hpp reads the JSON form, which uses degrees.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bankshot/geometry/contact.hpp"
#include "bankshot/numbers/range.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/leave.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/scene/table.hpp"
#include "bankshot/scene/target.hpp"

namespace bankshot {

/// A game, by the order in which it lets balls be potted (scene/game.hpp).
enum class Game {
  rotation,  ///< the lowest number first
  any,       ///< every ball at any time: straight pool
  eight,     ///< the player's own group, then ball 8
  list       ///< an order that is given
};

enum class Prefer { robust, soft, quick };
/// centre: the exact root. safest: may deviate from it to increase the value, as long as the shot counts as made.
enum class Aim { centre, safest };

/// Spins that the planner may choose from, each in units of natural roll (see LaunchSpin).
struct SpinRange {
  Range top{0, 0}, side{0, 0}, masse{0, 0};
};

/// Standard deviations of a player's errors, which are normally distributed and independent.
struct Noise {
  double angle = radians(0.125);  ///< rad; of the aim
  double speed = 0.075;           ///< m/s; of the launch speed
  double side = 0, top = 0;       ///< of the launch spin, in units of LaunchSpin
  double at = 0;                  ///< m; of each coordinate of each ball's position; the aim is unchanged
  double speed_share = 0;         ///< relative to the launch speed
  double tip = 0;                 ///< m; of each coordinate of the point where the tip meets the ball

  /// Returns the standard deviation of the speed [m/s] for this launch speed.
  double speed_at(double launch_speed) const {
    return speed_share > 0 ? std::hypot(speed, speed_share * launch_speed) : speed;
  }
  /// Return the standard deviations of the spin in units of LaunchSpin, including those from the tip position.
  double side_of(double radius) const { return spin_of(side, radius); }
  double top_of(double radius) const { return spin_of(top, radius); }
  /// Returns true if there are errors other than of aim and speed.
  bool in_more() const { return side > 0 || top > 0 || at > 0 || tip > 0; }
  /// Returns true if there are no errors.
  bool none() const { return angle == 0 && speed == 0 && speed_share == 0 && !in_more(); }
  bool operator==(const Noise&) const = default;

 private:
  double spin_of(double own, double radius) const { return tip > 0 ? std::hypot(own, tip / (0.4 * radius)) : own; }
};

/// Ball in hand: where the player may place the cue ball (scene/in_hand.hpp).
struct InHand {
  enum class Where { anywhere, behind_head_string, polygon } where = Where::anywhere;
  std::vector<Vec2d> vertices{};  ///< m; of the region, once around; not read for `anywhere`
};

/// A named player, as the key `noise` of a puzzle may give it.
struct Player {
  std::string_view name;
  Noise noise;
  std::string_view about;   ///< whom the errors describe
  std::string_view source;  ///< source of the numbers
};
/// Returns all players, from best to worst.
std::span<const Player> players();

struct Puzzle {
  std::string id{};     ///< JSON text of the identifier, echoed in the answer; empty without
  std::string about{};  ///< JSON text of the author's `about`, echoed too; empty without
  Table table{};
  Physics physics = rolling_physics();
  Ball ball{};
  std::optional<InHand> in_hand{};  ///< where the planner may place the cue ball; `ball.at` is then any such place
  std::vector<Ball> others{};       ///< other balls, at rest; others[k] is ball k + 1
  LaunchSpin spin{};                ///< launch spin, unless `spin_range` is given
  std::optional<SpinRange> spin_range{};  ///< spins that the planner may choose by `prefer`
  Target target{};
  CushionRule cushions{};
  std::optional<Range> arrive{};  ///< speed at the target [m/s]; the default depends on the target
  Range speed{0.1, 10};           ///< launch speed [m/s]
  std::optional<Range> angle{};   ///< rad, from low anticlockwise to high; high may exceed 2π
  Prefer prefer = Prefer::robust;
  /// m; among the most robust shots, the one whose cue ball rests nearest to this point is preferred. Needs a ball
  /// target.
  std::optional<Vec2d> rest_near{};
  std::optional<Game> game{};        ///< set if the question is what to play; `ask` sets target and leave (game.hpp)
  std::optional<Leave> leave{};      ///< where the cue ball should come to rest; needs a ball target
  std::optional<Aim> aim{};          ///< the default depends on the target: `aim_of`
  Noise noise{.speed_share = 0.03};  ///< the Computer Olympiad's pool noise, which grows with the speed
  std::optional<long> budget{};      ///< evaluation budget; the default depends on the target: `budget_of`
  /// m; displacement of each ball by `settle`, the cue ball first; empty if it was not requested.
  std::vector<Vec2d> settled{};

  /// Returns true if success depends on more than errors of aim and speed.
  bool errs_in_more() const { return noise.in_more() || physics.errors; }
};

/// A `simulate` document: a scene, a launch, and limits at which the simulation ends.
struct ShotRequest {
  std::string id{};
  Table table{};
  Physics physics = rolling_physics();
  Ball ball{};
  std::vector<Ball> others{};  ///< other balls, at rest; others[k] is ball k + 1
  Launch launch{1, 0};
  LaunchSpin spin{};
  struct Until {
    std::optional<double> time{};    ///< s
    std::optional<int> cushions{};   ///< number of bounces
    std::optional<double> length{};  ///< m; along the path
  } until{};
  std::vector<Vec2d> settled{};  ///< m; displacement of each ball by `settle`, as in a puzzle
};

/// Returns the name of a contact: that on the table, or `ball "8"` for a ball.
std::string contact_name(const Puzzle& puzzle, Contact contact);

/// Returns the target as the end of a sentence about a ball: "into top-right", "to rest in the ring", "through the
/// ring", "onto ball "8"".
std::string target_words(const Puzzle& puzzle);

/// Returns the given aim. By default, it is `safest` if `robust` shots are preferred and the target is a pocket (for
/// any ball) or a contact without a cut; otherwise `centre`.
Aim aim_of(const Puzzle& puzzle);

/// Returns the given evaluation budget. By default, it is 100,000 simulations for every six pairs of ball and pocket
/// that the target allows, at least 100,000 and at most 2,000,000.
long budget_of(const Puzzle& puzzle);

/// Returns the speed required at the target; none if any speed is allowed (`ideal` physics, or a fixed launch speed).
std::optional<Range> arrival_range(const Puzzle& puzzle);

/// Returns the constant speed of a ball in `ideal` physics [m/s]: the allowed launch or arrival speed nearest to 1.
double ideal_speed(const Puzzle& puzzle);

/// An exception for input that breaks a rule. `path` is the JSON path of the offending value ("/ball/at/0"), empty for
/// the document itself. `line` is set if the text is not JSON.
class InvalidInput : public std::runtime_error {
 public:
  InvalidInput(std::string where, const std::string& reason, long at_line = 0)
      : std::runtime_error(reason), path(std::move(where)), line(at_line) {}
  std::string path;
  long line;
};

/// Throws InvalidInput if the scene breaks a rule of geometry or range.
void validate(const Puzzle& puzzle);
void validate(const ShotRequest& request);

}  // namespace bankshot
