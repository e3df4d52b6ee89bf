// SPDX-License-Identifier: MIT
//
// Style options of pictures.
#pragma once

namespace bankshot {

enum class Theme { light, dark };  ///< `light` suits paper, `dark` suits dark screens

struct PictureStyle {
  Theme theme = Theme::light;
  bool words = true;    ///< draw a caption and the tip position below the table; otherwise only the table
  bool moving = false;  ///< animate the balls of the shot, or of the best one; paths are drawn as well
};

}  // namespace bankshot
