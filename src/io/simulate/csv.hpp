// SPDX-License-Identifier: MIT
//
// Formats the rows of a path as CSV.
#pragma once

#include <string>
#include <string_view>

#include "bankshot/motion/arc.hpp"

namespace bankshot {

inline constexpr std::string_view csv_header = "t,ball,x,y,vx,vy,wx,wy,wz";

/// Returns one row without a line break.
std::string csv_row(double time, std::string_view ball, const State<double>& state);

/// Returns a name as a CSV field, quoted if necessary (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace bankshot
