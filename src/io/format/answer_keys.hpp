// SPDX-License-Identifier: MIT
//
// The objects of an answer, key by key (format/key.hpp explains the rows). A key that is always present is `required`.
#pragma once

#include "io/format/key.hpp"
#include "io/format/scene_keys.hpp"

namespace bankshot::format {

inline constexpr std::string_view statuses[] = {"solved", "no-shot", "budget", "invalid"};

inline constexpr Key answer_spin_keys[] = {
    {"top", "number", "natural roll", required, "0.5",
     "1 in `ideal` and `rolling`, where the ball rolls from the start"},
    {"side", "number", "natural roll", required, "-0.3", "positive is right-hand"},
    {"masse", "number", "natural roll", "0", "0.2", "positive curves to the right"},
};
inline constexpr Object answer_spin{"answer_spin", "Spin at launch, each ω R / v.", answer_spin_keys};

inline constexpr Key tip_keys[] = {
    {"right", "number", "m", required, "-0.0034", "of the ball's centre, as the player sees it"},
    {"up", "number", "m", required, "0.0057", "over the centre; 2/5 R for natural roll"},
};
inline constexpr Object tip{"tip", "Where the cue meets the ball.", tip_keys};

inline constexpr Key arrival_keys[] = {
    {"time", "number", "s", required, "2.31", "since the launch", at_least(0)},
    {"speed", "number", "m/s", required, "0.5", "0 where it rests", at_least(0)},
    {"at", "point", "m", required, "[2.5, 1.24]", "the centre of the ball"},
};
inline constexpr Object arrival{"arrival", "When, how fast and where the ball is at its target.", arrival_keys};

inline constexpr Key margin_keys[] = {
    {"angle", "sides", "degrees", required, "[-0.41, 0.38]", "less and more; null where nothing breaks it within 180"},
    {"speed", "sides", "m/s", required, "[-0.22, null]", "less and more; null where nothing breaks it within 30"},
};
inline constexpr Object margin{"margin", "How far one number may move, the other held, with the shot still made.",
                               margin_keys};

inline constexpr Key hit_keys[] = {
    {"ball", "string", "", required, R"("8")", "the ball that is hit"},
    {"cut", "number", "degrees", required, "30", "from the line of travel to the line of centres, anticlockwise",
     between(-90, 90)},
    {"speed", "number", "m/s", required, "0.5", "of the ball that hits, just before", at_least(0)},
    {"at", "point", "m", required, "[1.85, 0.61]", "the centre of the ball that hits"},
};
inline constexpr Object hit{"hit", "A contact of two balls.", hit_keys};

inline constexpr Key contact_keys[] = {
    {"fullness", "number", "", required, "0.5",
     "how much of the object ball is covered: 1 is full, 0.5 a half-ball hit"},
    {"ghost", "point", "m", required, "[1.85, 0.61]", "the centre of the cue ball as they touch: the ghost ball"},
};
inline constexpr Object contact{"contact", "How the cue ball hits the object ball.", contact_keys};

inline constexpr Key spread_keys[] = {
    {"at", "point", "m", required, "[1.87, 0.6]", "the mean of these places"},
    {"sigma", "pair", "m", required, "[0.14, 0.03]", "standard deviations along two axes, the larger first",
     at_least(0)},
    {"angle", "number", "degrees", required, "31", "of the first axis, anticlockwise from +x", between(0, 180)},
};
inline constexpr Object spread{"spread", "Where the cue ball stops in plays that make the target.", spread_keys};

inline constexpr Key next_ball_keys[] = {
    {"ball", "string", "", required, R"("2")", "its id"},
    {"pocket", "string", "", required, R"("top-left")", "of its best straight pot"},
    {"success", "number", "", required, "0.88", "of that pot, to an estimate by geometry", between(0, 1)},
};
inline constexpr Object next_ball{"next_ball", "The next ball, from where the cue ball stops.", next_ball_keys};

inline constexpr Key shot_leave_keys[] = {
    {"at", "point", "m", required, "[1.88, 0.61]", "where the cue ball comes to rest"},
    {"miss", "number", "m", required, "0.02",
     "how far that is from the place asked for; 0 inside a region, and where no place is asked for", at_least(0)},
    {"success", "number", "", required, "0.41",
     "probability that the target is made and the cue ball stops as asked; with `for` it includes the pot of that ball",
     between(0, 1)},
    {"cushions", "[string]", "", required, R"(["right"])",
     "bounces of the cue ball after its last contact with a ball"},
    {"spread", "{spread}", "", "if hardly a play makes the target",
     R"({"at": [1.87, 0.6], "sigma": [0.14, 0.03], "angle": 31})", "how far the player's errors spread the cue ball"},
    {"next", "{next_ball}", "", "without `for`, or where none can be potted",
     R"({"ball": "2", "pocket": "top-left", "success": 0.88})", "the best pot from there"},
};
inline constexpr Object shot_leave{"shot_leave", "The leave of the cue ball.", shot_leave_keys};

inline constexpr std::string_view answer_aims[] = {"safest"};

inline constexpr Key sent_keys[] = {
    {"ball", "string", "", required, R"("8")", "its id"},
    {"cushions", "[string]", "", required, R"(["bottom"])", "its bounces in order"},
    {"pocket", "string", "", "of a shot into a pocket", R"("top-right")", "the name of the pocket that takes it"},
    {"then", "{sent}", "", "of a combination", R"({"ball": "5", "cushions": [], "pocket": "top-right"})",
     "the next ball of the combination"},
};
inline constexpr Object sent{"sent", "What an object ball does.", sent_keys};

inline constexpr Key answer_shot_keys[] = {
    {"speed", "number", "m/s", required, "2.1", "of the launch", at_least(0)},
    {"angle", "number", "degrees", required, "312.4", "of the aim, anticlockwise from +x", between(0, 360)},
    {"spin", "{answer_spin}", "", required, R"({"top": 0, "side": 0})", "at launch"},
    {"tip", "{tip}", "", required, R"({"right": 0, "up": 0})", "where the cue meets the ball"},
    {"cushions", "[string]", "", required, R"(["bottom", "right"])", "the bounces in order"},
    {"miss", "number", "m", required, "3.1e-13", "how far the replay passes from the point or exact line", at_least(0)},
    {"arrival", "{arrival}", "", required, R"({"time": 2.31, "speed": 0.5, "at": [2.5, 1.24]})", "at the target"},
    {"pocket", "string", "", "of a shot into a pocket", R"("top-right")", "the name of the pocket that it reaches"},
    {"offset", "number", "m", "0", "-0.0124",
     "how far the line of travel passes beside the pocket's centre, positive on its left"},
    {"hits", "[{hit}]", "", "none", R"([{"ball": "8", "cut": 30, "speed": 0.5, "at": [1.85, 0.61]}])",
     "contacts with other balls in order, up to the target"},
    {"then", "{sent}", "", "none", R"({"ball": "8", "cushions": ["bottom"], "pocket": "top-right"})",
     "what the object ball does"},
    {"contact", "{contact}", "", "of a shot that hits a ball", R"({"fullness": 0.5, "ghost": [1.85, 0.61]})",
     "the first contact with a ball"},
    {"scratch", "boolean", "", "false", "true", "the cue ball falls into a pocket afterwards"},
    {"cue_rests", "point | string", "m", "without other balls, or where it never rests", "[1.12, 0.4]",
     "where the cue ball comes to rest after the shot, or the name of the pocket that it falls into"},
    {"leave", "{shot_leave}", "", "without `leave` in the puzzle",
     R"({"at": [1.88, 0.61], "miss": 0.02, "success": 0.41, "cushions": ["right"]})",
     "how the cue ball is left, as the puzzle asks"},
    {"safety", "boolean", "", "false", "true", "of a game: it pots no ball, and leaves the opponent little"},
    {"rattles", "boolean", "", "false", "true", "it touches the jaws of a pocket on its way"},
    {"aim",
     "word",
     "",
     "of a shot that was moved",
     R"("safest")",
     "it was moved off the exact line or point, to a larger value",
     {},
     answer_aims},
    {"off_centre", "boolean", "", "false", "true", "it is made, but beside the exact line or point"},
    {"condition", "number", "m/rad", required, "41",
     "how far the arrival moves for a radian of aim, or for a relative change of speed", at_least(0)},
    {"digits", "whole", "", "9 or more", "6",
     "decimal digits of `at`, of the table's diagonal, and of the speed there, that can be promised", between(0, 9)},
    {"margin", "{margin}", "", "left out with --no-robustness", R"({"angle": [-0.41, 0.38], "speed": [-0.22, null]})",
     "how much may be wrong"},
    {"success", "number", "", "left out with --no-robustness", "0.87",
     "probability that the target is made, and the cue ball does not fall, under `noise`", between(0, 1)},
    {"value", "number", "", "left out with --no-robustness", "0.85",
     "success - 0.005 contacts with cushions and jaws - 0.004 speed - 0.02 tip's distance from the centre / radius"},
    {"sensitivity", "<number>", "m per unit", "with --sensitivity", R"({"cushion.height": 14.1})",
     "how far the arrival moves for each coefficient of the table, by its path in `physics`; `tilt.x` and `tilt.y` are "
     "the table's"},
    {"path", "[place]", "s, m, m", "with --path", "[[0, 0.635, 0.4], [0.0167, 0.66, 0.37]]",
     "[t, x, y] 60 times a second and at every event"},
    {"paths", "<[place]>", "s, m, m", "with --path, where other balls move",
     R"({"8": [[0.71, 1.6, 0.7], [0.73, 1.62, 0.71]]})", "paths of the other balls that move"},
    {"planner", "string", "", required, R"("unfold")",
     "how it was found: unfold, partition, continuation, relaxed, global, or the planner that was asked for"},
    {"simulations", "whole", "", required, "9", "spent until it was verified", at_least(0)},
    {"why", "string", "", "of `nearest` alone", R"("ends 0.2 m short")", "what is wrong with a miss"},
};
inline constexpr Object answer_shot{"answer_shot", "What to do, with its evidence.", answer_shot_keys};

inline constexpr Key placed_keys[] = {
    {"at", "point", "m", required, "[0.4, 0.7]", "its centre"},
};
inline constexpr Object placed{"placed", "The place of a cue ball in hand.", placed_keys};

inline constexpr Key planned_keys[] = {
    {"ball", "string", "", required, R"("2")", "that is potted"},
    {"pocket", "string", "", required, R"("top-right")", "into which it falls"},
    {"from", "point", "m", required, "[1.88, 0.61]", "where the shot before it leaves the cue ball"},
    {"speed", "number", "m/s", required, "1.2", "of the launch", at_least(0)},
    {"angle", "number", "degrees", required, "41", "of the aim, anticlockwise from +x", between(0, 360)},
    {"spin", "{answer_spin}", "", required, R"({"top": 0, "side": 0})", "at launch"},
    {"cue_rests", "point", "m", "where the cue ball falls", "[0.7, 0.9]", "where the cue ball comes to rest"},
    {"success", "number", "", "left out with --no-robustness", "0.91", "probability of the pot", between(0, 1)},
};
inline constexpr Object planned{"planned", "A shot that is planned after the first; it is made from that place.",
                                planned_keys};

inline constexpr Key plan_keys[] = {
    {"next", "[{planned}]", "", required, "[]", "the shots after the first, in order"},
    {"clears", "[number]", "", required, "[0.93, 0.81, 0.7]",
     "probability to pot the first ball, the first two, and so on, in one visit: an estimate along the planned shots",
     between(0, 1)},
    {"table", "boolean", "", required, "false", "the last of `clears` clears the table"},
    {"why", "string", "", "nothing to say",
     R"("the likeliest pot goes in 97 % of plays and the next ball too in 41 %; with this shot both go in 88 %")",
     "why this shot and not the likeliest pot"},
};
inline constexpr Object plan{"plan", "What is planned after the best shot of a game.", plan_keys};

inline constexpr Key error_keys[] = {
    {"path", "string", "", required, R"("/ball/at/0")",
     "the place in the puzzle, a JSON pointer; empty for the whole text"},
    {"reason", "string", "", required, R"("\"a\" must be a number")", "the rule, in words"},
};
inline constexpr Object error{"error", "What is wrong with a puzzle.", error_keys};

inline constexpr Text modelled_example{R"(["sliding", "rolling", ")", usual_cushion, R"(", "pockets"])"};
inline constexpr Key answer_keys[] = {
    {"id", "string | number", "", "none", R"("two-rail-1")", "the puzzle's"},
    {"status",
     "word",
     "",
     required,
     R"("solved")",
     "`no-shot`: certified, or searched as `message` says; `budget`: the search ended too soon",
     {},
     statuses},
    {"shots", "[{answer_shot}]", "", required, "[]", "best first; all of them with --all"},
    {"nearest", "{answer_shot} | null", "", required, "null", "the closest miss of a `no-shot`"},
    {"ball", "{placed}", "", "where the cue ball is not in hand", R"({"at": [0.4, 0.7]})", "where to put the cue ball"},
    {"plan", "{plan}", "", "without a game as target, and with --depth 0",
     R"({"next": [], "clears": [0.93], "table": true})", "what is planned after the best shot"},
    {"modelled", "[string]", "", "not of `invalid`", modelled_example, "what the simulation holds"},
    {"simulations", "whole", "", "not of `invalid`", "31", "spent on the search and on replays", at_least(0)},
    {"time_us", "number", "µs", "left out with --no-timing", "14.2", "of the search, without margin and success",
     at_least(0)},
    {"settled", "<point>", "m", "without `settle`", R"({"8": [-1.2e-5, 0]})",
     "by how much balls were moved apart before the search"},
    {"error", "{error}", "", "of `invalid` alone", R"({"path": "/table", "reason": "this key is required"})",
     "what is wrong with the puzzle"},
    {"message", "string", "", required, R"("made by bottom, right")", "one sentence for a person"},
    {"about", "any", "", "none", R"({"title": "The long bank"})", "the puzzle's"},
};
inline constexpr Object answer{"answer", "What `solve --json` prints, and `batch` prints for each line.", answer_keys};

}  // namespace bankshot::format
