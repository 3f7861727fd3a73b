// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/learning_event.h"
#include "db/connection/connection.h"

namespace torsio {

/// What an entry of the outbox tells of; empty texts where it has none.
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

  /// Reads what waits and may be tried now, in the order in which it happened; at most `limit`.
  [[nodiscard]] std::vector<LearningEvent> due(std::int64_t now_us, std::int64_t limit) const;
  /// Takes a waiting entry as it was read, so that no other station sends it before `until_us`. False:
  /// another one was faster.
  [[nodiscard]] bool claim(const LearningEvent& event, std::int64_t until_us);
  /// Keeps the text that is sent; where one is kept already it stays. Returns the one that is kept.
  [[nodiscard]] std::string keepStatement(const LearningEvent& event, const std::string& statement);
  /// Reads what an entry tells of; empty: it is gone.
  [[nodiscard]] std::optional<LearningFacts> facts(const LearningEvent& event) const;
  /// What came of a try.
  void setDelivered(const LearningEvent& event, const std::string& answer, std::int64_t now_us);
  void setDead(const LearningEvent& event, const std::string& answer, std::int64_t now_us);
  void setLater(const LearningEvent& event, const std::string& answer, std::int64_t now_us,
                std::int64_t nextTry_us);
  /// There is nothing to tell.
  void forget(const LearningEvent& event);

  [[nodiscard]] LearningEventCounts counts() const;
  /// Reads entries in a state, those answered last first; at most `limit`.
  [[nodiscard]] std::vector<LearningEvent> inState(LearningEventState state, std::int64_t limit) const;
  /// Reads the newest answer to what waits; empty: nothing that waits was tried.
  [[nodiscard]] std::string newestTrouble() const;
  /// Lets everything that waits or was refused for good be tried at once. Returns how many had been refused.
  std::int64_t retryAll();
  /// Gives up what was refused for good. Returns how many.
  std::int64_t dropDead();

 private:
  void answered(const LearningEvent& event, LearningEventState state, const std::string& answer,
                std::int64_t now_us, std::int64_t nextTry_us);
  Connection& connection_;
};

}  // namespace torsio
