// SPDX-License-Identifier: GPL-3.0-or-later
// torsio dataset import
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/connectors/foreign/foreign_import.h"
#include "app/services/base/assets.h"
#include "app/services/base/progress.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct ImportArguments {
  DatabaseOption database;
  std::string layout;
  std::string map;
  std::string folder;
  std::string reason;
  MaintenanceOptions maintenance;
  bool json = false;
};

template <typename Outcome>
void printImport(const Outcome& done, bool json) {
  if (json) {
    printJson(nlohmann::ordered_json{{"cohort", done.landed.cohortId.text()},
                                     {"recordings", done.trials},
                                     {"marks", done.marks},
                                     {"hash", done.contentHash},
                                     {"codes", done.landed.codes}});
    return;
  }
  std::cout << Text::verbatim("%1 {recording|recordings} and %2 {mark|marks}, %3", done.trials, done.marks,
                              done.contentHash)
            << "\n";
  for (const auto& [name, code] : done.landed.codes) {
    std::cout << name << " is " << code << "\n";
  }
}

void runImport(const ImportArguments& given) {
  const bool own = given.layout == "torsio";
  if (own ? given.folder.empty() || !given.map.empty() : given.map.empty() || !given.folder.empty()) {
    refuseUsage("a data set of Torsio is a folder; other formats need a map", given.layout,
                "Give --from FOLDER with --as torsio, --map FILE otherwise");
  }
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  auto line = std::make_unique<ProgressLine>();
  const ProgressCallback show = [&line](const Progress& progress) { line->show(progress); };
  if (own) {
    const DatasetOutcome done =
        importDataset(desk.session(), given.folder, assetsFolder(), given.reason, show);
    line.reset();
    printImport(done, given.json);
    return;
  }
  const ForeignOutcome done =
      importForeign(desk.session(), foreignLayout(given.layout), given.map, given.reason, show);
  line.reset();
  printImport(done, given.json);
}

}  // namespace

void addDatasetImport(CLI::App& dataset) {
  auto incoming = std::make_shared<ImportArguments>();
  CLI::App* in = dataset.add_subcommand("import", "A data set of Torsio, or recordings of other equipment");
  addDatabaseOption(*in, incoming->database);
  in->add_option("--as", incoming->layout, "torsio, jigsaws, rosma, perktutor, csv or parquet")->required();
  in->add_option("--from", incoming->folder, "torsio: folder of a data set that was exported whole");
  in->add_option("--map", incoming->map, "Other formats: a map of what the files do not contain (JSON)");
  in->add_option("--reason", incoming->reason, "Reason, for the audit trail");
  addSignIn(*in, incoming->maintenance, "--login")->required();
  in->add_flag("--json", incoming->json, "Print JSON");
  in->callback([incoming] { runImport(*incoming); });
}

}  // namespace torsio::cli
