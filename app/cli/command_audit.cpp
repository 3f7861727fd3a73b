// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/maintenance/station_anchor.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/results/number_format.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct AuditArguments {
  DatabaseOption database;
  std::string file;
  std::string key;
  std::string witness;
  std::string since;
  std::string publicKey;
  std::string certificate;
  std::string address;
  bool off = false;
  MaintenanceOptions maintenance;
  bool json = false;
};

nlohmann::ordered_json jsonOf(const DatabaseCheck& check, const HeadsVerdict& heads) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const AuditFinding& finding : check.audit) {
    findings.push_back({{"entry", finding.sequence},
                        {"kind", finding.objectKind},
                        {"id", finding.objectId},
                        {"what", finding.what}});
  }
  nlohmann::ordered_json clock = nlohmann::ordered_json::array();
  for (const Text& note : check.clock) {
    clock.push_back(note.str());
  }
  nlohmann::ordered_json proven = nlohmann::ordered_json::array();
  for (const ProvenTime& one : heads.proven) {
    proven.push_back({{"entry", one.length}, {"utc", formatUtc(one.utc_us)}, {"authority", one.authority}});
  }
  nlohmann::ordered_json notes = nlohmann::ordered_json::array();
  for (const Text& note : heads.notes) {
    notes.push_back(note.str());
  }
  return {{"entries", check.auditEntries},
          {"findings", std::move(findings)},
          {"clock", std::move(clock)},
          {"proven", std::move(proven)},
          {"notes", std::move(notes)}};
}

std::string certificatesIn(const std::string& file) {
  return file.empty() ? std::string() : certificatesOf(file);
}

/// Compares the record with heads stored elsewhere.
HeadsVerdict verdictOfHeads(const AuditArguments& arguments) {
  std::vector<std::string> heads;
  if (!arguments.witness.empty()) {
    heads = headsOf(arguments.witness);
  }
  if (!arguments.since.empty()) {
    heads.push_back(arguments.since);
  }
  if (heads.empty()) {
    return {};
  }
  return judgeHeads(arguments.database.locator(), heads,
                    arguments.key.empty() ? arguments.publicKey : publicAnchorKey(arguments.key),
                    certificatesIn(arguments.certificate));
}

void verify(const AuditArguments& arguments) {
  DatabaseCheck check = checkDatabase(arguments.database.locator());
  const HeadsVerdict heads = verdictOfHeads(arguments);
  check.audit.insert(check.audit.end(), heads.findings.begin(), heads.findings.end());
  if (!check.damage.empty()) {
    throw Error(ErrorCode::kVerifyFailed, "the database is damaged: " + check.damage.front(), check.location,
                Text::verbatim("Run torsio db check, and restore a backup"));
  }
  if (arguments.json) {
    printJson(jsonOf(check, heads));
  } else {
    for (const AuditFinding& finding : check.audit) {
      std::cout << finding.objectKind << " " << finding.objectId << ": " << finding.what;
      if (finding.sequence > 0) {
        std::cout << " (entry " << finding.sequence << ")";
      }
      std::cout << "\n";
    }
    for (const auto* notes : {&std::as_const(check.clock), &heads.notes}) {
      for (const Text& note : *notes) {
        std::cout << "Note: " << note << "\n";
      }
    }
    if (check.audit.empty()) {
      std::cout << "The audit trail is whole: " << check.auditEntries
                << (check.auditEntries == 1 ? " entry" : " entries")
                << "; every sealed row and every recording is as it was recorded.\n";
    }
  }
  if (!check.audit.empty()) {
    throw Error(ErrorCode::kVerifyFailed,
                (check.audit.size() == 1 ? std::string("one thing is")
                                         : std::to_string(check.audit.size()) + " things are") +
                    " not as recorded",
                check.location, Text::verbatim("Keep this file as it is, and compare it with a backup"));
  }
}

void printHead(const AuditArguments& arguments) {
  const std::string head = anchoredHead(arguments.database.locator(), arguments.key, utcNow_us());
  if (!arguments.witness.empty()) {
    appendToWitness(arguments.witness, head);
  }
  std::cout << head << "\n";
  if (arguments.key.empty()) {
    std::cerr
        << "torsio: this checkpoint is not signed; anybody who can write to the place where it is kept can "
           "replace it. torsio audit key FILE makes a key\n";
  }
  // Last: whatever an authority does, the head is kept.
  if (const std::optional<StampAuthority> authority = stampAuthority(arguments.database.locator())) {
    const std::string stamp = stampedBy(*authority, head);
    if (!arguments.witness.empty()) {
      appendToWitness(arguments.witness, stamp);
    }
    std::cout << stamp << "\n";
  }
}

void setAuthority(const AuditArguments& arguments) {
  const bool changes = arguments.off || !arguments.address.empty();
  if (!changes || arguments.maintenance.login.empty()) {
    if (changes) {
      refuseUsage("only somebody who may change settings names an authority", "--login", "Add --login");
    }
    const std::optional<StampAuthority> known = stampAuthority(arguments.database.locator());
    std::cout << "Time stamps: " << (known ? "from " + known->address : std::string("none")) << "\n";
    return;
  }
  MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.database.locator());
  setStampAuthority(desk.session(), {arguments.off ? std::string() : arguments.address,
                                     certificatesIn(arguments.certificate)});
  std::cout << "Time stamps: " << (arguments.off ? std::string("none") : "from " + arguments.address) << "\n";
}

void setStation(const AuditArguments& arguments) {
  StationAnchor anchor = stationAnchor();
  if (!arguments.witness.empty() || !arguments.key.empty()) {
    anchor.witness = arguments.witness.empty() ? anchor.witness.string() : arguments.witness;
    anchor.key = arguments.key.empty() ? anchor.key.string() : arguments.key;
    setStationAnchor(anchor);
    anchor = stationAnchor();
  }
  std::cout << "Witness file: " << (anchor.witness.empty() ? "none" : anchor.witness.string()) << "\n"
            << "Key: " << (anchor.key.empty() ? "none, checkpoints are not signed" : anchor.key.string())
            << "\n";
}

void replaceKey(const AuditArguments& arguments) {
  const ReplacedKey made = replaceAnchorKey(arguments.database.locator(), arguments.key, arguments.file,
                                            arguments.witness, utcNow_us());
  std::cout << "Public key: " << made.publicKey << "\n"
            << made.line << "\n"
            << "Keep this line with the checkpoints of the older key; torsio audit station --key "
            << arguments.file << " sets the new one.\n";
}

void makeKey(const AuditArguments& arguments) {
  if (!arguments.key.empty()) {
    replaceKey(arguments);
    return;
  }
  std::cout << "Public key: " << makeAnchorKey(arguments.file) << "\n"
            << "Keep " << arguments.file
            << " away from the record, and the public key where you check checkpoints.\n";
}

}  // namespace

void addAudit(CLI::App& program) {
  auto arguments = std::make_shared<AuditArguments>();
  CLI::App* audit = program.add_subcommand("audit", "The audit trail");
  audit->require_subcommand(1);
  const auto addDatabase = [&arguments](CLI::App& command) {
    addDatabaseOption(command, arguments->database);
  };
  CLI::App* command =
      audit->add_subcommand("verify", "Detects any change to the audit trail and to the data of reports");
  addDatabase(*command);
  command->add_option("--since", arguments->since, "A line of torsio audit head, in quotes");
  command->add_option("--witness", arguments->witness, "File with such lines");
  command->add_option("--key", arguments->key, "File of the key that must have signed them");
  command->add_option("--public-key", arguments->publicKey, "The public part of that key");
  command->add_option("--certificate", arguments->certificate,
                      "PEM file of the time stamp authority's root, instead of the centre's setting");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { verify(*arguments); });

  command = audit->add_subcommand("head", "Prints a checkpoint of the audit trail, to be stored elsewhere");
  addDatabase(*command);
  command->add_option("--key", arguments->key, "File of the key that signs it");
  command->add_option("--witness", arguments->witness, "File to which the line is appended");
  command->callback([arguments] { printHead(*arguments); });

  command =
      audit->add_subcommand("station", "Shows or sets where this station keeps checkpoints, and its key");
  command->add_option("--witness", arguments->witness,
                      "File to which a checkpoint is appended whenever an administrator signs out");
  command->add_option("--key", arguments->key, "File of the key that signs them");
  command->callback([arguments] { setStation(*arguments); });

  command =
      audit->add_subcommand("authority", "Shows or sets the authority that stamps checkpoints (RFC 3161)");
  addDatabase(*command);
  CLI::Option* address = command->add_option("--address", arguments->address, "Where it is asked, over HTTP");
  CLI::Option* certificate =
      command->add_option("--certificate", arguments->certificate, "PEM file of its root");
  address->needs(certificate);
  certificate->needs(address);
  CLI::Option* off = command->add_flag("--off", arguments->off, "No time stamps from now on");
  off->excludes(address);
  addSignIn(*command, arguments->maintenance, "--login");
  command->callback([arguments] { setAuthority(*arguments); });

  command = audit->add_subcommand("key", "Makes a key that signs checkpoints, in a file of its own");
  command->add_option("FILE", arguments->file, "The new file")->required();
  command->add_option("--replaces", arguments->key, "File of the key that it replaces");
  command->add_option("--witness", arguments->witness,
                      "File to which the line of the replacement is appended");
  addDatabase(*command);
  command->callback([arguments] { makeKey(*arguments); });
}

}  // namespace torsio::cli
