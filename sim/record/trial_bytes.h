// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/record/trial.h"

namespace torsio {

/// Writes header, chunk and summary as bytes: little-endian numbers, doubles by their bit pattern, texts
/// with their length before them. The same value gives the same bytes on every machine, so that they can be
/// hashed.
[[nodiscard]] std::vector<std::byte> toBytes(const TrialHeader& header);
[[nodiscard]] std::vector<std::byte> toBytes(const TrialChunk& chunk);
[[nodiscard]] std::vector<std::byte> toBytes(const TrialSummary& summary);

/// Read header, chunk and summary from the bytes of toBytes. Throw Error{kBadData} for bytes that toBytes
/// cannot have made.
[[nodiscard]] TrialHeader headerFromBytes(std::span<const std::byte> bytes);
[[nodiscard]] TrialChunk chunkFromBytes(std::span<const std::byte> bytes);
[[nodiscard]] TrialSummary summaryFromBytes(std::span<const std::byte> bytes);

}  // namespace torsio
