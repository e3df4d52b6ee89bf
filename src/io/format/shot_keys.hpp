// SPDX-License-Identifier: MIT
//
// The objects of a shot for `simulate`, key by key (format/key.hpp explains the rows).
#pragma once

#include "io/format/answer_keys.hpp"
#include "io/format/puzzle_keys.hpp"

namespace bankshot::format {

inline constexpr Key launch_spin_keys[] = {
    {"top", "number", "natural roll", "0", "1", "as in a ball"},
    {"side", "number", "natural roll", "0", "-0.3", "as in a ball"},
    {"masse", "number", "natural roll", "0", "0.2", "as in a ball"},
};
inline constexpr Object launch_spin{"launch_spin", "Spin at launch, each ω R / v.", launch_spin_keys};

inline constexpr Key launch_keys[] = {
    {"speed", "number", "m/s", required, "2.1", "", at_least(0)},
    {"angle", "number", "degrees", required, "312.4", "anticlockwise from +x"},
    {"spin", "{launch_spin}", "", "the ball's", R"({"side": 0.5})", "takes precedence over the ball's"},
};
inline constexpr Object launch{
    "launch", "How the ball leaves. The other keys of an answer's shot may stand here and are not read.", launch_keys,
    answer_shot_keys};

inline constexpr Key until_keys[] = {
    {"time", "number", "s", "none", "2.5", "", at_least(0)},
    {"cushions", "whole", "", "none; 100 in `ideal`", "3", "bounces", between(1, 1000000)},
    {"length", "number", "m", "none", "4", "of the path", at_least(0)},
};
inline constexpr Object until{"until", "When the simulation stops; without it, where the ball rests or falls.",
                              until_keys};

inline constexpr auto shot_keys = with_scene_keys({
    {"shot", "{launch}", "", required, R"({"speed": 2.1, "angle": 312.4})", "how the ball leaves"},
    {"until", "{until}", "", "the end", R"({"cushions": 3})", "when the simulation stops"},
});
inline constexpr Object shot{"shot",
                             "The input of `simulate`. The other keys of a puzzle may stand here too and are not read.",
                             shot_keys, puzzle_keys};

}  // namespace bankshot::format
