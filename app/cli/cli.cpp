// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cli.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/plain_output.h"
#include "app/cli/usage_errors.h"
#include "app/connectors/built_in.h"
#include "app/outputs/charts/graphics_application.h"
#include "app/services/base/build_info.h"
#include "app/services/base/configuration.h"
#include "app/services/base/log.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

/// Joins lines: messages of a parser or library may have several.
std::string oneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) {
    text.pop_back();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Returns what is wrong with a numeric option value; empty: nothing, or not a number, which the parser
/// reports. The parser itself takes an empty word for the default.
std::string noFiniteNumber(const std::string& text) {
  if (text.empty()) {
    return "an empty word is not a number";
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() || std::isfinite(value) ? "" : text + " is not a finite number";
}

/// Options that name something of an organ: an empty word is none of its names, and not the default.
constexpr std::array kNamingOptions{"--organ",   "--material", "--pattern", "--anatomy",
                                    "--markers", "--measured", "--out",     "--series"};

/// Rejects NaN, which passes range checks: it is neither below one end nor above the other; and empty names.
void refuseNoValues(CLI::App& command) {
  for (CLI::Option* option : command.get_options({})) {
    if (std::find(kNamingOptions.begin(), kNamingOptions.end(), option->get_name()) != kNamingOptions.end()) {
      option->check([](const std::string& text) {
        return std::string(text.empty() ? "an empty word is not a name" : "");
      });
    }
    const std::string type = option->get_type_name();
    if (type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT")) {
      option->check(noFiniteNumber);
    }
  }
  for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; })) {
    refuseNoValues(*below);
  }
}

void buildProgram(CLI::App& program) {
  program.name("torsio");
  program.set_version_flag("--version", "torsio " + softwareVersion());
  addAgreement(program);
  addAllocate(program);
  addAudit(program);
  addBench(program);
  addCompare(program);
  addCompareGroups(program);
  addCompetence(program);
  addConfig(program);
  addDb(program);
  addDemo(program);
  addDevice(program);
  addDoctor(program);
  addEvaluate(program);
  addExport(program);
  addDataset(program);
  addStudy(program);
  addInstrument(program);
  addInvite(program);
  addRoster(program);
  addLearning(program);
  addManual(program);
  addMetrics(program);
  addOrgan(program);
  addPower(program);
  addRecord(program);
  addReplay(program);
  addReport(program);
  addSection(program);
  addSettings(program);
#ifndef _WIN32
  addServe(program);
#endif
  addSetup(program);
  addStandardSetting(program);
  addStation(program);
  addSupport(program);
  if constexpr (kTrackerBuiltIn) {
    addTracker(program);
  }
  addTwist(program);
  if constexpr (kXapiBuiltIn) {
    addXapi(program);
  }
}

bool isCommand(const CLI::App& program, const std::string& word) {
  return !program
              .get_subcommands(
                  [&word](const CLI::App* command) { return !word.empty() && command->get_name() == word; })
              .empty();
}

/// One line on standard error for whatever is being thrown, and its exit code. Call inside a catch block.
int reportFailure() noexcept {
  if (logsToFile()) {  // the journal gets the line below
    writeLog(LogLevel::kError, causeForLog(std::current_exception()));
  }
  try {
    throw;
  } catch (const Error& error) {
    std::cerr << journalPriority(LogLevel::kError) << "torsio: " << oneLine(error.what()) << '\n';
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::cerr << journalPriority(LogLevel::kError) << "torsio: internal error: " << oneLine(error.what())
              << ". Please report this\n";
    return static_cast<int>(ErrorCode::kInternal);
  }
}

int parse(CLI::App& program, std::vector<std::string> words) {
  refuseNoValues(program);
  try {
    requireKnownCommands(program, words);
    std::reverse(words.begin(), words.end());  // as the parser wants them
    program.parse(std::move(words));
    return 0;
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    std::cerr << "torsio: " << oneLine(describedParseError(program, error)) << '\n';
    return static_cast<int>(ErrorCode::kUsage);
  } catch (...) {
    return reportFailure();
  }
}

/// These help to find a fault in the configuration of the computer, so they do without it.
constexpr std::array kWithoutConfiguration{"config", "doctor",    "help",   "--help",
                                           "-h",     "--version", "manual", "support"};

void configure(const std::string& firstWord) {
  try {
    loadConfiguration();
    openLog(LogWriter::kPerson);
  } catch (const Error&) {
    if (std::find(kWithoutConfiguration.begin(), kWithoutConfiguration.end(), firstWord) ==
        kWithoutConfiguration.end()) {
      throw;
    }
  }
}

constexpr const char* kPurpose = "Training and assessment of surgical twist skills";

}  // namespace

int runCommandLine(int argc, char** argv, std::initializer_list<ProgramAddition> windows) {
  const PlainOutput out(std::cout, false);
  const PlainOutput errors(std::cerr, true);
  try {
    configure(argc > 1 ? argv[1] : "");
    CLI::App program(kPurpose);
    buildProgram(program);
    // Settings and data of an account are the same for commands and windows.
    QCoreApplication::setApplicationName(QStringLiteral("torsio"));
    QCoreApplication::setOrganizationName(QStringLiteral("torsio"));
    // Qt draws reports without a display; the database drivers are Qt plug-ins.
    const auto application =
        argc > 1 && isCommand(program, argv[1]) && QCoreApplication::instance() == nullptr
            ? makeHeadlessGraphicsApplication(argc, argv)
            : nullptr;
    for (const ProgramAddition add : windows) {
      add(program);
    }
    program.footer(
        "Without a command Torsio opens its window. Exit codes: docs/cli.md.");  // now: else of all commands
    return parse(program, withHelpAsOption({argv + std::min(argc, 1), argv + argc}));
  } catch (...) {
    return reportFailure();
  }
}

}  // namespace torsio::cli
