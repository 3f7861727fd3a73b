// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_import.h"

#include <gtest/gtest.h>

#include "app/services/people/people_service.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "tests/app/services/people/commit_roster.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

RosterPreview look(SessionContext& session, const std::string& text,
                   RosterKind kind = RosterKind::kTrainees) {
  const RosterFile file = parseRoster(text, "roster.csv");
  return previewRoster(session, file, kind, suggestColumns(file, kind));
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

TEST(RosterImport, GivesEveryLineItsStatusAndARemedy) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
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

TEST(RosterImport, ImportsADuplicateLineOnce) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const char* text = "id,name,sex\nS-1,Ann,f\nS-2,Bob,m\nS-1,Ann,F\n";

  const RosterPreview preview = look(session, text);

  EXPECT_TRUE(preview.importable());
  EXPECT_EQ(preview.added, 2U);
  EXPECT_EQ(preview.rows[2].status, RosterStatus::kSame);
  EXPECT_EQ(preview.rows[2].hint, "the same as line 2: taken once");
  commitRoster(session, text);
  EXPECT_EQ(people(session).size(), 2U);
}

TEST(RosterImport, ReportsTheLineOfATextThatIsTooLongOrHasInvisibleCharacters) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");

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

TEST(RosterImport, ReportsTheLinesOfNumbersThatLookAlike) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
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

TEST(RosterImport, ImportsAllOrNothing) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const auto before = centre.rowCounts();

  EXPECT_THROW(commitRoster(session, "id,name,age\nS-1,Ann,24\nS-2,Bob,old\n"), Error);

  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(RosterImport, DryRunDoesEverythingAndRollsBack) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const auto before = centre.rowCounts();

  const RosterOutcome outcome =
      commitRoster(session, "id,name\nS-1,Ann\nS-2,Bob\n", RosterKind::kTrainees, RosterMode::kDryRun);

  EXPECT_EQ(outcome.added, 2U);
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(RosterImport, GivesPseudonymsAndKeepsNamesOutOfTheTrail) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");

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

TEST(RosterImport, EmptyCellsKeepExistingValues) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  commitRoster(session, "id,name,sex,level\nS-1,Ann,f,graduate\n");

  commitRoster(session, "id,name,sex,level\nS-1,Ann B.,,\nS-2,Bob,,\n");

  const NamedPersonRow ann = namedPeople(session).at(0);
  EXPECT_EQ(ann.identity.fullName, "Ann B.");
  EXPECT_EQ(ann.row.person.sex, "female");
  EXPECT_EQ(ann.row.person.level, "graduate");
}

TEST(RosterImport, FailsIfTheRecordChangedSinceThePreview) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const RosterFile file = parseRoster("id,name\nS-1,Ann\n", "roster.csv");
  const RosterColumns columns = suggestColumns(file, RosterKind::kTrainees);
  const RosterPreview preview = previewRoster(session, file, RosterKind::kTrainees, columns);
  addPerson(session, {.fullName = "Ann", .externalId = "S-1"});

  EXPECT_THROW(
      importRoster(session, file, RosterKind::kTrainees, columns, preview.fingerprint, RosterMode::kCommit),
      Error);
}

TEST(RosterImport, ReadsRatersWithTheirClass) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");

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

TEST(RosterImport, ImportsAThousandLinesQuickly) {
  StudyCentre centre;
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
