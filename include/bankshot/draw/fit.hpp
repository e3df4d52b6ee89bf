// SPDX-License-Identifier: MIT
//
// What a fit found, on a page: of each shot the path on the table with the places where the ball was seen, and how far
// these lie from it over time.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/learn/fit.hpp"

namespace bankshot {

/// `recordings`: the first of those that were fitted, or all of them.
std::string draw(std::span<const Recording> recordings, const Fit& fit, const PictureStyle& style = {});

}  // namespace bankshot
