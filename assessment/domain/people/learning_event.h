// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Purpose of consent required before events about a person leave for a learning system.
inline constexpr const char* kLearningConsent = "xapi_export";
/// Centre setting; "yes": events are sent.
inline constexpr const char* kLearningSetting = "learning_records";

/// Events reported to a learning system.
enum class LearningEventKind : std::uint8_t {
  kRegistered,  ///< object: the enrolment
  kLaunched,    ///< object: the trial
  kCompleted,   ///< object: the trial
  kJudged,      ///< passed or failed; object: the trial
  kRested,      ///< object: the exposure
  kRemarkRead,  ///< object: the remark
  kEnd,         ///< number of kinds
};
inline constexpr auto kLearningEventKinds = std::to_array<Term<LearningEventKind>>({
    {LearningEventKind::kRegistered, "registered", Text::tr("Enrolled")},
    {LearningEventKind::kLaunched, "launched", Text::tr("Run begun")},
    {LearningEventKind::kCompleted, "completed", Text::tr("Run completed")},
    {LearningEventKind::kJudged, "judged", Text::tr("Passed or failed")},
    {LearningEventKind::kRested, "rested", Text::tr("Rest taken")},
    {LearningEventKind::kRemarkRead, "remark_read", Text::tr("Remark read")},
});
[[nodiscard]] constexpr const auto& termsOf(LearningEventKind) noexcept {
  return kLearningEventKinds;
}
static_assert(isWholeTable(kLearningEventKinds, LearningEventKind::kEnd), "each kind has one row");

enum class LearningEventState : std::uint8_t { kWaiting, kDelivered, kDead };
inline constexpr std::array<Term<LearningEventState>, 3> kLearningEventStates{{
    {LearningEventState::kWaiting, "waiting", Text::tr("waits")},
    {LearningEventState::kDelivered, "delivered", Text::tr("delivered")},
    {LearningEventState::kDead, "dead", Text::tr("refused for good")},
}};
[[nodiscard]] constexpr const auto& termsOf(LearningEventState) noexcept {
  return kLearningEventStates;
}

/// One entry of the outbox, keyed by `kind` and `objectId`.
struct LearningEvent {
  LearningEventKind kind = LearningEventKind::kRegistered;
  std::string objectId{};
  PersonId personId{};
  std::int64_t happenedUtc_us = 0;
  std::string statement{};  ///< JSON as sent; empty: not built yet
  LearningEventState state = LearningEventState::kWaiting;
  std::int64_t tries = 0;
  std::int64_t nextTryUtc_us = 0;
  std::string answer{};  ///< answer to the last attempt; empty: none yet
  std::int64_t answeredUtc_us = 0;
};

/// Number of outbox entries in each state.
struct LearningEventCounts {
  std::int64_t waiting = 0;
  std::int64_t delivered = 0;
  std::int64_t dead = 0;
};

}  // namespace torsio
