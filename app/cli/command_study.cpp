// SPDX-License-Identifier: GPL-3.0-or-later
// torsio study: trials of several centres
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/outputs/report/report_names.h"
#include "app/services/access/station_name.h"
#include "app/services/base/build_info.h"
#include "app/services/centres/site_export.h"
#include "app/services/centres/site_package.h"
#include "app/services/centres/site_pool.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "assessment/results/number_format.h"
#include "db/connection/locator.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/demonstration_data.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct StudyArguments {
  DatabaseOption database;
  std::string cohort;
  std::string campaign;
  std::string out;
  std::string key;
  std::string package;
  std::string publicKey;
  MaintenanceOptions maintenance;
  bool json = false;

  /// Nobody said who acts: the owner of the file, for simulated people only.
  [[nodiscard]] bool simulatedOnly() const { return maintenance.login.empty() && !maintenance.asSystem; }
};

nlohmann::ordered_json jsonOf(const SiteManifest& manifest) {
  return {{"centre", manifest.centreId.text()},
          {"code", manifest.centreCode},
          {"name", manifest.centreName},
          {"public_key", manifest.publicKey},
          {"made", formatUtc(manifest.madeUtc_us)},
          {"trail_length", manifest.trailLength},
          {"trail_hash", manifest.trailHash},
          {"cohort", manifest.cohort},
          {"simulated", manifest.simulated},
          {"trainees", manifest.trainees},
          {"left_out", manifest.leftOut},
          {"sealed_rows", manifest.sealedRows},
          {"other_rows", manifest.otherRows},
          {"protocol_hash", manifest.protocol.hash()},
          {"rows", manifest.rows}};
}

std::int64_t rowsOf(const SiteManifest& manifest, const std::string& table) {
  const auto found = manifest.rows.find(table);
  return found == manifest.rows.end() ? 0 : found->second;
}

/// The names of simulated centres say so already, unless somebody gave them another.
const char* mark(const std::string& name, bool simulated) {
  constexpr const char* kMark = " (simulated)";
  return simulated && !name.ends_with(kMark) ? kMark : "";
}

void printWithdrawn(const std::vector<std::string>& codes) {
  if (!codes.empty()) {
    std::cout << "    no longer agree to research:";
    for (const std::string& code : codes) {
      std::cout << " " << Text(code);
    }
    std::cout << "\n";
  }
}

void print(const SiteManifest& manifest) {
  std::cout << "Centre " << Text(manifest.centreCode) << ", " << Text(manifest.centreName)
            << mark(manifest.centreName, manifest.simulated) << "\n"
            << "  cohort      " << Text(manifest.cohort) << "\n"
            << "  "
            << Text::verbatim(
                   "%1 {trainee|trainees}, %2 {recording|recordings}, %3 {mark|marks}; %4 left out",
                   manifest.trainees, rowsOf(manifest, "trial"), rowsOf(manifest, "training_mark"),
                   manifest.leftOut)
            << "\n"
            << "  made        " << formatUtc(manifest.madeUtc_us) << ", entry " << manifest.trailLength
            << " of its audit trail\n"
            << "  protocol    " << manifest.protocol.hash() << "\n"
            << "  public key  " << manifest.publicKey << "\n";
}

void exportPackage(const StudyArguments& given) {
  MaintenanceDesk desk(
      given.simulatedOnly() ? given.maintenance.ownerOrMaintainer() : given.maintenance.maintainer(),
      given.database.locator());
  const ReportRequest named =
      reportNamed(desk.session(), {.cohort = given.cohort, .campaign = given.campaign});
  std::optional<ProgressLine> line(std::in_place);
  const SitePackage made = exportSite(desk.session(),
                                      {.cohortId = named.cohortId,
                                       .campaignId = named.campaignId,
                                       .out = given.out,
                                       .key = given.key,
                                       .simulatedOnly = given.simulatedOnly()},
                                      [&line](const Progress& progress) { line->show(progress); });
  line.reset();
  if (made.keyMade) {
    std::cerr << "torsio: made the key of this centre, " << made.key.string()
              << ": keep it; every later package must be signed with it\n";
  }
  if (given.json) {
    nlohmann::ordered_json what = jsonOf(made.manifest);
    what["file"] = given.out;
    what["bytes"] = made.bytes;
    printJson(what);
    return;
  }
  std::cout << given.out << "\n";
  print(made.manifest);
}

void checkPackage(const StudyArguments& given) {
  const CheckedPackage checked = checkSitePackage(given.package, given.publicKey);
  if (given.json) {
    nlohmann::ordered_json what = jsonOf(checked.manifest);
    what["hash"] = checked.hash;
    printJson(what);
    return;
  }
  print(checked.manifest);
  std::cout << "The package is as its centre signed it"
            << (given.publicKey.empty() ? "; compare the public key with the one that the centre tells you.\n"
                                        : ".\n");
}

const char* kindOf(Pooled kind) {
  switch (kind) {
    case Pooled::kAdded:
      return "added";
    case Pooled::kNothingNew:
      return "nothing_new";
    case Pooled::kRepeated:
      return "repeated";
    case Pooled::kOlder:
      return "older";
  }
  return "";
}

void print(const PoolOutcome& outcome) {
  const Text site(outcome.siteCode);
  switch (outcome.kind) {
    case Pooled::kAdded:
      std::cout << "Centre " << site << ": " << outcome.rowsAdded << " rows added, " << outcome.rowsChanged
                << " changed; its people are " << site << "/T-01 ...\n";
      if (outcome.manifest.leftOut > 0) {
        std::cout << "  " << outcome.manifest.leftOut << " of its trainees do not agree to research\n";
      }
      break;
    case Pooled::kNothingNew:
      std::cout << "Centre " << site << ": nothing new; only the delivery was recorded.\n";
      break;
    case Pooled::kRepeated:
      std::cout << "Centre " << site << ": this package was delivered before, on "
                << formatUtc(outcome.earlierUtc_us) << "; nothing was changed.\n";
      break;
    case Pooled::kOlder:
      std::cout << "Centre " << site << ": this package is older than the one of "
                << formatUtc(outcome.earlierUtc_us) << " that was delivered; nothing was changed.\n";
      break;
  }
  printWithdrawn(outcome.withdrawn);
}

/// Removes a record that this command made unless the package was taken in.
class NewRecord {
 public:
  explicit NewRecord(const std::string& locator) {
    const Locator place = parseLocator(locator);
    std::error_code ignored;
    if (place.engine == Engine::kSqlite && !std::filesystem::exists(place.file, ignored)) {
      file_ = place.file;
    }
  }
  NewRecord(const NewRecord&) = delete;
  NewRecord& operator=(const NewRecord&) = delete;
  ~NewRecord() {
    if (!file_.empty()) {
      removeDatabase(file_);
    }
  }
  void keep() { file_.clear(); }

 private:
  std::filesystem::path file_;
};

void requireSimulated(const StudyArguments& given, const SiteManifest& manifest) {
  if (given.simulatedOnly() && !manifest.simulated) {
    throw Error(ErrorCode::kPermission, Text::tr("this package has people who are not simulated"),
                given.package,
                Text::tr("Sign in with --login NAME, or give --as-system as the owner of the record"));
  }
}

void poolPackage(const StudyArguments& given) {
  std::optional<ProgressLine> line(std::in_place);
  const ProgressCallback show = [&line](const Progress& progress) { line->show(progress); };
  const CheckedPackage checked = checkSitePackage(given.package, given.publicKey, show);
  requireSimulated(given, checked.manifest);
  NewRecord made(given.database.locator());
  PoolOutcome outcome;
  {
    MaintenanceDesk desk(
        given.simulatedOnly() ? given.maintenance.ownerOrMaintainer() : given.maintenance.maintainer(),
        openRecord(given.database.locator(), OpenMode::kCreate,
                   {.softwareVersion = softwareVersion(), .station = stationName()}),
        given.database.locator());
    outcome = poolSite(desk.session(), given.package, checked, show);
  }
  made.keep();
  line.reset();
  if (given.json) {
    nlohmann::ordered_json what{{"outcome", kindOf(outcome.kind)},
                                {"site", outcome.siteCode},
                                {"added", outcome.rowsAdded},
                                {"changed", outcome.rowsChanged},
                                {"withdrawn", outcome.withdrawn}};
    what["package"] = jsonOf(outcome.manifest);
    printJson(what);
    return;
  }
  print(outcome);
}

void listCentres(const StudyArguments& given) {
  MaintenanceDesk desk(given.maintenance.ownerOrMaintainer(), given.database.locator());
  const std::vector<SiteState> states = siteStates(desk.session());
  if (given.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const SiteState& state : states) {
      nlohmann::ordered_json one{{"code", state.site.code},
                                 {"centre", state.site.centreId.text()},
                                 {"name", state.site.name},
                                 {"simulated", state.site.demonstration},
                                 {"public_key", state.site.publicKey},
                                 {"trainees", state.trainees},
                                 {"recordings", state.recordings},
                                 {"marks", state.marks},
                                 {"withdrawn", state.withdrawn},
                                 {"deliveries", nlohmann::ordered_json::array()}};
      for (const SiteDelivery& delivery : state.deliveries) {
        one["deliveries"].push_back({{"made", formatUtc(delivery.madeUtc_us)},
                                     {"received", formatUtc(delivery.receivedUtc_us)},
                                     {"rows", delivery.rowsAdded},
                                     {"left_out", delivery.leftOut},
                                     {"package", delivery.packageHash}});
      }
      all.push_back(std::move(one));
    }
    printJson(all);
    return;
  }
  if (states.empty()) {
    std::cout << "No package was pooled into this record.\n";
  }
  for (const SiteState& state : states) {
    std::cout << Text(state.site.code) << "  " << Text(state.site.name)
              << mark(state.site.name, state.site.demonstration) << ": "
              << Text::verbatim("%1 {trainee|trainees}, %2 {recording|recordings}, %3 {mark|marks}",
                                state.trainees, state.recordings, state.marks)
              << "\n";
    for (const SiteDelivery& delivery : state.deliveries) {
      std::cout << "    made " << formatUtc(delivery.madeUtc_us) << ", received "
                << formatUtc(delivery.receivedUtc_us) << ", " << delivery.rowsAdded << " rows\n";
    }
    printWithdrawn(state.withdrawn);
  }
}

void addJson(CLI::App& command, StudyArguments& arguments) {
  command.add_flag("--json", arguments.json, "Print JSON");
}

}  // namespace

void addStudy(CLI::App& program) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* study = program.add_subcommand("study", "A trial of several centres");
  study->require_subcommand(1);

  CLI::App* out =
      study->add_subcommand("export", "What this centre gives to whoever pools the trial, signed");
  addDatabaseOption(*out, arguments->database);
  out->add_option("--out", arguments->out, "Package to write (*.torsio-site)")->required();
  out->add_option("--cohort", arguments->cohort, "Name of the cohort; default: the oldest");
  out->add_option("--evaluation", arguments->campaign,
                  "Name of the evaluation of models; default: the oldest with marks");
  out->add_option("--key", arguments->key,
                  "Key of this centre, made if missing; default: beside the record, *.site-key");
  addMaintenanceOptions(*out, arguments->maintenance);
  addJson(*out, *arguments);
  out->callback([arguments] { exportPackage(*arguments); });

  CLI::App* in = study->add_subcommand("pool", "Takes the package of a centre into a pooled record");
  in->add_option("package", arguments->package, "Package of a centre (*.torsio-site)")->required();
  addDatabaseOption(*in, arguments->database)->required()->description("Pooled record, made if missing");
  in->add_option("--public-key", arguments->publicKey, "Key that the package must be signed with");
  addMaintenanceOptions(*in, arguments->maintenance);
  addJson(*in, *arguments);
  in->callback([arguments] { poolPackage(*arguments); });

  CLI::App* check = study->add_subcommand("check", "Checks a package without a record");
  check->add_option("package", arguments->package, "Package of a centre (*.torsio-site)")->required();
  check->add_option("--public-key", arguments->publicKey, "Key that it must be signed with");
  addJson(*check, *arguments);
  check->callback([arguments] { checkPackage(*arguments); });

  CLI::App* list = study->add_subcommand("centres", "Which centre has delivered what and when");
  addDatabaseOption(*list, arguments->database);
  addSignIn(*list, arguments->maintenance, "--login");
  addJson(*list, *arguments);
  list->callback([arguments] { listCentres(*arguments); });
}

}  // namespace torsio::cli
