// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/study_centre.h"

#include <QTemporaryDir>

#include "app/services/people/people_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/people/account.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/setting_repository.h"
#include "tests/support/stored_rows.h"

namespace torsio::testing {

StudyCentre::StudyCentre(const std::string& locator) {
  QTemporaryDir folder;
  folder.setAutoRemove(false);
  folder_ = folder.path().toStdString();
  const std::string record = locator.empty() ? (folder_ / "administrator.sqlite").string() : locator;
  connection_ = std::make_unique<Connection>(
      openRecord(record, OpenMode::kCreate, {.softwareVersion = "test", .now_us = kStudyTime_us}));
  session_ = std::make_unique<SessionContext>(*connection_, ids_, SessionKey{record, "test station", {}},
                                              [this] { return now_us_; });
  session_->setPasswordCost(PasswordCost::kTest);
  AccessRepository access(*connection_, PasswordCost::kTest);
  for (const std::string& role : storedRoles(*connection_)) {
    const std::string id = ids_.newUuid();
    access.addUser({.id = id, .login = role, .createdUtc_us = now_us_, .roles = {role}}, kStudyPassword);
    access.setPassword(id, access.sealPassword(role, kStudyPassword), false);
    actors_[role] = {id, role, "", {role}, false};
  }
  SettingRepository(*connection_).set("two_people", "no", now_us_);  // one administrator may do everything
}

StudyCentre::~StudyCentre() {
  session_.reset();
  connection_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

SessionContext& StudyCentre::as(const std::string& role) {
  Actor actor = role.empty() ? Actor{} : actors_.at(role);
  actor.passwordShownUtc_us = now_us_;
  session_->setActor(actor);
  return *session_;
}

SessionContext& StudyCentre::asRater(const RaterId& raterId) {
  Actor actor = actors_.at("rater");
  actor.personId = raterId;
  actor.passwordShownUtc_us = now_us_;
  session_->setActor(actor);
  return *session_;
}

std::vector<TraineeId> StudyCentre::addTrainees(std::size_t count) {
  as("administrator");
  std::vector<TraineeId> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back(addPerson(*session_, {.fullName = "Trainee " + std::to_string(i + 1),
                                        .externalId = "S-" + std::to_string(1001 + i),
                                        .sex = i % 2 == 0 ? "female" : "male",
                                        .level = i % 3 == 0 ? "doctoral student" : "graduate"}));
  }
  return ids;
}

std::vector<RaterId> StudyCentre::addChiefs(std::size_t count) {
  as("administrator");
  std::vector<RaterId> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back(addPerson(*session_, {.fullName = "Chief " + std::to_string(i + 1),
                                        .externalId = "C-" + std::to_string(2001 + i),
                                        .trainee = false,
                                        .raterClass = "chief"}));
  }
  return ids;
}

std::string StudyCentre::runPaperCurriculum() {
  as("administrator");
  for (const CurriculumTemplate& shipped : curriculumTemplates(assets())) {
    if (shipped.id != "paper-three-arms") {
      continue;
    }
    const CurriculumId id = addCurriculum(*session_, shipped.title, shipped.description, shipped.content);
    const CurriculumVersionId version = publishCurriculum(*session_, id, "first", assets());
    runCurriculum(*session_, version);
    return version;
  }
  return {};
}

std::string StudyCentre::addPaperRubric() {
  as("administrator");
  const std::vector<RubricTemplate> shipped = rubricTemplates(assets());
  return addRubric(*session_, shipped.at(0).title, shipped.at(0).revision);
}

std::map<std::string, std::int64_t> StudyCentre::rowCounts() {
  std::map<std::string, std::int64_t> counts;
  Statement table = connection_->prepare("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  table.execute();
  std::vector<std::string> names;
  while (table.step()) {
    names.push_back(table.text(0));
  }
  for (const std::string& name : names) {
    Statement row = connection_->prepare("SELECT count(*) FROM " + name);
    row.execute();
    if (row.step()) {
      counts[name] = row.int64(0);
    }
  }
  return counts;
}

std::int64_t StudyCentre::audited(const std::string& action) {
  Statement row = connection_->prepare("SELECT count(*) FROM audit_entry WHERE action = ?");
  row.execute({action});
  return row.step() ? row.int64(0) : 0;
}

}  // namespace torsio::testing
