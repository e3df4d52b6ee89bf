// SPDX-License-Identifier: MIT
//
// How pictures look.
#pragma once

namespace bankshot {

enum class Theme { light, dark };  ///< for paper and for dark screens

struct PictureStyle {
  Theme theme = Theme::light;
  bool words = true;    ///< a caption and the cue's tip below the table; without, only the table
  bool moving = false;  ///< the balls of the shot, or of the best one, move; paths are drawn all the same
};

}  // namespace bankshot
