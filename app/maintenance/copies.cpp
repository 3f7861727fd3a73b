// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/copies.h"

#include <charconv>
#include <system_error>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/copy_register.h"
#include "db/repository/system/setting_repository.h"
#include "sim/base/clock.h"
#include "sim/base/time_units.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

std::int64_t keep_us(Connection& connection) {
  int days = kCopyKeep_days;
  if (const auto set = SettingRepository(connection).value("copy_keep_days")) {
    int stored = 0;
    std::from_chars(set->data(), set->data() + set->size(), stored);
    days = stored > 0 ? stored : days;
  }
  return days * kDay_us;
}

bool isGone(const RecordCopy& copy) {
  std::error_code unreadable;
  return copy.station == stationName() && !fs::exists(copy.place, unreadable) && !unreadable;
}

std::vector<ListedCopy> listed(Connection& connection, std::vector<RecordCopy> copies) {
  const std::int64_t keep = keep_us(connection);
  std::vector<ListedCopy> list;
  for (RecordCopy& copy : copies) {
    const std::int64_t due_us = copy.madeUtc_us + keep;
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

std::vector<ListedCopy> copiesHolding(SessionContext& session, const PersonId& personId) {
  session.require(Operation::kPersonErase);
  CopyRegister copies(session.connection());
  std::vector<RecordCopy> there;
  for (RecordCopy& copy : copies.holding(personId)) {
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
  std::erase_if(copies, isGone);
  return listed(connection, std::move(copies));
}

void registerCopyIn(const std::string& locator, CopyKind kind, const fs::path& place) {
  Connection connection = openRecord(locator, OpenMode::kReadWrite);
  registerCopy(connection, kind, place, utcNow_us());
}

}  // namespace torsio
