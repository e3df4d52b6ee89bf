// SPDX-License-Identifier: MIT
//
// The objects of a puzzle, key by key (format/key.hpp explains the rows).
#pragma once

#include <algorithm>
#include <array>

#include "bankshot/scene/puzzle.hpp"
#include "io/format/scene_keys.hpp"

namespace bankshot::format {

inline constexpr std::string_view preferences[] = {"robust", "soft", "quick"};
inline constexpr std::string_view aims[] = {"centre", "safest"};

inline constexpr Key point_keys[] = {
    {"point", "point", "m", required, "[1.9, 0.635]",
     "where the ball's centre is to pass or, when it arrives at speed 0, to rest"},
    {"within", "number", "m", "0.01", "0.05", "how far off still counts as made, in `margin` and `success`", positive},
};
inline constexpr Object to_point{"to_point", "Pass over a point, or stop on it.", point_keys};

inline constexpr Key to_pocket_keys[] = {
    {"pocket", "string", "", required, R"("top-right")", "a pocket of the table, or `any`"},
};
inline constexpr Object to_pocket{"to_pocket", "Fall into a pocket.", to_pocket_keys};

inline constexpr Key count_keys[] = {
    {"min", "whole", "", "0", "1", "", between(0, max_cushions)},
    {"max", "whole", "", "3, or min where that is more", "3", "", between(0, max_cushions)},
};
inline constexpr Object count{"count", "A number of cushions, from `min` to `max`.", count_keys};

inline constexpr Key then_cushions_key{"cushions",
                                       "whole | [string] | {count}",
                                       "",
                                       "0, and for a pocket `success` counts every fall",
                                       "1",
                                       "bounces of that ball: how many, which in order, or from `min` to `max`",
                                       between(0, max_cushions)};
inline constexpr Key then_point_keys[] = {point_keys[0], point_keys[1], then_cushions_key};
inline constexpr Object then_point{"then_point", "The object ball passes over a point, or stops on it.",
                                   then_point_keys};
inline constexpr Key then_pocket_keys[] = {to_pocket_keys[0], then_cushions_key};
inline constexpr Object then_pocket{"then_pocket", "The object ball falls into a pocket.", then_pocket_keys};
inline constexpr Key then_ball_keys[] = {
    {"ball", "string", "", required, R"("5")", "the next ball by its id"},
    {"cushions", "whole | [string] | {count}", "", "0", "1", "bounces of the ball that hits it",
     between(0, max_cushions)},
    {"then", "{then_point} | {then_pocket} | {then_ball}", "", required, R"({"pocket": "top-right"})",
     "where that ball is to go"},
};
inline constexpr Object then_ball{"then_ball", "A combination: the object ball hits another ball.", then_ball_keys};

inline constexpr Key to_ball_keys[] = {
    {"ball", "string | [string]", "", required, R"("8")",
     "a ball by its id, some of them, or `any`: the first that the cue ball touches"},
    {"cut", "number", "degrees", "any", "30",
     "from the line of travel to the line of centres; above 0, the object ball leaves to the left", between(-90, 90)},
    {"within", "number", "degrees", "5 with `cut`, else any", "2",
     "how far off the cut, or off a full hit, still counts as made", positive},
    {"pocket", "string", "", "none", R"("top-right")", R"(short for `"then": {"pocket": …}`)"},
    {"then", "{then_point} | {then_pocket} | {then_ball}", "", "none", R"({"pocket": "top-right"})",
     "where that ball is to go; instead of `cut` and `within`"},
};
inline constexpr Object to_ball{"to_ball", "Touch another ball.", to_ball_keys};

inline constexpr std::string_view carom_orders[] = {"given", "any"};
inline constexpr Key carom_keys[] = {
    {"carom", "[string]", "", required, R"(["red", "yellow"])",
     "two balls by their ids: the cue ball touches the first and then the second; `cushions` counts all that it "
     "meets before the second"},
    {"cut", "number", "degrees", "any", "30", "at the second ball; measured as with one ball", between(-90, 90)},
    {"within", "number", "degrees", "5 with `cut`, else any", "2", "how far off the cut still counts as made",
     positive},
    {"order",
     "word",
     "",
     R"("given")",
     R"("any")",
     "`any`: the two balls may be touched in either order",
     {},
     carom_orders},
};
inline constexpr Object carom{"carom", "Touch one ball and then another.", carom_keys};

inline constexpr std::string_view games[] = {"rotation", "any", "eight", "list"};
inline constexpr std::string_view groups[] = {"solids", "stripes"};
inline constexpr Key game_keys[] = {
    {"game",
     "word",
     "",
     required,
     R"("rotation")",
     "which ball may be potted next: the lowest, any, one of the own group and then the 8, or as `order` says",
     {},
     games},
    {"group",
     "word",
     "",
     "needed by `eight` alone",
     R"("solids")",
     "the player's own: balls 1 to 7, or 9 to 15",
     {},
     groups},
    {"order", "string | [string | [string]]", "", "needed by `list` alone", R"(["3", ["1", "2"]])",
     "balls one after the other, each once; of a list in the list all balls, in any order, before the next"},
};
inline constexpr Object game{
    "game", "What should I play? Pot a ball that the game allows, and leave the cue ball for the next.", game_keys};

inline constexpr Key arrive_keys[] = {
    {"speed", "range", "m/s", required, "1.5", "at the target; 0 rests there", at_least(0)},
};
inline constexpr Object arrive{"arrive", "The ball's speed at its target.", arrive_keys};

inline constexpr std::string_view player_names[] = {"pro", "league", "beginner"};
inline constexpr Key noise_keys[] = {
    {"player",
     "word",
     "",
     "none",
     R"("league")",
     "whose errors stand in for those that are not given",
     {},
     player_names},
    {"angle", "number", "degrees", "0.125", "0.3", "of aim", at_least(0)},
    {"speed", "number", "m/s", "0.075", "0.1", "of launch speed", at_least(0)},
    {"speed_share", "number", "", "0.03 without `speed`, else 0", "0.05",
     "of launch speed, as a share of it; with `speed` the root of the sum of their squares", at_least(0)},
    {"tip", "number", "m", "0", "0.001",
     "of each coordinate of the place where the tip meets the ball; only with the physics `spin`", at_least(0)},
    {"side", "number", "natural roll", "0", "0.02", "of side spin; only with the physics `spin`", at_least(0)},
    {"top", "number", "natural roll", "0", "0.02", "of topspin; only with the physics `spin`", at_least(0)},
    {"at", "number", "m", "0", "0.001", "of each coordinate of each ball's place; the aim stays", at_least(0)},
};
inline constexpr Object noise{"noise", "How far a player is off, one standard deviation.", noise_keys};

inline constexpr Key rest_near_keys[] = {
    {"leave", "point", "m", required, "[1.9, 0.6]",
     "where the cue ball should rest; among shots within 0.02 of the best value, the one that leaves it nearest is "
     "best"},
};
inline constexpr Object rest_near{
    "rest_near", "The likeliest shot that also leaves a good position; only with a ball as target.", rest_near_keys};

inline constexpr Key leave_place_keys[] = {
    {"point", "point", "m", required, "[1.9, 0.6]", "where the cue ball should come to rest"},
    {"within", "number", "m", "0.1", "0.05", "how far from there still counts", positive},
};
inline constexpr Object leave_place{"leave_place", "At a point.", leave_place_keys};
inline constexpr Key leave_region_keys[] = {
    {"polygon", "[point]", "m", required, "[[1.2, 0.3], [1.8, 0.3], [1.5, 0.9]]",
     "inside this polygon; its vertices go once around"},
};
inline constexpr Object leave_region{"leave_region", "Inside a polygon.", leave_region_keys};
inline constexpr Key leave_for_keys[] = {
    {"for", "string | [string | [string]]", "", required, R"("2")",
     "where the best pot of the next ball is likely: this one, or of a list the first that is still on the table; a "
     "list in the list allows any of its balls"},
};
inline constexpr Object leave_for{"leave_for", "Good for the next ball.", leave_for_keys};
inline constexpr Key leave_against_keys[] = {
    {"against", "string | [string | [string]]", "", required, R"("2")",
     "where the best pot of the opponent's next ball is unlikely; as in `for`"},
};
inline constexpr Object leave_against{"leave_against", "Bad for the opponent's next ball: a safety.",
                                      leave_against_keys};
inline constexpr Key leave_safe_keys[] = {
    {"safe", "[string]", "", required, R"(["1", "2"])",
     "where none of these balls can be hit directly; a play in which one of them falls does not count"},
};
inline constexpr Object leave_safe{"leave_safe", "A snooker.", leave_safe_keys};

inline constexpr Key budget_keys[] = {
    {"simulations", "whole", "", required, "20000", "at most; 0 is allowed", at_least(0)},
};
inline constexpr Object budget{"budget", "How long to search.", budget_keys};

inline constexpr std::string_view length_units[] = {"m", "cm", "mm", "in", "diamond"};
inline constexpr Key scene_keys[] = {
    {"id", "string | number", "", "none", R"("two-rail-1")", "comes back in the answer"},
    {"about", "any", "", "none", R"({"title": "The long bank", "difficulty": "hard"})",
     "anything; carried to the answer, never interpreted"},
    {"table",
     "word | {preset} | {rectangle} | {polygon}",
     "",
     required,
     R"("pool-9ft")",
     "a table by its name, or your own",
     {},
     table_names},
    {"physics",
     "word | {ideal} | {rolling} | {spin_physics}",
     "",
     R"("spin")",
     R"("rolling")",
     "the laws, by name or with coefficients of your own",
     {},
     physics_names},
    {"ball", "{ball}", "", required, R"({"at": [0.635, 0.4]})", "the cue ball"},
    {"others", "[{other}]", "", "[]", R"([{"id": "8", "at": [1.9, 0.635]}])", "balls at rest"},
    {"settle", "boolean", "", "false", "true",
     "first move balls apart that overlap by up to 1e-4 m, the cue ball too; the answer says by how much"},
    {"unit",
     "word",
     "",
     R"("m")",
     R"("diamond")",
     "of positions and lengths of the scene and the target; diamonds count from the lower left corner, 8 along the "
     "length "
     "and 4 along the width, and hold for positions alone",
     {},
     length_units},
};
/// Returns the keys of the scene followed by the document's own. It avoids std::ranges::copy, which libc++ 14 of the
/// WebAssembly engine lacks.
template <std::size_t N>
constexpr auto with_scene_keys(const Key (&own)[N]) {
  std::array<Key, std::size(scene_keys) + N> out{};
  std::copy(std::begin(own), std::end(own), std::copy(std::begin(scene_keys), std::end(scene_keys), out.begin()));
  return out;
}

inline constexpr auto puzzle_keys = with_scene_keys({
    {"target", "{to_point} | {to_pocket} | {to_ball} | {carom} | {game}", "", required, R"({"pocket": "top-right"})",
     "what the ball is to reach"},
    {"cushions", "whole | [string] | {count}", "", R"({"min": 0, "max": 3})", R"(["bottom", "right"])",
     "bounces before the target: how many, which in order, or from `min` to `max`", between(0, max_cushions)},
    {"arrive", "{arrive}", "", "a point: 0; a ball: [0.1, 5], with `cut` 0.5; a carom: [0.2, 5]; a pocket: [0.2, 3]",
     R"({"speed": 0.5})", "speed at the target, in `ideal` of the launch too; not with a launch speed that is fixed"},
    {"speed", "range", "m/s", "[0.1, 10]", "[0.5, 6]", "of the launch; one number fixes it", at_least(0)},
    {"angle", "pair", "degrees", "every aim", "[350, 20]",
     "bounds of the aim, from the first anticlockwise to the second, at most a turn", between(-720, 720)},
    {"prefer",
     "word | {rest_near}",
     "",
     R"("robust")",
     R"("soft")",
     "which shot is best: the one with the largest value, the slowest, or the quickest to arrive",
     {},
     preferences},
    {"aim",
     "word",
     "",
     R"(with `robust` "safest" for pockets and for contacts without `cut`, else "centre")",
     R"("centre")",
     "`centre` is on the exact line or point; `safest` may leave it where that has a larger value",
     {},
     aims},
    {"noise",
     "word | {noise}",
     "",
     R"({"angle": 0.125, "speed": 0.075, "speed_share": 0.03})",
     R"("league")",
     "the player's errors, by name or in numbers",
     {},
     player_names},
    {"leave", "{leave_place} | {leave_region} | {leave_for} | {leave_safe} | {leave_against}", "", "none",
     R"({"point": [1.9, 0.6], "within": 0.1})",
     "where the cue ball should come to rest after the shot; only with a ball as target"},
    {"budget", "{budget}", "", "100000 for each six pairs of a ball and a pocket", R"({"simulations": 20000})",
     "how long to search"},
});
inline constexpr Object puzzle{"puzzle", "The question: the input of `solve`, and one line of the input of `batch`.",
                               puzzle_keys};

inline constexpr auto play_keys = with_scene_keys({
    {"target", "{game}", "", R"({"game": "rotation"})", R"({"game": "eight", "group": "solids"})",
     "the game; the options of `play` come first"},
    puzzle["cushions"],
    puzzle["speed"],
    puzzle["angle"],
    puzzle["aim"],
    puzzle["noise"],
    puzzle["budget"],
});
inline constexpr Object play{"play", "A layout: the input of `play`. With its target it is a puzzle as well.",
                             play_keys};

}  // namespace bankshot::format
