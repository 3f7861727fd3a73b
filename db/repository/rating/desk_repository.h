// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/watch_account.h"
#include "db/connection/connection.h"

namespace torsio {

/// What the physician's desk stores besides sheets and marks. Each call is one transaction.
class DeskRepository {
 public:
  explicit DeskRepository(Connection& connection) : connection_(connection) {}

  [[nodiscard]] std::optional<Assignment> assignment(const AssignmentId& assignmentId) const;
  [[nodiscard]] bool isWithdrawn(const AssignmentId& assignmentId) const;
  /// All raters' newest marks of one trainee at one occasion, ordered by rater.
  [[nodiscard]] std::vector<CaseMark> marksOfCase(const EnrolmentId& enrolmentId,
                                                  const std::string& occasionCode) const;
  /// The rater's assignments whose panel of two or more has submitted completely, in the rater's own order.
  [[nodiscard]] std::vector<Assignment> committed(const RaterId& raterId) const;
  /// Length of a trial that has ended, microseconds; empty: unknown trial or still open.
  [[nodiscard]] std::optional<std::int64_t> trialLength_us(const TrialId& trialId) const;
  /// Hash of the recording; empty: unknown trial or still open.
  [[nodiscard]] std::optional<std::string> contentHash(const TrialId& trialId) const;

  void saveDraftViewing(const AssignmentId& assignmentId, const SheetViewing& viewing);
  [[nodiscard]] std::optional<SheetViewing> draftViewing(const AssignmentId& assignmentId) const;
  /// Seals the viewing data with the mark and deletes those of the draft.
  void sealViewing(const AssignmentId& assignmentId, const MarkId& markId, const SheetViewing& viewing);
  /// The account of a rater's watched time; a new one if there is none.
  [[nodiscard]] WatchAccount watchAccount(const RaterId& raterId) const;
  void saveWatchAccount(const RaterId& raterId, const WatchAccount& account);
  /// Working times of a rater's first versions, newest first, at most `limit`.
  [[nodiscard]] std::vector<std::int64_t> workingTimes_us(const RaterId& raterId, std::int64_t limit) const;

  /// Recordings that are or were assigned for scoring, without duplicates.
  [[nodiscard]] std::vector<TrialId> assignedTrials() const;

  void addReferenceRuns(std::span<const ReferenceRun> runs);
  /// Reference runs in use, by position.
  [[nodiscard]] std::vector<ReferenceRun> referenceRuns() const;
  /// All reference runs, including withdrawn ones, by position.
  [[nodiscard]] std::vector<ReferenceRun> allReferenceRuns() const;
  /// Withdraws a reference run, once. Throws Error{kDatabase} if it is unknown or already withdrawn.
  void withdrawReferenceRun(const ReferenceWithdrawal& withdrawal);
  [[nodiscard]] std::vector<ReferenceWithdrawal> referenceWithdrawals() const;

  /// An empty score removes the mark from the draft.
  void saveEvaluationDraft(const CampaignId& campaignId, const RaterId& raterId, const std::string& modelCode,
                           std::int64_t indexNumber, std::optional<std::int64_t> score_steps,
                           std::int64_t utc_us);
  [[nodiscard]] std::vector<EvaluationDraftMark> evaluationDraft(const CampaignId& campaignId,
                                                                 const RaterId& raterId) const;
  void removeEvaluationDraft(const CampaignId& campaignId, const RaterId& raterId,
                             const std::string& modelCode);

 private:
  [[nodiscard]] std::vector<ReferenceRun> referenceRunsWhere(const char* condition) const;

  Connection& connection_;
};

}  // namespace torsio
