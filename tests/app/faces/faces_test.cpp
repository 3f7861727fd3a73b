// SPDX-License-Identifier: GPL-3.0-or-later
// Window, browser, transcript, trend, learning record, command line, report, table of numbers and workbook
// say the same of the same run, word for word and in both languages.
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QProcess>
#include <QRegularExpression>
#include <QTextBrowser>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/built_in.h"
#include "app/connectors/xapi/learning_statement.h"
#include "app/gui/administrator/curriculum/mastery_table.h"
#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/tables/export_set.h"
#include "app/services/base/assets.h"
#include "app/services/recording/kept_digests.h"
#include "app/web/http_server.h"
#include "app/web/web_desk.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/random.h"
#include "sim/core/spsc_ring.h"
#include "sim/record/recorder.h"
#include "sim/record/sample_codec.h"
#include "tests/app/cli/program.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"
#include "tests/app/web/web_client.h"

namespace torsio {
namespace {

using nlohmann::json;
using testing::TrainingCentre;

constexpr int kRuns = 200;
constexpr int kUntwistings = 3;
constexpr int kLookedAt = 2;  ///< runs of each outcome whose debrief is opened, besides the untwistings
constexpr const char* kOffice = "office";
constexpr const char* kPassword = "correct horse battery";

/// What happens to a run.
enum class Fate { kWhole, kTorn, kInterrupted, kOverLimit, kUntwisted, kTargetChanged, kCutOff, kEnd };

struct Made {
  std::vector<Sample> samples{};
  TrialOutcome outcome = TrialOutcome::kCompleted;
};

/// One hand's run, spoiled by chance.
Made spoiled(std::vector<Sample> samples, Fate fate, Random& random) {
  Made made{std::move(samples)};
  const auto isHeld = [](const Sample& sample) { return sample.phase == ExercisePhase::kTwisting; };
  const auto grip = std::find_if(made.samples.begin(), made.samples.end(), isHeld);
  if (made.samples.end() - grip < 300) {
    return made;
  }
  switch (fate) {
    case Fate::kTorn:
      made.samples.erase(grip + 100, grip + 150);
      break;
    case Fate::kInterrupted:
      made.outcome = TrialOutcome::kInterrupted;
      break;
    case Fate::kOverLimit:
      (grip + 50)->response.force_N = {0.0, 6.5 + random.uniform(), 0.0};
      break;
    case Fate::kUntwisted:
      for (Sample& sample : made.samples) {
        sample.rules = kRulesOfDetorsion;
      }
      break;
    case Fate::kTargetChanged:
      grip->command = {.kind = ServoCommand::Kind::kSetTarget, .value = random.uniform()};
      break;
    case Fate::kCutOff:
      made.samples.erase(grip + 200, made.samples.end());
      break;
    case Fate::kWhole:
    case Fate::kEnd:
      break;
  }
  return made;
}

/// Short runs: the first twist and a fifth of a second.
std::vector<Sample> untilTheFirstTwistIsOver(std::vector<Sample> samples) {
  const auto isHeld = [](const Sample& sample) { return sample.phase == ExercisePhase::kTwisting; };
  const auto grip = std::find_if(samples.begin(), samples.end(), isHeld);
  const auto release = std::find_if_not(grip, samples.end(), isHeld);
  samples.erase(release + std::min<std::ptrdiff_t>(200, samples.end() - release), samples.end());
  return samples;
}

/// A centre with untwistings of T-01 at "second" and two hundred runs at "first", some of them spoiled, and a
/// desk for browsers.
class Faces : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { world_ = std::make_unique<World>(); }
  static void TearDownTestSuite() { world_.reset(); }

  struct World {
    World() {
      const std::vector<Sample> good = decodedRun(1.0);
      const std::vector<Sample> bad = decodedRun(0.0);
      untwist();
      Random random(7);
      for (int i = 0; i < kRuns; ++i) {
        const auto fate = static_cast<Fate>(random.bounded(static_cast<std::uint64_t>(Fate::kEnd)));
        store(i, "first", AttemptMode::kPractice, spoiled(random.uniform() < 0.7 ? good : bad, fate, random));
      }
      AccessRepository access(centre.connection(), PasswordCost::kTest);
      access.addUser({.id = "00000000-0000-4000-8000-000000000001",
                      .login = kOffice,
                      .createdUtc_us = testing::kCentreTime_us,
                      .roles = {"administrator"}},
                     kPassword);
      for (const UserAccount& user : access.users()) {
        access.setPassword(user.id, access.sealPassword(user.login, kPassword), false);
      }
      desk = std::make_unique<web::WebDesk>(web::DeskSettings{.locator = centre.locator(),
                                                              .assets = assetsFolder(),
                                                              .workers = 1,
                                                              .passwordCost = PasswordCost::kTest});
      server = std::make_unique<web::HttpServer>(
          web::HttpAddress{"127.0.0.1", 0}, web::TlsMaterial{}, web::HttpLimits{},
          [this](web::HttpRequest request, web::HttpServer::Reply reply) {
            desk->handle(std::move(request), std::move(reply));
          });
    }

    std::vector<Sample> decodedRun(double skill) {
      const TrialId id = centre.attempt("third", "practice", skill);
      const Trial trial = TrialRepository(centre.connection()).load(id);
      header = trial.header;
      return untilTheFirstTwistIsOver(decodeTrial(trial));
    }

    /// A whole untwisting, one with a turn left out, and the whole one with lost samples.
    void untwist() {
      const TrialHeader ofTheBar = header;
      for (const std::size_t turnsLeftOut : {0U, 1U}) {
        judge(centre.untwist("second", "graded", turnsLeftOut));
      }
      const Trial whole = TrialRepository(centre.connection()).load(order.front());
      Random random(8);
      header = whole.header;
      header.startedUtc_us = TrialRepository(centre.connection()).load(order.back()).header.startedUtc_us;
      store(kRuns, "second", AttemptMode::kGraded, spoiled(decodeTrial(whole), Fate::kTorn, random));
      const std::int64_t last_us = header.startedUtc_us;
      header = ofTheBar;
      header.startedUtc_us = last_us;
    }

    void store(int number, const char* module, AttemptMode mode, const Made& made) {
      header.trialId = "00000000-0000-4000-8000-0000000" + std::to_string(10'000 + number);
      header.startedUtc_us += testing::kMinute_us;
      centre.passTime_us(testing::kMinute_us);
      SpscRing<Sample> ring(kRecordingRing);
      TrialRepository sink(centre.connection(), {.station = "station 1",
                                                 .enrolmentId = centre.enrolment(),
                                                 .moduleId = centre.module(module),
                                                 .attemptMode = mode});
      Recorder recorder(ring, sink, header);
      for (const Sample& sample : made.samples) {
        EXPECT_TRUE(ring.push(sample));
        recorder.pump();
      }
      static_cast<void>(recorder.finish(made.outcome, 0, {}));
      judge(header.trialId);
    }

    /// Keeps by what every face is measured: the verdict on the recording itself.
    void judge(const TrialId& id) {
      const Trial stored = TrialRepository(centre.connection()).load(id);
      const std::string module = order.size() < kUntwistings ? "second" : "first";
      ExerciseRules exercises;
      const AttemptRules rules = recordedRules(exercises.of(centre.connection(), stored.header.sceneId,
                                                            stored.header.patternId, centre.module(module)),
                                               stored.header);
      truth[id] = judgeRun(measureAttempt(stored.header, decodeTrial(stored), rules), rules,
                           stored.summary.outcome == TrialOutcome::kInterrupted);
      order.push_back(id);
    }

    /// The cohort as it is exported.
    ExchangeData exported() {
      centre.become(kOffice);
      TrialDigests digests{std::filesystem::path()};
      ExchangeData data = exchangeData(centre.session(), {.cohortId = centre.cohort().id}, digests);
      EXPECT_EQ(data.inputs.trials.size(), order.size() + 2);
      std::erase_if(data.inputs.trials,
                    [this](const TrialSummaryRow& row) { return !truth.contains(row.trialId); });
      centre.become("T-01");
      return data;
    }

    TrainingCentre centre{
        {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual", .duration_us = 1'000'000'000'000}},
         .mastery = {{.metric = "twist.on_target", .threshold = 0.5, .unit = "1"},
                     {.metric = "force.violations", .comparison = "at_most", .unit = "count"}}}};
    TrialHeader header;
    std::map<std::string, RunVerdict> truth;  ///< by id of the run
    std::vector<std::string> order;           ///< oldest first
    std::unique_ptr<web::WebDesk> desk;
    std::unique_ptr<web::HttpServer> server;
  };

  /// The runs whose debrief is opened: the untwistings and some of each outcome.
  static std::vector<std::string> lookedAt() {
    std::vector<std::string> chosen(world_->order.begin(), world_->order.begin() + kUntwistings);
    std::map<RunOutcome, int> seen;
    for (const std::string& id : std::vector(world_->order.begin() + kUntwistings, world_->order.end())) {
      if (seen[world_->truth.at(id).outcome]++ < kLookedAt) {
        chosen.push_back(id);
      }
    }
    return chosen;
  }
  static WebClient browser(const std::string& language) {
    WebClient client(world_->server->port());
    EXPECT_TRUE(client.signIn("T-01", kPassword));
    client.headers = {{"x-torsio-language", language}};
    return client;
  }

  static std::unique_ptr<World> world_;
};

std::unique_ptr<Faces::World> Faces::world_;

std::string inWords(const Text& text) {
  return gui::toQString(text).toStdString();
}

/// Runs `look` in each language with its code.
template <typename Look>
void inBothLanguages(const Look& look) {
  gui::LanguageSwitch language;
  for (const auto& [chosen, code] :
       {std::pair(gui::Language::kEnglish, "en"), std::pair(gui::Language::kSimplifiedChinese, "zh_CN")}) {
    language.choose(chosen);
    SCOPED_TRACE(code);
    look(code);
  }
  language.choose(gui::Language::kEnglish);
}

TEST_F(Faces, TheRunsCameToEveryOutcomeThatARecordedRunCanHave) {
  std::map<RunOutcome, int> outcomes;
  for (const auto& [id, verdict] : world_->truth) {
    ++outcomes[verdict.outcome];
  }

  EXPECT_GT(outcomes[RunOutcome::kPassed], 5);
  EXPECT_GT(outcomes[RunOutcome::kNotPassed], 20);
  EXPECT_GT(outcomes[RunOutcome::kNotJudged], 5);
  EXPECT_GT(outcomes[RunOutcome::kInterrupted], 10);
  EXPECT_EQ(world_->truth.size(), static_cast<std::size_t>(kRuns + kUntwistings));
}

TEST_F(Faces, TrendAndTranscriptOfTheWindowSayTheVerdictOfEveryRun) {
  gui::Station station(world_->centre);
  inBothLanguages([&](const char*) {
    station.open(gui::PageId::kTrend, gui::toQString(world_->centre.module("first")));
    const QString table = station.page->findChild<gui::DataTable*>()->asText();
    station.open(gui::PageId::kTranscript);
    const QString transcript = station.page->findChild<QTextBrowser*>()->toPlainText();
    std::map<std::string, qsizetype> said;
    for (const auto& [id, verdict] : world_->truth) {
      ++said[inWords(wordOf(verdict.outcome))];
    }
    const QStringList cells = transcript.split(u'\n');
    for (const auto& [word, times] : said) {
      EXPECT_GE(cells.count(QString::fromStdString(word)), times) << word;
    }
    for (const RunOutcome outcome : {RunOutcome::kPassed, RunOutcome::kNotPassed}) {
      EXPECT_TRUE(table.contains(gui::capitalised(gui::toQString(wordOf(outcome))))) << table.toStdString();
    }
    EXPECT_TRUE(table.contains(gui::toQString(Text(rowOf(Quantity::kForceViolations).name))));
  });
}

TEST_F(Faces, TheListsOfTheBrowserSayTheVerdictOfEveryRun) {
  inBothLanguages([&](const char* code) {
    WebClient client = browser(code);
    const json own = client.get("/api/own").json();
    const json transcript = client.get("/api/own/transcript").json();

    // The newest run stands first; two others were made to take hands from.
    ASSERT_EQ(own.at("runs").size(), world_->order.size() + 2);
    for (std::size_t i = 0; i < world_->order.size(); ++i) {
      const std::size_t number = world_->order.size() - 1 - i;
      const RunVerdict& verdict = world_->truth.at(world_->order[number]);
      const json& run = own.at("runs").at(i);
      EXPECT_EQ(run.at("outcome").at("word"), inWords(wordOf(verdict.outcome)));
      EXPECT_EQ(run.at("outcome").at("code"), storedText(verdict.outcome));
      const bool untwisted = number < kUntwistings;
      const json& attempts = transcript.at("modules").at(untwisted ? 1 : 0).at("attempts");
      const json& line = attempts.at(untwisted ? number : number - kUntwistings);
      EXPECT_EQ(line.at("outcome"), run.at("outcome"));
    }
    EXPECT_EQ(own.at("modules").at(0).at("metric"), inWords(rowOf(Quantity::kForceViolations).name));
    for (const json& point : own.at("modules").at(0).at("points")) {
      EXPECT_NE(point.at("outcome").at("code"), "interrupted");
    }
  });
}

TEST_F(Faces, TheDebriefSaysTheSameInWindowAndBrowser) {
  gui::Station station(world_->centre);
  station.desk().lastScene = borrowed(testing::trainingBar());
  std::size_t findings = 0;
  std::size_t moments = 0;
  inBothLanguages([&](const char* code) {
    WebClient client = browser(code);
    const json own = client.get("/api/own").json();
    for (const std::string& id : lookedAt()) {
      const RunVerdict& verdict = world_->truth.at(id);
      const auto place = std::find(world_->order.rbegin(), world_->order.rend(), id) - world_->order.rbegin();
      const std::string handle = own.at("runs").at(static_cast<std::size_t>(place)).at("run");

      const json run = client.get("/api/own/runs/" + handle).json();
      station.open(gui::PageId::kDebrief, QString::fromStdString(id));

      EXPECT_EQ(station.find<QLabel>("verdict")->text().toStdString(), inWords(verdict.sentence()));
      EXPECT_EQ(run.at("outcome").at("sentence"), inWords(verdict.sentence()));
      EXPECT_EQ(run.at("outcome").at("cause"), inWords(verdict.cause()));
      EXPECT_EQ(run.at("outcome").at("remedy"), inWords(verdict.remedy()));
      const QString all = station.allText();
      ASSERT_EQ(run.at("told").at("checks").size(), verdict.checks.size());
      for (std::size_t i = 0; i < verdict.checks.size(); ++i) {
        const json& check = run.at("told").at("checks").at(i);
        const std::string said = check.at("text");
        EXPECT_TRUE(all.contains(QString::fromStdString(said))) << said << "\n" << all.toStdString();
        const std::string advice = check.at("advice");
        EXPECT_TRUE(advice.empty() || !(verdict.checks[i].passed || check.at("lost").get<bool>())) << said;
        EXPECT_TRUE(all.contains(QString::fromStdString(advice))) << advice;
        if (!check.at("from_s").is_null()) {
          ++moments;
          EXPECT_TRUE(all.contains(gui::clockTenths(check.at("from_s").get<double>()))) << said;
        }
        if (verdict.checks[i].consecutive <= 1) {
          EXPECT_EQ(said, inWords(verdict.checks[i].text()));
        }
      }
      for (const json& finding : run.at("told").at("findings")) {
        EXPECT_TRUE(all.contains(QString::fromStdString(finding.at("text")))) << finding;
      }
      findings += run.at("told").at("findings").size();
      EXPECT_EQ(run.at("told").at("findings").empty(), !run.at("untwisting").get<bool>());
    }
  });
  EXPECT_GT(findings, 2U * kUntwistings * 3U) << "in two languages";
  EXPECT_GT(moments, 4U) << "of targets that were missed";
}

TEST_F(Faces, NobodyReadsThatItIsNotTheirFaultBelowNotPassed) {
  for (const auto& [id, verdict] : world_->truth) {
    const bool excused = verdict.cause().str().find("not your fault") != std::string::npos;
    EXPECT_EQ(excused, verdict.outcome == RunOutcome::kNotJudged) << id;
  }
}

TEST_F(Faces, LearningRecordsTellOnlyWhatWasJudged) {
  if constexpr (kXapiBuiltIn) {
    Connection& connection = world_->centre.connection();
    const LrsIdentity identity{.settings = {.homePage = "https://centre.example"},
                               .accountKey = std::string(32, 'k')};
    ExerciseRules rules;
    for (const std::string& id : lookedAt()) {
      const LearningEvent event{
          .kind = LearningEventKind::kJudged, .objectId = id, .personId = PersonId(world_->centre.person())};
      const RunOutcome outcome = world_->truth.at(id).outcome;

      const std::string statement =
          statementOf(connection, event, identity, rules, testing::kCentreTime_us + 1);

      const bool judged = outcome == RunOutcome::kPassed || outcome == RunOutcome::kNotPassed;
      ASSERT_EQ(!statement.empty(), judged) << storedText(outcome);
      if (judged) {
        const json result = json::parse(statement).at("result");
        EXPECT_EQ(result.at("success"), outcome == RunOutcome::kPassed);
        EXPECT_EQ(result.at("extensions").at("urn:x-torsio:xapi:verdict"), storedText(outcome));
      }
    }
  } else {
    GTEST_SKIP() << "built without learning records";
  }
}

TEST_F(Faces, TheCommandLineSaysTheVerdictAndTheNames) {
  std::map<RunOutcome, bool> asked;
  for (const std::string& id : lookedAt()) {
    const RunVerdict& verdict = world_->truth.at(id);
    if (std::exchange(asked[verdict.outcome], true)) {
      continue;
    }
    const ProgramRun run = runTorsio("metrics " + id + " --cards --database " + world_->centre.locator(),
                                     world_->centre.folder());
    ASSERT_EQ(run.code, 0) << run.err;
    const json told = json::parse(run.out);
    EXPECT_EQ(told.at("verdict").at("outcome"), storedText(verdict.outcome));
    EXPECT_EQ(told.at("verdict").at("text"), verdict.sentence().str());
    ASSERT_EQ(told.at("verdict").at("checks").size(), verdict.checks.size());
    for (std::size_t i = 0; i < verdict.checks.size(); ++i) {
      EXPECT_EQ(told.at("verdict").at("checks").at(i).at("text"), verdict.checks[i].text().str());
    }
    for (const QuantityRow& row : quantityRows()) {
      const json& card = told.at("cards").at(std::string(row.id));
      EXPECT_EQ(card.at("name"), row.name.english());
      EXPECT_EQ(card.at("unit"), row.unit);
      EXPECT_EQ(card.at("shown_unit"), row.shown.unit);
      EXPECT_EQ(card.at("decimals"), row.shown.decimals);
    }
  }
}

/// What a program prints.
QString printedBy(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  EXPECT_TRUE(process.waitForFinished()) << program.toStdString();
  return QString::fromUtf8(process.readAllStandardOutput());
}

TEST_F(Faces, ReportAndPdfSayTheVerdictOfEveryRun) {
  const ExchangeData data = world_->exported();
  ReportModel report = cohortReport(data.inputs);
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.tables.empty() || section.tables.back().id != "table-trial-hashes";
  });
  ASSERT_EQ(report.sections.size(), 1U);
  const ReportTable& table = report.sections.front().tables.back();
  const std::string file = (world_->centre.folder() / "report.pdf").string();

  ASSERT_EQ(table.rows.size(), world_->order.size());
  inBothLanguages([&](const char* code) {
    writePdfReport(report, file, wordingIn(code), {}, code);
    const QString pages = printedBy("pdftotext", {"-raw", QString::fromStdString(file), "-"}).simplified();
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const TrialSummaryRow& row = data.inputs.trials[i];
      const std::string word = inWords(wordOf(world_->truth.at(row.trialId).outcome));
      ASSERT_EQ(table.rows[i][0].str(), row.trialId.text());
      EXPECT_EQ(inWords(table.rows[i][5]), word) << row.trialId;
      const std::string printed =
          formatFixed(row.minutes, 1) + " " + word + " " + row.contentHash.substr(0, 16);
      EXPECT_TRUE(pages.contains(QString::fromStdString(printed))) << printed << pages.toStdString();
    }
  });
}

/// Prints the sheets of a workbook as they are stored.
constexpr const char* kReadsSheets =
    "import sys, zipfile\n"
    "book = zipfile.ZipFile(sys.argv[1])\n"
    "for name in book.namelist():\n"
    "    if name.startswith('xl/worksheets/') and name.endswith('.xml'):\n"
    "        print(book.read(name).decode())";

TEST_F(Faces, TablesAndWorkbookSayTheVerdictOfEveryRun) {
  const ExchangeData data = world_->exported();
  std::map<std::string, std::string> said;  // in cohort.csv, by run
  std::string last;
  for (const CohortCsvRow& row : cohortCsvRows(data.analysed.ledger)) {
    if (row.section == "trial" && row.statistic == "outcome") {
      last = row.value;
    } else if (row.section == "trial" && row.statistic == "trial") {
      said[row.value] = std::exchange(last, {});
    }
  }
  const std::vector<ExportColumn>& columns = data.set.trials.columns;
  const auto placeOf = [&columns](const std::string& name) {
    return static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(),
                                                 [&](const auto& column) { return column.name == name; }) -
                                    columns.begin());
  };
  std::map<std::string, std::string> tabled;
  for (const std::vector<ExportCell>& row : data.set.trials.rows) {
    tabled[std::get<std::string>(row.at(placeOf("trial")))] =
        std::get<std::string>(row.at(placeOf("outcome")));
  }
  const std::filesystem::path file = world_->centre.folder() / "cohort.xlsx";
  world_->centre.become(kOffice);
  static_cast<void>(exportWorkbook(
      world_->centre.session(), data, [](const Text& text) { return text.str(); }, file));
  world_->centre.become("T-01");
  const QStringList lines =
      printedBy("/usr/bin/python3", {"-c", kReadsSheets, QString::fromStdString(file.string())})
          .split("<row ");

  for (const TrialSummaryRow& row : data.inputs.trials) {
    const std::string word = wordOf(world_->truth.at(row.trialId).outcome).str();
    EXPECT_EQ(said[row.trialId], word) << row.trialId;
    EXPECT_EQ(tabled[row.trialId], word) << row.trialId;
    const QString id = QString::fromStdString(">" + row.trialId.text() + "<");
    const QString hash = QString::fromStdString(">" + row.contentHash + "<");
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const QString& one) {
      return one.contains(id) && one.contains(hash);
    });
    ASSERT_NE(line, lines.end()) << row.trialId;
    EXPECT_TRUE(line->contains(QString::fromStdString(">" + word + "<"))) << line->toStdString();
  }
  inBothLanguages([&](const char* code) {
    const bool chinese = std::string(code) != "en";
    EXPECT_EQ(inWords(columns.at(placeOf("outcome")).title) != "Outcome", chinese);
  });
}

// A quantity that has a row is on every face without another line. A fixture cannot add a row to the table,
// so these tests ask each face for every row, in both languages: what may be asked for stands in the table of
// rules, what a trend offers in its list; a run that has a value of each quantity shows all of them in
// cohort.csv, tables, workbook and report. TheCommandLineSaysTheVerdictAndTheNames does the same of the
// cards.
TEST_F(Faces, EveryRowOfTheCatalogueIsFoundWhereItSays) {
  gui::Station station(world_->centre);
  inBothLanguages([&](const char* code) {
    gui::MasteryTable rules;
    rules.setRules({{.metric = "twist.on_target"}});
    const auto* asked = qobject_cast<QComboBox*>(rules.cellWidget(0, 0));
    ASSERT_NE(asked, nullptr);
    station.open(gui::PageId::kTrend, gui::toQString(world_->centre.module("first")));
    QStringList offered;
    for (const QComboBox* box : station.page->findChildren<QComboBox*>()) {
      for (int i = 0; i < box->count(); ++i) {
        offered << box->itemText(i);
      }
    }
    // A trend is one of twists or one of untwistings.
    const bool untwisting = offered.contains(gui::toQString(Text(rowOf(Quantity::kUntwisted).name)));
    for (const QuantityRow& row : quantityRows()) {
      const QString name = gui::toQString(Text(row.name));
      const bool chinese = std::string(code) != "en";
      EXPECT_EQ(name.toStdString() != row.name.english(), chinese) << row.id;
      EXPECT_EQ(asked->findData(gui::toQString(row.id)) >= 0, row.traits.asked) << row.id;
      if (row.traits.inTrend && isOfUntwisting(row.quantity) == untwisting) {
        EXPECT_TRUE(offered.contains(name)) << row.id;
      }
    }
  });
}

/// The value of each quantity in the run that has them all, SI.
double valueOf(Quantity quantity) {
  return isAnswer(quantity) ? 1.0 : 0.37 * static_cast<double>(quantity) + 0.21;
}

/// The exported cohort with only one run, which has a value of each quantity.
ExchangeData withEveryQuantity(ExchangeData data) {
  TrialSummaryRow run = data.inputs.trials.front();
  run.phase = Text::verbatim("every quantity");
  run.outcome = RunOutcome::kPassed;
  run.detorsion.clear();
  for (const QuantityRow& row : quantityRows()) {
    run.detorsion[std::string(row.id)] = valueOf(row.quantity);
  }
  data.inputs.trials = {run};
  data.analysed = analysedCohort(data.inputs);
  data.set = exportSet(data.analysed, {});
  return data;
}

TEST_F(Faces, TablesAndWorkbookTakeNameAndUnitOfEveryRowOfTheCatalogue) {
  const ExchangeData data = withEveryQuantity(world_->exported());
  const std::vector<CohortCsvRow> lines = cohortCsvRows(data.analysed.ledger);
  const ExportTable& trials = data.set.trials;
  ASSERT_EQ(trials.rows.size(), 1U);

  inBothLanguages([&](const char* code) {
    const std::filesystem::path file = world_->centre.folder() / "every.xlsx";
    world_->centre.become(kOffice);
    static_cast<void>(exportWorkbook(world_->centre.session(), data, inWords, file));
    world_->centre.become("T-01");
    const QString sheets =
        printedBy("/usr/bin/python3", {"-c", kReadsSheets, QString::fromStdString(file.string())});
    for (const QuantityRow& row : quantityRows()) {
      EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&row](const CohortCsvRow& line) {
        return line.statistic == row.id && std::stod(line.value) == valueOf(row.quantity);
      })) << row.id;
      std::string name(row.id);
      std::replace(name.begin(), name.end(), '.', '_');
      const auto column = std::find_if(trials.columns.begin(), trials.columns.end(),
                                       [&name](const ExportColumn& one) { return one.name == name; });
      ASSERT_NE(column, trials.columns.end()) << row.id;
      const bool plain = row.unit == "1" || row.unit == "count";
      EXPECT_EQ(column->unit, plain ? "" : row.unit);
      EXPECT_EQ(inWords(column->title), inWords(row.name));
      EXPECT_EQ(
          std::get<double>(trials.rows[0].at(static_cast<std::size_t>(column - trials.columns.begin()))),
          valueOf(row.quantity));
      const std::string head = ">" + inWords(row.name) + (plain ? "" : ", " + column->unit) + "<";
      EXPECT_TRUE(sheets.contains(QString::fromStdString(head))) << head << " " << code;
    }
  });
}

/// Without blanks, since a printed head is broken over lines, and with plain characters for the radicals that
/// pdftotext writes.
QString unbroken(const QString& text) {
  return text.normalized(QString::NormalizationForm_KC).remove(QRegularExpression(QStringLiteral("\\s")));
}

TEST_F(Faces, ReportAndPdfTakeNameUnitAndDecimalsFromTheCatalogue) {
  ExchangeData data = withEveryQuantity(world_->exported());
  TrialSummaryRow twisted = data.inputs.trials.front();  // a run with twists, and one of other equipment
  twisted.detorsion.clear();
  twisted.peakForce_N = valueOf(Quantity::kPeakForce);
  twisted.peakTorque_Nm = valueOf(Quantity::kPeakTorque);
  TrialSummaryRow foreign = data.inputs.trials.front();
  twisted.trialId = "twisted";
  foreign.trialId = "foreign";
  foreign.model = kForeignModel;
  data.inputs.trials.push_back(twisted);
  data.inputs.trials.push_back(foreign);
  ReportModel report = cohortReport(data.inputs);
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.tables.empty() || section.tables.front().id != "table-trials";
  });
  ASSERT_EQ(report.sections.size(), 1U);
  const std::string file = (world_->centre.folder() / "quantities.pdf").string();

  inBothLanguages([&](const char* code) {
    writePdfReport(report, file, wordingIn(code), {}, code);
    const QString pages = unbroken(printedBy("pdftotext", {"-raw", QString::fromStdString(file), "-"}));
    const auto holds = [&pages](const Text& text) {
      EXPECT_TRUE(pages.contains(unbroken(gui::toQString(text)))) << inWords(text) << "\n"
                                                                  << pages.toStdString();
    };
    for (const Quantity quantity : {Quantity::kCompletedTwists, Quantity::kTargetsReached,
                                    Quantity::kUntwisted, Quantity::kRelapse, Quantity::kFirstDirection}) {
      holds(rowOf(quantity).name);
    }
    for (const Quantity quantity : {Quantity::kPeakTorque, Quantity::kPeakForce}) {
      holds(meanTitle(quantity));
      holds(shownNumber(quantity, valueOf(quantity)));
    }
    for (const Quantity quantity : {Quantity::kTimeToFlow, Quantity::kDose, Quantity::kSlipBack,
                                    Quantity::kTime, Quantity::kTipPath, Quantity::kIdleTime}) {
      holds(medianTitle(quantity));
      holds(titleWithUnit(quantity));
      holds(shownNumber(quantity, valueOf(quantity)));
    }
  });
}

}  // namespace
}  // namespace torsio
