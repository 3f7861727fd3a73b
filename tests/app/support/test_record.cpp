// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/test_record.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <vector>

#include "app/services/base/build_info.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/schema_tables.h"

namespace torsio {

TestRecord::TestRecord(std::uint64_t seed, const std::string& locator)
    : folder_(std::filesystem::temp_directory_path() / ("torsio-" + SystemIdSource().newUuid())),
      locator_(locator.empty() ? (folder_ / "centre.sqlite").string() : locator),
      ids_(std::make_unique<SeededIdSource>(seed)) {
  std::filesystem::create_directories(folder_);
  if (locator.empty() && std::getenv("TORSIO_TEST_AS_STATION") != nullptr) {
    openOnServer();
  } else {
    open();
  }
}

TestRecord::TestRecord(const std::filesystem::path& folder)
    : owner_(false),
      folder_(folder),
      locator_((folder / "centre.sqlite").string()),
      ids_(std::make_unique<SystemIdSource>()) {
  open();
}

TestRecord::~TestRecord() {
  station_.reset();
  if (!schema_.empty()) {
    const std::string role = "station_" + schema_;
    Transaction transaction(*connection_);
    waitForRightsOfDatabase(*connection_);
    connection_->executeVerbatim("SET LOCAL client_min_messages = warning");
    connection_->executeVerbatim("DROP OWNED BY " + role);
    connection_->executeVerbatim("DROP ROLE " + role);
    connection_->executeVerbatim("DROP SCHEMA " + schema_ + " CASCADE");
    transaction.commit();
  }
  connection_.reset();
  std::error_code ignored;
  if (owner_) {
    std::filesystem::remove_all(folder_, ignored);
  }
}

void TestRecord::open() {
  connection_ = std::make_unique<Connection>(openRecord(
      locator_, OpenMode::kCreate, {.softwareVersion = softwareVersion(), .now_us = kRecordTime_us}));
}

void TestRecord::openOnServer() {
  schema_ = "t_" + SystemIdSource().newUuid();
  std::replace(schema_.begin(), schema_.end(), '-', '_');
  Locator place = parseLocator(std::getenv("TORSIO_TEST_POSTGRES"));
  openDatabase(addressOf(place), OpenMode::kReadWrite).executeVerbatim("CREATE SCHEMA " + schema_);
  place.schema = schema_;
  locator_ = addressOf(place);
  open();
  std::vector<std::string> tables{"schema_migration"};
  for (const SchemaTable& table : tablesInReferenceOrder(*connection_)) {
    tables.push_back(table.name);
  }
  std::set<std::string> appendOnly;
  for (const Migration& step : embeddedMigrations()) {
    for (const std::string& table : appendOnlyTables(step.sql)) {
      appendOnly.insert(table);
    }
  }
  place.user = "station_" + schema_;
  place.password = "the word of the stations";
  writeServerRoles(*connection_, tables, appendOnly, place.user);
  connection_->executeVerbatim("ALTER ROLE " + place.user + " PASSWORD '" + place.password + "'");
  station_ = std::make_unique<Connection>(openRecord(addressOf(place), OpenMode::kReadWrite));
}

Actor TestRecord::actorOf(const std::string& login) {
  for (const UserAccount& user : AccessRepository(*connection_, PasswordCost::kTest).users()) {
    if (user.login == login) {
      Actor actor{user.id, user.login, user.personId, user.roles, false, now_us_};
      if (station_) {
        actor.serverToken =
            selectFirst(*connection_, "SELECT new_session(?, FALSE)", {user.id}, readText).value_or("");
      }
      return actor;
    }
  }
  return {};
}

std::unique_ptr<SessionContext> TestRecord::sessionOf(const std::string& station, const Actor& actor) {
  return std::make_unique<SessionContext>(station_ ? *station_ : *connection_, *ids_,
                                          SessionKey{locator_, station, actor}, [this] { return now_us_; });
}

PersonId TestRecord::addTrainee(const std::string& code, bool demonstration) {
  Trainee trainee;
  trainee.person.id = ids_->newUuid();
  trainee.person.code = code;
  trainee.person.createdUtc_us = now_us_;
  trainee.person.demonstration = demonstration;
  PeopleRepository(*connection_).addTrainees({&trainee, 1});
  return trainee.person.id;
}

PersonId TestRecord::addChief(const std::string& code) {
  Rater chief;
  chief.person.id = ids_->newUuid();
  chief.person.code = code;
  chief.person.createdUtc_us = now_us_;
  chief.classCode = "chief";
  PeopleRepository(*connection_).addRaters({&chief, 1});
  return chief.person.id;
}

void TestRecord::addChiefClass(const std::string& label) {
  const SeniorityClass chiefs{"chief", label, 1};
  PeopleRepository(*connection_).addRaterClasses({&chiefs, 1});
}

UserId TestRecord::addUser(const std::string& login, const PersonId& personId, const std::string& role,
                           const std::string& password) {
  AccessRepository access(*connection_, PasswordCost::kTest);
  const UserId id = ids_->newUuid();
  access.addUser({.id = id, .login = login, .personId = personId, .createdUtc_us = now_us_, .roles = {role}},
                 password);
  access.setPassword(id, access.sealPassword(login, password), false);
  return id;
}

}  // namespace torsio
