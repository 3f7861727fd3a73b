// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/server_dump.h"

#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QStringList>

#include "db/connection/locator.h"
#include "db/migrations/file_in_the_making.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMagic = "PGDMP";
const QString kDump = QStringLiteral("pg_dump");
const QString kRestore = QStringLiteral("pg_restore");

QString programNamed(const QString& name) {
  const QString found = QStandardPaths::findExecutable(name);
  if (found.isEmpty()) {
    throw Error(ErrorCode::kFileMissing, Text::tr("this computer has no %1", name.toStdString()), "",
                Text::tr("Install the package postgresql-client"));
  }
  return found;
}

/// Runs a program to its end. Returns what it says if it failed, in one line; empty: it succeeded.
std::string complaintOf(const QString& name, const QStringList& words, const std::string& password) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  if (!password.empty()) {
    environment.insert(QStringLiteral("PGPASSWORD"), QString::fromStdString(password));
  }
  process.setProcessEnvironment(environment);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.setStandardInputFile(QProcess::nullDevice());
  process.start(programNamed(name), words);
  process.waitForFinished(-1);
  if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0) {
    return {};
  }
  const std::string said = QString::fromUtf8(process.readAll()).simplified().toStdString();
  return said.empty() ? process.errorString().toStdString() : said;
}

}  // namespace

void dumpServer(const std::string& locator, const fs::path& target) {
  Locator server = parseLocator(locator);
  const std::string password = server.password;
  const std::string schema = server.schema;
  server.password.clear();
  server.schema.clear();
  const FileInTheMaking part(target);
  QStringList words{QStringLiteral("--format=custom"), QStringLiteral("--no-password"),
                    QStringLiteral("--file=") + QString::fromStdString(part.path().string()),
                    QStringLiteral("--dbname=") + QString::fromStdString(addressOf(server))};
  if (!schema.empty()) {
    words << QStringLiteral("--schema=") + QString::fromStdString(schema);
  }
  if (const std::string said = complaintOf(kDump, words, password); !said.empty()) {
    throw Error(ErrorCode::kDatabase, Text::tr("the server's backup failed: %1", said), server.shown(),
                Text::tr("Use the account that owns the tables, with its password in ~/.pgpass"));
  }
  readDump(part.path());
  makePrivate(part.path());
  std::error_code failed;
  fs::rename(part.path(), target, failed);
  if (failed) {
    refuseUnwritable(target);
  }
}

bool isDump(const fs::path& file) {
  std::error_code missing;
  if (!fs::is_regular_file(file, missing)) {
    return false;  // a pipe would be waited for
  }
  std::array<char, kMagic.size()> begin{};
  std::ifstream in(file, std::ios::binary);
  return in.read(begin.data(), begin.size()) && std::string_view(begin.data(), begin.size()) == kMagic;
}

void readDump(const fs::path& file) {
  const QStringList words{QStringLiteral("--file=/dev/null"), QString::fromStdString(file.string())};
  if (const std::string said = complaintOf(kRestore, words, {}); !said.empty()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("the backup cannot be read: %1", said), file.string(),
                Text::tr("Use an older backup"));
  }
}

}  // namespace torsio
