// SPDX-License-Identifier: MIT
//
// Every object of the format, found by its name.
#pragma once

#include <string_view>
#include <vector>

#include "format/key.hpp"

namespace bankshot::format {

/// The types that a key may have, one by one.
std::vector<std::string_view> alternatives(std::string_view type);

/// A document and all that may stand in it, each once, in the order in which one meets them.
std::vector<const Object*> objects_of(std::string_view document);

}  // namespace bankshot::format
