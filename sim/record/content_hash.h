// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sim/record/trial.h"

namespace torsio {

/// Writes a TrialHeader, TrialChunk or TrialSummary as bytes: little-endian numbers, doubles by their bit
/// pattern, texts with their length before them. The same value gives the same bytes on every machine, so
/// that they can be hashed.
template <typename Part>
[[nodiscard]] std::vector<std::byte> toBytes(const Part& part);

/// Reads one of them from the bytes of toBytes. Throws Error{kBadData} for bytes that toBytes cannot have
/// made.
template <typename Part>
[[nodiscard]] Part fromBytes(std::span<const std::byte> bytes);

/// The chain that ties a trial together: first a hash over the whole header, then, chunk by chunk, a hash
/// over the link before and both digests of the chunk. Changing, dropping or swapping anything changes its
/// end.
class ContentHash {
 public:
  explicit ContentHash(const TrialHeader& header);
  void add(const TrialChunk& chunk);
  /// Returns the last link, 64 hexadecimal digits.
  [[nodiscard]] const std::string& hex() const noexcept { return link_; }

 private:
  std::string link_;
};

/// Computes the content hash that `trial` should carry in its summary.
[[nodiscard]] std::string contentHash(const Trial& trial);

/// Checks the content hash, every chunk's digest and the sample count. Throws Error{kVerifyFailed} saying
/// what does not fit. A trial that was interrupted before its summary has no content hash and fails.
void verifyContent(const Trial& trial);

}  // namespace torsio
