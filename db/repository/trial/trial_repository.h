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

/// Recorded trials. Append-only: header at begin(), one row per chunk, a closing row at finish(); each is on
/// disk when the call returns. A trial without a closing row is running or was interrupted. Storing the same
/// content twice is no error (a retry after a lost answer); an existing id with other content throws DbError
/// (kUnique).
class TrialRepository final : public TrialSink {
 public:
  explicit TrialRepository(Connection& connection, TrialContext context = {})
      : connection_(connection), context_(std::move(context)) {}

  /// Applies to trials begun from now on.
  void setContext(TrialContext context) { context_ = std::move(context); }

  /// Throws Error (kBadData) if no trainee has the header's code, DbError.
  void begin(const TrialHeader& header) override;
  /// Continues a trial that was begun over another connection. Writes nothing.
  void resume(const TrialId& trialId);
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

  [[nodiscard]] std::vector<TrialListing> list(const TrialFilter& filter = {});
  [[nodiscard]] std::optional<TrialHeader> find(const TrialId& trialId) const;
  /// List entry of one trial; empty: no such trial.
  [[nodiscard]] std::optional<TrialListing> listing(const TrialId& trialId) const;
  /// Where and for what purpose a trial was recorded; empty: no such trial.
  [[nodiscard]] std::optional<TrialContext> context(const TrialId& trialId) const;
  /// Loads header, all chunks and summary. The summary of an unfinished trial is computed from its chunks,
  /// without content hash, with outcome kInterrupted. Throws Error (kBadData) if the trial does not exist.
  [[nodiscard]] Trial load(const TrialId& trialId) const;

  /// Starts of the trials of a cohort, microseconds since 1970 UTC.
  [[nodiscard]] std::map<TrialId, std::int64_t> startsOf(const CohortId& cohortId) const;

  /// Model parameters of a cohort's trials whose organ was accepted with a warning, or where something was
  /// confirmed at their import, without duplicates.
  [[nodiscard]] std::vector<std::string> warnedParameters(const CohortId& cohortId) const;

  /// Trials of `station` without a closing row: at program start, the interrupted ones. Oldest first.
  [[nodiscard]] std::vector<TrialListing> unfinished(const std::string& station) const;
  /// Closes trials of `station` without a heartbeat since `quietSinceUtc_us` (another window of the same
  /// machine may be recording), with the content hash of what was stored. Returns them with their summaries.
  std::vector<TrialListing> closeInterrupted(const std::string& station, std::int64_t quietSinceUtc_us);

  /// Stores a trial that was recorded to a file while the database was unavailable, in one transaction; parts
  /// already in the database are kept. Throws Error (kVerifyFailed) if the file is corrupt, DbError (kUnique)
  /// if the database has the trial with other content, for example closed as interrupted.
  void import(const Trial& trial);

 private:
  void insertTrial(const TrialHeader& header, bool sameContext);
  void end(const TrialId& trialId, const std::string& station, const TrialSummary& summary);

  Connection& connection_;
  TrialContext context_;
  std::string current_;  ///< the trial between begin() and finish()
};

/// A TrialSink with its own connection, opened in the thread that first calls begin(), usually the
/// recorder's. A
/// lost connection is reopened and the failed write repeated; a server that stays away is reported as DbError
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
  TrialId trialId_;  ///< set by begin()
  std::unique_ptr<Open> open_;
};

/// Loads whole trials with statements prepared once. Confined to its connection's thread; the connection must
/// outlive it.
class TrialLoader {
 public:
  /// Maximum number of trials per statement.
  static constexpr std::size_t kAtOnce = 64;

  explicit TrialLoader(Connection& connection);
  /// See TrialRepository::load().
  [[nodiscard]] Trial load(const TrialId& trialId);
  /// Loads up to kAtOnce different trials, in the given order of ids.
  [[nodiscard]] std::vector<Trial> load(std::span<const TrialId> trialIds);

 private:
  /// Statements for a given number of trials.
  struct Statements {
    Statements(Connection& connection, std::size_t trials);
    /// Returns those that exist.
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
