// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

/// How a sheet came about: what of the recording was played, how fast, and how long the rater worked.
struct StoredViewing {
  std::string watched{};  ///< "0-1200;1500-1600": stretches in hundredths of a second; drafts only
  std::optional<std::int64_t> watched_permille{};  ///< of the recording; empty: live. Sealed marks only
  std::int64_t slowest_permille = 1000;            ///< speed, 1000 is as it happened
  std::int64_t fastest_permille = 1000;
  std::int64_t worked_us = 0;
};

/// The newest version of one rater's mark about a case, with its rows.
struct CaseMark {
  std::string markId{};
  std::string assignmentId{};
  std::string raterId{};
  std::int64_t version = 1;
  std::optional<std::int64_t> score_steps{};
  ScoreScale scale{};
  std::vector<SheetRow> rows{};
};

/// A run with the mark of a panel, for the warm-up.
struct StoredReferenceRun {
  std::string trialId{};
  std::int64_t position = 0;
  std::string rubricRevisionId{};
  double panel_steps = 0.0;  ///< mean of the panel, steps of the rubric's overall scale
  std::int64_t panelRaters = 1;
  std::string setBy{};
  std::int64_t setUtc_us = 0;
  bool demonstration = false;
};

/// A reference run that is given to nobody any more.
struct StoredReferenceWithdrawal {
  std::string trialId{};
  std::string reason{};
  std::string withdrawnBy{};
  std::int64_t withdrawnUtc_us = 0;
};

/// One mark of an unfinished evaluation form.
struct EvaluationDraftMark {
  std::string modelCode{};
  std::int64_t indexNumber = 0;
  std::int64_t score_steps = 0;
};

/// What the physician's desk keeps beside sheets and marks. One call, one transaction.
class DeskRepository {
 public:
  explicit DeskRepository(Connection& connection) : connection_(connection) {}

  [[nodiscard]] std::optional<StoredAssignment> assignment(const std::string& assignmentId) const;
  [[nodiscard]] bool isWithdrawn(const std::string& assignmentId) const;
  /// Everybody's newest mark about one trainee at one scoring point, ordered by rater.
  [[nodiscard]] std::vector<CaseMark> marksOfCase(const std::string& enrolmentId,
                                                  const std::string& occasionCode) const;
  /// The rater's assignments about cases on which everybody has committed and more than one was asked, in the
  /// rater's own order.
  [[nodiscard]] std::vector<StoredAssignment> committed(const std::string& raterId) const;
  /// Length of a trial that has ended, microseconds; empty: unknown trial or still open.
  [[nodiscard]] std::optional<std::int64_t> trialLength_us(const std::string& trialId) const;

  void saveDraftViewing(const std::string& assignmentId, const StoredViewing& viewing);
  [[nodiscard]] std::optional<StoredViewing> draftViewing(const std::string& assignmentId) const;
  /// Seals it with the mark and removes the draft's.
  void sealViewing(const std::string& assignmentId, const std::string& markId, const StoredViewing& viewing);
  /// Working times of a rater's first versions, newest first, at most `limit`.
  [[nodiscard]] std::vector<std::int64_t> workingTimes_us(const std::string& raterId,
                                                          std::int64_t limit) const;

  /// Recordings that somebody is or was asked to score, each once.
  [[nodiscard]] std::vector<std::string> assignedTrials() const;

  void addReferenceRuns(std::span<const StoredReferenceRun> runs);
  /// Reference runs that raters are given, by position.
  [[nodiscard]] std::vector<StoredReferenceRun> referenceRuns() const;
  /// All reference runs, the withdrawn ones too, by position.
  [[nodiscard]] std::vector<StoredReferenceRun> allReferenceRuns() const;
  /// Once a run. Throws Error{kDatabase} for a run that is none or is withdrawn already.
  void withdrawReferenceRun(const StoredReferenceWithdrawal& withdrawal);
  [[nodiscard]] std::vector<StoredReferenceWithdrawal> referenceWithdrawals() const;

  /// Empty score: removes the mark from the draft.
  void saveEvaluationDraft(const std::string& campaignId, const std::string& raterId,
                           const std::string& modelCode, std::int64_t indexNumber,
                           std::optional<std::int64_t> score_steps, std::int64_t utc_us);
  [[nodiscard]] std::vector<EvaluationDraftMark> evaluationDraft(const std::string& campaignId,
                                                                 const std::string& raterId) const;
  void removeEvaluationDraft(const std::string& campaignId, const std::string& raterId,
                             const std::string& modelCode);

 private:
  [[nodiscard]] std::vector<StoredReferenceRun> referenceRunsWhere(const char* condition) const;

  Connection& connection_;
};

}  // namespace torsio
