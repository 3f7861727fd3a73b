// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/devices/device_check.h"
#include "app/services/devices/device_monitor.h"
#include "assessment/results/number_format.h"
#include "sim/core/error.h"
#include "sim/device/drivers/device_list.h"

namespace torsio::cli {

namespace {

// A signal handler can only reach globals.
volatile std::sig_atomic_t stopAsked = 0;

void askToStop(int) {
  stopAsked = 1;
}

/// An interrupted program would leave the last force on the device until the vendor's watchdog notices, and
/// some units unusable until replugged. A program that a terminal halts (Ctrl+Z) would keep it for as long as
/// it sleeps: it ends instead.
void closeInOrderOnSignals() {
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
#ifdef SIGTSTP
  for (const int signal : {SIGHUP, SIGTSTP, SIGTTIN, SIGTTOU}) {
    std::signal(signal, askToStop);
  }
#endif
}

struct DeviceArguments {
  DeviceChoice choice;
  bool json = false;
  bool forceTest = false;
  bool buttons = false;
  double checkSeconds = 2.0;
  double wait_s = 30.0;
  double monitorSeconds = 10.0;
  double interval_s = 0.25;
};

constexpr std::array kGrades{"good", "note", "problem"};

constexpr std::array kUses{"station", "pointer", "no hand"};

void runList(const DeviceArguments& arguments) {
  const DeviceRequest request = deviceRequest(arguments.choice);
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  const std::string remembered = rememberedDevice().driver;
  for (const DeviceDriver& driver : deviceDrivers()) {
    const DriverFinding found = driver.look(request);
    out.push_back({{"id", driver.id},
                   {"name", driver.name},
                   {"needs", driver.needs.str()},
                   {"use", wordOf(driver.use, kUses)},
                   {"renders_force", driver.rendersForce},
                   {"chosen", driver.id == remembered},
                   {"available", found.available},
                   {"finding", found.sentence.str()},
                   {"remedy", found.remedy.str()}});
    if (arguments.json) {
      continue;
    }
    std::cout << std::left << std::setw(10) << driver.id << " " << std::setw(22) << driver.name
              << (found.available ? " available      " : " not available  ") << found.sentence
              << (driver.id == remembered ? " (chosen for this station)" : "") << "\n";
    if (!found.remedy.empty()) {
      std::cout << std::string(11, ' ') << "What to do: " << found.remedy << "\n";
    }
  }
  if (arguments.json) {
    std::cout << jsonText(out) << '\n';
  }
}

void runChoose(const DeviceArguments& arguments) {
  rememberDevice(arguments.choice);
  std::cout << (arguments.choice.driver.empty()
                    ? "This station takes the first device that is there.\n"
                    : "This station works with: " + chosenDriver(arguments.choice).name + ".\n");
}

void printCheck(const DeviceCheckResult& result, bool json) {
  if (!json) {
    for (const DeviceFinding& finding : result.findings) {
      std::cout << std::left << std::setw(8) << wordOf(finding.grade, kGrades) << " " << finding.subject
                << ": " << finding.sentence << "\n";
      if (!finding.remedy.empty()) {
        std::cout << std::string(9, ' ') << "What to do: " << finding.remedy << "\n";
      }
    }
    if (result.usable()) {
      std::cout << "The device is ready for training.\n";
    }
    return;
  }
  nlohmann::ordered_json out;
  out["usable"] = result.usable();
  out["findings"] = nlohmann::ordered_json::array();
  for (const DeviceFinding& finding : result.findings) {
    out["findings"].push_back({{"subject", finding.subject},
                               {"grade", wordOf(finding.grade, kGrades)},
                               {"sentence", finding.sentence.str()},
                               {"remedy", finding.remedy.str()}});
  }
  out["model"] = result.capabilities.model;
  out["serial"] = result.identity.serial;
  out["max_force_n"] = result.capabilities.maxForce_N;
  out["continuous_force_n"] = result.capabilities.continuousForce_N;
  out["rate_hz"] = result.rate_Hz;
  out["regular_share"] = result.regularShare;
  out["interval_edges_us"] = kTimingEdges_us;
  out["intervals"] = result.timing.intervals;
  out["longest_interval_us"] = result.timing.longest_us;
  std::cout << jsonText(out) << '\n';
}

void runCheck(const DeviceArguments& arguments) {
  closeInOrderOnSignals();
  DeviceCheckRequest request;
  request.choice = arguments.choice;
  request.seconds = arguments.checkSeconds;
  request.calibrationWait_s = arguments.wait_s;
  request.forceTest = arguments.forceTest;
  request.buttons = arguments.buttons;
  request.say = [](const Text& text) { std::cerr << text << "." << std::endl; };
  request.cancelled = [] { return stopAsked != 0; };
  if (arguments.forceTest) {
    request.say(Text::verbatim(
        "Warning: the device will push against the hand. Keep face and objects out of its reach"));
  }
  const DeviceCheckResult result = checkDevice(request);
  printCheck(result, arguments.json);
  if (const DeviceFinding* const worst = result.worst()) {
    throw Error(ErrorCode::kDevice, worst->sentence, worst->subject, worst->remedy);
  }
}

std::string readoutLine(const DeviceReadout& r) {
  std::ostringstream line;
  line << std::right << std::setw(7) << formatFixed(r.time_s, 2) << " s  tip";
  for (const double x_mm : {r.tip_mm.x, r.tip_mm.y, r.tip_mm.z}) {
    line << " " << std::setw(7) << formatFixed(x_mm, 1);
  }
  line << " mm  roll " << std::setw(7) << formatFixed(r.roll_deg, 1) << " deg"
       << (r.rollAtStop ? " (stop)" : "") << "  buttons " << (r.firstButton ? "1" : "-")
       << (r.secondButton ? "2" : "-") << "  motors " << formatFixed(100.0 * r.warmest, 0) << " %  "
       << formatFixed(r.rate_Hz, 0) << " Hz  " << (r.docked ? "docked, " : "") << r.state;
  for (const std::string& event : r.events) {
    line << "; " << event;
  }
  return line.str();
}

nlohmann::ordered_json readoutJson(const DeviceReadout& r) {
  return {{"time_s", r.time_s},
          {"state", r.state},
          {"tip_mm", {r.tip_mm.x, r.tip_mm.y, r.tip_mm.z}},
          {"roll_deg", r.roll_deg},
          {"roll_at_stop", r.rollAtStop},
          {"grip", r.grip},
          {"button_1", r.firstButton},
          {"button_2", r.secondButton},
          {"docked", r.docked},
          {"warmest_motor", r.warmest},
          {"rate_hz", r.rate_Hz},
          {"late_ticks", r.lateTicks},
          {"events", r.events}};
}

/// Writes one JSON document incrementally, one reading per line: `readings`, then how it ended.
class ReadoutDocument {
 public:
  ReadoutDocument() { std::cout << "{\"readings\": ["; }
  ReadoutDocument(const ReadoutDocument&) = delete;
  ReadoutDocument& operator=(const ReadoutDocument&) = delete;
  ~ReadoutDocument() {
    std::cout << "\n], \"ended\": " << jsonText(nlohmann::json(ended_), -1) << "}" << std::endl;
  }

  void add(const DeviceReadout& readout) {
    std::cout << (any_ ? ",\n" : "\n") << jsonText(readoutJson(readout), -1) << std::flush;
    any_ = true;
  }
  void end(const std::string& how) { ended_ = how; }

 private:
  bool any_ = false;
  std::string ended_;
};

void runMonitor(const DeviceArguments& arguments) {
  closeInOrderOnSignals();
  DeviceMonitorRequest request;
  request.choice = arguments.choice;
  request.seconds = arguments.monitorSeconds;
  request.interval_s = arguments.interval_s;
  request.cancelled = [] { return stopAsked != 0; };
  if (!arguments.json) {
    request.show = [](const DeviceReadout& r) { std::cout << readoutLine(r) << std::endl; };
    monitorDevice(request);
    return;
  }
  ReadoutDocument document;
  request.show = [&document](const DeviceReadout& r) { document.add(r); };
  try {
    monitorDevice(request);
    document.end(stopAsked != 0 ? "stopped" : "complete");
  } catch (const Error& error) {
    document.end(error.happened());
    throw;
  }
}

}  // namespace

void addDevice(CLI::App& program) {
  auto arguments = std::make_shared<DeviceArguments>();
  CLI::App* command = program.add_subcommand("device", "Haptic devices: list, choose, test and monitor them");
  command->require_subcommand(1);
  const auto addChoice = [arguments](CLI::App* sub) {
    sub->add_option("--library", arguments->choice.library, "The vendor's library, path or name");
  };
  const auto addName = [arguments](CLI::App* sub) {
    sub->add_option(
        "--device", arguments->choice.driver,
        "Driver, as listed by `torsio device list`; default: the chosen or first available device");
    sub->add_option("--name", arguments->choice.name, "Name of one of several devices of a driver");
  };

  CLI::App* list = command->add_subcommand("list", "All drivers and whether they can be used now");
  addChoice(list);
  list->add_flag("--json", arguments->json, "Print JSON");
  list->callback([arguments] { runList(*arguments); });

  CLI::App* choose = command->add_subcommand("choose", "Remembers which device this station works with");
  choose->add_option("device", arguments->choice.driver, "Driver; default: the first available device");
  choose->add_option("--name", arguments->choice.name, "Name of one of several devices of a driver");
  choose->callback([arguments] { runChoose(*arguments); });

  CLI::App* check =
      command->add_subcommand("check", "Tests the haptic device; exit code 12 if it is not ready");
  addChoice(check);
  addName(check);
  addDefaulted(*check, "--seconds", arguments->checkSeconds, "Length of the measurement");
  addDefaulted(*check, "--wait", arguments->wait_s, "Seconds to wait for the stylus in the inkwell");
  check->add_flag("--buttons", arguments->buttons, "I hold the stylus: ask for each button");
  check->add_flag("--force-test", arguments->forceTest, "I hold the stylus: push upwards with 0.5 N for 2 s");
  check->add_flag("--json", arguments->json, "Print JSON");
  check->callback([arguments] { runCheck(*arguments); });

  CLI::App* monitor = command->add_subcommand("monitor", "Shows the haptic device's readings; no force");
  addChoice(monitor);
  addName(monitor);
  addDefaulted(*monitor, "--seconds", arguments->monitorSeconds, "How long");
  addDefaulted(*monitor, "--interval", arguments->interval_s, "Seconds between two lines");
  monitor->add_flag("--json", arguments->json, "Print JSON");
  monitor->callback([arguments] { runMonitor(*arguments); });
}

}  // namespace torsio::cli
