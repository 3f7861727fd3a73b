// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/record/trial.h"

namespace torsio {

/// Where a recording goes when its sink gives up, and the context that is written with it.
struct SpillPlace {
  std::filesystem::path folder;  ///< made when needed
  std::string context;           ///< what the header does not say; text for whoever reads the file
};

/// A sink that knows its spill place. For any other sink the recorder's options decide.
class SpillingTrialSink : public TrialSink {
 public:
  /// Returns the place. Called in the recorder's thread, after this sink has failed.
  [[nodiscard]] virtual SpillPlace spillPlace() const = 0;
};

}  // namespace torsio
