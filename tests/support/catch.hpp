// SPDX-License-Identifier: MIT
//
// The only file that depends on the version of Catch2: versions 2 and 3 have different headers.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
