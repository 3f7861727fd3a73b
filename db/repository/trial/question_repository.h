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

  /// The bookmark must be stored. Throws DbError: kForeignKey, kUnique when it was sent before.
  void add(const TraineeQuestion& question);
  [[nodiscard]] std::optional<TraineeQuestion> find(const RemarkId& remarkId) const;
  /// By moment.
  [[nodiscard]] std::vector<TraineeQuestion> ofTrial(const TrialId& trialId) const;
  /// What waits first, oldest first; then what was answered, newest first.
  [[nodiscard]] std::vector<TraineeQuestion> toRater(const RaterId& raterId) const;
  /// Whom this person asked last; empty: nobody yet.
  [[nodiscard]] std::string lastAsked(const PersonId& personId) const;
  /// Whether the trial is or was given to raters to be scored, or is their reference: then names are kept
  /// out.
  [[nodiscard]] bool isScored(const TrialId& trialId) const;

 private:
  [[nodiscard]] std::vector<TraineeQuestion> read(const std::string& condition,
                                                  const std::string& value) const;
  Connection& connection_;
};

}  // namespace torsio
