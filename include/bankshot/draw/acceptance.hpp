// SPDX-License-Identifier: MIT
//
// Draws the acceptance window of a pocket: the angle runs across, the offset upwards. Lines that lead into the pocket
// are coloured by the way they enter.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/simulate/acceptance.hpp"

namespace bankshot {

/// Draws the windows one below the other, one per speed. Each shows the pocket's exact line (geometry/opening.hpp).
std::string draw(const Scene& scene, int pocket, std::span<const Acceptance> windows, Theme theme = Theme::light);

}  // namespace bankshot
