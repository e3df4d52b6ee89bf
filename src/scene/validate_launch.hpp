// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/ball.hpp"

namespace bankshot {

/// What `validate` checks of a shot beside its scene. Throws InvalidInput.
void validate(const Launch& launch, const LaunchSpin& spin);

}  // namespace bankshot
