// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/record_restore.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <QDateTime>
#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/base/build_info.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/copy_register.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kSpareRoom_bytes = 64ULL << 20;  // for the copy's write-ahead log, plus a margin

void requireFile(SessionContext& session) {
  if (session.connection().engine() == Engine::kSqlite) {
    return;
  }
  throw Error(ErrorCode::kUsage,
              Text::tr("this record is on a database server, which restores its own backups"),
              session.connection().location(), Text::tr("Use pg_restore on the server"));
}

std::set<std::string> idsOf(Connection& connection, const std::string& table) {
  std::set<std::string> ids;
  Statement row = connection.prepare("SELECT id FROM " + table);
  row.execute();
  while (row.step()) {
    ids.insert(row.text(0));
  }
  return ids;
}

std::int64_t missing(const std::set<std::string>& from, const std::set<std::string>& in) {
  return std::count_if(from.begin(), from.end(), [&](const std::string& id) { return !in.contains(id); });
}

std::int64_t newest(Connection& connection) {
  std::int64_t newest_us = 0;
  for (const char* sql :
       {"SELECT max(started_utc_us) FROM trial", "SELECT max(submitted_utc_us) FROM training_mark",
        "SELECT max(submitted_utc_us) FROM evaluation_mark"}) {
    Statement row = connection.prepare(sql);
    row.execute();
    while (row.step()) {
      newest_us = std::max(newest_us, row.int64(0));
    }
  }
  return newest_us;
}

/// Basis for comparing two records.
struct Contents {
  explicit Contents(Connection& connection)
      : people(idsOf(connection, "person")),
        trials(idsOf(connection, "trial")),
        marks(idsOf(connection, "training_mark")),
        newest_us(newest(connection)) {
    marks.merge(idsOf(connection, "evaluation_mark"));
  }
  [[nodiscard]] RecordExtent extent() const {
    return {std::ssize(people), std::ssize(trials), std::ssize(marks), newest_us};
  }

  std::set<std::string> people;
  std::set<std::string> trials;
  std::set<std::string> marks;
  std::int64_t newest_us;
};

struct Erasure {
  PersonId personId;
  std::string requestedBy;
  std::string reason;
  std::int64_t erasedUtc_us = 0;
};

/// Returns people erased in the present record but still complete in the older one.
std::vector<Erasure> erasedSince(Connection& present, Connection& older) {
  std::set<std::string> already;
  Statement there = older.prepare("SELECT person_id FROM erasure");
  there.execute();
  while (there.step()) {
    already.insert(there.text(0));
  }
  const std::set<std::string> people = idsOf(older, "person");
  std::vector<Erasure> out;
  Statement row = present.prepare("SELECT person_id, requested_by, reason, erased_utc_us FROM erasure");
  row.execute();
  while (row.step()) {
    if (people.contains(row.text(0)) && !already.contains(row.text(0))) {
      out.push_back({row.text(0), row.text(1), row.text(2), row.int64(3)});
    }
  }
  return out;
}

/// Returns id and name of the record's centre; empty if it has none yet.
std::pair<std::string, std::string> centreOf(Connection& connection) {
  Statement row = connection.prepare("SELECT id, name FROM centre");
  row.execute();
  return row.step() ? std::pair(row.text(0), row.text(1)) : std::pair<std::string, std::string>();
}

/// Returns "record-before-restore-20261121T143000Z.sqlite", next to the record.
fs::path safetyName(const fs::path& record, std::int64_t now_us) {
  const QString when =
      QDateTime::fromMSecsSinceEpoch(now_us / 1000, Qt::UTC).toString(QStringLiteral("yyyyMMddTHHmmssZ"));
  return freeName(record.parent_path() / (record.stem().string() + "-before-restore-" + when.toStdString() +
                                          record.extension().string()));
}

void requireRoom(const fs::path& record, const fs::path& backup) {
  std::error_code failed;
  const fs::path folder = fs::absolute(record).parent_path();
  const fs::space_info space = fs::space(folder, failed);
  if (failed) {
    return;  // writing will report the problem
  }
  if (!fs::exists(backup)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("the backup is not there any more"), backup.string(),
                Text::tr("Choose the backup again"));
  }
  const std::uintmax_t needed = fs::file_size(record) + fs::file_size(backup) + kSpareRoom_bytes;
  if (space.available >= needed) {
    return;
  }
  throw Error(
      ErrorCode::kFileUnwritable,
      Text::tr("there is not enough room for a safety backup and the restored record: %1 MiB are needed, "
               "%2 MiB are "
               "free",
               needed >> 20, space.available >> 20),
      folder.string(), Text::tr("Free some space on this disk"));
}

std::string hashOfFile(const fs::path& file) {
  constexpr std::size_t kPiece_bytes = 1 << 20;
  std::ifstream in(file, std::ios::binary);
  Digest digest;
  for (std::vector<char> piece(kPiece_bytes); in;) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    digest.update(std::string_view(piece.data(), static_cast<std::size_t>(in.gcount())));
  }
  return digest.hex();
}

constexpr const char* kReasonOfCommand = "restore from the command line";

void requireSoundBackup(const BackupCheck& check, const fs::path& backup) {
  if (!check.database.sound()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("the backup is not sound, so nothing was restored"),
                backup.string(), Text::tr("Choose an older backup"));
  }
}

/// Opens the current record at `file`. Empty if it cannot be opened, with the reason in `unreadable` if there
/// is one.
std::optional<Connection> presentRecord(const std::string& file, std::string& unreadable) {
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  (void)checkpointSqlite(file);  // throws while another program has it open
  try {
    return openRecord(file, OpenMode::kReadWrite);
  } catch (const Error& error) {
    unreadable = error.what();
    return std::nullopt;
  }
}

/// Adds who requested and who carried it out, if two people were needed: the requests are in the record being
/// replaced.
nlohmann::json withPeople(nlohmann::json what, const SessionContext& session, const UserId& askedBy) {
  if (!askedBy.empty()) {
    what["asked_by"] = askedBy.text();
    what["confirmed_by"] = session.actor().userId.text();
  }
  return what;
}

/// Adds an audit entry to the trail of `connection`.
void tell(SessionContext& session, Connection& connection, AuditAction action, const RestorePlan& plan,
          const fs::path& safety, const UserId& askedBy) {
  SessionKey key = session.key();
  const SessionContext there(connection, session.ids(), key, [&session] { return session.now_us(); });
  there.note(action, AuditObject::kDatabase, plan.backup.filename().string(),
             withPeople({{"trials", plan.restored.trials},
                         {"marks", plan.restored.marks},
                         {"lost_trials", plan.lostTrials},
                         {"lost_marks", plan.lostMarks},
                         {"safety_backup", safety.filename().string()}},
                        session, askedBy));
}

/// Transfers the register of later copies, which also contain people of the older record; omits copies of
/// people whom it does not have.
void transferCopyRegister(Connection& present, Connection& older) {
  const std::set<std::string> known = idsOf(older, "record_copy");
  const std::set<std::string> people = idsOf(older, "person");
  for (const RecordCopy& copy : CopyRegister(present).all()) {
    if (!known.contains(copy.id) && (copy.personId.empty() || people.contains(copy.personId.text()))) {
      CopyRegister(older).add(copy);
    }
  }
}

/// Another centre's record takes two people even if the centre's rule is off, unless the record has no
/// administrator who could ask.
bool alwaysTwo(SessionContext& session, const RestorePlan& plan) {
  if (!plan.otherCentre) {
    return false;
  }
  const std::vector<UserAccount> users = AccessRepository(session.connection()).users();
  return needsTwoPeople(session.connection()) ||
         std::any_of(users.begin(), users.end(), [](const UserAccount& user) {
           return !user.demonstration && isActiveAdministrator(user);
         });
}

/// Throws if another centre's record would replace this one without anybody meaning it, or by the owner of
/// the file alone.
void requireMeant(SessionContext& session, const RestorePlan& plan) {
  session.require(Operation::kDatabaseRestore);
  if (!plan.otherCentre) {
    return;
  }
  if (!plan.otherCentreMeant) {
    throw Error(ErrorCode::kUsage,
                Text::tr("this is the backup of another centre, %1: the record of %2 would be gone from here",
                         plan.backupCentre, plan.presentCentre),
                plan.backup.string(), Text::tr("Give --other-centre if this is meant"));
  }
  if (alwaysTwo(session, plan) && session.actor().userId.empty()) {
    throw Error(ErrorCode::kPermission,
                Text::tr("putting another centre's record in this one's place takes two people"),
                plan.backup.string(),
                Text::tr("Sign in with --login, and a second administrator with --with"));
  }
}

/// Migrates the copy, repeats later erasures and audits the restore.
void updateRestoredCopy(SessionContext& session, const fs::path& ready, const RestorePlan& plan,
                        const fs::path& safety, const UserId& askedBy) {
  Connection copy = openRecord(ready.string(), OpenMode::kReadWrite,
                               {.softwareVersion = softwareVersion(), .backup = false});
  for (const Erasure& erasure : erasedSince(session.connection(), copy)) {
    erasePerson(copy, erasure.personId, erasure.requestedBy, erasure.reason, erasure.erasedUtc_us);
  }
  transferCopyRegister(session.connection(), copy);
  registerCopy(copy, CopyKind::kBeforeRestore, safety, session.now_us());
  registerCopy(copy, CopyKind::kBackup, plan.backup, session.now_us());
  tell(session, copy, AuditAction::kDatabaseRestore, plan, safety, askedBy);
}

}  // namespace

RestorePlan planRestore(SessionContext& session, const fs::path& backup, const ProgressCallback& progress) {
  session.require(Operation::kDatabaseRestore);
  requireFile(session);
  requireNobodyAtWork(session);
  RestorePlan plan;
  plan.backup = backup;
  const Contents present(session.connection());
  plan.present = present.extent();
  const std::pair<std::string, std::string> here = centreOf(session.connection());
  plan.presentCentre = here.second;
  const BackupCheck check = verifyBackup(backup, progress, [&](Connection& copy) {
    const Contents restored(copy);
    plan.restored = restored.extent();
    const std::pair<std::string, std::string> there = centreOf(copy);
    plan.backupCentre = there.second;
    plan.otherCentre = !here.first.empty() && here.first != there.first;
    plan.lostPeople = missing(present.people, restored.people);
    plan.lostTrials = missing(present.trials, restored.trials);
    plan.lostMarks = missing(present.marks, restored.marks);
    plan.erasedSince = std::ssize(erasedSince(session.connection(), copy));
  });
  requireSoundBackup(check, backup);
  plan.backupHash = hashOfFile(backup);
  return plan;
}

DutyWish wishFor(const RestorePlan& plan, const std::string& reason) {
  const std::string centres = plan.otherCentre
                                  ? " \xC2\xB7 " + plan.backupCentre + " \xE2\x86\x92 " + plan.presentCentre
                                  : std::string();
  return {.act = DutyAct::kRestore,
          .subject = plan.backupHash,
          .shown = plan.backup.filename().string() + centres,
          .reason = reason};
}

bool mayRestoreNow(SessionContext& session, const RestorePlan& plan) {
  session.require(Operation::kDatabaseRestore);
  return secondPersonIsThere(session, DutyAct::kRestore, plan.backupHash, alwaysTwo(session, plan));
}

std::shared_ptr<PreparedRestore> prepareRestore(SessionContext& session, const RestorePlan& plan,
                                                const ProgressCallback& progress) {
  session.require(Operation::kDatabaseRestore);
  requireFile(session);
  requireNobodyAtWork(session);
  requireMeant(session, plan);
  const UserId askedBy =
      requireSecondPerson(session, DutyAct::kRestore, plan.backupHash, alwaysTwo(session, plan));
  const fs::path record = linkTarget(session.key().locator);
  requireRoom(record, plan.backup);
  const fs::path safety = safetyName(record, session.now_us());
  tell(session, session.connection(), AuditAction::kDatabaseRestoreBegin, plan, safety, askedBy);
  tellProgress(progress, Text::tr("Backing up the record as it is now"), 0.0);
  backupSqlite(session.connection(), safety);
  (void)checkBackup(safety);

  auto prepared = std::make_shared<PreparedRestore>(record, safety);
  const fs::path& ready = prepared->ready();
  copyStepwise(plan.backup, ready, partOf(progress, 0.5, 0.7));
  tellProgress(progress, Text::tr("Preparing the restored record"), 0.7);
  updateRestoredCopy(session, ready, plan, safety, askedBy);
  tellProgress(progress, Text::tr("Checking the restored record"), 0.8);
  flushSqlite(ready);
  tellProgress(progress, Text::tr("Ready"), 1.0);
  return prepared;
}

PreparedRestore::PreparedRestore(const fs::path& target, fs::path safety)
    : ready_(std::make_unique<FileInTheMaking>(target)), target_(target), safety_(std::move(safety)) {}

PreparedRestore::~PreparedRestore() = default;

const fs::path& PreparedRestore::ready() const noexcept {
  return ready_->path();
}

fs::path PreparedRestore::takeOver() {
  const fs::path aside = replaceSqlite(ready_->path(), target_);
  if (!aside.empty()) {
    try {
      registerCopyIn(target_.string(), CopyKind::kBeforeRestore, aside);
    } catch (const Error&) {
      return aside;  // it is found by its name (copiesOf())
    }
  }
  return aside;
}

void noteRestore(SessionContext& session, const fs::path& backup) {
  session.require(Operation::kDatabaseRestore);
  Transaction transaction(session.connection());
  const UserId askedBy = requireSecondPerson(session, DutyAct::kRestore, hashOfFile(backup));
  session.note(AuditAction::kDatabaseRestore, AuditObject::kDatabase, backup.filename().string(),
               withPeople({{"present", "unreadable"}}, session, askedBy));
  transaction.commit();
}

Restored restoreRecord(const Maintainer& maintainer, const fs::path& backup, const std::string& locator,
                       bool otherCentreMeant) {
  requireOwnRestore(locator);
  const std::string file = linkTarget(locator).string();
  sweepLeftovers(file);
  Restored restored{.content = checkBackup(backup)};
  if (std::optional<Connection> present = presentRecord(file, restored.unreadable)) {
    std::shared_ptr<PreparedRestore> prepared;
    {
      MaintenanceDesk desk(maintainer, std::move(*present), file);
      present.reset();
      restored.plan = planRestore(desk.session(), backup);
      restored.plan->otherCentreMeant = otherCentreMeant;
      requireMeant(desk.session(), *restored.plan);
      desk.handOver(maintainer, wishFor(*restored.plan, kReasonOfCommand));
      prepared = prepareRestore(desk.session(), *restored.plan);
    }
    restored.before = prepared->takeOver();
    return restored;
  }
  requireSoundBackup(verifyBackup(backup), backup);
  restored.before = restoreSqlite(backup, file, [&](const fs::path& copy) {
    MaintenanceDesk desk(maintainer,
                         openRecord(copy.string(), OpenMode::kReadWrite,
                                    {.softwareVersion = softwareVersion(), .backup = false}),
                         fs::exists(file) ? file : backup.string());
    desk.handOver(maintainer,
                  wishFor({.backup = backup, .backupHash = hashOfFile(backup)}, kReasonOfCommand));
    noteRestore(desk.session(), backup);
  });
  if (!restored.before.empty()) {
    registerCopyIn(file, CopyKind::kBeforeRestore, restored.before);
  }
  registerCopyIn(file, CopyKind::kBackup, backup);
  return restored;
}

std::vector<Text> othersAtWork(SessionContext& session) {
  session.require(Operation::kDatabaseRestore);
  const std::int64_t aliveSince_us = session.now_us() - kStationSilence_us;
  std::vector<Text> sentences;
  for (const StationState& state : StationRepository(session.connection()).board()) {
    if (state.heartbeatUtc_us < aliveSince_us) {
      continue;
    }
    if (!state.trialId.empty() && !state.ended) {
      sentences.push_back(Text::tr("a run is in progress at the station %1", state.station));
    } else if (state.station != session.station()) {
      sentences.push_back(Text::tr("the station %1 is connected", state.station));
    }
  }
  return sentences;
}

void requireNobodyAtWork(SessionContext& session) {
  const std::vector<Text> others = othersAtWork(session);
  if (others.empty()) {
    return;
  }
  throw Error(
      ErrorCode::kDatabase, others.front(), session.connection().location(),
      Text::tr("Let the run finish, close Torsio at all other stations, wait half a minute, and try again"));
}

}  // namespace torsio
