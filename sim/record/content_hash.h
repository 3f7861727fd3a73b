// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/record/trial.h"

namespace torsio {

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
