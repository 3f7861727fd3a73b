// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"
#include "sim/record/trial.h"

namespace torsio {

class Connection;

/// Where recordings wait that their database did not take: in the user's data folder, made when the first one
/// comes. Needs a QCoreApplication.
[[nodiscard]] std::filesystem::path unstoredFolder();

/// Makes the place where a recording goes, whoever makes it: a sink with a connection of its own to the
/// database at `locator`, for the recorder's thread. When the database stays away the recorder writes a file
/// into `folder`, and the file knows its database and `context` (RecordingSpec::context) for the later
/// import.
[[nodiscard]] std::unique_ptr<TrialSink> recordingSink(
    const std::string& locator, const TrialContext& context,
    const std::filesystem::path& folder = unstoredFolder());

/// A recording in a file that belongs to one database.
struct UnstoredTrial {
  std::filesystem::path file;
  Trial trial;
  TrialContext context;
};

/// What waits for a database.
struct UnstoredTrials {
  std::vector<UnstoredTrial> trials{};
  std::vector<Text> unreadable{};  ///< one sentence a file
};

/// A file without its end that has grown since then belongs to a recorder at work.
inline constexpr std::int64_t kQuietFile_us = 10'000'000;

/// Reads the files of `folder` that wait for the database at `locator`, oldest recording first; those of
/// other databases are passed over. Files that were cut off are read as far as they go, as interrupted
/// trials, unless they were written to in the last kQuietFile_us. A missing folder is an empty one.
[[nodiscard]] UnstoredTrials unstoredTrials(const std::string& locator, const std::filesystem::path& folder);

/// The database of this station when none is named: torsio.sqlite in the user's data folder, which is made
/// when missing. Needs a QCoreApplication (its name decides the folder). Throws Error{kFileUnwritable}.
[[nodiscard]] std::string defaultDatabase();

/// Recorded trials of one database, for the window. Belongs to the thread that made it.
class TrialStore {
 public:
  /// Opens or makes the database and brings its schema up to date. Throws Error, DbError.
  explicit TrialStore(const std::string& locator);
  ~TrialStore();

  /// Newest first, finished or not.
  [[nodiscard]] std::vector<TrialListing> list();
  [[nodiscard]] Trial load(const TrialId& trialId);
  /// Where it is, for people; never a password.
  [[nodiscard]] const std::string& location() const noexcept;

 private:
  std::unique_ptr<Connection> connection_;
};

}  // namespace torsio
