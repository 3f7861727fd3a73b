// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "db/connection/connection.h"
#include "sim/record/trial.h"

namespace torsio {

/// Recorded trials. Append-only: header at begin(), one row a chunk, a closing row at finish(); each is on
/// the disk when the call returns. A trial without its closing row is running or was interrupted.
/// Whatever is given twice is stored once: a retry after a lost answer succeeds. The same id with other
/// content is refused with DbError (kUnique).
class TrialRepository final : public TrialSink {
 public:
  explicit TrialRepository(Connection& connection, TrialContext context = {})
      : connection_(connection), context_(std::move(context)) {}

  /// For the trials begun from now on.
  void setContext(TrialContext context) { context_ = std::move(context); }

  /// Throws Error (kBadData) when no trainee has the header's code, DbError.
  void begin(const TrialHeader& header) override;
  /// Goes on with a trial that was begun over another connection. Touches no row.
  void resume(const TrialId& trialId);
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

  [[nodiscard]] std::vector<TrialListing> list(const TrialFilter& filter = {});
  [[nodiscard]] std::optional<TrialHeader> find(const TrialId& trialId) const;
  /// The line of one trial in a list; empty: no such trial.
  [[nodiscard]] std::optional<TrialListing> listing(const TrialId& trialId) const;
  /// Where and for what a trial was recorded; empty: no such trial.
  [[nodiscard]] std::optional<TrialContext> context(const TrialId& trialId) const;
  /// Header, all chunks and the summary; an unfinished trial has a summary counted from its chunks, without
  /// content hash, with the outcome kInterrupted. Throws Error (kBadData) when there is no such trial.
  [[nodiscard]] Trial load(const TrialId& trialId) const;

  /// When each trial of a cohort began, microseconds since 1970 UTC.
  [[nodiscard]] std::map<TrialId, std::int64_t> startsOf(const CohortId& cohortId) const;

  /// Parameters of the models of a cohort's trials whose organ was accepted with a warning, each once.
  [[nodiscard]] std::vector<std::string> warnedParameters(const CohortId& cohortId) const;

  /// Trials of `station` without a closing row: at program start, the interrupted ones. Oldest first.
  [[nodiscard]] std::vector<TrialListing> unfinished(const std::string& station) const;
  /// Closes those of `station` that have sent no heartbeat after `quietSinceUtc_us` (another window of
  /// the same machine may be recording), with the content hash of what is there. Returns them with their
  /// summaries.
  std::vector<TrialListing> closeInterrupted(const std::string& station, std::int64_t quietSinceUtc_us);

  /// Stores a trial that went to a file because the database was away, in one transaction; what of it the
  /// database has already is left as it is. Throws Error (kVerifyFailed) when the file is not what was
  /// recorded, DbError (kUnique) when the database has the trial with other content: for one, because it was
  /// closed as interrupted meanwhile.
  void import(const Trial& trial);

 private:
  void insertTrial(const TrialHeader& header, bool sameContext);
  void end(const TrialId& trialId, const std::string& station, const TrialSummary& summary);

  Connection& connection_;
  TrialContext context_;
  std::string current_;  ///< the trial between begin() and finish()
};

/// A TrialSink with a connection of its own, opened in the thread that first calls begin(): for the
/// recorder's thread, since a Connection belongs to the thread that opened it. A connection that was lost is
/// opened again, and what was being stored is stored again; a server that stays away is reported with DbError
/// (kUnreachable) after seconds, while the recorder's ring still has room. May be destroyed in any thread.
class OwnConnectionTrialSink final : public TrialSink {
 public:
  OwnConnectionTrialSink(std::string locator, TrialContext context);
  ~OwnConnectionTrialSink() override;

  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

 private:
  struct Open;
  void store(const std::function<void(TrialRepository&)>& act);
  void open();

  std::string locator_;
  TrialContext context_;
  TrialId trialId_;  ///< once begun
  std::unique_ptr<Open> open_;
};

/// Reads whole trials with statements that are compiled once. Belongs to the thread of its connection, which
/// outlives it.
class TrialLoader {
 public:
  /// That many trials are read by one statement at most.
  static constexpr std::size_t kAtOnce = 64;

  explicit TrialLoader(Connection& connection);
  /// As TrialRepository::load().
  [[nodiscard]] Trial load(const TrialId& trialId);
  /// The same for up to kAtOnce different trials, in the order of their ids here.
  [[nodiscard]] std::vector<Trial> load(std::span<const TrialId> trialIds);

 private:
  /// For one number of trials.
  struct Statements {
    Statements(Connection& connection, std::size_t trials);
    /// What there is of them.
    [[nodiscard]] std::map<TrialId, Trial> read(std::span<const Value> ids);

    Statement headers;
    Statement chunks;
    Statement closings;
  };

  Connection& connection_;
  Statements one_;
  std::optional<Statements> many_{};
};

}  // namespace torsio
