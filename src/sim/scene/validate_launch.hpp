// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/ball.hpp"

namespace bankshot {

/// Checks the launch of a shot, which `validate` does in addition to its scene. Throws InvalidInput.
void validate(const Launch& launch, const LaunchSpin& spin);

}  // namespace bankshot
