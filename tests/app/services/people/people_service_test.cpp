// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/services/people/people_service.h"

#include <functional>

#include <gtest/gtest.h>

#include "app/services/people/consent_service.h"
#include "app/services/people/roster_accounts.h"
#include "app/services/people/roster_import.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/services/people/commit_roster.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

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

RosterPreview look(SessionContext& session, const std::string& text,
                   RosterKind kind = RosterKind::kTrainees) {
  const RosterFile file = parseRoster(text, "roster.csv");
  return previewRoster(session, file, kind, suggestColumns(file, kind));
}

TEST(PeopleService, ANumberThatLooksLikeSomebodyElsesIsRefused) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  addPerson(session, {.fullName = "Ann Smith", .externalId = "S-10", .trainee = true});

  const std::string refused = testing::refusalText(
      [&] { addPerson(session, {.fullName = "Bo Chen", .externalId = "s-1O", .trainee = true}); });

  EXPECT_NE(refused.find("looks like that of T-01"), std::string::npos) << refused;
}

TEST(RosterPreview, TellsWhatASpreadsheetDidAndOneAddressForTwo) {
  StudyCentre centre;
  const RosterPreview preview = look(centre.as("administrator"),
                                     "id,name,email\n1E+05,Ann Smith,ann@x.org\nS-2,Bo Chen,Ann@X.org\n"
                                     "S-1E+05,Cy Diaz,\n2.34568E+11,Di Eck,\n");

  EXPECT_TRUE(preview.importable());
  EXPECT_NE(preview.rows[0].hint.str().find("spreadsheet"), std::string::npos);
  EXPECT_NE(preview.rows[1].hint.str().find("line 2 has the same e-mail address"), std::string::npos);
  EXPECT_EQ(preview.rows[2].hint.str(), "");
  EXPECT_NE(preview.rows[3].hint.str().find("spreadsheet"), std::string::npos);
}

TEST(RosterFile, ReadsCommaSemicolonAndTabWithAndWithoutByteOrderMark) {
  for (const char separator : {',', ';', '\t'}) {
    for (const char* mark : {"", "\xEF\xBB\xBF"}) {
      const std::string s(1, separator);
      const RosterFile file =
          parseRoster(mark + ("Staff ID" + s + "Name\r\nS-1" + s + "\"Smith, Ann\"\r\n"), "roster.csv");
      EXPECT_EQ(file.separator, separator);
      ASSERT_EQ(file.rows.size(), 1U);
      EXPECT_EQ(file.header, (std::vector<std::string>{"Staff ID", "Name"}));
      EXPECT_EQ(file.rows[0].values, (std::vector<std::string>{"S-1", "Smith, Ann"}));
    }
  }
}

TEST(RosterFile, ReadsEncodingsOfOlderSpreadsheets) {
  struct Saved {
    const char* encoding;
    std::string bytes;
    const char* name;
  };
  const std::vector<Saved> all{
      {"Windows-1252", "id;name\r\nS-1;J\xF6rg M\xFCller\r\n", "J\xC3\xB6rg M\xC3\xBCller"},
      {"Windows-1252", "id;name\r\nS-1;\x8Atefan \x96 \xC9t\xE9\r\n",
       "\xC5\xA0tefan \xE2\x80\x93 \xC3\x89t\xC3\xA9"},
      {"GB18030", "id,name\r\nS-1,\xD5\xC5\xCE\xB0\r\n", "\xE5\xBC\xA0\xE4\xBC\x9F"},
      {"UTF-8", "id,name\r\nS-1,M\xC3\xBCller\r\n", "M\xC3\xBCller"},
      {"UTF-16", std::string("\xFF\xFEi\0d\0\t\0n\0a\0m\0e\0\r\0\n\0S\0-\0001\0\t\0\xFC\0\r\0\n\0", 34),
       "\xC3\xBC"},
      {"UTF-16", std::string("\xFE\xFF\0i\0d\0,\0n\0a\0m\0e\0\n\0S\0,\0\xFC", 24), "\xC3\xBC"}};
  for (const Saved& saved : all) {
    const RosterFile file = parseRoster(saved.bytes, "roster.csv");
    EXPECT_EQ(file.encoding, saved.encoding);
    ASSERT_EQ(file.rows.size(), 1U) << saved.encoding;
    ASSERT_EQ(file.rows[0].values.size(), 2U) << saved.encoding;
    EXPECT_EQ(file.rows[0].values[1], saved.name) << saved.encoding;
  }
}

TEST(RosterFile, RejectsFilesThatAreNotTextWithAPlainSentence) {
  for (const std::string& bytes :
       {std::string("\xFF\xFEi\0d\0\0", 7), std::string("id,name\nS-1,\x81\x8D\n")}) {
    const Error refused = testing::refusal([&] { (void)parseRoster(bytes, "roster.csv"); });
    EXPECT_EQ(refused.where(), "roster.csv");
    EXPECT_EQ(refused.remedy(), "Save the table as UTF-8 CSV");
  }
}

TEST(RosterFile, SkipsLinesWithOnlySeparators) {
  const RosterFile file = parseRoster("id;name;level\nS-1;Ann;\n;;\n ; ;\nS-2;Bob;\n;;;;;\n", "roster.csv");
  ASSERT_EQ(file.rows.size(), 2U);
  EXPECT_EQ(file.rows[1].line, 5U);
}

TEST(RosterFile, SuggestsColumnsFromEnglishAndChineseHeaders) {
  const RosterFile english = parseRoster("E-Mail,Gender,Full Name,Student No.\nx,y,z,1\n", "a.csv");
  const RosterFile chinese = parseRoster("姓名,学号,性别\n王,1,女\n", "b.csv");

  const RosterColumns first = suggestColumns(english, RosterKind::kTrainees);
  const RosterColumns second = suggestColumns(chinese, RosterKind::kTrainees);

  EXPECT_EQ(first[static_cast<std::size_t>(RosterField::kEmail)], 0U);
  EXPECT_EQ(first[static_cast<std::size_t>(RosterField::kExternalId)], 3U);
  EXPECT_EQ(second[static_cast<std::size_t>(RosterField::kFullName)], 0U);
  EXPECT_EQ(second[static_cast<std::size_t>(RosterField::kExternalId)], 1U);
  EXPECT_FALSE(second[static_cast<std::size_t>(RosterField::kEmail)].has_value());
}

TEST(RosterFile, AcceptsItsOwnTemplate) {
  for (const RosterKind kind : {RosterKind::kTrainees, RosterKind::kRaters}) {
    const RosterFile file = parseRoster(rosterTemplate(kind), "template.csv");
    const RosterColumns columns = suggestColumns(file, kind);
    for (const RosterField field : rosterFields(kind)) {
      EXPECT_TRUE(columns[static_cast<std::size_t>(field)].has_value()) << rosterFieldCode(field);
    }
  }
}

/// An empty centre with its administrator signed in.
class RosterImports : public ::testing::Test {
 protected:
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
};

TEST_F(RosterImports, GivesEveryLineItsStatusAndARemedy) {
  commitRoster(session, "id,name,sex,level,email\nS-1,Ann,f,graduate,ann@x.org\nS-2,Bob,m,graduate,\n");

  const RosterPreview preview = look(session,
                                     "id,name,sex,level,email\n"
                                     "S-1,Ann,F,graduate,ann@x.org\n"  // unchanged
                                     "S-2,Bob,m,doctoral student,\n"   // level differs
                                     "S-3,Cid,,,ann@x.org\n"           // new, with an address in use
                                     "S-4,Dan,purple,,\n"              // invalid sex
                                     ",Eve,,,\n"                       // no number
                                     "S-3,Cid again,,,\n"              // duplicate number
                                     "S-5,Fay,f\n");                   // too few values

  ASSERT_EQ(preview.rows.size(), 7U);
  EXPECT_EQ(preview.rows[0].status, RosterStatus::kSame);
  EXPECT_EQ(preview.rows[1].status, RosterStatus::kChanges);
  ASSERT_EQ(preview.rows[1].changes.size(), 1U);
  EXPECT_EQ(preview.rows[1].changes[0].from, "graduate");
  EXPECT_EQ(preview.rows[1].changes[0].to, "doctoral student");
  EXPECT_EQ(preview.rows[2].status, RosterStatus::kNew);
  EXPECT_NE(preview.rows[2].hint.str().find("the e-mail address belongs to"), std::string::npos);
  EXPECT_EQ(preview.rows[3].problem, "\"purple\" is not understood as Sex");
  EXPECT_EQ(preview.rows[4].problem, "Staff or student number is missing");
  EXPECT_EQ(preview.rows[5].problem, "the number S-3 is already on line 4");
  EXPECT_EQ(preview.rows[6].problem, "the line has 3 values, the header 5");
  for (std::size_t i = 3; i < 7; ++i) {
    EXPECT_FALSE(preview.rows[i].remedy.empty()) << i;
  }
  EXPECT_EQ(preview.errors, 4U);
  EXPECT_FALSE(preview.importable());
}

TEST_F(RosterImports, ImportsADuplicateLineOnce) {
  const char* text = "id,name,sex\nS-1,Ann,f\nS-2,Bob,m\nS-1,Ann,F\n";

  const RosterPreview preview = look(session, text);

  EXPECT_TRUE(preview.importable());
  EXPECT_EQ(preview.added, 2U);
  EXPECT_EQ(preview.rows[2].status, RosterStatus::kSame);
  EXPECT_EQ(preview.rows[2].hint, "the same as line 2: taken once");
  commitRoster(session, text);
  EXPECT_EQ(people(session).size(), 2U);
}

TEST_F(RosterImports, ReportsTheLineOfATextThatIsTooLongOrHasInvisibleCharacters) {
  const RosterPreview preview = look(session,
                                     "id,name,level\n"
                                     "S-1,Ann,\n"
                                     "S-2," +
                                         std::string(201, 'x') +
                                         ",\n"                          // 201 characters
                                         "S-3,Bob\xE2\x80\xAE nnA,\n"   // U+202E reverses what follows
                                         "S-4\xE2\x80\x8B,Cid,\n"       // U+200B, a zero-width space
                                         "S-5,Dan,\"second\nyear\"\n"   // a line end
                                         "S-6,Zo\xC3\xAB O'Brien,\n");  // valid

  ASSERT_EQ(preview.rows.size(), 6U);
  EXPECT_EQ(preview.rows[1].problem, "Full name is longer than 200 characters");
  EXPECT_EQ(preview.rows[2].problem, "Full name contains the invisible character U+202E");
  EXPECT_EQ(preview.rows[3].line, 5U);
  EXPECT_FALSE(preview.rows[3].problem.empty());
  EXPECT_FALSE(preview.rows[4].problem.empty());
  EXPECT_EQ(preview.rows[5].status, RosterStatus::kNew);
  EXPECT_EQ(preview.errors, 4U);
}

TEST_F(RosterImports, ReportsTheLinesOfNumbersThatLookAlike) {
  commitRoster(session, "id,name\nS-1,Ann\n");

  const RosterPreview preview = look(session,
                                     "id,name\n"
                                     "\xD0\x85-1,Ann\n"  // Cyrillic dze
                                     "S-2,Bob\n"         //
                                     "S\xE2\x80\x93"
                                     "2,Bob\n"               // en dash
                                     "\xEF\xBC\xB3-3,Cid\n"  // wide S, unique
                                     "S-4,Dan\n"
                                     "S-\xD9\xA4,Dan\n"          // an Arabic 4
                                     "S-10,Eve\nS-1O,Eve\n"      // O for 0
                                     "\xF0\xA0\x80\x80-7,Fay\n"  // two rare Chinese characters
                                     "\xF0\xA0\x80\x81-7,Gil\n");

  ASSERT_EQ(preview.rows.size(), 10U);
  EXPECT_NE(preview.rows[0].problem.str().find("looks like that of T-"), std::string::npos);
  EXPECT_NE(preview.rows[2].problem.str().find("looks like that of line 3"), std::string::npos);
  EXPECT_EQ(preview.rows[3].status, RosterStatus::kNew);
  EXPECT_NE(preview.rows[5].problem.str().find("looks like that of line 6"), std::string::npos);
  EXPECT_NE(preview.rows[7].problem.str().find("looks like that of line 8"), std::string::npos);
  EXPECT_EQ(preview.rows[9].status, RosterStatus::kNew);
  EXPECT_EQ(preview.errors, 4U);
}

TEST_F(RosterImports, ImportsAllOrNothing) {
  const auto before = centre.rowCounts();

  EXPECT_THROW(commitRoster(session, "id,name,age\nS-1,Ann,24\nS-2,Bob,old\n"), Error);

  EXPECT_EQ(centre.rowCounts(), before);
}

TEST_F(RosterImports, DryRunDoesEverythingAndRollsBack) {
  const auto before = centre.rowCounts();

  const RosterOutcome outcome =
      commitRoster(session, "id,name\nS-1,Ann\nS-2,Bob\n", RosterKind::kTrainees, RosterMode::kDryRun);

  EXPECT_EQ(outcome.added, 2U);
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST_F(RosterImports, GivesPseudonymsAndKeepsNamesOutOfTheTrail) {
  const RosterOutcome outcome = commitRoster(session, "id,name,sex\nS-1,Ann Onymous,f\nS-2,Bob Onymous,m\n");

  EXPECT_EQ(outcome.newCodes, (std::vector<std::string>{"T-01", "T-02"}));
  EXPECT_EQ(centre.audited("person.add"), 2);
  EXPECT_EQ(centre.audited("roster.import"), 1);
  for (const AuditEntry& entry : AuditRepository(centre.connection()).entries()) {
    EXPECT_EQ((entry.oldJson + entry.newJson + entry.reason).find("Onymous"), std::string::npos);
  }
  for (const PersonRow& row : people(session)) {
    EXPECT_TRUE(row.trainee);
  }
  EXPECT_EQ(namedPeople(session).size(), 2U);
}

TEST_F(RosterImports, EmptyCellsKeepExistingValues) {
  commitRoster(session, "id,name,sex,level\nS-1,Ann,f,graduate\n");

  commitRoster(session, "id,name,sex,level\nS-1,Ann B.,,\nS-2,Bob,,\n");

  const NamedPersonRow ann = namedPeople(session).at(0);
  EXPECT_EQ(ann.identity.fullName, "Ann B.");
  EXPECT_EQ(ann.row.person.sex, "female");
  EXPECT_EQ(ann.row.person.level, "graduate");
}

TEST_F(RosterImports, FailsIfTheRecordChangedSinceThePreview) {
  const RosterFile file = parseRoster("id,name\nS-1,Ann\n", "roster.csv");
  const RosterColumns columns = suggestColumns(file, RosterKind::kTrainees);
  const RosterPreview preview = previewRoster(session, file, RosterKind::kTrainees, columns);
  addPerson(session, {.fullName = "Ann", .externalId = "S-1"});

  EXPECT_THROW(
      importRoster(session, file, RosterKind::kTrainees, columns, preview.fingerprint, RosterMode::kCommit),
      Error);
}

TEST_F(RosterImports, ReadsRatersWithTheirClass) {
  const RosterOutcome outcome = commitRoster(
      session, "staff id;name;class\nC-1;Lee;chief physician\nC-2;Wang;主任医师\nC-3;Ruiz;deputy_chief\n",
      RosterKind::kRaters);

  EXPECT_EQ(outcome.newCodes, (std::vector<std::string>{"R-01", "R-02", "R-03"}));
  std::map<std::string, std::size_t> classes;
  for (const PersonRow& row : people(session)) {
    ++classes[row.raterClass];
  }
  EXPECT_EQ(classes["chief"], 2U);
  EXPECT_EQ(classes["deputy_chief"], 1U);
  EXPECT_EQ(look(session, "staff id,name,class\nC-9,Xu,professor\n", RosterKind::kRaters).errors, 1U);
}

TEST_F(RosterImports, ImportsAThousandLinesQuickly) {
  std::string text = "id,name,level\n";
  for (int i = 0; i < 1000; ++i) {
    text += "S-" + std::to_string(i) + ",Person " + std::to_string(i) + ",graduate\n";
  }

  const RosterOutcome outcome = commitRoster(centre.as("administrator"), text);

  EXPECT_EQ(outcome.added, 1000U);
  EXPECT_EQ(outcome.newCodes.back(), "T-1000");
}

}  // namespace

}  // namespace torsio
