// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/remark.h"
#include "db/connection/connection.h"

namespace torsio {

/// Bookmarks, remarks and replies at moments of a trial, with read receipts; self-scores and calibration
/// scores. Each call is one transaction. Adding the same content twice stores it once; an existing id with
/// other content throws DbError (kUnique).
class RemarkRepository {
 public:
  explicit RemarkRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError: kForeignKey if the trial or the answered remark does not exist, kCheck if only one of
  /// purpose "reply" and replyTo is given.
  void add(const Remark& remark);
  [[nodiscard]] std::optional<Remark> find(const RemarkId& remarkId) const;
  /// By time in the trial, then by time of writing.
  [[nodiscard]] std::vector<Remark> remarks(const TrialId& trialId) const;
  /// Throws DbError (kUnique) if this version was stored elsewhere with other text.
  void revise(const RemarkRevision& revision);
  /// Superseded texts of the edited remarks of a trial, oldest first.
  [[nodiscard]] std::map<RemarkId, std::vector<RemarkWording>> earlierWordings(const TrialId& trialId) const;
  /// The first read of a version counts; later ones are ignored.
  void markRead(const ReadReceipt& receipt);
  [[nodiscard]] std::vector<ReadReceipt> receipts(const TrialId& trialId) const;
  /// Remarks and replies by others on this trainee's trials whose newest text `reader` has not read, oldest
  /// first.
  [[nodiscard]] std::vector<Remark> unreadOnTrialsOf(const TraineeId& traineeId,
                                                     const std::string& reader) const;
  /// Replies by others to remarks of `author` whose newest text `author` has not read, oldest first.
  [[nodiscard]] std::vector<Remark> unreadReplies(const std::string& author) const;

  void addSelfScore(const SelfScore& score);
  /// All versions for a trial, oldest first.
  [[nodiscard]] std::vector<SelfScore> selfScores(const TrialId& trialId) const;

  void addCalibrationScore(const CalibrationScore& score);
  /// Calibration scores of one rater, oldest first.
  [[nodiscard]] std::vector<CalibrationScore> calibrationScores(const RaterId& raterId) const;

 private:
  Connection& connection_;
};

/// SQL for a column of a remark's newest revision, or `otherwise` if it was never edited.
[[nodiscard]] inline std::string newestOfRemark(const std::string& remark, const std::string& column,
                                                const std::string& otherwise) {
  return "COALESCE((SELECT r." + column + " FROM remark_revision r WHERE r.remark_id = " + remark +
         ".id ORDER BY r.version DESC LIMIT 1), " + otherwise + ")";
}

/// Questions about moments of trials. Throws DbError when the database refuses.
class QuestionRepository {
 public:
  explicit QuestionRepository(Connection& connection) : connection_(connection) {}

  /// The bookmark must be stored. Throws DbError: kForeignKey, kUnique if it was already sent.
  void add(const TraineeQuestion& question);
  [[nodiscard]] std::optional<TraineeQuestion> find(const RemarkId& remarkId) const;
  /// Questions about a trial, by moment.
  [[nodiscard]] std::vector<TraineeQuestion> ofTrial(const TrialId& trialId) const;
  /// Unanswered questions first, oldest first; then answered ones, newest first.
  [[nodiscard]] std::vector<TraineeQuestion> toRater(const RaterId& raterId) const;
  /// Id of the rater whom this person asked last; empty: none.
  [[nodiscard]] std::string lastAsked(const PersonId& personId) const;
  /// True if the trial is or was assigned for scoring, or is a reference run: names must then be hidden.
  [[nodiscard]] bool isScored(const TrialId& trialId) const;

 private:
  [[nodiscard]] std::vector<TraineeQuestion> read(const std::string& condition,
                                                  const std::string& value) const;
  Connection& connection_;
};

}  // namespace torsio
