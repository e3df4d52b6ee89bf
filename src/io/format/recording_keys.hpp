// SPDX-License-Identifier: MIT
//
// The objects of a recording for `fit`, key by key (format/key.hpp explains the rows).
#pragma once

#include "io/format/shot_keys.hpp"

namespace bankshot::format {

inline constexpr auto recording_keys = with_scene_keys({
    {"track", "<[place]>", "s, m", "none", R"({"cue": [[0, 0.5, 0.6], [0.02, 0.54, 0.61]]})",
     "[t, x, y] of balls by their names: increasing seconds from any zero, and centres; gaps are allowed"},
    {"rest", "<point>", "m", "not seen", R"({"cue": [1.9, 0.4]})", "where balls came to rest"},
    {"sigma", "number", "m", "estimated", "0.002", "standard deviation of one coordinate of one sample", positive},
    {"cushions", "[string]", "", "found by the fit", R"(["top", "right"])",
     "cushions that the cue ball was seen to meet, in order"},
    {"shot", "{launch}", "", "found by the fit", R"({"speed": 2.1, "angle": 312.4})",
     "the launch as far as it is known, where a fit starts; for `advise`, the launch that was meant"},
    {"puzzle", "{puzzle}", "", "none",
     R"({"table": "pool-9ft", "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "any"}})",
     "for `advise`: what was meant, if the meant launch is not known"},
    {"made", "boolean", "", "none", "true", "for `advise`: whether the puzzle's target was made"},
});
inline constexpr Object recording{"recording",
                                  "What was seen of one real shot: the input of `fit` and `advise`, one per line. It "
                                  "needs `track`, `rest` or both; for `advise`, `made` with a `puzzle` suffices.",
                                  recording_keys};

}  // namespace bankshot::format
