// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/dataset/replication.h"
#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/report_export.h"
#include "app/outputs/report/report_names.h"
#include "app/outputs/wording/wording.h"
#include "app/services/access/two_people.h"
#include "app/services/base/assets.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/study_statements.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/number_format.h"
#include "assessment/results/validity_argument.h"

namespace torsio::cli {

namespace {

/// Adds an option that takes one of these words. (CLI::CheckedTransformer prints the bytes of the values.)
template <typename Target, typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, const std::string& what, Target& target,
                       const std::map<std::string, Value>& choices) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) {
    words.push_back(word);
  }
  return command
      .add_option_function<std::string>(
          name, [&target, choices](const std::string& word) { target = choices.at(word); }, what)
      ->check(CLI::IsMember(words));
}

struct ReportArguments {
  DatabaseOption database;
  TraceRequest trace;
  bool json = false;
};

struct CohortArguments {
  DatabaseOption database;
  ReportNames names;
  ReportIdentity identity = ReportIdentity::kCoded;
  std::string language = "en";
  std::string out;
  std::string csv;
  MaintenanceOptions maintenance;
  bool json = false;
};

nlohmann::ordered_json jsonOf(const TraceStep& step) {
  nlohmann::ordered_json json{{"what", step.what.str()}, {"value", step.value}};
  for (const TraceStep& part : step.madeOf) {
    json["made_of"].push_back(jsonOf(part));
  }
  return json;
}

void print(const TraceStep& step, const std::string& indent) {
  std::cout << indent << step.what.str() << (step.value.empty() ? "" : " = " + step.value) << "\n";
  for (const TraceStep& part : step.madeOf) {
    print(part, indent + "  ");
  }
}

/// Writes the files that were asked for; returns them with size and hash.
nlohmann::ordered_json writtenFiles(SessionContext& session, const ReportRequest& request,
                                    const CohortInputs& inputs, const CohortArguments& given) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  const auto write = [&](ReportFormat format, const std::string& file) {
    const ReportExport done = exportReport(session, request, inputs, format, file, given.language);
    files.push_back({{"file", done.file.string()}, {"bytes", done.bytes}, {"hash", done.contentHash}});
  };
  write(ReportFormat::kPdf, given.out);
  if (!given.csv.empty()) {
    write(ReportFormat::kCsv, given.csv);
  }
  return files;
}

/// Reads what a report says, with a line of progress.
CohortInputs inputsWithProgress(SessionContext& session, const ReportRequest& request) {
  TrialDigests digests(assetsFolder());
  ProgressLine line;
  return reportInputs(session, request, digests, [&line](const Progress& at) { line.show(at); });
}

void writeCohort(const CohortArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  ReportRequest request = reportNamed(desk.session(), given.names);
  request.identity = given.identity;
  const CohortInputs inputs = inputsWithProgress(desk.session(), request);
  const nlohmann::ordered_json files = writtenFiles(desk.session(), request, inputs, given);
  if (given.json) {
    printJson({{"simulated", inputs.demonstration}, {"files", files}});
    return;
  }
  for (const auto& file : files) {
    std::cout << file["file"].get<std::string>() << "\n";
  }
}

void addReportNames(CLI::App& command, ReportNames& names) {
  command.add_option("--cohort", names.cohort, "Name of the cohort; default: the oldest");
  command.add_option("--evaluation", names.campaign,
                     "Name of the evaluation of models; default: the oldest with marks");
  command.add_option("--frozen", names.frozen, "Name of a frozen data set; default: current data");
}

void addCohort(CLI::App& report) {
  auto arguments = std::make_shared<CohortArguments>();
  CLI::App* command = report.add_subcommand("cohort", "Writes the report of a cohort");
  addDatabaseOption(*command, arguments->database);
  addReportNames(*command, arguments->names);
  command->add_option("--out", arguments->out, "PDF to write")->required();
  command->add_option("--csv", arguments->csv, "Also write the table of numbers to this file");
  addDefaulted(*command, "--language", arguments->language, "Language of the PDF; the table stays English",
               CLI::IsMember(reportLanguages()));
  addChoice(*command, "--people", "How people are shown; default: coded", arguments->identity,
            std::map<std::string, ReportIdentity>{{"coded", ReportIdentity::kCoded},
                                                  {"named", ReportIdentity::kNamed},
                                                  {"aggregated", ReportIdentity::kAggregated}});
  addSignIn(*command, arguments->maintenance, "--login");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { writeCohort(*arguments); });
}

nlohmann::ordered_json jsonOf(const ValidityLine& line) {
  nlohmann::ordered_json json{{"id", line.id},
                              {"inference", nameOf(line.inference)},
                              {"source", nameOf(line.source)},
                              {"claim", line.claim}};
  if (line.threshold) {
    json["threshold"] = {{"words", thresholdText(*line.threshold)},
                         {"value", line.threshold->value},
                         {"source", line.threshold->source},
                         {"sealed", line.threshold->sealed}};
  }
  if (line.results > 0) {
    json["number"] = numberJson(line.number, line.note);
    if (line.interval) {
      json["interval"] = intervalJson(*line.interval);
    }
    json["n"] = line.n;
    json["results"] = line.results;
    json["cell"] = line.cell;
  }
  json["verdict"] = nameOf(line.verdict);
  json["note"] = line.note;
  return json;
}

/// For reading; the exact number stands in JSON and in the file.
std::string roundedText(double value) {
  constexpr int kDecimals = 3;
  return formatFixed(value, value == std::floor(value) ? 0 : kDecimals);
}

void print(const ValidityLine& line) {
  std::cout << line.id << ": " << nameOf(line.verdict) << "\n  " << line.claim << "\n  "
            << nameOf(line.inference) << "; " << nameOf(line.source) << "\n";
  if (line.threshold) {
    std::cout << "  threshold: " << thresholdText(*line.threshold) << " (" << line.threshold->source << ")"
              << (line.threshold->sealed ? "" : "; threshold not sealed beforehand") << "\n";
  }
  if (line.number) {
    std::cout << "  number: " << roundedText(*line.number);
    if (line.interval) {
      std::cout << ", 95 % interval [" << roundedText(line.interval->lower) << ", "
                << roundedText(line.interval->upper) << "]";
    } else if (line.counted) {
      std::cout << ", counted or planned, so without an interval";
    }
    std::cout << "; n = " << line.n;
    if (line.results > 1) {
      std::cout << "; the worst of " << line.results;
    }
    std::cout << "\n  cell: " << line.cell << "\n";
  }
  if (!line.note.empty()) {
    std::cout << (line.verdict == ValidityVerdict::kNotCollected ? "  to collect: " : "  note: ") << line.note
              << "\n";
  }
}

void argueValidity(const CohortArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  const ReportRequest request = reportNamed(desk.session(), given.names);
  const CohortInputs inputs = inputsWithProgress(desk.session(), request);
  const std::vector<ValidityLine> lines = validityArgument(analysedCohort(inputs));
  if (!given.out.empty()) {
    (void)exportReport(desk.session(), request, inputs, ReportFormat::kValidity, given.out);
  }
  if (given.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const ValidityLine& line : lines) {
      list.push_back(jsonOf(line));
    }
    printJson({{"simulated", inputs.demonstration}, {"lines", list}});
    return;
  }
  if (inputs.demonstration) {
    std::cout << "Simulated data: no evidence about people\n";
  }
  for (const ValidityLine& line : lines) {
    print(line);
  }
}

void addValidity(CLI::App& report) {
  auto arguments = std::make_shared<CohortArguments>();
  CLI::App* command =
      report.add_subcommand("validity", "Weighs what a cohort's results say for and against its scores");
  addDatabaseOption(*command, arguments->database);
  addReportNames(*command, arguments->names);
  command->add_option("--out", arguments->out, "Also write the lines to this file, as CSV");
  addSignIn(*command, arguments->maintenance, "--login");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { argueValidity(*arguments); });
}

void replicate(const CohortArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  const ReportRequest named = reportNamed(desk.session(), given.names);
  TrialDigests digests(assetsFolder());
  const ExchangeData data = exchangeData(
      desk.session(),
      {.cohortId = named.cohortId, .campaignId = named.campaignId, .frozenId = named.frozenId}, digests);
  const ExchangeFiles written = exportReplication(desk.session(), data, given.out);
  if (given.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const std::filesystem::path& file : written.files) {
      files.push_back(file.string());
    }
    printJson({{"folder", given.out}, {"files", files}, {"hash", written.contentHash}});
    return;
  }
  std::cout << given.out << ": " << written.files.size() << " files, hash " << written.contentHash
            << "\nTo recompute, run Rscript analysis.R there\n";
}

void checkPackage(const CohortArguments& given, const std::string& folder) {
  const ReplicationCheck check = checkReplication(folder);
  if (given.json) {
    nlohmann::ordered_json differences = nlohmann::ordered_json::array();
    for (const Text& difference : check.differences) {
      differences.push_back(difference.str());
    }
    printJson({{"same", check.same()},
               {"recomputed", check.recomputed},
               {"computed", check.computed},
               {"own_script", check.ownScript},
               {"differences", differences}});
  } else {
    std::cout << check.recomputed << " of " << check.computed << " computed numbers recomputed by R\n"
              << (check.ownScript ? ""
                                  : "The folder's analysis.R is not this program's, which was run instead\n");
    for (const Text& difference : check.differences) {
      std::cout << difference << "\n";
    }
  }
  if (!check.same()) {
    throw Error(ErrorCode::kVerifyFailed,
                Text::verbatim("the package does not give the numbers of its report"), folder,
                Text::verbatim("Get a fresh copy from whoever wrote it, or write it again"));
  }
}

void addReplicate(CLI::App& report) {
  auto arguments = std::make_shared<CohortArguments>();
  auto folder = std::make_shared<std::string>();
  CLI::App* command = report.add_subcommand(
      "replicate", "Writes or checks a folder from which R recomputes the report's numbers");
  addDatabaseOption(*command, arguments->database);
  addReportNames(*command, arguments->names);
  CLI::Option* out = command->add_option("--out", arguments->out, "New folder to write");
  command
      ->add_option("--check", *folder, "Folder to check: hashes, R, number by number; code 13 if it differs")
      ->excludes(out);
  for (const char* name : {"--cohort", "--evaluation", "--frozen"}) {
    command->get_option(name)->excludes("--check");
  }
  addSignIn(*command, arguments->maintenance, "--login");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, folder] {
    if (arguments->out.empty() == folder->empty()) {
      refuseUsage("neither --out nor --check", "report replicate", "Give one of them");
    }
    folder->empty() ? replicate(*arguments) : checkPackage(*arguments, *folder);
  });
}

struct FreezeArguments {
  DatabaseOption database;
  ReportNames names;
  std::string name;
  std::string whyIncomplete;
  MaintenanceOptions maintenance;
};

void freeze(const FreezeArguments& given) {
  const Maintainer maintainer = given.maintenance.maintainer();
  MaintenanceDesk desk(maintainer, given.database.locator());
  const ReportRequest of = reportNamed(desk.session(), given.names);
  if (!given.whyIncomplete.empty()) {
    desk.handOver(maintainer, {.act = DutyAct::kFreezeInterim,
                               .subject = of.cohortId,
                               .shown = given.names.cohort,
                               .reason = given.whyIncomplete});
  }
  std::vector<CampaignId> campaigns;
  if (!of.campaignId.empty()) {
    campaigns.push_back(of.campaignId);
  }
  const FrozenRow row = freezeData(desk.session(), of.cohortId, given.name, campaigns, given.whyIncomplete);
  std::cout << "Frozen as \"" << row.name << "\", " << row.contentHash << ": " << sentenceOf(row.sheets)
            << "\n";
}

void addFreeze(CLI::App& report) {
  auto arguments = std::make_shared<FreezeArguments>();
  CLI::App* command =
      report.add_subcommand("freeze", "Freezes the data of a cohort under a name, signed with your password");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--cohort", arguments->names.cohort, "Name of the cohort")->required();
  command->add_option("--evaluation", arguments->names.campaign,
                      "Name of the evaluation of models; default: the oldest with marks");
  command->add_option("--name", arguments->name, "Name of the data set")->required();
  command->add_option("--incomplete", arguments->whyIncomplete,
                      "Why an interim state is frozen, where sheets are missing");
  addSignIn(*command, arguments->maintenance, kLoginOrAs)->required();
  addSecondPerson(*command, arguments->maintenance);
  command->callback([arguments] { freeze(*arguments); });
}

struct StatementArguments {
  DatabaseOption database;
  std::string cohort;
  StudyItem item = StudyItem::kEnd;
  std::string statement;
  MaintenanceOptions maintenance;
  bool json = false;
};

void setStatement(const StatementArguments& given) {
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  const CohortId cohort = reportNamed(desk.session(), {.cohort = given.cohort}).cohortId;
  StudyStatements all = studyStatements(desk.session(), cohort);
  if (given.item != StudyItem::kEnd) {
    if (given.statement.empty()) {
      all.erase(given.item);
    } else {
      all[given.item] = given.statement;
    }
    setStudyStatements(desk.session(), cohort, all);
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Term<StudyItem>& item : kStudyItems) {
    const auto stated = all.find(item.value);
    const std::string words = stated == all.end() ? std::string() : stated->second;
    json[std::string(item.stored)] = words;
    if (!given.json) {
      std::cout << item.stored << ": "
                << (words.empty() ? "not recorded (" + std::string(hintOf(item.value).english()) + ")"
                                  : words)
                << "\n";
    }
  }
  if (given.json) {
    printJson(json);
  }
}

void addStatement(CLI::App& report) {
  auto arguments = std::make_shared<StatementArguments>();
  CLI::App* command = report.add_subcommand(
      "statement", "Shows or changes what a study says about itself: registration, ethics approval ...");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--cohort", arguments->cohort, "Name of the cohort; default: the oldest");
  std::map<std::string, StudyItem> items;
  for (const Term<StudyItem>& item : kStudyItems) {
    items.emplace(item.stored, item.value);
  }
  CLI::Option* item = addChoice(*command, "ITEM", "Item to change, as listed", arguments->item, items);
  command->add_option("STATEMENT", arguments->statement, "What it says from now on; empty: take it back")
      ->needs(item);
  command->add_flag("--json", arguments->json, "Print JSON");
  addSignIn(*command, arguments->maintenance, kLoginOrAs)->required();
  command->callback([arguments] { setStatement(*arguments); });
}

}  // namespace

void addReport(CLI::App& program) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* report = program.add_subcommand("report", "The cohort report");
  report->require_subcommand(1);
  addCohort(*report);
  addValidity(*report);
  addReplicate(*report);
  addFreeze(*report);
  addStatement(*report);
  CLI::App* command = report->add_subcommand(
      "trace", "Traces a number to its marks, criteria, scoring sheet, recording and program");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--cohort", arguments->trace.cohort, "Name of the cohort; default: the oldest");
  command->add_option("--evaluation", arguments->trace.campaign,
                      "Name of the evaluation of models; default: the oldest with marks");
  command->add_flag("--json", arguments->json, "Print JSON");
  command
      ->add_option("CELL", arguments->trace.cell,
                   "The first seven cells of a row of cohort.csv, from section to statistic")
      ->required();
  command->callback([arguments] {
    arguments->trace.record = arguments->database.locator();
    const TraceStep step = traceCell(arguments->trace);
    if (arguments->json) {
      printJson(jsonOf(step));
    } else {
      print(step, "");
    }
  });
}

}  // namespace torsio::cli
