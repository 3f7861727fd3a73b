// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"
#include "sim/record/trial.h"

namespace torsio {

class Connection;

/// Returns the folder for recordings that could not be stored, in the user's data folder; created with the
/// first one. Needs a QCoreApplication.
[[nodiscard]] std::filesystem::path unstoredFolder();

/// Creates the sink of any recording: with its own connection to the database at `locator`, for the
/// recorder's thread. If the database stays unreachable, the recorder writes a file into `folder`, which
/// identifies its database and `context` (RecordingSpec::context) for the later import.
[[nodiscard]] std::unique_ptr<TrialSink> recordingSink(
    const std::string& locator, const TrialContext& context,
    const std::filesystem::path& folder = unstoredFolder());

/// A recording in a file, for one database.
struct UnstoredTrial {
  std::filesystem::path file;
  Trial trial;
  TrialContext context;
};

/// Recordings waiting for a database.
struct UnstoredTrials {
  std::vector<UnstoredTrial> trials{};
  std::vector<Text> unreadable{};  ///< one sentence per file
};

/// A file without an end that was written to within this time belongs to an active recorder.
inline constexpr std::int64_t kQuietFile_us = 10'000'000;

/// Reads the files of `folder` for the database at `locator`, oldest recording first; skips those of other
/// databases. Reads truncated files as far as possible, as interrupted trials, unless they were written to
/// within the last kQuietFile_us. A missing folder counts as empty.
[[nodiscard]] UnstoredTrials unstoredTrials(const std::string& locator, const std::filesystem::path& folder);

/// Recorded trials of one database, for the window. Belongs to the thread that created it.
class TrialStore {
 public:
  /// Opens or creates the database and migrates its schema. Throws Error, DbError.
  explicit TrialStore(const std::string& locator);
  ~TrialStore();

  /// Returns all trials, latest first, finished or not.
  [[nodiscard]] std::vector<TrialListing> list();
  [[nodiscard]] Trial load(const TrialId& trialId);
  /// Returns its location for display, without a password.
  [[nodiscard]] const std::string& location() const noexcept;

 private:
  std::unique_ptr<Connection> connection_;
};

/// The recorder's ring holds eight seconds, enough for two calls of this length.
inline constexpr std::chrono::milliseconds kSinkPatience{3'500};

/// A sink whose calls return within `patience`: each call runs in the sink's own thread. If one takes longer,
/// it is abandoned, and this and all further calls throw DbError{kUnreachable}; the recorder then keeps the
/// trial in a file, at `place`. For servers that hang, which no connection time-out detects.
class TimedTrialSink final : public SpillingTrialSink {
 public:
  explicit TimedTrialSink(std::unique_ptr<TrialSink> sink, SpillPlace place = {},
                          std::chrono::milliseconds patience = kSinkPatience);
  ~TimedTrialSink() override;
  TimedTrialSink(const TimedTrialSink&) = delete;
  TimedTrialSink& operator=(const TimedTrialSink&) = delete;

  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;
  [[nodiscard]] SpillPlace spillPlace() const override { return place_; }

 private:
  struct State;
  using Call = std::function<void(TrialSink&)>;
  void call(Call call);
  static void run(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  std::thread thread_;  // from the first call
  SpillPlace place_;
  std::chrono::milliseconds patience_;
  bool lost_ = false;
};

}  // namespace torsio
