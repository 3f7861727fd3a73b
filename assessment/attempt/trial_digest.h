// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// All measures of a recording, with the version of the formulas and the rules used.
struct TrialDigest {
  TrialId trialId{};
  std::int64_t formulaVersion = 0;
  double tolerance_rad = 0.0;
  std::optional<double> forceLimit_N{};    ///< at least 0; empty: none
  std::optional<double> torqueLimit_Nm{};  ///< at least 0; empty: none
  std::string contentHash{};               ///< of the measured recording
  std::string model{};
  AttemptMeasures measures{};
  std::int64_t computedUtc_us = 0;
  friend bool operator==(const TrialDigest&, const TrialDigest&) = default;
};

}  // namespace torsio
