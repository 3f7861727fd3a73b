// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/core/text.h"

namespace torsio {

/// Progress of a long operation.
struct Progress {
  Text step;                  ///< "Recording G1-03"
  double fraction = 0.0;      ///< of all work, 0..1
  double remaining_s = -1.0;  ///< estimate; negative while unknown
};

/// Called from the working thread, at most a few times a second.
using ProgressCallback = std::function<void(const Progress&)>;

/// Reports progress; does nothing without a callback.
inline void tellProgress(const ProgressCallback& progress, const Text& step, double fraction) {
  if (progress) {
    progress({step, fraction, -1.0});
  }
}

/// Maps progress 0..1 of a step to `from` .. `to` of the whole.
[[nodiscard]] inline ProgressCallback partOf(const ProgressCallback& whole, double from, double to) {
  if (!whole) {
    return {};
  }
  return [whole, from, to](const Progress& part) {
    whole({part.step, from + (to - from) * part.fraction, -1.0});
  };
}

}  // namespace torsio
