// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/station_anchor.h"

#include <algorithm>
#include <system_error>

#include <QSettings>

#include "app/services/maintenance/anchor.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWitness = "witness";
constexpr const char* kKey = "key";
constexpr std::chrono::seconds kLeavingPatience{4};

/// A separate file in the account's settings.
QSettings settings() {
  return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"), QStringLiteral("anchor")};
}

QString textOf(const fs::path& path) {
  return path.empty() ? QString() : QString::fromStdString(fs::absolute(path).string());
}

}  // namespace

StationAnchor stationAnchor() {
  const QSettings stored = settings();
  return {stored.value(QLatin1String(kWitness)).toString().toStdString(),
          stored.value(QLatin1String(kKey)).toString().toStdString()};
}

void setStationAnchor(const StationAnchor& anchor) {
  if (!anchor.witness.empty()) {
    requireNoDatabase(anchor.witness);
  }
  if (!anchor.key.empty()) {
    (void)publicAnchorKey(anchor.key);
  }
  QSettings stored = settings();
  stored.setValue(QLatin1String(kWitness), textOf(anchor.witness));
  stored.setValue(QLatin1String(kKey), textOf(anchor.key));
}

bool remindOfKey() {
  QSettings stored = settings();
  const QString told = QStringLiteral("told_of_no_key");
  if (!stored.value(QLatin1String(kKey)).toString().isEmpty() || stored.value(told).toBool()) {
    return false;
  }
  stored.setValue(told, true);
  return true;
}

std::optional<StationSignature> signedByStation(const std::string& text) {
  const StationAnchor anchor = stationAnchor();
  if (anchor.key.empty()) {
    return std::nullopt;
  }
  const SecretKey key = readKey(anchor.key);
  return StationSignature{publicOf(key), signedWith(key, text)};
}

LeftHead witnessHead(Connection& connection, std::int64_t now_us, std::chrono::milliseconds patience) {
  const StationAnchor anchor = stationAnchor();
  LeftHead head{.line = anchoredHead(connection, anchor.key, now_us), .witness = anchor.witness};
  if (head.witness.empty()) {
    return head;
  }
  appendToWitness(head.witness, head.line);  // first: a head without a stamp is better than none
  if (const std::optional<StampAuthority> authority = stampAuthority(connection)) {
    try {
      appendToWitness(head.witness, stampedBy(*authority, head.line, patience));
    } catch (const Error& error) {
      head.noStamp = Text::tr("%1: %2", error.whereText(), error.happenedText());
    }
  }
  return head;
}

LeftHead headOnLeaving(Connection& connection, std::int64_t now_us) {
  try {
    return witnessHead(connection, now_us, kLeavingPatience);
  } catch (const Error& error) {
    return {.line = anchoredHead(connection, {}, now_us),
            .trouble = Text::tr("%1: %2", error.whereText(), error.happenedText())};
  }
}

}  // namespace torsio

#ifdef _WIN32
#include <QStorageInfo>
#else
#include <sys/stat.h>
#endif

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/session_context.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWitnessSetting = "station_witness";
constexpr const char* kKeySetting = "station_key";

/// Returns the folder of a file that may not exist yet.
fs::path folderOf(const fs::path& file) {
  return fs::absolute(file).lexically_normal().parent_path();
}

/// Compares the files themselves if possible: a list of mounts is wrong after chroot.
bool onOneDisk(const fs::path& one, const fs::path& other) {
#ifdef _WIN32
  const QStorageInfo first(QString::fromStdString(folderOf(one).string()));
  const QStorageInfo second(QString::fromStdString(folderOf(other).string()));
  return first.isValid() && first == second;
#else
  struct stat first {};
  struct stat second {};
  return ::stat(folderOf(one).c_str(), &first) == 0 && ::stat(folderOf(other).c_str(), &second) == 0 &&
         first.st_dev == second.st_dev;
#endif
}

/// Returns the record's file; empty if it is on a server.
fs::path recordFile(const SessionContext& session) {
  const Locator locator = parseLocator(session.key().locator);
  return locator.engine == Engine::kSqlite ? fs::path(locator.file) : fs::path();
}

/// Returns the public key of a key file that may be gone; empty if none.
std::string publicPart(const fs::path& key) {
  try {
    return key.empty() ? std::string() : publicAnchorKey(key);
  } catch (const Error&) {
    return {};
  }
}

void useKey(SessionContext& session, const fs::path& file) {
  StationAnchor anchor = stationAnchor();
  const std::string before = publicPart(anchor.key);
  anchor.key = file;
  setStationAnchor(anchor);
  noteSetting(session, kKeySetting, {{"public_key", before}}, {{"public_key", publicPart(file)}});
}

}  // namespace

StationHeads stationHeads(SessionContext& session) {
  session.require(Operation::kAuditView);
  StationHeads heads{.anchor = stationAnchor()};
  if (const std::optional<StampAuthority> authority = stampAuthority(session.connection())) {
    heads.authority = authority->address;
  }
  const fs::path record = recordFile(session);
  try {
    if (!heads.anchor.key.empty()) {
      heads.publicKey = publicAnchorKey(heads.anchor.key);
    }
    std::error_code ignored;
    if (fs::exists(heads.anchor.witness, ignored)) {
      const std::vector<std::string> lines = headsOf(heads.anchor.witness);
      heads.kept = std::count_if(lines.begin(), lines.end(),
                                 [](const std::string& line) { return !isStampLine(line); });
    }
  } catch (const Error& error) {
    heads.trouble = Text::tr("%1: %2", error.whereText(), error.happenedText());
  }
  if (!record.empty()) {
    heads.witnessOnDisk = !heads.anchor.witness.empty() && onOneDisk(heads.anchor.witness, record);
    heads.keyBesideRecord = !heads.anchor.key.empty() && folderOf(heads.anchor.key) == folderOf(record);
  }
  return heads;
}

std::string headNow(SessionContext& session) {
  session.require(Operation::kAuditView);
  return anchoredHead(session.connection(), stationAnchor().key, session.now_us());
}

Text keepHeadNow(SessionContext& session) {
  session.require(Operation::kAuditView);
  if (stationAnchor().witness.empty()) {
    throw Error(ErrorCode::kUsage, Text::tr("this station keeps no checkpoints"), "",
                Text::tr("Choose a witness file first"));
  }
  return witnessHead(session.connection(), session.now_us()).noStamp;
}

void chooseWitness(SessionContext& session, const fs::path& file) {
  session.require(Operation::kSettingsEdit);
  StationAnchor anchor = stationAnchor();
  const fs::path before = anchor.witness;
  if (!file.empty()) {  // before anything is changed, check that the file is writable
    appendToWitness(file, anchoredHead(session.connection(), anchor.key, session.now_us()));
  }
  anchor.witness = file;
  setStationAnchor(anchor);
  noteSetting(session, kWitnessSetting, {{"file", before.string()}}, {{"file", file.string()}});
}

void makeStationKey(SessionContext& session, const fs::path& file) {
  session.require(Operation::kSettingsEdit);
  const StationAnchor anchor = stationAnchor();
  if (publicPart(anchor.key).empty()) {
    (void)makeAnchorKey(file);
  } else {
    replaceAnchorKey(session.connection(), anchor.key, file, anchor.witness, session.now_us());
  }
  useKey(session, file);
}

void chooseStationKey(SessionContext& session, const fs::path& file) {
  session.require(Operation::kSettingsEdit);
  useKey(session, file);
}

HeadsVerdict verifyHeads(SessionContext& session, const std::vector<std::string>& lines,
                         const std::string& publicKey) {
  session.require(Operation::kAuditView);
  const std::string key = publicKey.empty() ? publicPart(stationAnchor().key) : publicKey;
  HeadsVerdict verdict = judgeHeads(session.connection(), lines, key, {});
  session.note(AuditAction::kAuditVerify, AuditObject::kAuditEntry, {},
               {{"heads", lines.size()}, {"findings", verdict.findings.size()}});
  return verdict;
}

}  // namespace torsio
