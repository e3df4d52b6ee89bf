// SPDX-License-Identifier: MIT
//
// Draws the result of a fit on one page. Each shot shows its path on the table with the observed positions, and their
// distances from the path over time.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/learn/fit.hpp"

namespace bankshot {

/// `recordings` holds the fitted recordings, or only the first few of them.
std::string draw(std::span<const Recording> recordings, const Fit& fit, const PictureStyle& style = {});

}  // namespace bankshot
