// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/learning_event.h"
#include "db/connection/connection.h"

namespace torsio {

/// Adds outbox entries for the learning system about what was just stored; call it in the same transaction.
/// No effect if sending is off, the person has not agreed, the data are demonstration data or nobody's, or
/// the entry exists. `objectIds`: as in LearningEventKind.
void noteLearningEvents(Connection& connection, LearningEventKind kind,
                        std::span<const std::string> objectIds);

/// True if the person's newest decision permits reporting to a learning system.
[[nodiscard]] bool agreesToLearningRecords(Connection& connection, const PersonId& personId);

/// Data of an outbox entry's event; empty texts where not applicable.
struct LearningFacts {
  EnrolmentId enrolmentId{};
  CohortId cohortId{};
  std::string cohortName{};
  TrialId trialId{};
  ModuleId moduleId{};
  std::int64_t duration_us = 0;
};

/// The outbox for the learning system; noteLearningEvents() fills it.
class LearningRepository {
 public:
  explicit LearningRepository(Connection& connection) : connection_(connection) {}

  /// Returns pending entries that may be sent now, oldest event first; at most `limit`.
  [[nodiscard]] std::vector<LearningEvent> due(std::int64_t now_us, std::int64_t limit) const;
  /// Claims a pending entry as read, so that no other station sends it before `until_us`. Returns false if
  /// another one was faster.
  [[nodiscard]] bool claim(const LearningEvent& event, std::int64_t until_us);
  /// Stores the statement to be sent unless there is one already. Returns the stored one.
  [[nodiscard]] std::string keepStatement(const LearningEvent& event, const std::string& statement);
  /// Returns the data of an entry's event; empty: it no longer exists.
  [[nodiscard]] std::optional<LearningFacts> facts(const LearningEvent& event) const;
  /// Record the outcome of an attempt: delivered, refused for good, or to be retried at `nextTry_us`.
  void setDelivered(const LearningEvent& event, const std::string& answer, std::int64_t now_us);
  void setRefused(const LearningEvent& event, const std::string& answer, std::int64_t now_us);
  void setRetry(const LearningEvent& event, const std::string& answer, std::int64_t now_us,
                std::int64_t nextTry_us);
  /// Removes an entry whose event no longer exists.
  void forget(const LearningEvent& event);

  [[nodiscard]] LearningEventCounts counts() const;
  /// Returns entries in a state, most recently answered first; at most `limit`.
  [[nodiscard]] std::vector<LearningEvent> inState(LearningEventState state, std::int64_t limit) const;
  /// Returns the newest answer to a pending entry; empty: none was tried.
  [[nodiscard]] std::string newestError() const;
  /// Makes all pending and permanently refused entries due now. Returns how many had been refused.
  std::int64_t retryAll();
  /// Drops permanently refused entries. Returns their number.
  std::int64_t dropRefused();

 private:
  void answered(const LearningEvent& event, LearningEventState state, const std::string& answer,
                std::int64_t now_us, std::int64_t nextTry_us);
  Connection& connection_;
};

}  // namespace torsio
