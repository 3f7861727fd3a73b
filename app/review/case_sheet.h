// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/access/workplace.h"
#include "app/review/blinded_case.h"
#include "app/review/watch_log.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

/// What the centre asks of a rater who scores from a recording. Settings "review.minimum_watched_percent" and
/// "review.speeds" ("1" or "0.5,1,1.5"); what cannot be read there falls back to the defaults.
struct ViewingRules {
  double minimumWatched = 0.8;      ///< share of the recording, 0..1
  std::vector<double> speeds{1.0};  ///< allowed ones, rising; more than one: declared by the centre
};
[[nodiscard]] ViewingRules viewingRules(Workplace& workplace);

/// Where a keystroke is kept once it is said to be saved.
enum class KeptAt { kThisMachine, kServer };
/// kMarkSubmit.
[[nodiscard]] KeptAt keptAt(Workplace& workplace);

/// A case as it is laid on the desk.
struct OpenedSheet {
  BlindedCase shown{};
  StoredRubricRevision rubric{};
  Sheet sheet{};  ///< the draft, or the newest sealed version
  SheetState state = SheetState::kOpen;
  WatchLog watched{};
};
/// kMarkSubmit, own case.
[[nodiscard]] OpenedSheet openSheet(Workplace& workplace, const std::string& assignmentId);

/// Stores the draft; it is on the disk when the call returns. Call it with every keystroke. Returns the new
/// revision. Drafts leave no trace in the audit trail: they are nobody's record until they are submitted.
/// kMarkSubmit, own case. Throws DbError{kConflict} when the draft was changed at another station meanwhile.
std::int64_t saveSheet(Workplace& workplace, const std::string& assignmentId, Sheet sheet,
                       const WatchLog& watched);

/// What stands between a sheet and its submission, and what is worth a second look.
struct SheetCheck {
  std::vector<std::string> unanswered{};  ///< row codes; kOverallRow: the overall mark
  bool watchedTooLittle = false;
  bool speedNotAllowed = false;
  bool allTheSame = false;      ///< three rows or more and one and the same score, in share of their scales
  bool farApart = false;        ///< three rows or more that span most of their scales
  bool overallOutside = false;  ///< the overall mark lies outside the range of the rows
  double watchedShare = 1.0;
  [[nodiscard]] bool mayBeSubmitted() const noexcept {
    return unanswered.empty() && !watchedTooLittle && !speedNotAllowed;
  }
};
/// Pure. A sheet whose overall mark is "not assessable" need not have been watched.
[[nodiscard]] SheetCheck checkSheet(const StoredRubricRevision& rubric, const Sheet& sheet, bool live,
                                    const WatchLog& watched, const ViewingRules& rules);

/// Seals the sheet with what was watched and how fast. kMarkSubmit, own case; audited. Throws Error{kBadData}
/// when checkSheet() says no, DbError{kUnique} when it was submitted before.
void submitSheet(Workplace& workplace, const std::string& assignmentId, const Sheet& sheet,
                 const WatchLog& watched);

/// The next version of a submitted sheet; the one before stays as it is. kMarkSubmit, own case; audited.
/// Throws Error{kBadParameter} without a reason, {kBadData}: not submitted yet, or not complete.
void amendSheet(Workplace& workplace, const std::string& assignmentId, const Sheet& sheet,
                const std::string& reason);

/// One sealed version of an own sheet.
struct SheetVersion {
  std::int64_t version = 1;
  std::optional<std::int64_t> overall_steps{};
  std::string comment{};
  std::string amendReason{};
  std::int64_t submittedUtc_us = 0;
};
/// Oldest first. kMarkSubmit, own case.
[[nodiscard]] std::vector<SheetVersion> sheetVersions(Workplace& workplace, const std::string& assignmentId);

}  // namespace torsio
