// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// A physician's remark on the trainee's trial, with the replies. The author is never identified.
struct TraineeRemark {
  RemarkId id{};
  TrialId trialId{};
  double at_s = 0.0;
  std::string text{};  ///< latest version
  std::int64_t version = 1;
  std::int64_t writtenUtc_us = 0;
  std::int64_t editedUtc_us = 0;         ///< 0: never edited
  std::vector<RemarkWording> earlier{};  ///< previous versions, oldest first
  bool own = false;                      ///< written by the trainee (a reply, or a question)
  bool question = false;                 ///< the trainee's question to a named physician
  bool read = false;                     ///< the latest version was read
  std::vector<TraineeRemark> replies{};
};

/// A trial with remarks.
struct TrialRemarks {
  TrialId trialId{};
  std::string moduleTitle{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  std::vector<TraineeRemark> remarks{};
  std::size_t unread = 0;
};

/// Returns the actor's trials with remarks, latest first. Remarks on a trial assigned for scoring appear when
/// the marks of that occasion are released. kTrialViewOwn.
[[nodiscard]] std::vector<TrialRemarks> ownRemarks(SessionContext& session);
/// Counts visible unread remarks. kTrialViewOwn.
[[nodiscard]] std::size_t unreadRemarks(SessionContext& session);
/// Marks a version of a remark as read. Audited. kTrialViewOwn.
void markRemarkRead(SessionContext& session, const RemarkId& remarkId, std::int64_t version);
/// Returns the id of the reply. Audited. kTrialViewOwn. Throws Error{kBadParameter} for an empty text.
RemarkId replyToRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text);

/// Adds a version to the actor's reply or question. Audited. kTrialViewOwn. Throws Error like revisionOf().
void editRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text);

/// One row of a sheet with the trainee's own answer; in points, not steps.
struct ScoreGapRow {
  std::string code{};
  std::string label{};
  double lowest = 1.0;
  double highest = 10.0;
  double step = 0.1;
  std::optional<double> own{};
  std::optional<double> panel{};  ///< mean of the raters; empty until released and self-scored
};

/// Self-assessment compared with the raters.
struct ScoreGap {
  TrialId trialId{};
  ScoreGapRow overall{};
  std::vector<ScoreGapRow> rows{};
  bool selfScored = false;
  bool released = false;   ///< the raters' marks may be shown
  std::size_t raters = 0;  ///< number of raters in the means
};
/// kTrialViewOwn and kMarkViewOwn. The raters' means are empty until the trainee has scored.
[[nodiscard]] ScoreGap scoreGap(SessionContext& session, const TrialId& trialId);

struct SelfScoreRow {
  std::string code{};
  double points = 0.0;
};
/// Stores the trainee's own sheet; a change before the raters' marks were seen is a new version. Audited.
/// kTrialViewOwn. Throws Error{kBadParameter} for points outside the scale, {kPermission} once the raters'
/// marks were shown.
void selfScore(SessionContext& session, const TrialId& trialId, double overall,
               const std::vector<SelfScoreRow>& rows);

}  // namespace torsio
