// SPDX-License-Identifier: MIT
//
// Finds the objects of the format by name.
#pragma once

#include <string_view>
#include <vector>

#include "io/format/key.hpp"

namespace bankshot::format {

/// Splits a type into its alternatives.
std::vector<std::string_view> alternatives(std::string_view type);

/// Returns a document and all objects that it may contain, each once, in the order of their first use.
std::vector<const Object*> objects_of(std::string_view document);

}  // namespace bankshot::format
