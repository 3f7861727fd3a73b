// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/people_service.h"

#include <functional>

#include <gtest/gtest.h>

#include "app/services/people/consent_service.h"
#include "app/services/people/roster_import.h"
#include "assessment/domain/people/account.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

TEST(PeopleService, NumbersAreUniqueAndCodesAreNeverReused) {
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

TEST(PeopleService, ChangesAreAuditedWithOldAndNewValuesButWithoutNames) {
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

TEST(PeopleService, NamedExportIsAuditedAndSafeForSpreadsheets) {
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

TEST(RosterAccounts, EverybodyWithoutAnAccountGetsOneWithAPasswordToChange) {
  StudyCentre centre;
  const std::vector<TraineeId> trainees = centre.addTrainees(3);
  const std::vector<RaterId> chiefs = centre.addChiefs(2);
  SessionContext& session = centre.as("administrator");
  addUser(session, {.login = "t-01",  // used by somebody else, who needs no second account
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

TEST(RosterAccounts, CancellingKeepsTheAccountsAlreadyCreated) {
  StudyCentre centre;
  const std::vector<TraineeId> trainees = centre.addTrainees(4);
  SessionContext& session = centre.as("administrator");
  std::vector<StartAccount> made;

  EXPECT_THROW(addAccounts(session, trainees, made,
                           [](const Progress& progress) {
                             if (progress.fraction >= 0.5) {
                               throw Error(ErrorCode::kBadData, Text::verbatim("stop"), "", "");
                             }
                           }),
               Error);

  EXPECT_EQ(made.size(), 2U);
  EXPECT_EQ(peopleWithoutAccount(session).size(), 2U);
  EXPECT_EQ(signIn(session, made[1].login, made[1].startPassword).outcome, SignIn::kMustChange);
}

TEST(ConsentService, LatestDecisionCountsAndWithdrawalIsListed) {
  StudyCentre centre;
  const std::string id = centre.addTrainees(1).front();
  SessionContext& session = centre.session();
  const std::string version = shippedConsent(centre.assets()).id;

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

  const ConsentVersion shipped = shippedConsent(centre.assets());
  const ConsentWords& english = wordsIn(shipped, "en");
  const ConsentWords& chinese = wordsIn(shipped, "zh_CN");

  ASSERT_EQ(english.texts.size(), 5U);
  ASSERT_EQ(chinese.texts.size(), 5U);
  for (std::size_t i = 0; i < english.texts.size(); ++i) {
    EXPECT_EQ(english.texts[i].purpose, chinese.texts[i].purpose);
    EXPECT_NE(english.texts[i].text, chinese.texts[i].text);
  }
  EXPECT_EQ(&wordsIn(shipped, "eo"), &english) << "a language that it lacks";
}

TEST(ConsentService, TheCentrePublishesItsOwnTextsAndKeepsEveryVersion) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const ConsentVersion before = askedConsent(session, centre.assets());
  std::vector<ConsentWords> words = before.languages;
  words.front().texts.front().text = "We keep everything for two years.";
  words.push_back({"de", words.front().texts});
  for (ConsentWords& one : words) {
    one.texts.push_back({"", "Photographs", "My picture may hang in the corridor."});
    one.texts.erase(one.texts.begin() + 1);  // no video here
  }

  const std::string id = publishConsent(session, centre.assets(), words, "two years, photographs");

  const ConsentVersion now = askedConsent(session, centre.assets());
  EXPECT_EQ(now.id, id);
  EXPECT_EQ(now.note, "two years, photographs");
  EXPECT_EQ(now.publishedBy, session.actor().userId);
  ASSERT_EQ(now.languages.size(), 3U);
  const ConsentWords& german = wordsIn(now, "de");
  ASSERT_EQ(german.language, "de");
  ASSERT_EQ(german.texts.size(), 5U);
  EXPECT_EQ(german.texts[1].purpose, "research");
  EXPECT_EQ(german.texts[4].purpose, "purpose-6");
  EXPECT_EQ(german.texts[4].title, "Photographs");
  const std::vector<ConsentVersion> all = consentVersions(session, centre.assets());
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, before.id);
  EXPECT_EQ(wordsIn(all[0], "en").texts[0].text, wordsIn(before, "en").texts[0].text);
  EXPECT_EQ(centre.audited("consent.publish"), 1);
  const std::string person = centre.addTrainees(1).front();
  recordConsent(session, person, "purpose-6", true, id);
  EXPECT_EQ(consentHistory(session, person).back().purpose, "purpose-6");
}

TEST(ConsentService, RejectsInvalidTexts) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const std::vector<ConsentWords> words = askedConsent(session, centre.assets()).languages;
  const auto refused = [&](const std::function<void(std::vector<ConsentWords>&)>& spoil,
                           const std::string& note = "why") {
    std::vector<ConsentWords> spoiled = words;
    spoil(spoiled);
    const auto rows = centre.rowCounts();
    EXPECT_THROW((void)publishConsent(session, centre.assets(), spoiled, note), Error);
    EXPECT_EQ(centre.rowCounts(), rows);
  };

  refused([](auto&) {});  // no changes
  refused([](auto& all) { all[0].texts[0].text = "new"; }, "");
  refused([](auto& all) { all.clear(); });
  refused([](auto& all) {
    for (ConsentWords& one : all) {
      one.texts.erase(one.texts.begin());  // the training record
    }
  });
  refused([](auto& all) { all[0].texts.pop_back(); });
  refused([](auto& all) { std::swap(all[1].texts[1], all[1].texts[2]); });
  refused([](auto& all) { all[1].texts[1].text.clear(); });
  refused([](auto& all) { all[1].texts[1].title.clear(); });
  refused([](auto& all) { all[1].language = all[0].language; });
  refused([](auto& all) {
    for (ConsentWords& one : all) {
      one.texts[1].purpose = "selling";
    }
  });
  refused([](auto& all) {
    for (ConsentWords& one : all) {
      one.texts[1].purpose = one.texts[2].purpose;
    }
  });
}

TEST(ConsentService, APaperDecisionKeepsTheDateOfTheSignature) {
  StudyCentre centre;
  const std::string id = centre.addTrainees(1).front();
  SessionContext& session = centre.session();

  recordConsent(session, id, "video", true, "2026-1", kStudyTime_us - 3 * kDay_us);
  recordConsent(session, id, "teaching", true, "2026-1");

  const std::vector<ConsentDecision> all = consentHistory(session, id);
  ASSERT_EQ(all.size(), 2U);
  for (const ConsentDecision& one : all) {
    EXPECT_EQ(one.form, ConsentForm::kPaper);
    EXPECT_EQ(one.signedUtc_us, one.purpose == "video" ? kStudyTime_us - 3 * kDay_us : kStudyTime_us);
  }
  EXPECT_THROW(recordConsent(session, id, "video", true, "2026-1", kStudyTime_us + 3 * kDay_us), Error);
}

// What the consent promises: trainees can request a copy of their record, or its erasure.

/// Signs in the user "trainee" as this person of the record.
SessionContext& asTrainee(StudyCentre& centre, const TraineeId& person) {
  SessionContext& session = centre.as("trainee");
  Actor actor = session.actor();
  actor.personId = person;
  session.setActor(actor);
  return session;
}

TEST(PersonRequests, GoFromTheTraineesPageToTheAdministratorsListAndBack) {
  StudyCentre centre;
  const std::vector<TraineeId> people = centre.addTrainees(2);

  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kExport);
  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase);
  EXPECT_THROW(requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase), Error)
      << "it waits already";
  requestAboutOwnRecord(asTrainee(centre, people[1]), PersonRequestKind::kExport);

  EXPECT_EQ(ownRequests(asTrainee(centre, people[0])).size(), 2U) << "nobody sees another one's";
  const std::vector<PersonRequest> all = personRequests(centre.as("administrator"));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(centre.audited("person.request"), 3);
  for (const PersonRequest& one : all) {
    if (one.kind == PersonRequestKind::kErase) {
      EXPECT_EQ(one.personCode, "T-01");
      EXPECT_THROW(answerPersonRequest(centre.as("administrator"), one.id, false, ""), Error);
      answerPersonRequest(centre.as("administrator"), one.id, false, "the study still runs");
      EXPECT_THROW(answerPersonRequest(centre.as("administrator"), one.id, true, "twice"), Error);
    } else if (one.personId == people[0]) {
      answerPersonRequest(centre.as("administrator"), one.id, true, "handed over");
    } else {
      EXPECT_THROW(takeBackOwnRequest(asTrainee(centre, people[0]), one.id), Error) << "not theirs";
      takeBackOwnRequest(asTrainee(centre, people[1]), one.id);
    }
  }
  for (const PersonRequest& one : ownRequests(asTrainee(centre, people[0]))) {
    EXPECT_EQ(one.answer, one.kind == PersonRequestKind::kErase ? PersonRequestAnswer::kDeclined
                                                                : PersonRequestAnswer::kDone);
    EXPECT_FALSE(one.reason.empty());
  }
  EXPECT_EQ(ownRequests(asTrainee(centre, people[1])).at(0).answer, PersonRequestAnswer::kTakenBack);
  EXPECT_EQ(centre.audited("person.request_answer"), 3);
  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase);  // may request again
}

TEST(PersonRequests, AreForPeopleOfTheRecord) {
  StudyCentre centre;
  EXPECT_THROW(requestAboutOwnRecord(asTrainee(centre, {}), PersonRequestKind::kExport), Error);
}

}  // namespace
}  // namespace torsio
