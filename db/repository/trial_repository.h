// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "sim/record/trial.h"

namespace torsio {

/// What the database adds to a trial's header.
struct TrialContext {
  std::string station{};      ///< which machine records: it alone may close its interrupted trials
  std::string enrolmentId{};  ///< the cohort for which the trial counts; empty for free practice
};

/// Something that happened in a trial. Appended beside the samples, never changed.
struct StoredTrialEvent {
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... within the trial
  std::int64_t tick = 0;
  std::int64_t time_us = 0;  ///< since the first tick
  std::string kind{};        ///< "contact", "twisting", "released", "bookmark", "limit" ...
  std::string label{};
  std::optional<double> value{};
};

/// One line of a list of trials.
struct TrialListing {
  std::string trialId{};
  std::string traineeCode{};  ///< empty: nobody (free practice)
  std::string enrolmentId{};
  std::string station{};
  std::string sceneId{};
  std::string patternId{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;
  std::optional<TrialSummary> summary{};  ///< empty: running, or interrupted and not closed yet
};

/// Which trials to list, newest first. Empty texts do not restrict.
struct TrialFilter {
  std::string traineeCode{};
  std::string enrolmentId{};
  std::string sceneId{};
  std::int64_t limit = 200;
  std::int64_t offset = 0;
};

/// Recorded trials. Append-only: header at begin(), one row a chunk, a closing row at finish(); each is on
/// the disk when the call returns. A trial without its closing row is running or was interrupted.
class TrialRepository final : public TrialSink {
 public:
  explicit TrialRepository(Connection& connection, TrialContext context = {})
      : connection_(connection), context_(std::move(context)) {}

  /// For the trials begun from now on.
  void setContext(TrialContext context) { context_ = std::move(context); }

  /// Throws Error (kBadData) when no trainee has the header's code, DbError.
  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

  void addEvents(const std::string& trialId, std::span<const StoredTrialEvent> events);
  [[nodiscard]] std::vector<StoredTrialEvent> events(const std::string& trialId);

  [[nodiscard]] std::vector<TrialListing> list(const TrialFilter& filter = {});
  [[nodiscard]] std::optional<TrialHeader> find(const std::string& trialId);
  /// Header, all chunks and the summary; an unfinished trial has a summary counted from its chunks, without
  /// content hash, with the outcome kInterrupted. Throws Error (kBadData) when there is no such trial.
  [[nodiscard]] Trial load(const std::string& trialId);

  /// Trials of `station` without a closing row: at program start, the interrupted ones. Oldest first.
  [[nodiscard]] std::vector<TrialListing> unfinished(const std::string& station);
  /// Closes those of `station` that have shown no sign of life after `quietSinceUtc_us` (another window of
  /// the same machine may be recording), with the content hash of what is there. Returns them with their
  /// summaries.
  std::vector<TrialListing> closeInterrupted(const std::string& station, std::int64_t quietSinceUtc_us);

  /// Stores a trial that went to a file because the database was away, in one transaction. Throws Error
  /// (kVerifyFailed) when the file is not what was recorded.
  void import(const Trial& trial);

 private:
  void end(const std::string& trialId, const std::string& station, const TrialSummary& summary);

  Connection& connection_;
  TrialContext context_;
  std::string current_;  ///< the trial between begin() and finish()
};

/// A TrialSink with a connection of its own, opened in the thread that first calls begin(): for the
/// recorder's thread, since a Connection belongs to the thread that opened it. May be destroyed in any
/// thread.
class OwnConnectionTrialSink final : public TrialSink {
 public:
  OwnConnectionTrialSink(std::string locator, TrialContext context);
  ~OwnConnectionTrialSink() override;

  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

 private:
  struct Open;
  std::string locator_;
  TrialContext context_;
  std::unique_ptr<Open> open_;
};

}  // namespace torsio
