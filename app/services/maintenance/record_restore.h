// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/access/two_people.h"
#include "app/services/base/progress.h"
#include "db/migrations/backup.h"
#include "sim/core/text.h"

namespace torsio {

class FileInTheMaking;
struct Maintainer;

/// Amount of data in a record.
struct RecordExtent {
  std::int64_t people = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;         ///< of training and evaluations, all versions
  std::int64_t newestUtc_us = 0;  ///< of the latest recording or mark; 0: none
};

/// Effect of a restore, shown before anything is done.
struct RestorePlan {
  std::filesystem::path backup{};
  std::string backupHash{};     ///< of the file's bytes: identifies what two people agree on
  RecordExtent present{};       ///< the current record
  RecordExtent restored{};      ///< the backup
  std::int64_t lostPeople = 0;  ///< in the current record but not in the backup
  std::int64_t lostTrials = 0;
  std::int64_t lostMarks = 0;
  std::string presentCentre{};    ///< name of the record's centre
  std::string backupCentre{};     ///< name of the backup's centre
  bool otherCentre = false;       ///< the backup belongs to another centre, even if it has the same name
  bool otherCentreMeant = false;  ///< whoever restores has said so; see prepareRestore()
  std::int64_t erasedSince = 0;   ///< people of the backup who were erased later; they stay erased
};

/// Reads the whole backup in a separate copy and compares it with the record, without changing anything.
/// kDatabaseRestore. Throws Error: kUsage if the record is not a file (servers have their own tools),
/// kDatabase while others work on the record, kVerifyFailed and others if the backup is damaged; what
/// `progress` throws.
[[nodiscard]] RestorePlan planRestore(SessionContext& session, const std::filesystem::path& backup,
                                      const ProgressCallback& progress = {});

/// Returns what a second person is asked for: the file, and both centres if it belongs to another one.
[[nodiscard]] DutyWish wishFor(const RestorePlan& plan, const std::string& reason);

/// Returns whether prepareRestore() can proceed: somebody else has requested this restore, or nobody needs
/// to. kDatabaseRestore.
[[nodiscard]] bool mayRestoreNow(SessionContext& session, const RestorePlan& plan);

/// A restored copy next to the record, ready to replace it. The destructor removes it unless it has replaced
/// the record.
class PreparedRestore {
 public:
  PreparedRestore(const std::filesystem::path& target, std::filesystem::path safety);
  PreparedRestore(const PreparedRestore&) = delete;
  PreparedRestore& operator=(const PreparedRestore&) = delete;
  ~PreparedRestore();

  /// Returns the path of the restored copy.
  [[nodiscard]] const std::filesystem::path& ready() const noexcept;
  /// Replaces the record, keeping the old one as "<record>.before-restore-N". Quick. All connections to the
  /// record must be closed. Returns the old record's new path. Throws Error: kDatabase if somebody has it
  /// open, kFileUnwritable; then the record is unchanged.
  std::filesystem::path takeOver();
  /// Returns the backup of the record as it was before.
  [[nodiscard]] const std::filesystem::path& safety() const noexcept { return safety_; }

 private:
  std::unique_ptr<FileInTheMaking> ready_;
  std::filesystem::path target_;
  std::filesystem::path safety_;
};

/// Backs up the current record, checked, next to it with the date in its name; then creates a checked copy of
/// the planned backup with its schema migrated, in which people erased since then stay erased, and whose
/// audit trail contains the restore, who did it and what was lost. The record itself only gets an audit entry
/// until takeOver(). kDatabaseRestore. Throws Error{kUsage} for the backup of another centre unless
/// `plan.otherCentreMeant`, {kPermission} if the owner of the file alone means it although the centre wants
/// two people or has an administrator, SecondPersonNeeded (subject: the backup's hash) if nobody else has
/// requested this restore, what planRestore() throws, and kFileUnwritable if there is not enough space; then
/// at most the finished safety backup remains.
[[nodiscard]] std::shared_ptr<PreparedRestore> prepareRestore(SessionContext& session,
                                                              const RestorePlan& plan,
                                                              const ProgressCallback& progress = {});

/// Result of a restore without the window.
struct Restored {
  BackupContent content{};
  std::filesystem::path before{};     ///< the previous record; empty: there was none
  std::optional<RestorePlan> plan{};  ///< what was lost; empty if there was no record to compare with
  std::string unreadable{};           ///< why the previous record could not be compared; empty: it could
};

/// Replaces the record at `locator` by a sound backup, with planRestore(), prepareRestore() and takeOver().
/// If the record cannot be read, `maintainer` signs in to the backup, and later erasures are unknown. Throws
/// Error: kUsage for a server address, kPermission, and what those throw; nothing is changed then.
Restored restoreRecord(const Maintainer& maintainer, const std::filesystem::path& backup,
                       const std::string& locator, bool otherCentreMeant = false);

/// Audits in the restored record that it was restored from `backup` without a record to compare with.
/// kDatabaseRestore.
void noteRestore(SessionContext& session, const std::filesystem::path& backup);

/// Returns one sentence for each current activity of others on this record: runs in progress (also at this
/// station) and other stations with a heartbeat within kStationSilence_us. kDatabaseRestore.
[[nodiscard]] std::vector<Text> othersAtWork(SessionContext& session);

/// Call before a record is replaced or moved. kDatabaseRestore. Throws Error (kDatabase) with the first of
/// othersAtWork().
void requireNobodyAtWork(SessionContext& session);

}  // namespace torsio
