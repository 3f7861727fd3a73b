// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

/// Returns the name nearest to a misspelt word; empty: none is near.
[[nodiscard]] std::string nearestOf(const std::vector<std::string>& names, const std::string& word);

/// Joins words with commas: "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace torsio
