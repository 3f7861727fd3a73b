// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/kept_backups.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include <QDateTime>
#include <QString>
#include <QTimeZone>

#include "app/services/access/station_name.h"
#include "db/repository/base/copy_register.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxKept = 1000;
constexpr std::int64_t kMillisecond_us = kSecond_us / 1000;
constexpr const char* kBeginning = "torsio-";
const QString kTimeInName = QStringLiteral("yyyy-MM-ddTHHmmss'Z'");

/// Returns when a file of a backup's name was made, UTC us; empty: it has another name.
std::optional<std::int64_t> madeAt(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::string ending = file.extension().string();
  if (!stem.starts_with(kBeginning) || (ending != ".sqlite" && ending != ".dump")) {
    return std::nullopt;
  }
  QDateTime made = QDateTime::fromString(
      QString::fromStdString(stem.substr(std::char_traits<char>::length(kBeginning))), kTimeInName);
  made.setTimeZone(QTimeZone::utc());
  return made.isValid() ? std::optional(made.toMSecsSinceEpoch() * kMillisecond_us) : std::nullopt;
}

std::string nameFor(std::int64_t now_us, Engine engine) {
  const QString time =
      QDateTime::fromMSecsSinceEpoch(now_us / kMillisecond_us, QTimeZone::utc()).toString(kTimeInName);
  return kBeginning + time.toStdString() + (engine == Engine::kSqlite ? ".sqlite" : ".dump");
}

/// Number of the day, week (from Monday) or month of a time.
using Period = std::int64_t (*)(std::chrono::sys_days day);

std::int64_t dayOf(std::chrono::sys_days day) {
  return day.time_since_epoch().count();
}
std::int64_t weekOf(std::chrono::sys_days day) {
  return (day.time_since_epoch() - (std::chrono::weekday(day) - std::chrono::Monday)).count();
}
std::int64_t monthOf(std::chrono::sys_days day) {
  const std::chrono::year_month_day date(day);
  return static_cast<int>(date.year()) * std::int64_t{12} + static_cast<unsigned>(date.month());
}

}  // namespace

KeepRule keepRule(const std::string& text) {
  std::istringstream in(text);
  int numbers[3] = {-1, -1, -1};
  char comma[2] = {};
  in >> numbers[0] >> comma[0] >> numbers[1] >> comma[1] >> numbers[2];
  const bool whole =
      !in.fail() && in.peek() == std::char_traits<char>::eof() && comma[0] == ',' && comma[1] == ',';
  if (!whole || numbers[0] < 1 ||
      std::any_of(std::begin(numbers), std::end(numbers), [](int n) { return n < 0 || n > kMaxKept; })) {
    refuseParameter(Text::tr("\"%1\" does not say how many days, weeks and months of backups stay", text), "",
                    Text::tr("Write three numbers, the first at least 1: 7,5,12"));
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<std::size_t> outdated(const KeepRule& rule, std::span<const std::int64_t> made_us) {
  std::vector<std::size_t> newestFirst(made_us.size());
  for (std::size_t i = 0; i < newestFirst.size(); ++i) {
    newestFirst[i] = i;
  }
  std::stable_sort(newestFirst.begin(), newestFirst.end(),
                   [&](std::size_t a, std::size_t b) { return made_us[a] > made_us[b]; });
  const std::pair<Period, int> periods[] = {{dayOf, rule.days}, {weekOf, rule.weeks}, {monthOf, rule.months}};
  std::set<std::size_t> kept;
  for (const auto& [period, most] : periods) {
    std::set<std::int64_t> seen;
    for (const std::size_t place : newestFirst) {
      const std::chrono::sys_time<std::chrono::microseconds> time{std::chrono::microseconds(made_us[place])};
      const std::int64_t number = period(std::chrono::floor<std::chrono::days>(time));
      if (static_cast<int>(seen.size()) < most && seen.insert(number).second) {
        kept.insert(place);
      }
    }
  }
  std::vector<std::size_t> gone;
  for (std::size_t i = 0; i < made_us.size(); ++i) {
    if (!kept.contains(i)) {
      gone.push_back(i);
    }
  }
  return gone;
}

KeptBackup keepBackup(SessionContext& session, const fs::path& folder, const KeepRule& rule) {
  session.require(Operation::kDatabaseBackup);
  ensureFolder(folder);
  KeptBackup kept{.file = fs::absolute(folder / nameFor(session.now_us(), session.connection().engine()))};
  kept.content = backUpDatabase(session, kept.file, {}, Replace::kNothing);

  CopyRegister copies(session.connection());
  std::vector<RecordCopy> own;
  std::vector<std::int64_t> made_us;
  for (RecordCopy& copy : copies.all()) {
    const std::optional<std::int64_t> made = madeAt(copy.place);
    std::error_code gone;
    if (made && copy.kind == CopyKind::kBackup && copy.station == stationName() &&
        fs::equivalent(fs::path(copy.place).parent_path(), folder, gone) &&
        fs::is_regular_file(copy.place, gone)) {
      own.push_back(std::move(copy));
      made_us.push_back(*made);
    }
  }
  for (const std::size_t place : outdated(rule, made_us)) {
    std::error_code failed;
    if (!fs::remove(own[place].place, failed)) {
      continue;  // stays known, and is tried again with the next backup
    }
    copies.setGone(own[place].id, session.now_us());
    session.note(AuditAction::kBackupRemoved, AuditObject::kDatabase,
                 fs::path(own[place].place).filename().string());
    kept.removed.emplace_back(own[place].place);
  }
  return kept;
}

fs::path newestBackup(const fs::path& folder) {
  std::pair<std::int64_t, fs::path> newest{-1, {}};
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
    if (const auto made = madeAt(entry.path())) {
      newest = std::max(newest, std::pair(*made, entry.path()));
    }
  }
  if (newest.second.empty()) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("there is no backup in this folder"), folder.string(),
                Text::tr("Make one with torsio db backup --into FOLDER"));
  }
  return newest.second;
}

}  // namespace torsio
