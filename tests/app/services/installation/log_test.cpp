// SPDX-License-Identifier: GPL-3.0-or-later
// The log: levels, a file that stays small, what a cause may say; and the report for support.
#include "app/services/base/log.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <QByteArray>
#include <QtGlobal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/configuration.h"
#include "app/services/installation/support_report.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class Log : public ::testing::Test {
 protected:
  Log() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Log() override {
    qputenv("TORSIO_CONFIG", "");
    loadConfiguration();
    fs::remove_all(folder_);
  }
  void configure(const std::string& text) const {
    writeFileAtomically(folder_ / "torsio.conf", "log.file = " + file().string() + "\n" + text);
    qputenv("TORSIO_CONFIG", QByteArray::fromStdString((folder_ / "torsio.conf").string()));
    loadConfiguration();
    openLog(LogWriter::kPerson);
  }
  [[nodiscard]] fs::path file() const { return folder_ / "torsio.log"; }
  [[nodiscard]] fs::path older(int age) const { return file().string() + "." + std::to_string(age); }
  const fs::path folder_ = fs::temp_directory_path() / ("torsio-log-" + std::to_string(getpid()));
};

TEST_F(Log, WritesWhatIsGraveEnoughWithTimeAndLevelOneLineEach) {
  configure("log.level = warning\n");

  writeLog(LogLevel::kInfo, "an answer");
  writeLog(LogLevel::kWarning, "the record\nis lost\x1b[2J");
  writeLog(LogLevel::kError, "no disk");

  const std::vector<std::string> lines = newestLogLines(10);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].find("Z warning: the record is lost"), std::string::npos) << lines[0];
  EXPECT_EQ(lines[0].find('\x1b'), std::string::npos) << "commands no terminal";
  EXPECT_TRUE(lines[1].ends_with("Z error: no disk")) << lines[1];
}

TEST_F(Log, AFullFileMakesRoomAndFiveAreKept) {
  configure("");
  for (char letter = 'a'; letter < 'h'; ++letter) {
    writeFileAtomically(file(), std::string(kLogFile_bytes, letter));
    writeLog(LogLevel::kError, "next");
  }
  EXPECT_LT(fs::file_size(file()), 100U);
  for (int age = 1; age < kLogFiles; ++age) {
    EXPECT_EQ(readFile(older(age))[0], 'a' + 7 - age);
  }
  EXPECT_FALSE(fs::exists(older(kLogFiles)));
  EXPECT_TRUE(newestLogLines(1)[0].ends_with("error: next"));
}

TEST_F(Log, ACauseSaysNothingThatVaries) {
  const auto cause = [](const auto& thrown) { return causeForLog(std::make_exception_ptr(thrown)); };
  const std::string name = "Ada Lovelace";
  EXPECT_EQ(cause(Error(ErrorCode::kBadData, Text::verbatim("%1 is known already", name), name, name)),
            "error of kind 8: %1 is known already");
  EXPECT_EQ(cause(Error(ErrorCode::kPermission, name, name, name)), "error of kind 11") << "may be a name";
  EXPECT_EQ(cause(std::runtime_error(name)).find(name), std::string::npos);
}

TEST_F(Log, ALogThatCannotBeWrittenStopsNobody) {
  fs::create_directories(file());
  configure("");
  EXPECT_NO_THROW(writeLog(LogLevel::kError, "nowhere"));
  EXPECT_TRUE(newestLogLines(5).empty());
}

TEST_F(Log, AReportForSupportHasTheNewestLinesAndNoAccount) {
  configure("record = postgresql://anna@db.example.org/torsio\nstation = OR-3\n");
  for (std::size_t i = 0; i < kSupportLogLines + 5; ++i) {
    writeLog(LogLevel::kInfo, "line " + std::to_string(i));
  }
  const fs::path report = folder_ / "support.json";

  writeSupportReport(report, {.locator = (folder_ / "none.sqlite").string(), .now_us = 1});

  const nlohmann::json read = nlohmann::json::parse(readFile(report));
  EXPECT_EQ(read.at("log").size(), kSupportLogLines);
  EXPECT_TRUE(read.at("log").back().get<std::string>().ends_with("line 504"));
  EXPECT_GT(read.at("checks").size(), 10U);
  EXPECT_EQ(read.at("configuration")[0].at("value"), "postgresql://db.example.org/torsio");
  EXPECT_EQ(read.dump().find("anna"), std::string::npos);
}

}  // namespace
}  // namespace torsio
