// SPDX-License-Identifier: MIT
//
// The colours of both themes. On paper, dark lines lie on a pale cloth, as in coaching books; on a dark screen, light
// lines lie on a dark cloth. Most colour-blind readers can distinguish the eight path colours.
#pragma once

#include <array>

#include "bankshot/draw/style.hpp"

namespace bankshot::drawing {

struct Colours {
  const char *page, *ink, *faint;
  const char *wood, *wood_words, *sight, *leather, *cushion, *cushion_words, *cloth, *hole;
  const char *band, *aim, *target, *halo, *ball, *ball_edge;
  std::array<const char*, 8> paths;
  std::array<const char*, 8> pool;  ///< balls 1 to 8; balls 9 to 15 have stripes in the colours 1 to 7
};

inline constexpr Colours light{
    "#ffffff",
    "#1c2530",
    "#66707c",  //
    "#9a6a41",
    "#f3e3cd",
    "#fff8e8",
    "#5d3b20",
    "#2f7f5b",
    "#ffffff",
    "#d3ead9",
    "#161616",  //
    "#2f6fdb",
    "#c2410c",
    "#c81e5b",
    "#ffffff",
    "#ffffff",
    "#1c2530",  //
    {"#0b2545", "#b45309", "#1d4ed8", "#7e22ce", "#0f766e", "#be123c", "#4d5b00", "#57534e"},
    {"#d9a400", "#1d4ed8", "#d02020", "#6d28d9", "#e8710a", "#0b7a3b", "#7f1d1d", "#1a1a1a"}};

inline constexpr Colours dark{"#14171b",
                              "#ece9e2",
                              "#9aa3ad",  //
                              "#3d2a1b",
                              "#b79e80",
                              "#e8d7b0",
                              "#231710",
                              "#0d3b29",
                              "#d8efe2",
                              "#1d5f44",
                              "#040404",  //
                              "#a9d0ff",
                              "#ffb454",
                              "#ff7aa8",
                              "#14171b",
                              "#ffffff",
                              "#04140d",  //
                              {"#ffffff", "#ffb454", "#7cc7ff", "#ff9ec0", "#cdb8ff", "#ffe873", "#93efcd", "#d3d3d3"},
                              {"#f5c518", "#5b8cff", "#ff5a4f", "#a78bfa", "#ff9838", "#3ecf7a", "#c0555b", "#000000"}};

inline const Colours& colours(Theme theme) { return theme == Theme::light ? light : dark; }

}  // namespace bankshot::drawing
