// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/core/text.h"

namespace torsio {

/// How far a long piece of work has come.
struct Progress {
  Text step;                  ///< "Recording G1-03"
  double fraction = 0.0;      ///< of the whole work, 0..1
  double remaining_s = -1.0;  ///< estimate; negative while unknown
};

/// Called from the working thread, at most a few times a second.
using ProgressCallback = std::function<void(const Progress&)>;

/// Tells how far the work is; does nothing without a listener.
inline void tellProgress(const ProgressCallback& progress, const Text& step, double fraction) {
  if (progress) {
    progress({step, fraction, -1.0});
  }
}

/// For a piece of the work that reaches from `from` to `to` of the whole and counts 0..1 itself.
[[nodiscard]] inline ProgressCallback partOf(const ProgressCallback& whole, double from, double to) {
  if (!whole) {
    return {};
  }
  return [whole, from, to](const Progress& part) {
    whole({part.step, from + (to - from) * part.fraction, -1.0});
  };
}

}  // namespace torsio
