// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/copies.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <system_error>
#include <utility>

#include "app/services/access/centre_settings.h"
#include "app/services/access/station_name.h"
#include "app/services/access/station_record.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/copy_register.h"
#include "sim/core/clock.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

/// Returns whether this is Torsio's default folder for records.
bool isOwnFolder(const fs::path& folder) {
  std::error_code missing;
  return fs::equivalent(folder, dataFolder(), missing);
}

}  // namespace

Text othersCouldRead(const fs::path& file) {
  return Text::tr("Other accounts of this computer could read %1; now only yours can", file.string());
}

std::vector<Text> closeRecordFiles(const std::string& locator, const fs::path& folder) {
  std::vector<Text> told;
  const auto close = [&told](const fs::path& file) {
    if (makePrivate(file)) {
      told.push_back(othersCouldRead(file));
    }
  };
  close(folder);
  const Locator place = parseLocator(locator);
  if (place.engine != Engine::kSqlite) {
    return told;
  }
  std::error_code unreadable;
  const fs::path record = fs::weakly_canonical(place.file, unreadable);  // with links resolved
  const std::string copies = record.stem().string() + "-before-restore-";
  if (isOwnFolder(record.parent_path())) {
    close(record.parent_path());
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(record.parent_path(), unreadable)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(record.filename().string()) || name.starts_with(copies)) {
      close(entry.path());
    }
  }
  return told;
}

namespace fs = std::filesystem;

namespace {

bool onServer(const RecordCopy& copy) {
  return copy.place.starts_with("postgresql://");
}

/// Returns a record's location in the format of the register.
std::string placeOf(const std::string& locator) {
  const Locator place = parseLocator(locator);
  return place.engine == Engine::kSqlite ? fs::absolute(place.file).lexically_normal().string()
                                         : place.shown();
}

/// Returns when a file was written last.
std::int64_t changedUtc_us(const fs::path& file) {
  std::error_code gone;
  const auto changed = fs::last_write_time(file, gone);
  return gone ? 0
              : std::chrono::duration_cast<std::chrono::microseconds>(
                    std::chrono::file_clock::to_sys(changed).time_since_epoch())
                    .count();
}

/// Returns whether this end of a move is the record at `locator` itself.
bool isSelf(const RecordCopy& copy, const std::string& locator) {
  return copy.kind == CopyKind::kMoved && copy.place == placeOf(locator) &&
         (onServer(copy) || copy.station == stationName());
}

bool isGone(const RecordCopy& copy) {
  std::error_code unreadable;
  return !onServer(copy) && copy.station == stationName() && !fs::exists(copy.place, unreadable) &&
         !unreadable;
}

/// Returns the copies beside a record that its restores and schema changes put aside: also what killed ones
/// left, of which no register tells.
std::vector<RecordCopy> putAside(const std::string& locator) {
  const Locator place = parseLocator(locator);
  std::vector<RecordCopy> found;
  if (place.engine != Engine::kSqlite) {
    return found;
  }
  std::error_code unreadable;
  const fs::path record = fs::weakly_canonical(place.file, unreadable);
  const std::string name = record.filename().string();
  const std::pair<std::string, CopyKind> kBeginnings[] = {
      {name + ".before-restore-", CopyKind::kBeforeRestore},
      {record.stem().string() + "-before-restore-", CopyKind::kBeforeRestore},
      {name + ".schema-", CopyKind::kBeforeSchema}};
  for (const fs::directory_entry& entry : fs::directory_iterator(record.parent_path(), unreadable)) {
    const std::string file = entry.path().filename().string();
    const bool part = std::any_of(std::begin(kDatabaseParts) + 1, std::end(kDatabaseParts),
                                  [&file](const char* suffix) { return file.ends_with(suffix); });
    std::error_code ignored;
    if (part || file.ends_with(".part") || file.ends_with(".lock") || !entry.is_regular_file(ignored)) {
      continue;
    }
    for (const auto& [beginning, kind] : kBeginnings) {
      if (file.starts_with(beginning)) {
        found.push_back({.kind = kind,
                         .place = entry.path().string(),
                         .station = stationName(),
                         .madeUtc_us = changedUtc_us(entry.path())});
      }
    }
  }
  return found;
}

/// Returns those of putAside() that are not in the register.
std::vector<RecordCopy> strays(Connection& connection, const std::string& locator) {
  const std::vector<RecordCopy> known = CopyRegister(connection).all();
  std::vector<RecordCopy> found = putAside(locator);
  std::erase_if(found, [&known](const RecordCopy& stray) {
    std::error_code ignored;
    return std::any_of(known.begin(), known.end(), [&](const RecordCopy& copy) {
      return (copy.station == stray.station ||
              copy.station.empty()) &&  // a change of schema knows no station

             (copy.place == stray.place || fs::equivalent(copy.place, stray.place, ignored));
    });
  });
  return found;
}

std::vector<ListedCopy> listed(Connection& connection, std::vector<RecordCopy> copies) {
  const std::int64_t keep_us = centreSetting<kCopyKeep_days>(connection) * kDay_us;
  std::vector<ListedCopy> list;
  for (RecordCopy& copy : copies) {
    const std::int64_t due_us = copy.madeUtc_us + keep_us;
    list.push_back({std::move(copy), due_us});
  }
  return list;
}

}  // namespace

void registerCopy(Connection& connection, CopyKind kind, const fs::path& place, std::int64_t now_us,
                  const PersonId& personId) {
  CopyRegister(connection)
      .add({.kind = kind,
            .place = fs::absolute(place).lexically_normal().string(),
            .station = stationName(),
            .personId = personId,
            .madeUtc_us = now_us});
}

RegisteredMove::RegisteredMove(Connection& connection, const std::string& from, const std::string& to,
                               std::int64_t now_us)
    : connection_(connection) {
  CopyRegister copies(connection);
  const std::vector<RecordCopy> before = copies.all();
  for (const std::string& end : {from, to}) {
    const RecordCopy copy{
        .kind = CopyKind::kMoved, .place = placeOf(end), .station = stationName(), .madeUtc_us = now_us};
    const bool known = std::any_of(before.begin(), before.end(),
                                   [&](const RecordCopy& one) { return one.place == copy.place; });
    const std::string id = copies.add(copy);
    if (!known) {
      fresh_.push_back(id);
    }
  }
}

void RegisteredMove::giveUp(std::int64_t now_us) {
  for (const std::string& id : fresh_) {
    CopyRegister(connection_).setGone(id, now_us);
  }
}

std::vector<Text> closeKnownCopies(Connection& connection) {
  std::vector<Text> told;
  for (const RecordCopy& copy : CopyRegister(connection).all()) {
    std::error_code unreadable;
    const fs::path place = copy.place;
    const bool ours =
        fs::is_regular_file(place, unreadable) || fs::exists(place / "manifest.json", unreadable);
    if (copy.station == stationName() && !onServer(copy) && ours && makePrivate(place)) {
      told.push_back(othersCouldRead(place));
    }
  }
  return told;
}

std::vector<ListedCopy> copiesHolding(SessionContext& session, const PersonId& personId) {
  session.require(Operation::kPersonErase);
  CopyRegister copies(session.connection());
  for (const RecordCopy& stray : strays(session.connection(), session.key().locator)) {
    (void)copies.add(stray);
  }
  std::vector<RecordCopy> there;
  for (RecordCopy& copy : copies.holding(personId)) {
    if (isSelf(copy, session.key().locator)) {
      continue;
    }
    if (isGone(copy)) {
      copies.setGone(copy.id, session.now_us());
    } else {
      there.push_back(std::move(copy));
    }
  }
  return listed(session.connection(), std::move(there));
}

std::vector<ListedCopy> copiesOf(const std::string& locator) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  std::vector<RecordCopy> copies = CopyRegister(connection).all();
  std::erase_if(copies, [&](const RecordCopy& copy) { return isGone(copy) || isSelf(copy, locator); });
  for (RecordCopy& stray : strays(connection, locator)) {
    copies.push_back(std::move(stray));
  }
  return listed(connection, std::move(copies));
}

void registerCopyIn(const std::string& locator, CopyKind kind, const fs::path& place) {
  Connection connection = openRecord(locator, OpenMode::kReadWrite);
  registerCopy(connection, kind, place, utcNow_us());
}

}  // namespace torsio
