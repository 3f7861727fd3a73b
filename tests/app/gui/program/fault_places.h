// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio::gui::testing {

/// First argument of the test program when it is to be one of these places and no test.
inline constexpr const char* kBeAPlace = "--be-a-place";

/// Runs free practice ("practice") or a graded run ("graded") of a window with the fake library as a person
/// would see it, in real time, until the fake's story is over or `seconds` have passed; then closes the
/// window. Prints one JSON object: `words` that were shown, `longest_ms` for which the window did not answer,
/// `closed_ms` that closing it took. Returns the exit code.
int beAPlace(const std::string& place, const std::string& library, double seconds);

}  // namespace torsio::gui::testing
