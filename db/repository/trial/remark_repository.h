// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring/instrument.h"
#include "db/connection/connection.h"

namespace torsio {

/// What somebody wrote at a time of a trial. Append-only.
struct StoredRemark {
  std::string id{};
  std::string trialId{};
  std::string author{};          ///< who: id of a user, or of a person who has none
  std::string authorPersonId{};  ///< the person behind; empty: a user without one
  std::string purpose{};         ///< "bookmark" (one's own), "remark" (an expert's), "reply"
  std::string replyTo{};         ///< the remark that a reply answers; empty else
  std::int64_t tick = 0;
  std::int64_t time_us = 0;  ///< since the first tick
  std::string text{};        ///< empty: a mere mark, or erased with its author or trainee
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Receipt: somebody has read a remark, and when first.
struct StoredReceipt {
  std::string remarkId{};
  std::string reader{};          ///< as StoredRemark::author
  std::string readerPersonId{};  ///< empty: a user without a person
  std::int64_t readUtc_us = 0;
};

/// One row of a trainee's own sheet.
struct StoredSelfScoreRow {
  std::string rubricRevisionId{};
  std::string rowCode{};
  std::int64_t score_steps = 0;
  friend bool operator==(const StoredSelfScoreRow&, const StoredSelfScoreRow&) = default;
};

/// How a trainee judges a trial of their own. Append-only: a change of mind is the next version.
struct StoredSelfScore {
  std::string id{};
  std::string trialId{};
  std::string traineeId{};
  std::int64_t version = 1;        ///< 1, 2, 3 ... of this trial and trainee
  std::string rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  std::vector<StoredSelfScoreRow> rows{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// A rater's score of a reference trial before the real ones. Append-only.
struct StoredWarmup {
  std::string id{};
  std::string raterId{};
  std::string referenceTrialId{};
  std::string rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  double panelOffset_steps = 0.0;  ///< rater minus panel
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Bookmarks, remarks and replies at times of a trial, who has read them; self-scores and warm-ups. One call,
/// one transaction. Whatever is added twice with the same content is stored once; the same id with other
/// content is refused with DbError (kUnique).
class RemarkRepository {
 public:
  explicit RemarkRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError: kForeignKey when the trial or the remark that is answered does not exist, kCheck when
  /// only one of purpose "reply" and replyTo is given.
  void add(const StoredRemark& remark);
  [[nodiscard]] std::optional<StoredRemark> find(const std::string& remarkId) const;
  /// By time in the trial, then by when they were written.
  [[nodiscard]] std::vector<StoredRemark> remarks(const std::string& trialId) const;
  /// The first reading counts; later ones change nothing.
  void markRead(const StoredReceipt& receipt);
  [[nodiscard]] std::vector<StoredReceipt> receipts(const std::string& trialId) const;
  /// Remarks and replies of others on this trainee's trials that `reader` has not read, oldest first.
  [[nodiscard]] std::vector<StoredRemark> unreadOnTrialsOf(const std::string& traineeId,
                                                           const std::string& reader) const;
  /// Replies of others to remarks of `author` that `author` has not read, oldest first.
  [[nodiscard]] std::vector<StoredRemark> unreadReplies(const std::string& author) const;

  void addSelfScore(const StoredSelfScore& score);
  /// All versions for a trial, oldest first.
  [[nodiscard]] std::vector<StoredSelfScore> selfScores(const std::string& trialId) const;

  void addWarmup(const StoredWarmup& warmup);
  /// Of one rater, oldest first.
  [[nodiscard]] std::vector<StoredWarmup> warmups(const std::string& raterId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
