// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/reference_run.h"
#include "assessment/domain/rating/remark.h"
#include "assessment/domain/rating/self_score.h"
#include "db/connection/connection.h"

namespace torsio {

/// Bookmarks, remarks and replies at times of a trial, who has read them; self-scores and calibration scores.
/// One call, one transaction. Whatever is added twice with the same content is stored once; the same id with
/// other content is refused with DbError (kUnique).
class RemarkRepository {
 public:
  explicit RemarkRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError: kForeignKey when the trial or the remark that is answered does not exist, kCheck when
  /// only one of purpose "reply" and replyTo is given.
  void add(const Remark& remark);
  [[nodiscard]] std::optional<Remark> find(const RemarkId& remarkId) const;
  /// By time in the trial, then by when they were written.
  [[nodiscard]] std::vector<Remark> remarks(const TrialId& trialId) const;
  /// Throws DbError (kUnique) when somebody else's window has stored this version with other words.
  void revise(const RemarkRevision& revision);
  /// What was written before the newest words, oldest first, of the edited remarks of a trial.
  [[nodiscard]] std::map<RemarkId, std::vector<RemarkWording>> earlierWordings(const TrialId& trialId) const;
  /// The first reading of a version counts; later ones change nothing.
  void markRead(const ReadReceipt& receipt);
  [[nodiscard]] std::vector<ReadReceipt> receipts(const TrialId& trialId) const;
  /// Remarks and replies of others on this trainee's trials whose newest words `reader` has not read, oldest
  /// first.
  [[nodiscard]] std::vector<Remark> unreadOnTrialsOf(const TraineeId& traineeId,
                                                     const std::string& reader) const;
  /// Replies of others to remarks of `author` whose newest words `author` has not read, oldest first.
  [[nodiscard]] std::vector<Remark> unreadReplies(const std::string& author) const;

  void addSelfScore(const SelfScore& score);
  /// All versions for a trial, oldest first.
  [[nodiscard]] std::vector<SelfScore> selfScores(const TrialId& trialId) const;

  void addCalibrationScore(const CalibrationScore& score);
  /// Of one rater, oldest first.
  [[nodiscard]] std::vector<CalibrationScore> calibrationScores(const RaterId& raterId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
