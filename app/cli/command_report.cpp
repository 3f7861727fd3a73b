// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/outputs/report/cell_trace.h"

namespace torsio::cli {

namespace {

struct ReportArguments {
  TraceRequest trace;
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

}  // namespace

void addReport(CLI::App& program) {
  auto arguments = std::make_shared<ReportArguments>();
  arguments->trace.record = "torsio.sqlite";
  CLI::App* report = program.add_subcommand("report", "The cohort report");
  report->require_subcommand(1);
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
