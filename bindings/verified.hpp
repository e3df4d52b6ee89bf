// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

namespace bankshot::bindings {

/// Whether every claim of an answer holds against a replay in 50 digits, and the same as JSON with what does not:
/// {"holds": false, "checked": 14, "failed": [{"shot", "claim", "off", "allowed", "what"}]}. Throws InvalidInput.
std::pair<bool, std::string> verified(const std::string& puzzle, const std::string& answer);

}  // namespace bankshot::bindings
