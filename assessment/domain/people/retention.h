// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
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

/// What people may request about their own record.
enum class PersonRequestKind : std::uint8_t {
  kExport,  ///< a copy of everything held about them
  kErase,   ///< deletion of name and recordings
  kEnd,     ///< number of kinds
};
inline constexpr auto kPersonRequestKinds = std::to_array<Term<PersonRequestKind>>({
    {PersonRequestKind::kExport, "export", Text::tr("a copy of everything kept")},
    {PersonRequestKind::kErase, "erase", Text::tr("erasing the record")},
});
[[nodiscard]] constexpr const auto& termsOf(PersonRequestKind) noexcept {
  return kPersonRequestKinds;
}
static_assert(isWholeTable(kPersonRequestKinds, PersonRequestKind::kEnd),
              "each kind has one row, at its own place");

enum class PersonRequestAnswer : std::uint8_t { kDone, kDeclined, kTakenBack };
inline constexpr std::array<Term<PersonRequestAnswer>, 3> kPersonRequestAnswers{{
    {PersonRequestAnswer::kDone, "done", Text::tr("done")},
    {PersonRequestAnswer::kDeclined, "declined", Text::tr("declined")},
    {PersonRequestAnswer::kTakenBack, "taken_back", Text::tr("taken back")},
}};
[[nodiscard]] constexpr const auto& termsOf(PersonRequestAnswer) noexcept {
  return kPersonRequestAnswers;
}

struct PersonRequest {
  std::string id{};
  PersonId personId{};
  PersonRequestKind kind = PersonRequestKind::kExport;
  std::int64_t askedUtc_us = 0;
  std::optional<PersonRequestAnswer> answer{};  ///< empty: pending
  std::string reason{};                         ///< of the answer
  std::int64_t answeredUtc_us = 0;
  std::string personCode{};  ///< filled when read
};

/// Kinds of copies of the record, whole or of one person.
enum class CopyKind : std::uint8_t {
  kBackup,
  kBeforeRestore,  ///< the record before a backup was restored over it
  kBeforeSchema,   ///< the record before a schema migration
  kPackage,        ///< everything about one person
  kMoved,          ///< the target of a move to another database
};
inline constexpr auto kCopyKinds = std::to_array<Term<CopyKind>>({
    {CopyKind::kBackup, "backup", Text::tr("backup")},
    {CopyKind::kBeforeRestore, "before_restore", Text::tr("record before a restore")},
    {CopyKind::kBeforeSchema, "before_schema", Text::tr("record before a new schema")},
    {CopyKind::kPackage, "package", Text::tr("package about the person")},
    {CopyKind::kMoved, "moved", Text::tr("record before or after a move")},
});
[[nodiscard]] constexpr const auto& termsOf(CopyKind) noexcept {
  return kCopyKinds;
}

/// A copy and where it was put.
struct RecordCopy {
  CopyKind kind = CopyKind::kBackup;
  std::string place{};    ///< file or folder; address of a server, without an account
  std::string station{};  ///< machine whose disk holds it, or that made it on a server
  PersonId personId{};    ///< empty: whole record
  std::int64_t madeUtc_us = 0;
  std::string id{};
};

}  // namespace torsio
