// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/test_record.h"

#include "app/services/base/build_info.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"

namespace torsio {

TestRecord::TestRecord(std::uint64_t seed, const std::string& locator)
    : folder_(std::filesystem::temp_directory_path() / ("torsio-" + SystemIdSource().newUuid())),
      locator_(locator.empty() ? (folder_ / "centre.sqlite").string() : locator),
      ids_(std::make_unique<SeededIdSource>(seed)) {
  std::filesystem::create_directories(folder_);
  open();
}

TestRecord::TestRecord(const std::filesystem::path& folder)
    : owner_(false),
      folder_(folder),
      locator_((folder / "centre.sqlite").string()),
      ids_(std::make_unique<SystemIdSource>()) {
  open();
}

TestRecord::~TestRecord() {
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

Actor TestRecord::actorOf(const std::string& login) {
  for (const UserAccount& user : AccessRepository(*connection_, PasswordCost::kTest).users()) {
    if (user.login == login) {
      return {user.id, user.login, user.personId, user.roles, false, now_us_};
    }
  }
  return {};
}

std::unique_ptr<SessionContext> TestRecord::sessionOf(const std::string& station, const Actor& actor) {
  return std::make_unique<SessionContext>(*connection_, *ids_, SessionKey{locator_, station, actor},
                                          [this] { return now_us_; });
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
