// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/services/training/detorsion_story.h"
#include "sim/core/text.h"

namespace torsio {

/// A finding about an untwisting, worded equally in window and browser.
struct UntwistingFinding {
  enum class Kind : std::uint8_t {
    kFirstTurnRight,
    kFirstTurnWrong,
    kTwistedFurther,  ///< value: angle, rad
    kFlowFromStart,
    kFlowBack,  ///< value: time of the hand, s; other: time of the tissue, s
    kNoFlow,
    kLost,      ///< value: ischaemic dose
    kSurvives,  ///< value: ischaemic dose
    kRegrips,   ///< value: number; other: minimum number
    kSlipBack,  ///< value: angle, rad
    kInStages,  ///< value: angle, rad
    kTooFast,   ///< value: angle, rad
    kOverload,  ///< value: seconds
    kTears,     ///< value: number
    kBruises,   ///< value: number
    kSlips,     ///< value: number
    kRelapsed,
    kResidual,  ///< value: angle, rad
    kMishapsUnknown,
  };
  Kind kind = Kind::kNoFlow;
  double value = 0.0;
  double other = 0.0;
  std::optional<double> at_s{};  ///< when to look, since the first sample; empty: everywhere

  [[nodiscard]] Text text() const;
};

/// Returns the findings about an untwisting in the order of display.
[[nodiscard]] std::vector<UntwistingFinding> findingsOf(const DetorsionStory& story);

}  // namespace torsio
