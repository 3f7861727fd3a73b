// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "tests/app/cli/program.h"

namespace torsio {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline constexpr int kHospitals = 3;

/// The hospitals are made once for all tests of this program, which only copy from them.
class CentresTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!sites_.empty()) {
      return;
    }
    sites_ = emptyFolder("hospitals");
    for (int seed = 1; seed <= kHospitals; ++seed) {
      const std::string number = std::to_string(seed);
      const ProgramRun made = runTorsio(
          "demo --out " + (sites_ / number).string() + " --seed " + number + " --shorten 600 --twists 0",
          sites_);
      ASSERT_EQ(made.code, 0) << made.err;
      const ProgramRun given =
          exportFrom(sites_ / number / "torsio.sqlite", sites_ / ("D" + number + ".torsio-site"));
      ASSERT_EQ(given.code, 0) << given.err;
    }
  }

  static ProgramRun exportFrom(const fs::path& record, const fs::path& out, const std::string& more = "") {
    return runTorsio("study export --database " + record.string() + " --out " + out.string() + " " + more,
                     sites_);
  }
  [[nodiscard]] static fs::path package(int seed) {
    return sites_ / ("D" + std::to_string(seed) + ".torsio-site");
  }
  [[nodiscard]] ProgramRun pool(const fs::path& file) const {
    return runTorsio("study pool " + file.string() + " --database " + pooled_.string() + " --json", folder_);
  }
  [[nodiscard]] std::string outcomeOf(const fs::path& file) const {
    const ProgramRun run = pool(file);
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out).at("outcome").get<std::string>();
  }
  void poolAll() const {
    for (int seed = 1; seed <= kHospitals; ++seed) {
      ASSERT_EQ(outcomeOf(package(seed)), "added");
    }
  }
  [[nodiscard]] ProgramRun verify() const {
    return runTorsio("audit verify --database " + pooled_.string(), folder_);
  }
  /// Returns a hospital of its own, to be changed.
  [[nodiscard]] fs::path copyOf(int seed) const {
    const fs::path copy = folder_ / "hospital";
    fs::create_directories(copy);
    for (const char* name : {"torsio.sqlite", "torsio.sqlite.site-key"}) {
      fs::copy_file(sites_ / std::to_string(seed) / name, copy / name, fs::copy_options::overwrite_existing);
    }
    return copy / "torsio.sqlite";
  }
  /// Returns the only number of a SELECT in the pooled record.
  [[nodiscard]] std::int64_t numberOf(const std::string& select) const {
    Connection record = openDatabase(pooled_.string(), OpenMode::kReadOnly);
    return selectFirst(record, select, {}, readInt64).value_or(-1);
  }
  /// Nothing was taken, in words of people.
  static void expectRefused(const ProgramRun& run, int code, const std::string& words) {
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("SQL"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("constraint"), std::string::npos) << run.err;
  }

  inline static fs::path sites_;
  fs::path folder_ = emptyFolder(::testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::path pooled_ = folder_ / "pooled.sqlite";
};

}  // namespace torsio
