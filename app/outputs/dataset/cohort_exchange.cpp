// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/cohort_exchange.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/outputs/dataset/dataset_study.h"
#include "app/outputs/dataset/replication.h"
#include "app/outputs/report/report_names.h"
#include "app/services/base/build_info.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/nearest_name.h"
#include "app/services/study/curriculum_content.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/people/person.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::int64_t kRecordedRate_Hz = kSecond_us / kTickPeriod_us;

/// The owner of the record's file can read all of it anyway.
bool mayTakeCodes(const SessionContext& session) {
  return !session.actor().systemAccount.empty() || session.may(Operation::kPersonViewIdentity);
}

/// Returns when a report with lines about single people of the cohort was last saved; 0: never.
std::int64_t reportSaved_us(Connection& connection, const CohortId& cohortId) {
  for (const AuditEntry& entry :
       AuditRepository(connection)
           .entries({.objectKind = AuditObject::kCohort, .objectId = cohortId.text()})) {
    const bool report = entry.action == storedText(AuditAction::kReportExportCoded) ||
                        entry.action == storedText(AuditAction::kReportExportNamed);
    const nlohmann::json what = nlohmann::json::parse(entry.newJson, nullptr, false);
    if (report && what.is_object() && what.value("identity", "") != "aggregated" &&
        what.value("identity", "") != "pseudonymised") {
      return entry.atUtc_us;
    }
  }
  return 0;
}

ExchangeFiles noted(SessionContext& session, const ExchangeRequest& request, const std::string& format,
                    std::int64_t people, bool named, const std::optional<PseudonymReport>& pseudonyms,
                    std::vector<std::filesystem::path> files) {
  ExchangeFiles done;
  Digest digest;
  for (const std::filesystem::path& file : files) {
    const std::string content = readFile(file);
    digest.update(content);
    done.bytes += content.size();
  }
  done.files = std::move(files);
  done.contentHash = digest.hex();
  nlohmann::ordered_json what;
  what["format"] = format;
  what["identity"] = named ? "named" : pseudonyms ? "pseudonymised" : "coded";
  what["campaign"] = request.campaignId.text();
  what["frozen"] = request.frozenId.text();
  what["trainees"] = people;
  if (pseudonyms) {
    what["smallest_cell"] = pseudonyms->smallestAfter;
    what["free_text"] = request.withFreeText;
  }
  what["files"] = done.files.size();
  what["bytes"] = done.bytes;
  what["hash"] = done.contentHash;
  AuditNote note{.action = named ? AuditAction::kReportExportNamed : AuditAction::kReportExportCoded,
                 .objectKind = AuditObject::kCohort,
                 .objectId = request.cohortId.text(),
                 .newJson = what.dump(),
                 .reason = request.reason};
  Transaction transaction(session.connection());
  session.note(note);
  transaction.commit();
  return done;
}

/// Returns the position of an occasion by its name; empty: the last one.
std::size_t occasionAt(const Grades& grades, const std::string& name) {
  if (name.empty()) {
    return grades.occasions.size() - 1;
  }
  const auto found = std::find(grades.occasions.begin(), grades.occasions.end(), name);
  if (found == grades.occasions.end()) {
    std::string known;
    for (const std::string& occasion : grades.occasions) {
      known += (known.empty() ? "" : ", ") + occasion;
    }
    throw Error(ErrorCode::kBadParameter, Text::tr("is not an occasion of the cohort"), name,
                Text::tr("Use one of: %1", known));
  }
  return static_cast<std::size_t>(found - grades.occasions.begin());
}

/// Returns the scores that may be shown, with what identifies people elsewhere. Throws Error{kBadData} if
/// there are none.
Grades gradesOf(SessionContext& session, const CohortInputs& inputs) {
  const Ledger ledger = analysedCohort(inputs).ledger;
  Grades grades{.title = inputs.title.str(),
                .occasions = ledger.names().occasions,
                .scale = inputs.trainingScale,
                .people = {}};
  std::map<std::string, GradedPerson> people;  // by code
  for (const Result* score : ledger.select({.statistic = "score", .of = kEach})) {
    GradedPerson& person = people[score->key.of];
    person.code = score->key.of;
    person.scores.resize(grades.occasions.size());
    person.scores.at(occasionAt(grades, score->key.occasion)) = resultText(score->value);
  }
  if (people.empty()) {
    refuse(Text::tr("nobody has a score that may be shown"), inputs.title,
           Text::tr("Wait until every sheet is in, or freeze the data"));
  }
  PeopleRepository repository(session.connection());
  std::map<PersonId, std::string> codeOf;
  for (const Trainee& trainee : repository.trainees()) {
    codeOf[trainee.person.id] = trainee.person.code;
  }
  for (const Identity& identity : repository.identities()) {
    const auto code = codeOf.find(identity.personId);
    const auto person = code == codeOf.end() ? people.end() : people.find(code->second);
    if (person != people.end()) {
      person->second.name = identity.fullName;
      person->second.email = identity.email;
      person->second.number = identity.externalId;
    }
  }
  for (auto& [code, person] : people) {
    grades.people.push_back(std::move(person));
  }
  return grades;
}

WorkbookContents contentsOf(const ExchangeData& data, const ReportModel& report) {
  WorkbookContents contents;
  contents.title = report.title;
  contents.facts = report.facts;
  contents.facts.emplace_back(Text::tr("Torsio"), report.softwareVersion);
  for (const Text& sentence : originSentences(data.inputs)) {
    contents.facts.emplace_back(Text::tr("Origin"), sentence);
  }
  contents.facts.emplace_back(Text::tr("Times"), Text::tr("All times are UTC."));
  for (const Text& sentence : pseudonymSentences(data)) {
    contents.facts.emplace_back(Text::tr("Pseudonymised"), sentence);
  }
  contents.tables = tablesOf(data.set);
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      contents.figures.push_back(&figure);
    }
  }
  // Taken from the report: the analysis takes seconds for thousands of marks.
  const auto methods = std::find_if(report.sections.begin(), report.sections.end(),
                                    [](const auto& section) { return section.id == "methods"; });
  if (methods != report.sections.end()) {
    contents.methods.assign(methods->paragraphs.begin(), methods->paragraphs.end());
  }
  return contents;
}

}  // namespace

void nameRequest(SessionContext& session, const std::string& cohort, const std::string& campaign,
                 ExchangeRequest& request) {
  const ReportRequest named = reportNamed(session, {.cohort = cohort, .campaign = campaign});
  request.cohortId = named.cohortId;
  request.campaignId = named.campaignId;
}

ExchangeData exchangeData(SessionContext& session, const ExchangeRequest& request, TrialDigests& digests,
                          const ProgressCallback& progress) {
  session.require(Operation::kReportExportCoded);
  ExchangeData data{request, {}, {}, {}, {}, {}, 0};
  data.inputs =
      reportInputs(session, {request.cohortId, request.campaignId, request.frozenId, ReportIdentity::kCoded},
                   digests, progress);
  std::map<TrialId, std::int64_t> starts = TrialRepository(session.connection()).startsOf(request.cohortId);
  if (request.pseudonymised || !mayTakeCodes(session)) {
    const Pseudonyms names(request.key.empty() ? Pseudonyms::freshKey() : request.key);
    PseudonymReport report;
    for (const TrialSummaryRow& trial : data.inputs.trials) {
      data.recordings[TrialId(names.of("T", trial.trialId.text()))] = trial.trialId;
    }
    data.inputs = pseudonymised(std::move(data.inputs), starts, names, request.withFreeText, report);
    data.reportSavedUtc_us = reportSaved_us(session.connection(), request.cohortId);
    data.pseudonyms = report;
  } else {
    for (const TrialSummaryRow& trial : data.inputs.trials) {
      data.recordings[trial.trialId] = trial.trialId;
    }
  }
  data.analysed = analysedCohort(data.inputs);
  data.set = exportSet(data.analysed, starts);
  return data;
}

std::vector<Text> pseudonymSentences(const ExchangeData& data) {
  if (!data.pseudonyms) {
    return {};
  }
  const PseudonymReport& done = *data.pseudonyms;
  std::vector<Text> sentences{
      Text::tr("Names of people and recordings are opaque; times of each person are moved by whole days."),
      Text::tr("Group, sex and level are shared by at least %1 people (%2 before).", done.smallestAfter,
               done.smallestBefore),
      Text::tr("Left out: level of %1 {person|people}, sex of %2, free text of %3 {entry|entries}, "
               "person of %4 {deviation|deviations}.",
               done.levelsHidden, done.sexesHidden, done.textsLeftOut, done.deviationsUnlinked)};
  if (data.reportSavedUtc_us > 0) {
    sentences.push_back(
        Text::tr("Warning: a report with scores under the centre's codes was saved on %1. Whoever has it and "
                 "these files can tell people by their scores: do not give both away.",
                 formatUtc(data.reportSavedUtc_us)));
  }
  return sentences;
}

ExchangeFiles exportWorkbook(SessionContext& session, const ExchangeData& data, const ExportWording& say,
                             const std::filesystem::path& file, const ProgressCallback& progress) {
  session.require(Operation::kReportExportCoded);
  const ReportModel report = cohortReport(data.inputs, data.analysed);
  writeWorkbook(contentsOf(data, report), say, file, progress);
  return noted(session, data.request, "workbook", std::ssize(data.inputs.trainees), false, data.pseudonyms,
               {file});
}

ExchangeFiles exportTables(SessionContext& session, const ExchangeData& data, TableFormat format,
                           const std::filesystem::path& folder, const ProgressCallback& progress) {
  session.require(Operation::kReportExportCoded);
  std::vector<std::filesystem::path> files = writeTables(tablesOf(data.set), format, folder, progress);
  return noted(session, data.request, "tables", std::ssize(data.inputs.trainees), false, data.pseudonyms,
               std::move(files));
}

ExchangeFiles exportReplication(SessionContext& session, const ExchangeData& data,
                                const std::filesystem::path& folder) {
  session.require(Operation::kReportExportCoded);
  return noted(session, data.request, "replication", std::ssize(data.inputs.trainees), false, data.pseudonyms,
               writeReplication(data.inputs, data.analysed, folder));
}

ExchangeFiles exportDataset(SessionContext& session, const ExchangeData& data, const DatasetRequest& request,
                            const std::filesystem::path& folder, const ProgressCallback& progress) {
  session.require(Operation::kReportExportCoded);
  if (request.rate_Hz < 1 || kRecordedRate_Hz % request.rate_Hz != 0) {
    refuseParameter(Text::tr("trajectories cannot be written at this rate"), std::to_string(request.rate_Hz),
                    Text::tr("Use a rate that divides 1000 Hz, for example 100"));
  }
  const bool package = request.layout != DatasetLayout::kBids && request.layout != DatasetLayout::kLerobot;
  if (request.whole && (data.pseudonyms || !package)) {
    refuseParameter(
        Text::tr("a data set for another record needs codes, and BIDS and LeRobot have no place for it"),
        std::string("whole"), Text::tr("Use frictionless, ro-crate or parquet, and not pseudonymised"));
  }
  if (request.whole && !data.inputs.singleMarks) {
    refuseParameter(Text::tr("single marks may not be seen yet"), std::string("whole"),
                    Text::tr("Freeze the data when every sheet is in, or export as the owner of the file"));
  }
  DatasetContents contents;
  contents.about = request.about;
  contents.about.madeUtc_us = session.now_us();
  contents.tables = tablesOf(data.set);
  contents.every = kRecordedRate_Hz / request.rate_Hz;
  contents.softwareVersion = softwareVersion();
  for (const Text& sentence : originSentences(data.inputs)) {
    contents.origin.push_back(sentence.str());
  }
  for (const CohortTrainee& trainee : data.inputs.trainees) {
    contents.participants.emplace_back(trainee.code, data.inputs.groups[trainee.group].name.str());
  }
  contents.progress = progress;
  Connection& connection = session.connection();
  TrialLoader recordings(connection);
  for (const TrialSummaryRow& trial : data.inputs.trials) {
    contents.recordings.push_back(
        {trial.trialId.text(), trial.trainee,
         [&recordings, &data, id = trial.trialId] { return recordings.load(data.recordings.at(id)); }});
  }
  const Cohort cohort = StudyRepository(connection).cohort(data.request.cohortId);
  if (const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId)) {
    contents.curriculumJson = curriculumJson(withCodes(*version));
  }
  if (request.whole) {
    contents.studyJson = datasetStudyJson(connection, data);
    contents.studySeal = datasetSeal(contents.studyJson);
  }
  std::vector<std::filesystem::path> files = writeDataset(contents, request.layout, folder);
  return noted(session, data.request, "dataset", std::ssize(data.inputs.trainees), false, data.pseudonyms,
               std::move(files));
}

namespace {

/// Returns the first names and how many there are besides: "T-01, T-02 and 3 more".
Text fewOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  const std::vector<std::string> first(
      names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(kMost, names.size())));
  return names.size() <= kMost ? Text(joined(first))
                               : Text(Text::tr("%1 and %2 more", joined(first), names.size() - kMost));
}

std::vector<Text> leftOut(const IliasGrades& filled) {
  std::vector<Text> notes;
  if (!filled.absent.empty()) {
    notes.push_back(
        Text::tr("%1 {trainee with a score is|trainees with a score are} not in the file from ILIAS: %2",
                 std::ssize(filled.absent), fewOf(filled.absent)));
  }
  if (!filled.strangers.empty()) {
    notes.push_back(Text::tr("%1 {login|logins} of the file {belongs|belong} to no trainee: %2",
                             std::ssize(filled.strangers), fewOf(filled.strangers)));
  }
  return notes;
}

}  // namespace

ExchangeFiles exportGradebook(SessionContext& session, const ExchangeRequest& request, TrialDigests& digests,
                              const GradebookRequest& wanted, const std::filesystem::path& file) {
  session.require(Operation::kReportExportNamed);
  const Grades grades = gradesOf(
      session,
      reportInputs(session, {request.cohortId, {}, request.frozenId, ReportIdentity::kCoded}, digests));
  std::string text;
  std::vector<Text> notes;
  switch (wanted.form) {
    case GradebookForm::kMoodle:
      text = moodleGrades(grades);
      break;
    case GradebookForm::kCanvas:
      text = canvasGrades(grades);
      break;
    case GradebookForm::kIlias: {
      if (wanted.status.empty()) {
        throw Error(ErrorCode::kBadParameter, Text::tr("ILIAS knows people by numbers of its own"),
                    file.string(),
                    Text::tr("Give the status file of the exercise, downloaded from ILIAS as CSV"));
      }
      IliasGrades filled = iliasGrades(grades, occasionAt(grades, wanted.occasion), readFile(wanted.status),
                                       wanted.status.string());
      text = std::move(filled.text);
      notes = leftOut(filled);
      break;
    }
  }
  writeFileAtomically(file, text);
  ExchangeFiles written = noted(session, request, std::string("gradebook, ") + nameOf(wanted.form),
                                std::ssize(grades.people), true, {}, {file});
  written.notes = std::move(notes);
  return written;
}

}  // namespace torsio
