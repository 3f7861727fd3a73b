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

/// What a physician wrote at a time of one's trial, with the answers. Never who it was.
struct TraineeRemark {
  RemarkId id{};
  TrialId trialId{};
  double at_s = 0.0;
  std::string text{};  ///< the newest words
  std::int64_t version = 1;
  std::int64_t writtenUtc_us = 0;
  std::int64_t editedUtc_us = 0;         ///< 0: never edited
  std::vector<RemarkWording> earlier{};  ///< what stood there before, oldest first
  bool own = false;                      ///< written by the trainee (a reply, or a question)
  bool question = false;                 ///< the trainee's question to a named physician
  bool read = false;                     ///< the newest words
  std::vector<TraineeRemark> replies{};
};

/// One trial that somebody has something to say about.
struct TrialRemarks {
  TrialId trialId{};
  std::string moduleTitle{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  std::vector<TraineeRemark> remarks{};
  std::size_t unread = 0;
};

/// Own trials with remarks, newest first. A remark on a trial that raters were asked to score appears when
/// the marks of that occasion were released. kTrialViewOwn.
[[nodiscard]] std::vector<TrialRemarks> ownRemarks(SessionContext& session);
/// Remarks that may be seen and were not read yet. kTrialViewOwn.
[[nodiscard]] std::size_t unreadRemarks(SessionContext& session);
/// Notes that the actor has read a version of a remark. Audited. kTrialViewOwn.
void markRemarkRead(SessionContext& session, const RemarkId& remarkId, std::int64_t version);
/// Returns the id of the reply. Audited. kTrialViewOwn. Throws Error{kBadParameter} for an empty text.
RemarkId replyToRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text);

/// New words for an own reply or question, beside the old ones. Audited. kTrialViewOwn. Throws Error as
/// revisionOf() does.
void editRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text);

/// One row of a sheet beside the trainee's own answer; points, not steps.
struct ScoreGapRow {
  std::string code{};
  std::string label{};
  double lowest = 1.0;
  double highest = 10.0;
  double step = 0.1;
  std::optional<double> own{};
  std::optional<double> panel{};  ///< mean of the raters; empty until released and self-scored
};

/// Own marks first, then the gap.
struct ScoreGap {
  TrialId trialId{};
  ScoreGapRow overall{};
  std::vector<ScoreGapRow> rows{};
  bool selfScored = false;
  bool released = false;   ///< the raters' marks may be shown
  std::size_t raters = 0;  ///< whose marks the means rest on
};
/// kTrialViewOwn and kMarkViewOwn. The raters' means are empty until the trainee has scored.
[[nodiscard]] ScoreGap scoreGap(SessionContext& session, const TrialId& trialId);

struct SelfScoreRow {
  std::string code{};
  double points = 0.0;
};
/// Stores the trainee's own sheet; a change of mind before the raters' marks were seen is a new version.
/// Audited. kTrialViewOwn. Throws Error{kBadParameter} for points that the scale does not have,
/// {kPermission} once the raters' marks were shown.
void selfScore(SessionContext& session, const TrialId& trialId, double overall,
               const std::vector<SelfScoreRow>& rows);

}  // namespace torsio
