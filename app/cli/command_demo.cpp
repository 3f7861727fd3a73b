// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/wording/wording.h"
#include "app/services/base/assets.h"
#include "app/services/demonstration/demonstration.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/number_format.h"
#include "sim/core/clock.h"
#include "sim/core/file_io.h"

namespace torsio::cli {

namespace {

struct DemoArguments {
  std::string out;
  std::uint64_t seed = 1;
  std::optional<std::int64_t> shorten;
  std::optional<std::size_t> twists;
  bool full = false;
  std::string language = "en";
  OrganArguments organ;
};

void runDemo(const DemoArguments& arguments) {
  DemonstrationOptions options;
  options.out = arguments.out;
  options.seed = arguments.seed;
  options.shortening = arguments.full ? 1 : arguments.shorten.value_or(options.shortening);
  options.fewestTwists =
      arguments.twists.value_or(arguments.full || arguments.shorten ? 0 : kDemonstrationTwists);
  options.training = sceneRequest(arguments.organ);
  options.example.assets = assetsFolder();
  options.example.id = "stomach";
  options.createdUtc_us = utcNow_us();
  options.writeReport = [wording = wordingIn(arguments.language)](const CohortInputs& inputs,
                                                                  const DemonstrationSummary& files) {
    const AnalysedCohort analysed = analysedCohort(inputs);
    writePdfReport(cohortReport(inputs, analysed), files.report, wording);
    writeFileAtomically(files.table, cohortCsvText(analysed.ledger));
  };
  DemonstrationSummary summary;
  {
    ProgressLine line;
    options.progress = [&line](const Progress& progress) { line.show(progress); };
    summary = runDemonstration(options);
  }
  std::cout << "Demonstration with simulated people, seed " << arguments.seed << "\n"
            << "  " << summary.trials << " runs, " << formatFixed(summary.recorded_min, 1)
            << " minutes recorded, " << summary.samples << " samples, " << summary.twists << " twists\n"
            << "  report    " << summary.report.string() << "\n"
            << "  table     " << summary.table.string() << "\n"
            << "  database  " << summary.database.string() << "\n"
            << "Replay a run: torsio replay " << summary.firstTrialId << " --database "
            << summary.database.string() << " --verify\n";
}

}  // namespace

void addDemo(CLI::App& program) {
  auto arguments = std::make_shared<DemoArguments>();
  CLI::App* command = program.add_subcommand(
      "demo", "A whole study with simulated people: twist, record, mark, evaluate, report");
  command->add_option("--out", arguments->out, "Folder for cohort.pdf, cohort.csv and torsio.sqlite")
      ->required();
  addDefaulted(*command, "--seed", arguments->seed, "Same seed, same results");
  command
      ->add_option("--shorten", arguments->shorten,
                   "Shortens training time by this factor, however few twists remain (default: 60)")
      ->check(CLI::Range(1, 600));
  command
      ->add_option("--twists", arguments->twists,
                   "Minimum number of twists per phase (default: 10; none with --shorten or --full)")
      ->check(CLI::Range(0, 200));
  addDefaulted(*command, "--language", arguments->language, "Language of the report; the table stays English",
               CLI::IsMember(reportLanguages()));
  command->add_flag("--full", arguments->full, "Full length: twenty minutes per phase");
  addOrganOptions(*command, arguments->organ);
  command->callback([arguments] { runDemo(*arguments); });
}

}  // namespace torsio::cli
