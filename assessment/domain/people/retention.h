// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Reasons why a person's record may be due for deletion.
inline constexpr const char* kRetainTrainee = "trainee";  ///< since their last activity
inline constexpr const char* kRetainRater = "rater";      ///< since their last activity
inline constexpr const char* kRetainLeft = "left";        ///< left the centre; since their last activity
inline constexpr const char* kRetainWithdrawn =
    "consent_withdrawn";  ///< since consent to the record was withdrawn

/// Retention period of a category and its lawful basis.
struct RetentionRule {
  std::string category{};  ///< one of the constants above
  std::int64_t keep_days = 0;
  std::string basis{};
  std::int64_t changedUtc_us = 0;
};

/// A reviewer's decision about one person's record.
enum class HoldKind : std::uint8_t { kLock, kExtend, kRelease };
inline constexpr std::array<Term<HoldKind>, 3> kHoldKinds{{
    {HoldKind::kLock, "lock", Text::tr("locked"), "kept for good"},
    {HoldKind::kExtend, "extend", Text::tr("kept longer"), "kept until a day"},
    {HoldKind::kRelease, "release", Text::tr("released"), "may be erased when it is due"},
}};
[[nodiscard]] constexpr const auto& termsOf(HoldKind) noexcept {
  return kHoldKinds;
}

/// A stored decision of a reviewer about one person's record. Append-only; the newest one counts.
struct RetentionHold {
  PersonId personId{};
  HoldKind kind = HoldKind::kLock;
  std::optional<std::int64_t> untilUtc_us{};  ///< for kExtend only
  std::string reason{};
  std::string decidedBy{};
  std::int64_t decidedUtc_us = 0;
};

/// One row of the review queue.
struct RetentionItem {
  PersonId personId{};
  std::string code{};
  std::string category{};  ///< the rule that was due first
  std::string basis{};
  std::int64_t sinceUtc_us = 0;  ///< last activity, or withdrawal
  std::int64_t dueUtc_us = 0;
  std::optional<RetentionHold> hold{};  ///< the newest decision
  bool held = false;                    ///< locked, or extended beyond the date of the review
};

}  // namespace torsio
