// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "db/migrations/backup.h"
#include "sim/core/text.h"

namespace torsio {

class FileInTheMaking;
struct Maintainer;

/// How much a record holds.
struct RecordExtent {
  std::int64_t people = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;         ///< of training and of evaluations, every version
  std::int64_t newestUtc_us = 0;  ///< of a recording or mark; 0: there is none
};

/// What a restore would do, told before anything is done.
struct RestorePlan {
  std::filesystem::path backup{};
  std::string backupHash{};     ///< of the file's bytes: what two people agree about
  RecordExtent present{};       ///< the record as it is now
  RecordExtent restored{};      ///< as the backup has it
  std::int64_t lostPeople = 0;  ///< in the present record, but not in the backup
  std::int64_t lostTrials = 0;
  std::int64_t lostMarks = 0;
  std::string presentCentre{};   ///< whose record it is
  std::string backupCentre{};    ///< whose record the backup is
  bool otherCentre = false;      ///< the backup is not of this centre, whatever it is called
  std::int64_t erasedSince = 0;  ///< people of the backup who were erased later: they stay erased
};

/// Reads the backup from end to end in a copy of its own, and compares it with the record. Changes nothing.
/// kDatabaseRestore. Throws Error: kUsage when the record is no file (a server has its own tools), kDatabase
/// while others work at the record, kVerifyFailed and others when the backup is not sound; whatever
/// `progress` throws.
[[nodiscard]] RestorePlan planRestore(SessionContext& session, const std::filesystem::path& backup,
                                      const ProgressCallback& progress = {});

/// Whether prepareRestore() would go on: somebody else has asked for this restore, or nobody needs to.
/// kDatabaseRestore.
[[nodiscard]] bool mayRestoreNow(SessionContext& session, const RestorePlan& plan);

/// A backup that stands ready beside the record. Removes itself unless it has taken the record's place.
class PreparedRestore {
 public:
  PreparedRestore(const std::filesystem::path& target, std::filesystem::path safety);
  PreparedRestore(const PreparedRestore&) = delete;
  PreparedRestore& operator=(const PreparedRestore&) = delete;
  ~PreparedRestore();

  /// Where the restored record is being made.
  [[nodiscard]] const std::filesystem::path& ready() const noexcept;
  /// Takes the place of the record; what was there is kept as "<record>.before-restore-N" besides. Quick.
  /// Every connection to the record must be closed. Throws Error: kDatabase when somebody has it open,
  /// kFileUnwritable; then the record is as before.
  /// Returns that name.
  std::filesystem::path takeOver();
  /// The backup that was made of the record as it was.
  [[nodiscard]] const std::filesystem::path& safety() const noexcept { return safety_; }

 private:
  std::unique_ptr<FileInTheMaking> ready_;
  std::filesystem::path target_;
  std::filesystem::path safety_;
};

/// Makes a backup of the record as it is now, checked, with its date in the name, beside the record; then a
/// checked copy of the planned backup, brought up to date, in which those who were erased since stay erased,
/// and whose audit trail tells of the restore, who did it and what was lost. The record itself gets an audit
/// entry and is else unchanged until takeOver(). kDatabaseRestore. Throws SecondPersonNeeded (subject: the
/// hash of the backup) where nobody else has asked for this restore, as planRestore does, and kFileUnwritable
/// when there is not enough room; then nothing is left but the finished safety backup, if any.
[[nodiscard]] std::shared_ptr<PreparedRestore> prepareRestore(SessionContext& session,
                                                              const RestorePlan& plan,
                                                              const ProgressCallback& progress = {});

/// What a restore without the window did.
struct Restored {
  BackupContent content{};
  std::filesystem::path before{};     ///< the record as it was; empty: there was none
  std::optional<RestorePlan> plan{};  ///< what was lost; none when there was no record to compare with
  std::string unreadable{};           ///< why what was there could not be compared; empty: it could
};

/// Puts a sound backup in the place of the record at `locator`, as planRestore, prepareRestore and takeOver
/// do. Where no record can be read, `maintainer` signs in to the backup, and it cannot be known who was
/// erased since. Throws Error: kUsage for an address of a server, kPermission, and what those throw; nothing
/// is changed then.
Restored restoreRecord(const Maintainer& maintainer, const std::filesystem::path& backup,
                       const std::string& locator);

/// Tells in the restored record that it was restored from `backup`, without a record to compare it with.
/// kDatabaseRestore.
void noteRestore(SessionContext& session, const std::filesystem::path& backup);

/// Who else works at this record now, one plain sentence each: runs that go on, at this station too, and
/// other stations that sent a heartbeat in the last kStationSilence_us. kDatabaseRestore.
[[nodiscard]] std::vector<Text> othersAtWork(SessionContext& session);

/// Before a record is replaced or moved. kDatabaseRestore. Throws Error (kDatabase) with the first of
/// othersAtWork.
void requireNobodyAtWork(SessionContext& session);

}  // namespace torsio
