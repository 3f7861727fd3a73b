// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/person_package.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/maintenance/copies.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/csv_cell.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/trial_file.h"

namespace torsio {

namespace {

bool isSimulated(SessionContext& session, const PersonId& personId) {
  const std::optional<Person> person = PeopleRepository(session.connection()).find(personId);
  return person && person->demonstration;
}

}  // namespace

bool mayEraseNow(SessionContext& session, const PersonId& personId) {
  return isSimulated(session, personId) || secondPersonIsThere(session, DutyAct::kErase, personId);
}

void eraseGuarded(SessionContext& session, const PersonId& personId, const std::string& reason) {
  Transaction transaction(session.connection());
  if (!isSimulated(session, personId)) {
    requireSecondPerson(session, DutyAct::kErase, personId);
  }
  erasePerson(session.connection(), personId, session.actor().userId, reason, session.now_us());
  transaction.commit();
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kReadme =
    "What this folder holds\n"
    "======================\n\n"
    "Everything that the training centre has stored about one person.\n\n"
    "tables/NAME.csv      one table of the record; opens in any spreadsheet (UTF-8, comma, decimal point)\n"
    "tables/NAME.json     the same for programs\n"
    "recordings/*.torsio-trial   the person's recorded runs; Torsio replays them\n"
    "manifest.json        every file with its size and its BLAKE2b-256 hash\n\n"
    "Times that end in _utc_us are microseconds since 1970-01-01 UTC. Scores that end in _steps are whole "
    "steps\n"
    "of their scale: divide by steps_per_point. Passwords are not part of the package, not even in hidden "
    "form.\n"
    "Other people stand in it under their codes only.\n";

Json jsonOf(const Value& value) {
  struct Visitor {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(std::int64_t number) const { return number; }
    Json operator()(double number) const { return number; }
    Json operator()(bool flag) const { return flag; }
    Json operator()(const std::string& text) const { return text; }
    Json operator()(const Blob& bytes) const { return std::to_string(bytes.size()) + " bytes"; }
  };
  return std::visit(Visitor{}, value.storage());
}

std::string cellOf(const Json& value) {
  if (value.is_null()) {
    return "";
  }
  return csvCell(value.is_string() ? value.get<std::string>() : value.dump());
}

void writeTable(const fs::path& folder, const PersonTable& table) {
  std::string csv(kByteOrderMark);
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    csv.append(i == 0 ? "" : ",").append(table.columns[i]);
  }
  csv += "\r\n";
  for (const std::vector<Value>& values : table.rows) {
    Json row = Json::object();
    for (std::size_t i = 0; i < values.size(); ++i) {
      row[table.columns[i]] = jsonOf(values[i]);
      csv.append(i == 0 ? "" : ",").append(cellOf(row[table.columns[i]]));
    }
    csv += "\r\n";
    rows.push_back(std::move(row));
  }
  writeFileAtomically(folder / (table.table + ".csv"), csv);
  writeFileAtomically(folder / (table.table + ".json"), rows.dump(2) + "\n");
}

/// Returns false for a trial that is running or whose samples were erased: it has no complete file.
bool writeRecording(Connection& connection, const TrialId& trialId, const fs::path& folder) {
  const Trial trial = TrialRepository(connection).load(trialId);
  if (trial.summary.contentHash.empty() || trial.chunks.empty()) {
    return false;
  }
  TrialFileSink file(folder / (trialId + ".torsio-trial"));
  file.begin(trial.header);
  for (const TrialChunk& chunk : trial.chunks) {
    file.append(chunk);
  }
  file.finish(trial.summary);
  return true;
}

void writeManifest(const fs::path& folder, const PersonId& personId, const TrailHead& head,
                   std::int64_t now_us) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  Json list = Json::array();
  for (const fs::path& file : files) {
    const std::string bytes = readFile(file);
    Digest digest;
    digest.update(std::string_view(bytes));
    list.push_back({{"file", fs::relative(file, folder).generic_string()},
                    {"bytes", bytes.size()},
                    {"blake2b_256", digest.hex()}});
  }
  const Json manifest{{"person", personId},
                      {"made_utc_us", now_us},
                      {"audit_trail", {{"entries", head.length}, {"head", head.hash}}},
                      {"files", std::move(list)}};
  writeFileAtomically(folder / "manifest.json", manifest.dump(2) + "\n");
}

void refuseKnownFolder(const fs::path& folder) {
  if (fs::exists(folder)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("this folder exists already"), folder.string(),
                Text::tr("Name a new folder"));
  }
}

}  // namespace

PersonPackage exportPersonPackage(SessionContext& session, const PersonId& personId, const fs::path& folder,
                                  const std::string& reason) {
  session.require(Operation::kPersonExport);
  refuseKnownFolder(folder);
  const std::vector<PersonTable> tables = exportPerson(session.connection(), personId);
  if (tables.empty()) {
    refuse(Text::tr("there is no such person"), personId, Text::tr("Check the code"));
  }
  PersonPackage package{.folder = folder};
  const FileInTheMaking making(folder);
  ensureFolder(making.path() / "tables");
  ensureFolder(making.path() / "recordings");
  for (const PersonTable& table : tables) {
    writeTable(making.path() / "tables", table);
    ++package.tables;
    package.rows += static_cast<std::int64_t>(table.rows.size());
    if (table.table != "trial") {
      continue;
    }
    for (const std::vector<Value>& row : table.rows) {
      const std::string& id = std::get<std::string>(row.at(0).storage());
      if (writeRecording(session.connection(), id, making.path() / "recordings")) {
        ++package.recordings;
      }
    }
  }
  writeFileAtomically(making.path() / "README.txt", std::string_view(kReadme));
  writeManifest(making.path(), personId, AuditRepository(session.connection()).head(), session.now_us());
  Transaction together(session.connection());
  registerCopy(session.connection(), CopyKind::kPackage, folder, session.now_us(), personId);
  session.note(AuditAction::kPersonExport, AuditObject::kPerson, personId, {}, reason);
  together.commit();
  std::error_code failed;
  fs::rename(making.path(), folder, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable,
                Text::tr("the package cannot be given its name: %1", failed.message()), folder.string(),
                Text::tr("Choose a folder in which you may write"));
  }
  return package;
}

std::vector<PersonPackage> exportPersonPackages(SessionContext& session, std::span<const PersonId> people,
                                                const fs::path& folder, const std::string& reason,
                                                const ProgressCallback& progress) {
  session.require(Operation::kPersonExport);
  refuseKnownFolder(folder);
  std::vector<PersonPackage> packages;
  for (const PersonId& id : people) {
    const std::optional<Person> person = PeopleRepository(session.connection()).find(id);
    const std::string code = person ? person->code : "";
    tellProgress(progress, Text::tr("Record of %1", code),
                 static_cast<double>(packages.size()) / static_cast<double>(people.size()));
    if (packages.empty()) {
      ensureFolder(folder);
    }
    packages.push_back(exportPersonPackage(session, id, folder / ("record-" + code), reason));
  }
  return packages;
}

void erasePersonRecord(SessionContext& session, const PersonId& personId, const std::string& reason) {
  session.require(Operation::kPersonErase);
  if (reason.empty()) {
    refuseParameter(Text::tr("erasing needs a reason"), personId, Text::tr("Say why, for the audit trail"));
  }
  eraseGuarded(session, personId, reason);
  truncateLog(session.connection());
}

}  // namespace torsio
