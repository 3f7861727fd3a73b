// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/base/text.h"

namespace torsio {

/// How far a long piece of work has come.
struct Progress {
  Text step;                  ///< "Recording G1-03"
  double fraction = 0.0;      ///< of the whole work, 0..1
  double remaining_s = -1.0;  ///< estimate; negative while unknown
};

/// Called from the working thread, at most a few times a second.
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace torsio
