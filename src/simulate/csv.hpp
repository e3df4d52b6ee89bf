// SPDX-License-Identifier: MIT
//
// The rows of a path as CSV, for whoever writes one.
#pragma once

#include <string>
#include <string_view>

#include "bankshot/motion/arc.hpp"

namespace bankshot {

inline constexpr std::string_view csv_header = "t,ball,x,y,vx,vy,wx,wy,wz";

/// Without a line break.
std::string csv_row(double time, std::string_view ball, const State<double>& state);

/// A name as a field: in quotes where it needs them (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace bankshot
