// SPDX-License-Identifier: MIT
//
// The one place that knows which Catch2 this is: version 2 has one header, version 3 another.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
