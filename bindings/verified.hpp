// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

namespace bankshot::bindings {

/// Checks every claim of an answer against a replay in 50 digits. Returns whether all hold, and a JSON report of those
/// that do not: {"holds": false, "checked": 14, "failed": [{"shot", "claim", "off", "allowed", "what"}]}. Throws
/// InvalidInput.
std::pair<bool, std::string> verified(const std::string& puzzle, const std::string& answer);

}  // namespace bankshot::bindings
