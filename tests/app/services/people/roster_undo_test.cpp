// SPDX-License-Identifier: GPL-3.0-or-later
// Undoing an import, with the service and the command: in a file, on a server as owner of the tables, and
// there in the role of the stations.
#include "app/services/people/roster_undo.h"

#include <array>
#include <fstream>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/access_service.h"
#include "app/services/access/start_password.h"
#include "app/services/maintenance/server_move.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_accounts.h"
#include "app/services/people/roster_import.h"
#include "app/services/study/cohort_service.h"
#include "db/connection/locator.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/app/services/people/commit_roster.h"
#include "tests/app/support/study_centre.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

constexpr const char* kStationPassword = "the word of the stations";
constexpr const char* kChiefsAsTrainees =
    "Staff ID,Name,E-mail\nC-1,Ann Chief,ann@example.org\nC-2,Bo Chief,bo@example.org\n";

enum class Account { kOwner, kStation };

/// An office that uses the account of the owner, or that of the stations.
class RosterUndo : public DatabaseTest, public ::testing::WithParamInterface<Account> {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    if (GetParam() == Account::kStation && !onPostgresql()) {
      GTEST_SKIP() << "an SQLite file has no roles";
    }
    centre_ = std::make_unique<StudyCentre>(locator());
    record_ = locator();
    if (GetParam() == Account::kStation) {
      workAsStation();
    }
    own_ = std::make_unique<SessionContext>(SessionKey{record_, "the desk", {}});
    ASSERT_EQ(signIn(*own_, "administrator", kStudyPassword).outcome, SignIn::kOk);
    folder_ = emptyFolder(std::string("undo-") + (GetParam() == Account::kStation ? "s-" : "o-") +
                          std::to_string(::testing::UnitTest::GetInstance()->current_test_info()->line()));
    std::ofstream(folder_ / "password") << kStudyPassword << "\n";
  }
  void TearDown() override {
    own_.reset();
    if (!role_.empty()) {
      Connection& owner = centre_->connection();
      Transaction transaction(owner);
      waitForRightsOfDatabase(owner);
      owner.executeVerbatim("DROP OWNED BY " + role_);
      owner.executeVerbatim("DROP ROLE " + role_);
      transaction.commit();
    }
    centre_.reset();
    DatabaseTest::TearDown();
  }
  void workAsStation() {
    Locator address = parseLocator(locator());
    role_ = "station_" + address.schema.substr(address.schema.size() - 8);
    prepareServer(centre_->as("administrator"), role_);
    centre_->connection().executeVerbatim("ALTER ROLE " + role_ + " PASSWORD '" + kStationPassword + "'");
    address.user = role_;
    address.password = kStationPassword;
    record_ = addressOf(address);
  }

  SessionContext& office() {
    own_->beginCall();
    return *own_;
  }
  /// Returns the import that added this many people; imports at the same time have no order.
  ImportedRoster importThatAdded(std::int64_t people) {
    for (const ImportedRoster& one : importedRosters(office())) {
      if (one.added == people) {
        return one;
      }
    }
    ADD_FAILURE() << "no import added " << people;
    return {};
  }
  /// Runs the program as the user `login`, with this office's account; its password comes from elsewhere.
  [[nodiscard]] ProgramRun run(const std::string& arguments,
                               const std::string& login = "administrator") const {
    std::string address = record_;
    std::string environment;
    if (Locator server = parseLocator(record_); server.engine == Engine::kPostgresql) {
      environment = "PGPASSWORD='" + server.password + "'";
      server.password.clear();
      address = addressOf(server);
    }
    return runTorsio("roster " + arguments + " --database '" + address + "' --as " + login +
                         " --password-fd 3 3<" + (folder_ / "password").string(),
                     folder_, environment);
  }
  [[nodiscard]] nlohmann::json listed() const {
    const ProgramRun shown = run("imports --json");
    EXPECT_EQ(shown.code, 0) << shown.err;
    return nlohmann::json::parse(shown.out, nullptr, false);
  }

  std::unique_ptr<StudyCentre> centre_;
  std::string record_;
  std::string role_;  // of the stations; empty: none
  std::unique_ptr<SessionContext> own_;
  std::filesystem::path folder_;
};

INSTANTIATE_TEST_SUITE_P(Accounts, RosterUndo, ::testing::Values(Account::kOwner, Account::kStation),
                         [](const ::testing::TestParamInfo<Account>& one) {
                           return one.param == Account::kOwner ? "AsOwner" : "AsStation";
                         });

TEST_P(RosterUndo, UndoesRatersImportedAsTrainees) {
  commitRoster(office(), kChiefsAsTrainees);
  const std::vector<ImportedRoster> imports = importedRosters(office());
  ASSERT_EQ(imports.size(), 1U);
  EXPECT_EQ(imports[0].added, 2);
  EXPECT_EQ(imports[0].codes, (std::vector<std::string>{"T-01", "T-02"}));
  EXPECT_TRUE(imports[0].hindrance.empty()) << imports[0].hindrance.str();
  std::vector<StartAccount> accounts;
  own_->setPasswordCost(PasswordCost::kTest);
  addAccounts(office(), {people(office())[0].person.id}, accounts);
  ASSERT_EQ(accounts.size(), 1U);

  takeBackRosters(office(), std::array{imports[0].id}, "these are raters");

  EXPECT_TRUE(people(office()).empty());
  EXPECT_EQ(numberFrom(centre_->connection(), "SELECT count(*) FROM app_user WHERE login = 't-01'"), 0)
      << "nobody used the account";
  EXPECT_TRUE(importedRosters(office())[0].takenBack);
  EXPECT_EQ(importedRosters(office())[0].added, 2) << "the list still says what it was";
  EXPECT_EQ(centre_->audited("person.erase"), 2);
  EXPECT_EQ(centre_->audited("roster.import"), 2) << "imported, and taken back";
  EXPECT_THROW(takeBackRosters(office(), std::array{imports[0].id}, "again"), Error);
  commitRoster(office(), "Staff ID,Name,Class\nC-1,Ann Chief,chief physician\nC-2,Bo Chief,chief physician\n",
               RosterKind::kRaters);
  ASSERT_EQ(people(office()).size(), 2U) << "their numbers are free again";
  EXPECT_TRUE(people(office())[0].rater);
  EXPECT_FALSE(people(office())[0].trainee);
  EXPECT_TRUE(verifyAuditTrail(centre_->connection()).empty());
}

TEST_P(RosterUndo, RestoresPeopleWhomTheImportChanged) {
  commitRoster(office(), "Staff ID,Name,Class\nC-1,Ann Chief,chief physician\n", RosterKind::kRaters);
  commitRoster(office(), "Staff ID,Name,E-mail\nC-1,Ann Chief,ann@example.org\n");
  ASSERT_TRUE(people(office())[0].trainee) << "the chief became a trainee as well";

  takeBackRosters(office(), std::array{importThatAdded(0).id}, "the wrong file");

  ASSERT_EQ(people(office()).size(), 1U);
  EXPECT_TRUE(people(office())[0].rater);
  EXPECT_FALSE(people(office())[0].trainee);
  EXPECT_EQ(namedPeople(office())[0].identity.email, "") << "the file brought the address";
  EXPECT_TRUE(verifyAuditTrail(centre_->connection()).empty());
}

TEST_P(RosterUndo, SeveralAreUndoneLatestFirstAllOrNothing) {
  commitRoster(office(), kChiefsAsTrainees);
  commitRoster(office(), "Staff ID,Name,E-mail\nC-1,Ann Chief,new@example.org\nC-2,Bo Chief,b@example.org\n");
  const std::string first = importThatAdded(2).id;
  const std::string changed = importThatAdded(0).id;
  const std::string hindrance = importThatAdded(2).hindrance.str();
  EXPECT_TRUE(hindrance.ends_with(" was changed since")) << hindrance;

  EXPECT_THROW(takeBackRosters(office(), std::array{changed, std::string("no-such")}, "wrong"), Error);
  std::set<std::string> mails;  // codes are assigned at random
  for (const NamedPersonRow& one : namedPeople(office())) {
    mails.insert(one.identity.email);
  }
  EXPECT_TRUE(mails.contains("new@example.org")) << "none was taken back";
  const ProgramRun taken = run("take-back " + first + " " + changed + " --reason 'both are wrong'");

  EXPECT_EQ(taken.code, 0) << taken.err;
  EXPECT_TRUE(people(office()).empty());
  EXPECT_TRUE(verifyAuditTrail(centre_->connection()).empty());
}

TEST_P(RosterUndo, NothingIsUndoneIfAPersonHasDependentData) {
  commitRoster(office(), kChiefsAsTrainees);
  const ImportedRoster imported = importedRosters(office())[0];
  const PersonId last = people(office())[1].person.id;
  recordConsent(office(), last, "training_record", true, shippedConsent(centre_->assets()).id);

  const ImportedRoster now = importedRosters(office())[0];
  EXPECT_EQ(now.hindrance.str(), "T-02 has decided about a consent");
  EXPECT_THROW(takeBackRosters(office(), std::array{imported.id}, "the wrong file"), Error);
  EXPECT_EQ(people(office()).size(), 2U);

  commitRoster(office(), "Staff ID,Name\nS-9,Di Intern\n");
  const PersonId corrected = people(office())[2].person.id;
  PersonEntry entry = personEntry(office(), corrected);
  entry.level = "doctoral student";
  changePerson(office(), corrected, entry, "asked");
  EXPECT_EQ(importThatAdded(1).hindrance.str(), "T-03 was changed since");
}

TEST_P(RosterUndo, TheCommandListsAndUndoesImports) {
  commitRoster(office(), kChiefsAsTrainees);
  commitRoster(office(), "Staff ID,Name\nS-9,Di Intern\n");
  const CohortId cohort = addCohort(office(), {.name = "Study", .groups = {{"G1", "all"}}});
  for (const PersonRow& row : people(office())) {
    if (row.person.code == "T-03") {
      (void)enrolTrainees(office(), cohort, {row.person.id});
    }
  }
  const std::string chiefs = importThatAdded(2).id;
  const std::string enrolled = importThatAdded(1).id;

  const ProgramRun lines = run("imports");
  EXPECT_EQ(lines.code, 0) << lines.err;
  EXPECT_NE(lines.out.find(chiefs), std::string::npos) << lines.out;
  EXPECT_NE(lines.out.find("trainees: 2 added, 0 changed; can be undone"), std::string::npos) << lines.out;
  EXPECT_NE(lines.out.find("1 added, 0 changed; T-03 is enrolled in a cohort"), std::string::npos)
      << lines.out;
  const ProgramRun held = run("take-back " + enrolled + " --reason 'the wrong file'");
  EXPECT_EQ(held.code, static_cast<int>(ErrorCode::kBadData)) << held.err;
  EXPECT_NE(held.err.find("T-03 is enrolled in a cohort"), std::string::npos) << held.err;
  const ProgramRun taken = run("take-back " + chiefs + " --reason 'these are raters'");
  EXPECT_EQ(taken.code, 0) << taken.err;
  EXPECT_EQ(taken.out, "Taken back: " + chiefs + "\n");

  ASSERT_EQ(people(office()).size(), 1U);
  EXPECT_EQ(people(office())[0].person.code, "T-03");
  for (const nlohmann::json& one : listed()) {
    EXPECT_EQ(one.at("taken_back"), one.at("id") == chiefs) << one;
    EXPECT_EQ(one.at("by"), "administrator");
    EXPECT_EQ(one.at("codes").size(), one.at("id") == chiefs ? 0U : 1U) << one;
  }
  EXPECT_EQ(numberFrom(centre_->connection(),
                       "SELECT count(*) FROM audit_entry WHERE action = 'roster.import'"
                       " AND reason = 'these are raters'"),
            1);
}

TEST_P(RosterUndo, TheCommandRejectsMissingRightsAndUnknownImports) {
  commitRoster(office(), kChiefsAsTrainees);
  const std::string chiefs = importThatAdded(2).id;

  const ProgramRun statistician = run("take-back " + chiefs + " --reason 'curious'", "statistician");
  EXPECT_EQ(statistician.code, static_cast<int>(ErrorCode::kPermission)) << statistician.err;
  EXPECT_EQ(run("imports", "statistician").code, static_cast<int>(ErrorCode::kPermission));
  EXPECT_EQ(run("take-back " + chiefs).code, static_cast<int>(ErrorCode::kUsage)) << "needs a reason";
  const ProgramRun unknown = run("take-back no-such-import --reason 'the wrong file'");
  EXPECT_EQ(unknown.code, static_cast<int>(ErrorCode::kBadData)) << unknown.err;
  EXPECT_NE(unknown.err.find("no-such-import"), std::string::npos) << unknown.err;

  EXPECT_EQ(people(office()).size(), 2U);
}

}  // namespace
}  // namespace torsio
