// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/people/people_service.h"

#include <gtest/gtest.h>

#include "app/people/consent_service.h"
#include "app/people/roster_accounts.h"
#include "assessment/people/account.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

TEST(PeopleService, NumbersAreUniqueAndCodesNeverComeTwice) {
  StudyCentre centre;
  const std::string first = centre.addTrainees(1).front();

  EXPECT_THROW(addPerson(centre.session(), {.fullName = "Other", .externalId = "S-1001"}), Error);
  setPersonState(centre.session(), first, PersonState::kLeft, "moved away");
  addPerson(centre.session(), {.fullName = "Next", .externalId = "S-2"});

  const std::vector<PersonRow> rows = people(centre.session());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].person.code, "T-01");
  EXPECT_EQ(rows[0].person.state, PersonState::kLeft);
  EXPECT_EQ(rows[1].person.code, "T-02");
}

TEST(PeopleService, ChangingKeepsOldAndNewInTheTrailWithoutNames) {
  StudyCentre centre;
  const std::string id = centre.addTrainees(1).front();
  SessionContext& session = centre.session();
  PersonEntry entry = personEntry(session, id);
  entry.level = "doctoral student";
  entry.fullName = "Married Name";
  entry.raterClass = "intern";

  changePerson(session, id, entry, "asked by herself");

  EXPECT_EQ(personEntry(session, id).raterClass, "intern");
  EXPECT_EQ(centre.audited("person.change"), 1);
  entry.trainee = false;
  EXPECT_THROW(changePerson(session, id, entry, "no"), Error);
}

TEST(PeopleService, NamedExportIsAuditedAndHarmlessToSpreadsheets) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  addPerson(session, {.fullName = "=cmd(\"x\"), Dr", .externalId = "S-1"});
  const std::filesystem::path file = centre.folder() / "people.csv";

  EXPECT_EQ(exportPeople(session, file, true), 1U);

  const std::string text = readFile(file);
  EXPECT_TRUE(
      text.starts_with("\xEF\xBB\xBF"
                       "code,trainee,rater_class"));
  EXPECT_NE(text.find("\"'=cmd(\"\"x\"\"), Dr\""), std::string::npos);
  EXPECT_EQ(centre.audited("people.export_named"), 1);
  EXPECT_THROW(exportPeople(centre.as("statistician"), file, true), Error);
  EXPECT_EQ(exportPeople(centre.as("statistician"), file, false), 1U);
  EXPECT_EQ(readFile(file).find("cmd"), std::string::npos);
}

TEST(RosterAccounts, EverybodyWithoutOneGetsAnAccountThatMustChangeItsPassword) {
  StudyCentre centre;
  const std::vector<TraineeId> trainees = centre.addTrainees(3);
  const std::vector<RaterId> chiefs = centre.addChiefs(2);
  SessionContext& session = centre.as("administrator");
  addUser(session, {.login = "t-01",  // taken by somebody else, who needs no second account
                    .personId = trainees[1],
                    .roles = {"trainee"},
                    .startPassword = "window over the yard"});
  setPersonState(session, chiefs[1], PersonState::kLeft, "retired");

  std::vector<PersonId> everybody = trainees;
  everybody.insert(everybody.end(), chiefs.begin(), chiefs.end());
  std::vector<StartAccount> made;
  addAccounts(session, everybody, made);

  ASSERT_EQ(made.size(), 3U);
  EXPECT_EQ(made[0].login, "r-01");
  EXPECT_EQ(made[1].login, "t-01.2");
  EXPECT_EQ(made[2].login, "t-03");
  EXPECT_TRUE(peopleWithoutAccount(session).empty());
  EXPECT_EQ(centre.audited("user.add"), 4);
  const SignInAnswer answer = signIn(session, "r-01", made[0].startPassword);
  EXPECT_EQ(answer.outcome, SignIn::kMustChange);
  EXPECT_EQ(answer.actor.roles, std::vector<std::string>{"rater"});
  EXPECT_EQ(answer.actor.personId, chiefs[0]);
}

TEST(RosterAccounts, GivingUpKeepsTheAccountsThatWereMade) {
  StudyCentre centre;
  const std::vector<TraineeId> trainees = centre.addTrainees(4);
  SessionContext& session = centre.as("administrator");
  std::vector<StartAccount> made;

  EXPECT_THROW(addAccounts(session, trainees, made,
                           [](const Progress& progress) {
                             if (progress.fraction >= 0.5) {
                               throw Error(ErrorCode::kBadData, "stop", "", "");
                             }
                           }),
               Error);

  EXPECT_EQ(made.size(), 2U);
  EXPECT_EQ(peopleWithoutAccount(session).size(), 2U);
  EXPECT_EQ(signIn(session, made[1].login, made[1].startPassword).outcome, SignIn::kMustChange);
}

TEST(ConsentService, NewestDecisionCountsAndWithdrawalIsListed) {
  StudyCentre centre;
  const std::string id = centre.addTrainees(1).front();
  SessionContext& session = centre.session();
  const std::string version = consentTexts(centre.assets()).at(0).version;

  recordConsent(session, id, "research", true, version);
  centre.passTime_us(1);
  recordConsent(session, id, "research", false, version);

  EXPECT_EQ(consentHistory(session, id).size(), 2U);
  EXPECT_TRUE(people(session).at(0).consents.empty());
  EXPECT_EQ(centre.audited("consent.withdraw"), 1);
  EXPECT_THROW(recordConsent(session, id, "marketing", true, version), Error);
  EXPECT_THROW(recordConsent(session, id, "research", true, ""), Error);
}

TEST(ConsentService, TextsExistInBothLanguagesUnderOneVersion) {
  StudyCentre centre;

  const auto english = consentTexts(centre.assets(), "en");
  const auto chinese = consentTexts(centre.assets(), "zh_CN");

  ASSERT_EQ(english.size(), 5U);
  ASSERT_EQ(chinese.size(), 5U);
  for (std::size_t i = 0; i < english.size(); ++i) {
    EXPECT_EQ(english[i].purpose, chinese[i].purpose);
    EXPECT_EQ(english[i].version, chinese[i].version);
    EXPECT_NE(english[i].text, chinese[i].text);
  }
}

}  // namespace
}  // namespace torsio
