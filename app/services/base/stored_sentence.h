// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/core/text.h"

namespace torsio {

/// Serialises a sentence with its arguments for the record, so that each reader gets it in their own
/// language. Empty for an empty one.
[[nodiscard]] std::string storedSentence(const Text& text);
/// Parses a stored sentence; empty if invalid.
[[nodiscard]] Text readSentence(const std::string& stored);

}  // namespace torsio
