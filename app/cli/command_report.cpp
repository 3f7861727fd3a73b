// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/report_export.h"
#include "app/outputs/report/report_names.h"
#include "app/outputs/wording/wording.h"
#include "app/services/base/assets.h"
#include "app/services/maintenance/maintenance_desk.h"

namespace torsio::cli {

namespace {

struct ReportArguments {
  TraceRequest trace;
  bool json = false;
};

struct CohortArguments {
  std::string database = "torsio.sqlite";
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

void writeCohort(const CohortArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database);
  ReportRequest request = reportNamed(desk.session(), given.names);
  request.identity = given.identity;
  TrialDigests digests(assetsFolder());
  CohortInputs inputs;
  {
    ProgressLine line;
    inputs = reportInputs(desk.session(), request, digests, [&line](const Progress& at) { line.show(at); });
  }
  const nlohmann::ordered_json files = writtenFiles(desk.session(), request, inputs, given);
  if (given.json) {
    printJson({{"simulated", inputs.demonstration}, {"files", files}});
    return;
  }
  for (const auto& file : files) {
    std::cout << file["file"].get<std::string>() << "\n";
  }
}

void addCohort(CLI::App& report) {
  auto arguments = std::make_shared<CohortArguments>();
  CLI::App* command = report.add_subcommand("cohort", "Writes the report of a cohort");
  addDatabaseArgument(*command, "--database", arguments->database, "SQLite file or postgresql://... address")
      ->capture_default_str();
  command->add_option("--cohort", arguments->names.cohort, "Name of the cohort; default: the oldest");
  command->add_option("--evaluation", arguments->names.campaign,
                      "Name of the evaluation of models; default: the oldest with marks");
  command->add_option("--frozen", arguments->names.frozen,
                      "Name of a frozen data set; default: current data");
  command->add_option("--out", arguments->out, "PDF to write")->required();
  command->add_option("--csv", arguments->csv, "Also write the table of numbers to this file");
  addDefaulted(*command, "--language", arguments->language, "Language of the PDF; the table stays English",
               CLI::IsMember(reportLanguages()));
  command->add_option("--people", arguments->identity, "coded, named or aggregated; default: coded")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ReportIdentity>{{"coded", ReportIdentity::kCoded},
                                                {"named", ReportIdentity::kNamed},
                                                {"aggregated", ReportIdentity::kAggregated}}));
  addSignIn(*command, arguments->maintenance, "--login");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { writeCohort(*arguments); });
}

}  // namespace

void addReport(CLI::App& program) {
  auto arguments = std::make_shared<ReportArguments>();
  arguments->trace.record = "torsio.sqlite";
  CLI::App* report = program.add_subcommand("report", "The cohort report");
  report->require_subcommand(1);
  addCohort(*report);
  CLI::App* command = report->add_subcommand(
      "trace", "Traces a number to its marks, criteria, scoring sheet, recording and program");
  addDatabaseArgument(*command, "--database", arguments->trace.record,
                      "SQLite file or postgresql://... address")
      ->capture_default_str();
  command->add_option("--cohort", arguments->trace.cohort, "Name of the cohort; default: the oldest");
  command->add_option("--evaluation", arguments->trace.campaign,
                      "Name of the evaluation of models; default: the oldest with marks");
  command->add_flag("--json", arguments->json, "Print JSON");
  command
      ->add_option("CELL", arguments->trace.cell,
                   "The first seven cells of a row of cohort.csv, from section to statistic")
      ->required();
  command->callback([arguments] {
    const TraceStep step = traceCell(arguments->trace);
    if (arguments->json) {
      printJson(jsonOf(step));
    } else {
      print(step, "");
    }
  });
}

}  // namespace torsio::cli
