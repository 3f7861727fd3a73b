// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio::gui::testing {

/// First argument that makes the test program one of these places.
inline constexpr const char* kBeAPlace = "--be-a-place";

/// Runs free practice ("practice") or a graded run ("graded") in a window with the fake library, in real
/// time, until the fake's story is over or `seconds` have passed; then closes the window. Prints a JSON
/// object: `words` shown, `longest_ms` for which the window was unresponsive, `closed_ms` that closing took.
/// Returns the exit code.
int beAPlace(const std::string& place, const std::string& library, double seconds);

}  // namespace torsio::gui::testing
