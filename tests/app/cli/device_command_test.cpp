// SPDX-License-Identifier: GPL-3.0-or-later
// `torsio device` through the real program: without a vendor library, with the fake one, and with the fake
// one unplugged. The fake is controlled by the environment (tests/support/fakehd/fakehd.h) and its servo runs
// in real time, like the program's; no test depends on its regularity.
#include <algorithm>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class DeviceCommand : public ::testing::Test {
 protected:
  fs::path folder_ = emptyFolder("device");

  /// `story`: FAKEHD_... assignments, separated by blanks.
  ProgramRun run(const std::string& arguments, const std::string& story = "") const {
    for (const char* name :
         {"FAKEHD_NO_DEVICE", "FAKEHD_NO_LICENCE", "FAKEHD_CALIBRATION", "FAKEHD_DOCK_AT_TICK",
          "FAKEHD_UNPLUG_AT_TICK", "FAKEHD_POSE", "FAKEHD_LOG", "FAKEHD_TICK_US", "FAKEHD_LIE",
          "FAKEHD_BUTTONS", "FAKEHD_PRESS_TICKS", "FAKEHD_DIE_AT_TICK"}) {
      unsetenv(name);
    }
    for (std::size_t begin = 0; begin < story.size();) {
      const std::size_t end = std::min(story.find(' ', begin), story.size());
      const std::string word = story.substr(begin, end - begin);
      const std::size_t equals = word.find('=');
      setenv(word.substr(0, equals).c_str(), word.substr(equals + 1).c_str(), 1);
      begin = end + 1;
    }
    return runTorsio("device " + arguments, folder_);
  }
  ProgramRun check(const std::string& story, const std::string& more = "--seconds 0.4") const {
    return run("check --library " TORSIO_FAKEHD " " + more, story);
  }
};

void expectMentions(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

constexpr int kDevice = static_cast<int>(ErrorCode::kDevice);

TEST_F(DeviceCommand, TheStationIsShownAndGetsAnotherNameOnRequest) {
  const std::string settings = "XDG_CONFIG_HOME=" + (folder_ / "station settings").string();
  const auto station = [&](const std::string& word) {
    const ProgramRun result = runTorsio("station " + word + " --json", folder_, "'" + settings + "'");
    EXPECT_EQ(result.code, 0) << result.err;
    return nlohmann::json::parse(result.out);
  };
  EXPECT_FALSE(station("show").at("own_name"));
  EXPECT_EQ(station("show").at("name"), station("show").at("computer"));

  const std::string name = station("renew").at("name");

  EXPECT_TRUE(station("show").at("own_name"));
  EXPECT_EQ(station("show").at("name"), name);
  EXPECT_NE(station("renew").at("name"), name);
}

TEST_F(DeviceCommand, L1_CheckSaysWhatToInstallWithoutAVendorLibrary) {
  const ProgramRun result = run("check --library /nowhere/libHD.so");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"problem", "Library: the vendor's library is not installed",
                              "/nowhere/libHD.so", "Install the device's driver"});
  expectMentions(result.err, {"torsio: Library: ", "not installed"});
}

/// Ctrl+Z: a program that sleeps would leave the last force on the device.
TEST_F(DeviceCommand, AHaltedCheckEndsWithTheOutputOff) {
  const std::string log = (folder_ / "log").string();
  const std::string script = "export FAKEHD_LOG=" + log +
                             "\n" TORSIO_PROGRAM " device check --seconds 60 --library " TORSIO_FAKEHD
                             " >/dev/null 2>&1 & p=$!\n"
                             "until grep -qs hdStartScheduler " +
                             log +
                             "; do sleep 0.1; done\n"
                             "kill -TSTP $p; (sleep 40; kill -KILL $p) >/dev/null 2>&1 & k=$!\n"
                             "wait $p; c=$?; kill $k; exit $c\n";
  writeFileAtomically(folder_ / "halt.sh", script);
  const ProgramRun halted = runProgram("sh", (folder_ / "halt.sh").string(), folder_);

  EXPECT_EQ(halted.code, kDevice) << "137: it had to be killed";
  const std::string calls = readFile(log);
  EXPECT_NE(calls.find("hdDisableDevice"), std::string::npos) << calls;
  EXPECT_LT(calls.find("hdStartScheduler"), calls.rfind("force output off")) << calls;
}

TEST_F(DeviceCommand, L1_ListNamesEveryDriverWithoutAVendorLibrary) {
  const ProgramRun result = run("list --library /nowhere/libHD.so");

  EXPECT_EQ(result.code, 0) << result.err;
  expectMentions(result.out, {"hdapi", "not available", "What to do:", "pointer", "Mouse and keyboard",
                              "scripted", "replay", "idle"});
}

TEST_F(DeviceCommand, ListShowsTheDriverAsAvailableWithTheLibrary) {
  const ProgramRun result = run("list --json --library " TORSIO_FAKEHD);

  ASSERT_EQ(result.code, 0) << result.err;
  const auto drivers = nlohmann::json::parse(result.out);
  ASSERT_GE(drivers.size(), 5U);
  EXPECT_EQ(drivers[0]["id"], "hdapi");
  EXPECT_TRUE(drivers[0]["available"]);
}

TEST_F(DeviceCommand, ListNamesUnconfirmedDevicesWithoutForce) {
  const ProgramRun result = run("list --json --library /nowhere/libHD.so");

  ASSERT_EQ(result.code, 0) << result.err;
  const auto drivers = nlohmann::json::parse(result.out);
  for (const char* const id : {"controller", "spacemouse"}) {
    const auto found =
        std::find_if(drivers.begin(), drivers.end(), [&](const auto& driver) { return driver["id"] == id; });
    ASSERT_NE(found, drivers.end()) << id;
    EXPECT_FALSE((*found)["renders_force"]) << id;
    EXPECT_EQ((*found)["use"], "station") << id;
    EXPECT_NE((*found)["needs"].get<std::string>().find("not confirmed on hardware"), std::string::npos);
  }
}

TEST_F(DeviceCommand, TheChosenDeviceIsRememberedUntilAnotherIsChosen) {
  setenv("XDG_CONFIG_HOME", (folder_ / "settings").c_str(), 1);

  const ProgramRun chosen = run("choose spacemouse");
  const ProgramRun list = run("list --library /nowhere/libHD.so");
  const ProgramRun forgotten = run("choose");
  const ProgramRun listAgain = run("list --library /nowhere/libHD.so");
  const ProgramRun refused = run("choose scripted");
  unsetenv("XDG_CONFIG_HOME");

  EXPECT_EQ(chosen.code, 0) << chosen.err;
  expectMentions(chosen.out, {"works with: SpaceMouse"});
  expectMentions(list.out, {"(chosen for this station)"});
  EXPECT_EQ(forgotten.code, 0) << forgotten.err;
  EXPECT_EQ(listAgain.out.find("chosen for this station"), std::string::npos);
  EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kBadParameter));
}

TEST_F(DeviceCommand, AMissingDeviceIsReportedByName) {
  const ProgramRun checked = run("check --device spacemouse", "SPNAV_SOCKET=/nowhere/spnav.sock");
  const ProgramRun watched = run("monitor --device spacemouse", "SPNAV_SOCKET=/nowhere/spnav.sock");

  EXPECT_EQ(checked.code, kDevice);
  expectMentions(checked.out, {"Driver: the daemon spacenavd does not answer", "Install spacenavd"});
  EXPECT_EQ(watched.code, kDevice);
}

TEST_F(DeviceCommand, L2_CheckNamesAMissingDependency) {
  const ProgramRun result = run("check --library " TORSIO_FAKEHD_DEPENDENCY);

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"libncurses_of_another_year.so.5", "which is missing"});
}

TEST_F(DeviceCommand, L3_CheckNamesAMissingFunction) {
  const ProgramRun result = run("check --library " TORSIO_FAKEHD_INCOMPLETE);

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"lacks hdUnschedule", "OpenHaptics 3.0 to 3.5"});
}

TEST_F(DeviceCommand, CheckFindsACalibratedDeviceReady) {
  const ProgramRun result = check("");

  EXPECT_EQ(result.code, 0) << result.out << result.err;
  expectMentions(result.out,
                 {"Device: Touch, serial number 000123", "Licence:", "Calibration: the device is",
                  "Rate:", "Jitter:", "3.30 N", "no torque about the stylus", "ready for training"});
  EXPECT_EQ(result.out.find("Force:"), std::string::npos) << "no force without consent";
}

TEST_F(DeviceCommand, A1_CheckReportsThatNoDeviceAnswers) {
  const ProgramRun result = check("FAKEHD_NO_DEVICE=1");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"Device: no haptic device could be opened", "Check power and cable"});
}

TEST_F(DeviceCommand, A6_CheckReportsALicenceProblem) {
  const ProgramRun result = check("FAKEHD_NO_LICENCE=1");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"no valid licence", "OH_SDK_LICENSE_PATH"});
}

TEST_F(DeviceCommand, C2_CheckAsksForTheInkwellAndContinuesWithTheStylusDocked) {
  const ProgramRun result = check("FAKEHD_CALIBRATION=dock FAKEHD_DOCK_AT_TICK=600");

  EXPECT_EQ(result.code, 0) << result.out << result.err;
  expectMentions(result.err, {"Put the stylus into the inkwell"});
  expectMentions(result.out, {"Calibration: done in the inkwell"});
}

TEST_F(DeviceCommand, C2_CheckGivesUpIfNobodyDocksTheStylus) {
  const ProgramRun result = check("FAKEHD_CALIBRATION=dock", "--wait 0.3");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"Calibration: the device is not calibrated", "repeat the check"});
}

TEST_F(DeviceCommand, E2_CheckReportsAnUnpluggedDevice) {
  const ProgramRun result = check("FAKEHD_UNPLUG_AT_TICK=300", "--seconds 20");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"Connection: the connection to the device broke off", "Check cable and power",
                              "does not release"});
  expectMentions(result.err, {"torsio: Connection: "});
}

TEST_F(DeviceCommand, S4_CheckRejectsASlowServo) {
  const ProgramRun result = check("FAKEHD_TICK_US=2500");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"problem", "Rate:", "no force is rendered"});
}

TEST_F(DeviceCommand, CheckRejectsPositionsInAnotherUnitOrAlongOtherAxes) {
  for (const char* const lie : {"FAKEHD_LIE=inches", "FAKEHD_LIE=swapped"}) {
    const ProgramRun result = check(lie);

    EXPECT_EQ(result.code, kDevice) << lie << result.out;
    expectMentions(result.out, {"problem", "Geometry: position and joint angles differ by", "another unit"});
    EXPECT_EQ(result.out.find("ready for training"), std::string::npos);
  }
  EXPECT_EQ(check("FAKEHD_MODEL=Touch X").code, 0);
}

TEST_F(DeviceCommand, CheckSaysWhetherButtonsAreStuckAndAsksForThem) {
  const ProgramRun stuck = check("FAKEHD_BUTTONS=2");
  const ProgramRun loose = check("");
  const ProgramRun pressed = check("FAKEHD_BUTTONS=3 FAKEHD_PRESS_TICKS=100", "--seconds 0.4 --buttons");
  const ProgramRun silent =
      check("FAKEHD_BUTTONS=1 FAKEHD_PRESS_TICKS=100", "--seconds 0.4 --wait 2 --buttons");

  EXPECT_EQ(stuck.code, kDevice);
  expectMentions(stuck.out, {"Buttons: button 2 is pressed all the time", "Let go of the buttons"});
  EXPECT_EQ(loose.code, 0) << loose.out << loose.err;
  expectMentions(loose.out, {"Buttons: none is stuck; button 1, 2 was not pressed"});
  EXPECT_EQ(pressed.code, 0) << pressed.out << pressed.err;
  expectMentions(pressed.out, {"Buttons: both buttons answer"});
  expectMentions(pressed.err, {"Press each button of the stylus once"});
  EXPECT_EQ(silent.code, kDevice);
  expectMentions(silent.out, {"Buttons: button 2 did not answer"});
}

/// The library's servo dies while the whole program gets no time, as on a machine that others keep busy.
TEST_F(DeviceCommand, AStarvedComputerIsNoBrokenCable) {
  for (const char* const command : {"check --seconds 20", "monitor --seconds 20 --interval 0.05"}) {
    const fs::path log = folder_ / "calls";
    fs::remove(log);
    setenv("FAKEHD_LOG", log.c_str(), 1);
    setenv("FAKEHD_DIE_AT_TICK", "400", 1);
    const std::string out = (folder_ / "out").string();
    const std::string script = "touch " + log.string() + "; " TORSIO_PROGRAM " device " + command +
                               " --library " TORSIO_FAKEHD " >" + out + " 2>&1 & program=$!; " +
                               "until grep -q hdStartScheduler " + log.string() +
                               "; do sleep 0.02; done; sleep 0.15; kill -STOP $program; sleep 1.2; "
                               "kill -CONT $program; wait $program";
    const int status = std::system(script.c_str());
    unsetenv("FAKEHD_DIE_AT_TICK");
    unsetenv("FAKEHD_LOG");

    EXPECT_EQ(WEXITSTATUS(status), kDevice);
    const std::string said = readFile(out);
    expectMentions(said,
                   {"the computer was too busy: it gave Torsio no time for 1.", "Close other programs"});
    EXPECT_EQ(said.find("cable"), std::string::npos) << said;
  }
}

TEST_F(DeviceCommand, ForceTestWarnsAndPushesOnlyWithConsent) {
  const fs::path log = folder_ / "calls";
  const ProgramRun result =
      check("FAKEHD_POSE=centre FAKEHD_LOG=" + log.string(), "--seconds 0.2 --force-test");

  EXPECT_EQ(result.code, 0) << result.out << result.err;
  expectMentions(result.err, {"Warning: the device will push", "Hold the stylus"});
  expectMentions(result.out, {"Force: 0.50 N upwards were sent"});
  expectMentions(readFile(log), {"force output on\n", "\nforce\n", "zero force\n"});
}

TEST_F(DeviceCommand, MonitorShowsReadingsAndEndsInOrder) {
  const ProgramRun result = run("monitor --seconds 0.3 --interval 0.1 --library " TORSIO_FAKEHD);

  EXPECT_EQ(result.code, 0) << result.err;
  expectMentions(result.out, {"tip", "roll", "docked, ready, force off"});
}

TEST_F(DeviceCommand, CheckReportsWhatTheSystemGrantsTheServo) {
  const std::string check = "check --seconds 0.5 --wait 5 --json --library " TORSIO_FAKEHD;
  // Without the privilege, whoever runs the tests.
  const std::string without = std::string("setpriv --inh-caps=-all --bounding-set=-sys_nice,-ipc_lock ") +
                              "--no-new-privs sh -c 'ulimit -r 0 2>/dev/null; exec " TORSIO_PROGRAM
                              " device " +
                              check + "' > " + (folder_ / "out").string() + " 2>/dev/null";
  const ProgramRun usual = run(check);
  const bool dropped = geteuid() == 0 && std::system(without.c_str()) != -1;

  const auto sentenceOf = [](const nlohmann::json& result) {
    for (const nlohmann::json& finding : result["findings"]) {
      if (finding["subject"] == "Scheduling") {
        EXPECT_NE(finding["grade"], "problem");
        return finding["sentence"].get<std::string>();
      }
    }
    return std::string();
  };
  EXPECT_FALSE(sentenceOf(nlohmann::json::parse(usual.out)).empty());
  if (dropped) {
    const std::string refused = sentenceOf(nlohmann::json::parse(readFile(folder_ / "out")));
    EXPECT_NE(refused.find("the system refuses real-time priority"), std::string::npos) << refused;
  }
}

TEST_F(DeviceCommand, MonitorPrintsOneJsonDocumentHoweverItEnds) {
  const ProgramRun whole = run("monitor --seconds 0.3 --interval 0.05 --json --library " TORSIO_FAKEHD);
  const ProgramRun lost = run("monitor --seconds 30 --interval 0.05 --json --library " TORSIO_FAKEHD,
                              "FAKEHD_UNPLUG_AT_TICK=200");

  EXPECT_EQ(whole.code, 0) << whole.err;
  const nlohmann::json complete = nlohmann::json::parse(whole.out);
  EXPECT_EQ(complete["ended"], "complete");
  ASSERT_GE(complete["readings"].size(), 3U);
  EXPECT_EQ(complete["readings"].back()["state"], "ready, force off");
  EXPECT_EQ(lost.code, kDevice);
  const nlohmann::json ended = nlohmann::json::parse(lost.out);
  // The fake's servo runs in real time: on a busy machine it may be given up before it reports the loss.
  EXPECT_THAT(ended["ended"].get<std::string>(),
              testing::AnyOf("the connection to the device broke off", "the device does not answer"));
  EXPECT_EQ(ended["readings"].back()["state"], "connection lost");
}

TEST_F(DeviceCommand, ListSurvivesATruncatedLibrary) {
  const fs::path cut = folder_ / "libHD.so";
  std::ofstream(cut, std::ios::binary) << readFile(TORSIO_FAKEHD).substr(0, 3000);

  const ProgramRun listed = run("list --json --library " + cut.string());

  EXPECT_EQ(listed.code, 0) << listed.err;
  const nlohmann::json drivers = nlohmann::json::parse(listed.out);
  EXPECT_EQ(drivers[0]["id"], "hdapi");
  EXPECT_EQ(drivers[0]["available"], false);
  EXPECT_NE(drivers[0]["finding"].get<std::string>().find("truncated"), std::string::npos);
}

TEST_F(DeviceCommand, E2_MonitorEndsWithTheDeviceCodeWhenTheDeviceIsUnplugged) {
  const ProgramRun result =
      run("monitor --seconds 30 --interval 0.05 --library " TORSIO_FAKEHD, "FAKEHD_UNPLUG_AT_TICK=200");

  EXPECT_EQ(result.code, kDevice);
  expectMentions(result.out, {"connection lost"});
  expectMentions(result.err, {"the connection to the device broke off", "plug the device in again"});
}

TEST_F(DeviceCommand, F8_MonitorClosesTheDeviceInOrderOnTheTerminationSignal) {
  const fs::path log = folder_ / "calls";
  setenv("FAKEHD_LOG", log.c_str(), 1);
  const std::string script = "touch " + log.string() +
                             "; " TORSIO_PROGRAM
                             " device monitor --seconds 60 --interval 0.05 --library " TORSIO_FAKEHD
                             " >/dev/null & program=$!; "
                             "until grep -q hdStartScheduler " +
                             log.string() +
                             "; do sleep 0.02; done; "
                             "kill -TERM $program; wait $program";
  const int status = std::system(script.c_str());

  EXPECT_EQ(WEXITSTATUS(status), 0);
  const std::string calls = readFile(log);
  const std::size_t start = calls.find("hdStartScheduler");
  const std::size_t stop = calls.find("hdStopScheduler");
  const std::size_t unschedule = calls.find("hdUnschedule");
  const std::size_t disable = calls.find("hdDisableDevice");
  ASSERT_TRUE(start != std::string::npos && disable != std::string::npos) << calls;
  EXPECT_TRUE(start < stop && stop < unschedule && unschedule < disable) << calls;
}

TEST_F(DeviceCommand, RejectsTimesOutOfRange) {
  EXPECT_EQ(check("", "--seconds 0").code, static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(run("").code, static_cast<int>(ErrorCode::kUsage));
}

}  // namespace
}  // namespace torsio
