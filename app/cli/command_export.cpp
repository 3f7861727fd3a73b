// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "app/connectors/built_in.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/wording/wording.h"
#include "app/services/base/assets.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::cli {

namespace {

struct ExportArguments {
  DatabaseOption database;
  std::string cohort;
  std::string campaign;
  std::string out;
  std::string format = "csv";
  std::string system = "moodle";
  std::string status;
  std::string occasion;
  std::string language = "en";
  std::string keyFile;
  DatasetRequest dataset;
  ExchangeRequest request;
  MaintenanceOptions maintenance;
  bool json = false;
};

/// Returns the key in a file, creating it if missing.
std::string keyOf(const std::string& file) {
  if (file.empty()) {
    return {};
  }
  if (!std::filesystem::exists(file)) {
    writeFileAtomically(file, Pseudonyms::freshKey() + "\n");
  }
  std::string key = readFile(file);
  while (!key.empty() && (key.back() == '\n' || key.back() == '\r')) {
    key.pop_back();
  }
  (void)Pseudonyms(
      key);  // rejects short keys; an empty one would silently be replaced by a random one each time
  return key;
}

void print(const ExchangeFiles& done, const std::vector<Text>& sentences, bool json) {
  if (json) {
    nlohmann::ordered_json what{{"bytes", done.bytes}, {"hash", done.contentHash}};
    for (const std::filesystem::path& file : done.files) {
      what["files"].push_back(file.string());
    }
    for (const Text& sentence : sentences) {
      what["pseudonymised"].push_back(sentence.str());
    }
    for (const Text& note : done.notes) {
      what["notes"].push_back(note.str());
    }
    printJson(what);
    return;
  }
  for (const Text& note : done.notes) {
    say(note);
  }
  for (const std::filesystem::path& file : done.files) {
    std::cout << file.string() << "\n";
  }
  std::cout << done.bytes << " bytes, " << done.contentHash << "\n";
}

using Write = ExchangeFiles (*)(SessionContext& session, const ExchangeData& data,
                                const ExportArguments& given);

void run(const ExportArguments& given, Write write) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  ExchangeRequest request = given.request;
  request.pseudonymised = request.pseudonymised || !given.keyFile.empty();
  request.key = keyOf(given.keyFile);
  nameRequest(desk.session(), given.cohort, given.campaign, request);
  TrialDigests digests(assetsFolder());
  const ExchangeData data = exchangeData(desk.session(), request, digests);
  const std::vector<Text> sentences = pseudonymSentences(data);
  for (const Text& sentence : sentences) {
    std::cerr << "torsio: " << sentence.str() << "\n";
  }
  print(write(desk.session(), data, given), sentences, given.json);
}

ExchangeFiles writeBook(SessionContext& session, const ExchangeData& data, const ExportArguments& given) {
  const Wording wording = wordingIn(given.language, Signs::kOfFiles);
  return exportWorkbook(
      session, data, [&](const Text& text) { return wording(text).toStdString(); }, given.out);
}

ExchangeFiles writeTableFiles(SessionContext& session, const ExchangeData& data,
                              const ExportArguments& given) {
  return exportTables(session, data, tableFormat(given.format), given.out);
}

ExchangeFiles writeSet(SessionContext& session, const ExchangeData& data, const ExportArguments& given) {
  return exportDataset(session, data, given.dataset, given.out);
}

void writeGrades(const ExportArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  ExchangeRequest request = given.request;
  nameRequest(desk.session(), given.cohort, {}, request);
  TrialDigests digests(assetsFolder());
  print(exportGradebook(desk.session(), request, digests,
                        {gradebookForm(given.system), given.status, given.occasion}, given.out),
        {}, given.json);
}

void addCommon(CLI::App& command, ExportArguments& arguments, const char* out) {
  addDatabaseOption(command, arguments.database);
  command.add_option("--cohort", arguments.cohort, "Name of the cohort; default: the oldest");
  command.add_option("--out", arguments.out, out)->required();
  command.add_option("--reason", arguments.request.reason, "Reason, for the audit trail");
  addSignIn(command, arguments.maintenance, "--login");
  command.add_flag("--json", arguments.json, "Print JSON");
}

void addPseudonyms(CLI::App& command, ExportArguments& arguments) {
  command.add_option("--evaluation", arguments.campaign,
                     "Name of the evaluation of models; default: the oldest with marks");
  command.add_flag("--pseudonymised", arguments.request.pseudonymised,
                   "Opaque names, shifted times, without rare attributes and free text");
  command.add_option("--key-file", arguments.keyFile,
                     "Key of the pseudonyms, created if missing: exports with the same key can be joined");
  command.add_flag("--with-free-text", arguments.request.withFreeText,
                   "With --pseudonymised: keep free text");
}

}  // namespace

void addExport(CLI::App& program) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* parent = program.add_subcommand("export", "A cohort's data for other programs");
  parent->require_subcommand(1);

  CLI::App* book = parent->add_subcommand("workbook", "A workbook for spreadsheets (.xlsx), with charts");
  addCommon(*book, *arguments, "File to write");
  addPseudonyms(*book, *arguments);
  addDefaulted(*book, "--language", arguments->language, "en or zh_CN");
  book->callback([arguments] { run(*arguments, &writeBook); });

  CLI::App* tables = parent->add_subcommand("tables", "Tables for statisticians, with a codebook");
  addCommon(*tables, *arguments, "Folder to write into");
  addPseudonyms(*tables, *arguments);
  addDefaulted(*tables, "--as", arguments->format, "spss, r or csv");
  tables->callback([arguments] { run(*arguments, &writeTableFiles); });

  CLI::App* grades = parent->add_subcommand("gradebook", "Scores for a learning system");
  addCommon(*grades, *arguments, "File to write");
  addDefaulted(*grades, "--as", arguments->system, "moodle, canvas or ilias");
  grades->add_option("--status", arguments->status,
                     "With --as ilias: status file of the exercise, downloaded from ILIAS as CSV");
  grades->add_option("--occasion", arguments->occasion,
                     "With --as ilias: occasion whose scores are the marks; default: the last");
  grades->callback([arguments] { writeGrades(*arguments); });
}

void addDataset(CLI::App& program) {
  auto arguments = std::make_shared<ExportArguments>();
  arguments->format = "frictionless";
  CLI::App* parent =
      program.add_subcommand("dataset", "A cohort's data with its recordings, for publication");
  parent->require_subcommand(1);

  CLI::App* out = parent->add_subcommand("export", "Tables, trajectories and definitions, with a descriptor");
  addCommon(*out, *arguments, "New folder to write into");
  addPseudonyms(*out, *arguments);
  addDefaulted(*out, "--as", arguments->format, "frictionless, ro-crate, parquet, bids or lerobot");
  DatasetAbout& about = arguments->dataset.about;
  out->add_option("--title", about.title, "Title of the data set")->required();
  out->add_option("--licence", about.licence, "SPDX identifier of the licence: CC-BY-4.0")->required();
  out->add_option("--description", about.description, "What the data are about");
  out->add_option("--citation", about.citation, "How users cite the data");
  out->add_option("--creator", about.creator, "Author: person or centre");
  addDefaulted(*out, "--rate", arguments->dataset.rate_Hz,
               "Samples of a trajectory per second; a divisor of 1000");
  out->add_flag("--whole", arguments->dataset.whole, "Also include what an import into another record needs");
  out->callback([arguments] {
    arguments->dataset.layout = datasetLayout(arguments->format);
    requireWhole(arguments->dataset.about);
    run(*arguments, &writeSet);
  });

  if constexpr (kForeignBuiltIn) {
    addDatasetImport(*parent);
  }
}

}  // namespace torsio::cli
