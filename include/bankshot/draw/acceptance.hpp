// SPDX-License-Identifier: MIT
//
// The acceptance window of a pocket: angle across, offset upwards, the lines that lead in coloured by how.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/simulate/acceptance.hpp"

namespace bankshot {

/// One window below the other, a speed each, with the pocket's exact line (geometry/opening.hpp) in all of them.
std::string draw(const Scene& scene, int pocket, std::span<const Acceptance> windows, Theme theme = Theme::light);

}  // namespace bankshot
