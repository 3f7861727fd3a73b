// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/gradebook.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/base/csv_table.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

Grades grades() {
  return {.title = "Autumn intake",
          .occasions = {"before", "after 40 min"},
          .scale = {10, 100, 10},
          .people = {{"T-01", "Ada Green", "ada.green@example.org", "1001", {"4.5", "7.25"}},
                     {"T-02", "Li, Wei", "li@example.org", "1002", {"", "8"}},
                     {"T-03", "", "", "", {"3", ""}}}};
}

/// Returns what `call` says when it throws.
template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(Gradebook, OfMoodleHasALinePerPersonAndAColumnPerOccasion) {
  EXPECT_EQ(moodleGrades(grades()),
            "ID number,Email address,Autumn intake: before,Autumn intake: after 40 min\r\n"
            "1001,ada.green@example.org,4.5,7.25\r\n"
            "1002,li@example.org,,8\r\n"
            "T-03,,3,\r\n");
}

// Canvas reads the first columns by these names in this order, then a line with the points that are possible.
TEST(Gradebook, OfCanvasHasTheColumnsThatCanvasExports) {
  EXPECT_EQ(
      canvasGrades(grades()),
      "Student,ID,SIS User ID,SIS Login ID,Section,Autumn intake: before,Autumn intake: after 40 min\r\n"
      "    Points Possible,,,,,10,10\r\n"
      "Ada Green,,1001,ada.green@example.org,,4.5,7.25\r\n"
      "\"Li, Wei\",,1002,li@example.org,,,8\r\n"
      "T-03,,T-03,,,3,\r\n");
}

constexpr const char* kStatusHead =
    "update,usr_id,login,lastname,firstname,status,mark,notice,comment,plagiarism,plag_comment\r\n";

TEST(Gradebook, OfIliasFillsInTheStatusFileOfTheExercise) {
  const std::string status =
      std::string("\xEF\xBB\xBF") +
      "update;usr_id;login;lastname;firstname;status;mark;notice;comment;plagiarism;"
      "plag_comment\n0;311;ada.green;Green;Ada;notgraded;;;;;\n"
      "0;312;1002;Li;Wei;passed;5;\"late; ill\";;;\n0;313;nobody;No;Body;notgraded;;;;;\n";

  Grades more = grades();
  more.people.push_back({.code = "T-09", .scores = {"1", "2"}});
  const IliasGrades filled = iliasGrades(more, 1, status, "status.csv");
  EXPECT_EQ(filled.strangers, std::vector<std::string>{"nobody"});
  EXPECT_EQ(filled.absent, std::vector<std::string>{"T-09"});
  EXPECT_EQ(filled.text, std::string(kStatusHead) + "1,311,ada.green,Green,Ada,notgraded,7.25,,,,\r\n" +
                             "1,312,1002,Li,Wei,passed,8,\"late; ill\",,,\r\n" +
                             "0,313,nobody,No,Body,notgraded,,,,,\r\n");
  // A score that may not be shown leaves the line as it is.
  EXPECT_THAT(iliasGrades(grades(), 0, status, "status.csv").text, HasSubstr("0,312,1002,Li,Wei,passed,5,"));
}

TEST(Gradebook, OfIliasSaysWhatDoesNotFit) {
  EXPECT_THAT(refusal([] { (void)iliasGrades(grades(), 1, "name,mark\r\nAda,\r\n", "marks.csv"); }),
              HasSubstr("column update is missing"));
  EXPECT_THAT(refusal([] { (void)iliasGrades(grades(), 1, "", "empty.csv"); }), HasSubstr("empty.csv"));
  EXPECT_THAT(refusal([] {
                (void)iliasGrades(grades(), 1, std::string(kStatusHead) + "0,313,nobody,,,,,,,,\r\n",
                                  "s.csv");
              }),
              HasSubstr("no login of the file belongs to somebody with a score"));
  Grades twins = grades();
  twins.people[1].number = "1001";
  EXPECT_THAT(refusal([&] {
                (void)iliasGrades(twins, 1, std::string(kStatusHead) + "0,311,1001,,,,,,,,\r\n", "s.csv");
              }),
              HasSubstr("s.csv, line 2"));
}

TEST(Gradebook, OfAnUnknownSystemIsRefused) {
  EXPECT_EQ(gradebookForm("canvas"), GradebookForm::kCanvas);
  EXPECT_STREQ(nameOf(GradebookForm::kIlias), "ilias");
  EXPECT_THAT(refusal([] { (void)gradebookForm("blackboard"); }), HasSubstr("Use moodle, canvas or ilias"));
}

}  // namespace
}  // namespace torsio
