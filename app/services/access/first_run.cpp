// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/first_run.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include <QFileInfo>

#include "app/services/access/centre_settings.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Opens a record for reading. Work left unfinished by a killed program is rolled back first, which needs
/// write access.
Connection openForReading(const std::string& locator, const Locator& place) {
  try {
    return openDatabase(locator, OpenMode::kReadOnly);
  } catch (const Error&) {
    if (place.engine != Engine::kSqlite || !hasJournal(place.file)) {
      throw;
    }
  }
  (void)openDatabase(locator, OpenMode::kReadWrite);
  return openDatabase(locator, OpenMode::kReadOnly);
}

}  // namespace

CentreSign centreSign(Connection& connection) {
  CentreSign sign;
  if (const auto centre = StudyRepository(connection).centre()) {
    sign.name = centre->name;
  }
  sign.language = centreSetting<kLanguage>(connection);
  return sign;
}

bool saysPassword(const std::string& locator) {
  return !locator.empty() && !parseLocator(locator).password.empty();
}

RecordPlace lookAtRecord(const std::string& locator) {
  const Locator place = parseLocator(locator);
  std::error_code ignored;
  if (place.engine == Engine::kSqlite && !std::filesystem::exists(place.file, ignored)) {
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(place.file, ignored))) {
      requireUsableFile(place.file, OpenMode::kReadOnly);  // a new record in its place would hide the old one
    }
    const QFileInfo folder(QFileInfo(QString::fromStdString(place.file)).absolutePath());
    if (!folder.isDir() || !folder.isWritable()) {
      throw Error(ErrorCode::kFileUnwritable,
                  folder.isDir() ? Text::tr("folder is read-only") : Text::tr("no such folder"),
                  folder.filePath().toStdString(), Text::tr("Choose a folder in which you may write"));
    }
    return RecordPlace::kNothing;
  }
  Connection connection = openForReading(locator, place);
  if (checkSchema(connection, embeddedMigrations()).version == 0) {
    return RecordPlace::kEmpty;
  }
  return needsFirstRun(connection) ? RecordPlace::kEmpty : RecordPlace::kCentre;
}

void requireKnownRecord(const std::string& locator) {
  switch (lookAtRecord(locator)) {
    case RecordPlace::kCentre:
      return;
    case RecordPlace::kNothing:
      throw Error(ErrorCode::kFileMissing, Text::tr("the record of this station is gone"), locator,
                  Text::tr("Connect the disk that it is on, or restore the latest backup"));
    case RecordPlace::kEmpty:
      break;
  }
  throw Error(ErrorCode::kVerifyFailed, Text::tr("the record of this station no longer contains a centre"),
              parseLocator(locator).shown(), Text::tr("Restore the latest backup"));
}

std::string hashOfSecret(std::string_view purpose, const std::string& typed) {
  std::string secret = typed;
  std::erase_if(secret, [](char c) { return c == ' ' || c == '-'; });
  Digest digest;
  digest.update(purpose);
  digest.update(std::string_view(secret));
  return digest.hex();
}

std::vector<StartAccount> performFirstRun(SessionContext& session, const FirstRun& first,
                                          const AddPeople& addPeople) {
  std::vector<StartAccount> accounts;
  Transaction transaction(session.connectionWithoutRight());
  try {
    setUpCentre(session, first);
    const SignInAnswer answer = signIn(session, first.login, first.password);
    TORSIO_EXPECTS(answer.outcome == SignIn::kOk);
    if (first.demonstration) {
      accounts = addPeople(session);
    }
    transaction.commit();
  } catch (...) {
    session.setActor({});  // nothing was stored, so nobody is signed in
    throw;
  }
  return accounts;
}

}  // namespace torsio
