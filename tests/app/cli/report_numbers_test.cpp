// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the cohort report equal those of the commands, to the last digit.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <QCoreApplication>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/report_data.h"
#include "app/outputs/report/report_export.h"
#include "app/outputs/report/report_names.h"
#include "app/services/access/session_context.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/cohort_numbers.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void equalThoseOfTheCommandsToTheLastDigit(const fs::path& folder) {
  const CohortNumbers report(folder / "out" / "cohort.csv");
  expectEvaluationOfTheCommand(report, folder);

  // Agreement and comparison, from the marks in the record.
  Connection connection = openRecord((folder / "out" / "torsio.sqlite").string(), OpenMode::kReadWrite);
  const TrainingResult training = readTraining(connection, StudyRepository(connection).cohorts().at(0).id);
  const std::vector<std::string> occasions = {"before", "after 20 min", "after 40 min"};
  std::map<std::pair<std::string, std::string>, std::string>
      lines;  // of the first group at the last occasion, by trainee and rater
  for (const TrainingMark& mark : training.marks) {
    if (mark.occasion == 2 && mark.group == 0) {
      lines[{mark.trainee, mark.rater}] = mark.trainee + "," + mark.rater + "," +
                                          formatExact(pointsFromSteps(mark.steps, training.scale)) + "\n";
    }
  }
  std::string marks = "target,rater,score\n";
  for (const auto& [key, line] : lines) {
    marks += line;
  }
  expectAgreementOfTheCommand(report, marks, folder);

  std::string scores = "subject,group,occasion,score\n";
  for (const TraineeScore& score : training.trainees) {
    scores += score.trainee + ",Group " + std::to_string(score.group + 1) + "," + occasions[score.occasion] +
              "," + formatExact(score.score) + "\n";
  }
  writeFileAtomically(folder / "scores.csv", scores);
  const ProgramRun compared = runTorsio("compare-groups " + (folder / "scores.csv").string(), folder);
  ASSERT_EQ(compared.code, 0) << compared.err;
  const json ancova = json::parse(compared.out)["ancova"];
  EXPECT_EQ(report.at("comparison", "", "", "", occasions[2], "ancova_f"), ancova["statistic"].get<double>());
  EXPECT_EQ(ancova["errors"], "HC3");
  for (const json& pair : ancova["pairs"]) {
    const std::string name =
        pair["groups"][0].get<std::string>() + " - " + pair["groups"][1].get<std::string>();
    EXPECT_EQ(report.at("comparison", name, "", "", occasions[2], "adjusted_difference"),
              pair["difference"].get<double>());
    EXPECT_EQ(report.at("comparison", name, "", "", occasions[2], "robust_p_holm"),
              pair["p_holm"].get<double>());
    EXPECT_EQ(report.at("comparison", name, "", "", occasions[2], "p_holm"),
              pair["pooled"]["p_holm"].get<double>());
    for (const char* end : {"lower", "upper"}) {
      EXPECT_EQ(report.at("comparison", name, "", "", occasions[2],
                          std::string("robust_difference_holm_") + end + "_95"),
                pair["interval_holm"][end].get<double>());
    }
  }
}

/// All lines of a table, in order, without the byte order mark.
std::vector<std::string> lines(const fs::path& file) {
  std::vector<std::string> all;
  std::string content = readFile(file);
  if (content.starts_with("\xEF\xBB\xBF")) {
    content.erase(0, 3);
  }
  std::istringstream text(content);
  for (std::string line; std::getline(text, line);) {
    all.push_back(line);
  }
  return all;
}

void ofTheWindowAreThoseOfTheCommandLineInEveryCell(const fs::path& folder) {
  const std::string record = (folder / "out" / "torsio.sqlite").string();
  Connection connection = openRecord(record, OpenMode::kReadWrite);
  SystemIdSource ids;
  const UserId user(ids.newUuid());
  AccessRepository(connection, PasswordCost::kTest)
      .addUser({.id = user, .login = "s", .createdUtc_us = 1, .roles = {"statistician"}},
               "ten signs and more");
  SessionContext session(connection, ids, {record, "test", {.userId = user, .login = "s"}}, utcNow_us);
  ReportRequest request;
  request.cohortId = StudyRepository(connection).cohorts().at(0).id;
  request.campaignId = reportableCampaigns(session).at(0).id;
  TrialDigests digests(fs::path(TORSIO_SOURCE_DIR) / "assets");

  const CohortInputs inputs = reportInputs(session, request, digests);
  (void)exportReport(session, request, inputs, ReportFormat::kCsv, folder / "window.csv", "en");

  // The head of the audit trail is that at the time when the window made its table.
  std::vector<std::string> window = lines(folder / "window.csv");
  EXPECT_EQ(
      std::erase_if(window,
                    [](const std::string& line) { return line.find(",audit_trail,") != std::string::npos; }),
      1U);
  // Each names the file that made it, which differ.
  std::vector<std::string> command = lines(folder / "out" / "cohort.csv");
  for (std::vector<std::string>* table : {&window, &command}) {
    EXPECT_EQ(
        std::erase_if(*table, [](const std::string& line) { return line.find("file_blake2b") != line.npos; }),
        1U);
  }
  ASSERT_GT(window.size(), 1000U);
  for (std::size_t i = 0; i < std::min(window.size(), command.size()); ++i) {
    ASSERT_EQ(window[i], command[i]) << "line " << i + 1;
  }
  EXPECT_EQ(window.size(), command.size());
}

/// The steps of a kind in a trace, at any depth.
void collect(const json& step, const std::string& what, std::vector<json>& found) {
  if (step["what"].get<std::string>().starts_with(what)) {
    found.push_back(step);
  }
  if (step.contains("made_of")) {
    for (const json& part : step["made_of"]) {
      collect(part, what, found);
    }
  }
}

/// The first seven cells of a line of cohort.csv.
std::string addressIn(const std::string& line) {
  bool quoted = false;
  int commas = 0;
  std::size_t end = 0;
  for (; commas < 7; ++end) {
    quoted = quoted != (line[end] == '"');
    commas += line[end] == ',' && !quoted ? 1 : 0;
  }
  return line.substr(0, end - 1);
}

/// Whether every way down from a step ends at something that the record holds.
bool endsInTheRecord(const TraceStep& step) {
  if (step.madeOf.empty()) {
    return !step.value.empty();
  }
  return std::all_of(step.madeOf.begin(), step.madeOf.end(), [](const TraceStep& part) {
    return part.what != "not shown to you one by one; so many" && endsInTheRecord(part);
  });
}

void areFollowedToTheMarksTheSheetAndTheRecording(const fs::path& folder) {
  const std::string command =
      "report trace --json --database " + (folder / "out" / "torsio.sqlite").string() + " ";
  const auto traced = [&](const std::string& cell) {
    const ProgramRun run = runTorsio(command + "'" + cell + "'", folder);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  };
  const std::vector<std::string> table = lines(folder / "out" / "cohort.csv");
  const auto cellOf = [&](const std::string& part) {
    const auto line = std::find_if(table.begin(), table.end(), [&](const std::string& one) {
      return one.find(part) != std::string::npos;
    });
    EXPECT_NE(line, table.end()) << part;
    return addressIn(*line);
  };

  const json group = traced(cellOf("training,all,Group 1,,,after 40 min,mean,"));
  std::vector<json> scores;
  std::vector<json> marks;
  collect(group, "score of", scores);
  collect(group, "rater_mark of", marks);
  ASSERT_EQ(scores.size(), 10U);
  ASSERT_EQ(marks.size(), 100U);
  double sum = 0.0;
  for (const json& mark : marks) {
    sum += std::stod(mark["value"].get<std::string>());
  }
  EXPECT_NEAR(sum / 100.0, std::stod(group["value"].get<std::string>()), 1e-12);
  std::vector<json> program;
  collect(group, "program file", program);
  ASSERT_EQ(program.size(), 1U);
  EXPECT_EQ(program[0]["value"].get<std::string>().size(), 64U);
  std::vector<json> sheets;
  std::vector<json> live;
  collect(marks.front(), "scoring sheet", sheets);
  collect(marks.front(), "seen live", live);
  ASSERT_EQ(sheets.size(), 1U);
  EXPECT_EQ(sheets[0]["value"], "Overall mark on the real arm (demonstration), revision 1");
  EXPECT_EQ(live.size(), 1U);

  std::vector<json> recordings;
  const json error = traced(cellOf(",virtual 0-20 min,mean_absolute_error_deg,"));
  collect(error, "recorded by program version", recordings);
  ASSERT_EQ(recordings.size(), 1U);
  EXPECT_FALSE(recordings[0]["value"].get<std::string>().empty());

  std::vector<json> means;
  std::vector<json> given;
  const json n = traced(cellOf("evaluation,all,,PM,,,N_eq27,"));
  collect(n, "M of", means);
  collect(n, "mark of", given);
  EXPECT_EQ(means.size(), 9U) << "one an index";
  EXPECT_EQ(given.size(), 360U);
  Connection record = openRecord((folder / "out" / "torsio.sqlite").string(), OpenMode::kReadOnly);
  const CohortId cohort = cohortNamed(record, "");
  const CohortInputs inputs = wholeInputs(record, cohort, campaignNamed(record, ""));
  CellTracer tracer(record, cohort, inputs);
  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_TRUE(endsInTheRecord(tracer.trace(addressIn(table[i])))) << table[i];
  }
  const ReportModel report = cohortReport(inputs);
  const auto areFollowed = [&](const ReportTable& shown) {
    for (const std::vector<ReportCell>& row : shown.rows) {
      for (const ReportCell& cell : row) {
        EXPECT_TRUE(cell.key == nullptr || endsInTheRecord(tracer.trace(keyAddress(*cell.key))))
            << shown.id << ": " << cell;
      }
    }
  };
  for (const ReportSection& section : report.sections) {
    std::for_each(section.tables.begin(), section.tables.end(), areFollowed);
    for (const ReportFigure& figure : section.figures) {
      areFollowed(figureTable(figure));
    }
  }
  EXPECT_EQ(runTorsio(command + "'training,nobody,,,,,score'", folder).code,
            static_cast<int>(ErrorCode::kBadParameter));
}

/// The whole lines of a table that are not about its being made, without byte order mark.
std::vector<std::string> studyLines(const fs::path& table) {
  std::vector<std::string> out;
  for (std::string& line : lines(table)) {
    if (line.find("training,") == 0 || line.find("evaluation,") == 0 || line.find("comparison,") == 0) {
      out.push_back(std::move(line));
    }
  }
  return out;
}

void areInTheReportThatTheOwnerOfTheFileWrites(const fs::path& folder) {
  const std::string command =
      "report cohort --database " + (folder / "out" / "torsio.sqlite").string() + " --out ";
  const fs::path pdf = folder / "again.pdf";
  const ProgramRun run =
      runTorsio(command + pdf.string() + " --csv " + (folder / "again.csv").string() + " --json", folder);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(json::parse(run.out)["simulated"].get<bool>());
  EXPECT_EQ(json::parse(run.out)["files"].size(), 2U);
  EXPECT_EQ(readFile(pdf).substr(0, 5), "%PDF-");
  EXPECT_FALSE(studyLines(folder / "again.csv").empty());
  EXPECT_EQ(studyLines(folder / "again.csv"), studyLines(folder / "out" / "cohort.csv"));
  EXPECT_EQ(runTorsio(command + "no.pdf --cohort nobody", folder).code, 7);
  EXPECT_NE(runTorsio(command + "no.pdf --login nobody --password-fd 0 </dev/null", folder).code, 0);
  EXPECT_FALSE(fs::exists(folder / "no.pdf"));
}

void restTheValidityArgumentOnTheSameCells(const fs::path& folder) {
  const std::string command = "report validity --database " + (folder / "out" / "torsio.sqlite").string();
  const ProgramRun run = runTorsio(command + " --json --out " + (folder / "validity.csv").string(), folder);
  ASSERT_EQ(run.code, 0) << run.err;
  const json argument = json::parse(run.out);
  EXPECT_TRUE(argument["simulated"].get<bool>());
  const std::vector<std::string> table = lines(folder / "out" / "cohort.csv");
  std::set<std::string> verdicts;
  for (const json& line : argument["lines"]) {
    verdicts.insert(line["verdict"].get<std::string>());
    EXPECT_EQ(line.contains("cell"), line["verdict"] != "not collected") << line;
    if (!line.contains("cell")) {
      EXPECT_FALSE(line["note"].get<std::string>().empty()) << line;
      continue;
    }
    const std::string cell = line["cell"].get<std::string>();
    EXPECT_EQ(std::count_if(table.begin(), table.end(),
                            [&](const std::string& one) { return addressIn(one) == cell; }),
              1)
        << line;
  }
  EXPECT_EQ(verdicts.size(), 4U) << "of the demonstration";
  EXPECT_EQ(lines(folder / "validity.csv").size(), argument["lines"].size() + 1);
  EXPECT_NE(runTorsio(command, folder).out.find("generalisation.raters: "), std::string::npos);
  EXPECT_EQ(runTorsio(command + " --cohort nobody", folder).code, 7);
}

// A single test, because the demonstration takes most of the time.
TEST(ReportNumbers, OfCommandsWindowAndTraceAreEqual) {
  const fs::path folder = emptyFolder("report-numbers");
  ASSERT_EQ(runTorsio("demo --out " + (folder / "out").string() + " --shorten 150 --seed 7", folder).code, 0);
  equalThoseOfTheCommandsToTheLastDigit(folder);
  areFollowedToTheMarksTheSheetAndTheRecording(folder);
  ofTheWindowAreThoseOfTheCommandLineInEveryCell(folder);
  areInTheReportThatTheOwnerOfTheFileWrites(folder);
  restTheValidityArgumentOnTheSameCells(folder);
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);  // QtSql loads its drivers through it
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
