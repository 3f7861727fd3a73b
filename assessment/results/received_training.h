// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/results/cohort_report.h"

// What each trainee's group was to train, and what the record says they trained.
namespace torsio {

/// How the training of a trainee compares with the plan of the group.
enum class Received : std::uint8_t {
  kAsPlanned,
  kNothing,     ///< no minute of the planned training
  kTooLittle,   ///< less than kLeastShare of the planned time on simulator or real arm
  kTooMuch,     ///< more than kMaxShare of it
  kOtherGroup,  ///< time on a simulator or arm that the plan of the group does not contain
};
inline constexpr std::array kEveryReceived{Received::kAsPlanned, Received::kNothing, Received::kTooLittle,
                                           Received::kTooMuch, Received::kOtherGroup};
inline constexpr double kLeastShare = 0.8;
inline constexpr double kMaxShare = 1.2;
/// How far training as planned may be from the plan, as a share of it.
inline constexpr double kWithinShare = std::max(1.0 - kLeastShare, kMaxShare - 1.0);

/// Returns "as_planned", "nothing" ..., the word in cohort.csv.
[[nodiscard]] std::string_view wordOf(Received received) noexcept;
/// Returns "received_nothing" ..., the statistic that counts such trainees of a group.
[[nodiscard]] inline std::string receivedStatistic(Received received) {
  return "received_" + std::string(wordOf(received));
}
/// Returns "no training", "too little training" ..., for a sentence.
[[nodiscard]] Text labelOf(Received received);

struct ReceivedTraining {
  std::string trainee;
  std::size_t group = 0;
  double virtual_min = 0.0;  ///< noted
  double real_min = 0.0;
  Received received = Received::kAsPlanned;
};

/// Returns whether the record has the plan of every group and training times.
[[nodiscard]] bool knowsPlanAndTimes(const CohortInputs& inputs);
/// Compares plan and record for every trainee, in the order of `inputs`; empty without plan or times. Nothing
/// noted for a trainee counts as no training.
[[nodiscard]] std::vector<ReceivedTraining> receivedTraining(const CohortInputs& inputs);

}  // namespace torsio
