// SPDX-License-Identifier: MIT
//
// The program's 50-digit arithmetic, under the namespace that the tests use.
#pragma once

#include "truth/condition.hpp"

namespace bankshot::test {
using namespace bankshot::truth;
}
