// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// A bookmark that was sent to a physician, with what came back. Append-only.
struct StoredQuestion {
  std::string remarkId{};  ///< the trainee's bookmark: moment and words
  std::string raterId{};
  std::int64_t askedUtc_us = 0;
  std::string trialId{};   ///< of the bookmark, as what follows; not written by add()
  std::string personId{};  ///< who asks
  std::int64_t time_us = 0;
  std::string text{};      ///< empty: none, or erased
  std::string answerId{};  ///< the rater's first reply; empty: it still waits
  std::string answerText{};
  std::int64_t answeredUtc_us = 0;
};

/// Questions about moments of trials. Throws DbError when the database refuses.
class QuestionRepository {
 public:
  explicit QuestionRepository(Connection& connection) : connection_(connection) {}

  /// The bookmark must be stored. Throws DbError: kForeignKey, kUnique when it was sent before.
  void add(const StoredQuestion& question);
  [[nodiscard]] std::optional<StoredQuestion> find(const std::string& remarkId) const;
  /// By moment.
  [[nodiscard]] std::vector<StoredQuestion> ofTrial(const std::string& trialId) const;
  /// What waits first, oldest first; then what was answered, newest first.
  [[nodiscard]] std::vector<StoredQuestion> toRater(const std::string& raterId) const;
  /// Whom this person asked last; empty: nobody yet.
  [[nodiscard]] std::string lastAsked(const std::string& personId) const;
  /// Whether the trial is or was given to raters to be scored, or is their reference: then names are kept
  /// out.
  [[nodiscard]] bool isScored(const std::string& trialId) const;

 private:
  [[nodiscard]] std::vector<StoredQuestion> read(const std::string& condition,
                                                 const std::string& value) const;
  Connection& connection_;
};

}  // namespace torsio
