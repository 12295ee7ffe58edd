// SPDX-License-Identifier: GPL-3.0-or-later
// The Catch2 header of the version that was found: tests include this one.
#pragma once

#if RIGOR_CATCH_VERSION >= 3
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif
