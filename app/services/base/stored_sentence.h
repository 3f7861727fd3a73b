// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/core/text.h"

namespace torsio {

/// A sentence as the record keeps it, with its arguments, so that each reader gets it in their own language.
/// Empty for an empty one.
[[nodiscard]] std::string storedSentence(const Text& text);
/// Reads such a sentence; empty for what is none.
[[nodiscard]] Text readSentence(const std::string& stored);

}  // namespace torsio
