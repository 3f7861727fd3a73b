// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"
#include "db/connection/connection.h"

namespace torsio {

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
