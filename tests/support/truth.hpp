// SPDX-License-Identifier: MIT
//
// The 50 digits of the program, under the name the tests know them by.
#pragma once

#include "truth/condition.hpp"

namespace bankshot::test {
using namespace bankshot::truth;
}
