// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in Parquet: files of three other programs (tests/data/parquet) and of our own writer give the
// same motion; what is not read is refused by name; damaged files are refused.
#include <array>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/foreign/foreign_import.h"
#include "app/connectors/foreign/foreign_motion.h"
#include "app/connectors/foreign/parquet_table.h"
#include "app/outputs/dataset/parquet_file.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/connectors/foreign/foreign_samples.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using ::testing::HasSubstr;
using testing::OwnFolder;

const fs::path kFiles = fs::path(TORSIO_TEST_DATA) / "parquet";

/// A study whose recordings are all this file.
fs::path studyOf(const fs::path& folder, const std::string& bytes,
                 const std::function<void(ordered_json&)>& change = {}) {
  const fs::path map = writeForeignStudy(folder, "parquet");
  ordered_json content = ordered_json::parse(readFile(map));
  for (const ordered_json& one : content["recordings"]) {
    writeFileAtomically(folder / one["file"].get<std::string>(), bytes);
  }
  if (change) {
    change(content);
  }
  writeFileAtomically(map, content.dump());
  return map;
}

std::vector<ForeignPose> parquetPoses(const fs::path& map) {
  const ForeignMap read = readForeignMap(map, ForeignLayout::kParquet);
  std::vector<ForeignPose> poses;
  readForeignMotion(read, ForeignLayout::kParquet, read.recordings.front(),
                    [&](const ForeignPose& pose, std::size_t) { poses.push_back(pose); });
  return poses;
}

void expectMotion(const std::vector<ForeignPose>& poses, const std::string& file) {
  ASSERT_EQ(poses.size(), kForeignLines) << file;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose expected = foreignPose(i);
    ASSERT_EQ(poses[i].time_us, static_cast<std::int64_t>(20'000 * i)) << file;
    ASSERT_NEAR(norm(poses[i].pose.position_m - expected.position_m), 0.0, 1e-12) << file << i;
    ASSERT_NEAR(poses[i].pose.orientation.z, expected.orientation.z, 1e-12) << file << i;
    ASSERT_NEAR(poses[i].grip, foreignJaw(i), 1e-7) << file << i;  // in one file of half the digits
  }
}

/// The columns t_ms, x, y, z, qw, qx, qy, qz, jaw.
std::vector<std::vector<std::optional<double>>> motionColumns() {
  std::vector<std::vector<std::optional<double>>> columns(9);
  for (std::size_t i = 0; i < kForeignLines; ++i) {
    const auto [place, turn] = foreignPose(i);
    const std::array<double, 9> row{500.0 + 20.0 * static_cast<double>(i),
                                    place.x,
                                    place.y,
                                    place.z,
                                    turn.w,
                                    turn.x,
                                    turn.y,
                                    turn.z,
                                    1.2 - 1.5 * foreignJaw(i)};
    for (std::size_t c = 0; c < row.size(); ++c) {
      columns[c].push_back(row[c]);
    }
  }
  return columns;
}

std::string ownFile(const fs::path& folder) {
  const auto columns = motionColumns();
  std::vector<ParquetColumn> all;
  std::size_t c = 0;
  for (const char* name : {"t_ms", "x", "y", "z", "qw", "qx", "qy", "qz", "jaw"}) {
    all.push_back({name, columns[c++]});
  }
  writeParquet(folder / "own.parquet", all);
  return readFile(folder / "own.parquet");
}

/// As LeRobot stores a motion: position and rotation in a list, the jaw in another.
std::string fileWithLists(const fs::path& folder) {
  const auto columns = motionColumns();
  ParquetLists<double> pose{7, {}};
  ParquetLists<float> action{1, {}};
  for (std::size_t i = 0; i < kForeignLines; ++i) {
    for (std::size_t c = 1; c < 8; ++c) {
      pose.values.push_back(columns[c][i].value());
    }
    action.values.push_back(static_cast<float>(columns[8][i].value()));
  }
  writeParquet(folder / "lists.parquet",
               {{"t_ms", columns[0]}, {"observation.state", std::move(pose)}, {"action", std::move(action)}});
  return readFile(folder / "lists.parquet");
}

void nameItems(ordered_json& map) {
  map["position"] = {"observation.state[0]", "observation.state[1]", "observation.state[2]"};
  map["rotation_columns"] = {"observation.state[3]", "observation.state[4]", "observation.state[5]",
                             "observation.state[6]"};
  map["grip"]["column"] = "action[0]";
}

TEST(ForeignParquet, ItemsOfListsAreReadByTheirPlace) {
  const OwnFolder own;
  expectMotion(parquetPoses(studyOf(own.path(), fileWithLists(own.path()), nameItems)), "lists");
}

TEST(ForeignParquet, AnEpisodeOfAFileIsARecording) {
  const OwnFolder own;
  auto columns = motionColumns();
  std::vector<std::int64_t> episode(kForeignLines, 4);
  for (std::vector<std::optional<double>>& column : columns) {
    const std::vector<std::optional<double>> other(column.rbegin(), column.rend());
    column.insert(column.begin(), other.begin(), other.end());
  }
  episode.insert(episode.begin(), kForeignLines, 3);
  std::vector<ParquetColumn> all{{"episode_index", episode}};
  std::size_t c = 0;
  for (const char* name : {"t_ms", "x", "y", "z", "qw", "qx", "qy", "qz", "jaw"}) {
    all.push_back({name, columns[c++]});
  }
  writeParquet(own.path() / "all.parquet", all);
  const std::string bytes = readFile(own.path() / "all.parquet");
  const auto choose = [](int number) {
    return [number](ordered_json& map) {
      map.erase("marks");
      map["recordings"][0]["episode"] = number;
    };
  };

  const ForeignMap map = readForeignMap(studyOf(own.path(), bytes, choose(4)), ForeignLayout::kParquet);
  EXPECT_THAT(map.recordings.front().name, ::testing::EndsWith("#4"));
  expectMotion(parquetPoses(studyOf(own.path(), bytes, choose(4))), "episode 4");
  EXPECT_THAT(testing::refusalText([&] { (void)parquetPoses(studyOf(own.path(), bytes, choose(5))); }),
              HasSubstr("the file has no episode 5"));
  EXPECT_THAT(testing::refusalText([&] {
                (void)readForeignMap(studyOf(own.path(), foreignCsv(), choose(4)), ForeignLayout::kCsv);
              }),
              HasSubstr("only a Parquet file may hold several recordings"));
}

TEST(ForeignParquet, ListsOfAnotherWriterAreRead) {
  const OwnFolder own;
  const fs::path file = kFiles / "arrow-gzip-2.parquet";
  ParquetTable table(file, "arrow", {"state[0]", "x", "state[1]"});
  std::vector<std::string> cells;
  std::size_t rows = 0;
  for (; table.next(cells); ++rows) {
    EXPECT_NEAR(std::stod(cells[0]), std::stod(cells[1]), 1e-5);  // of half the digits
    EXPECT_EQ(cells[2], "1");
  }
  EXPECT_EQ(rows, kForeignLines);
}

TEST(ForeignParquet, IsTheSameFromEachWriter) {
  for (const char* file :
       {"arrow-gzip-2.parquet", "arrow-zstd.parquet", "duckdb.parquet", "hyparquet.parquet"}) {
    const OwnFolder own;
    expectMotion(parquetPoses(studyOf(own.path(), readFile(kFiles / file))), file);
  }
  const OwnFolder own;
  expectMotion(parquetPoses(studyOf(own.path(), ownFile(own.path()))), "own");
}

TEST(ForeignParquet, ARowWithoutAPoseIsAGapIfTheMapAllowsIt) {
  const OwnFolder own;
  const std::string bytes = readFile(kFiles / "arrow-gaps.parquet");
  EXPECT_THAT(testing::refusal([&] { (void)parquetPoses(studyOf(own.path(), bytes)); }).where(),
              HasSubstr("S_B1.txt, line 1"));
  const auto poses =
      parquetPoses(studyOf(own.path(), bytes, [](ordered_json& map) { map["gaps"] = "leave out"; }));
  ASSERT_EQ(poses.size(), kForeignLines - 2);
  EXPECT_NEAR(norm(poses[97].pose.position_m - foreignPose(99).position_m), 0.0, 1e-12);
}

TEST(ForeignParquet, IsStoredWithMarksOfAParquetTable) {
  StudyCentre centre;
  const OwnFolder own;
  writeFileAtomically(own.path() / "marks.parquet", readFile(kFiles / "marks.parquet"));
  const fs::path map = studyOf(own.path(), readFile(kFiles / "duckdb.parquet"), [](ordered_json& content) {
    content["raters"] = {{{"name", "GRS 1"}, {"class", "chief"}}, {{"name", "GRS 2"}, {"class", "chief"}}};
    content["marks"] = {{"table", "marks.parquet"}, {"lowest", 6}, {"highest", 30}, {"steps_per_point", 1}};
  });
  const ForeignOutcome done = importForeign(centre.as("administrator"), ForeignLayout::kParquet, map, "");
  EXPECT_EQ(done.trials, 4U);
  EXPECT_EQ(done.samples, 4 * static_cast<std::int64_t>(kForeignLines));
  EXPECT_EQ(done.marks, 3U);
}

TEST(ForeignParquet, RefusesWhatItDoesNotReadByName) {
  struct Case {
    const char* said;
    std::string bytes;
    std::function<void(ordered_json&)> change{};
  };
  const std::string good = readFile(kFiles / "duckdb.parquet");
  const std::string newer = readFile(kFiles / "arrow-gzip-2.parquet");
  const std::vector<Case> cases{
      {"encoded as DELTA_BINARY_PACKED, which is not read", readFile(kFiles / "duckdb-delta.parquet")},
      {"packed with Brotli, which is not read", readFile(kFiles / "arrow-brotli.parquet"),
       [](ordered_json& map) {
         map.erase("time");
         map.erase("rotation_columns");
         map.erase("grip");
         map["rotation"] = "none";
         map["rate_Hz"] = 50;
         map["position"] = {"x", "x", "x"};
       }},
      {"each row of the column has a list", newer, [](ordered_json& map) { map["position"][0] = "state"; }},
      {"so there is no [99]", newer, [](ordered_json& map) { map["position"][0] = "state[99]"; }},
      {"exactly one column 'x[0]'", newer, [](ordered_json& map) { map["position"][0] = "x[0]"; }},
      {"is not a number", newer, [](ordered_json& map) { map["position"][0] = "note"; }},
      {"exactly one column 'px'", good, [](ordered_json& map) { map["position"][0] = "px"; }},
      {"its times are in ms, and the map says s", newer,
       [](ordered_json& map) { map["time"]["unit"] = "s"; }},
      {"not a complete Parquet file", foreignCsv()},
      {"not a complete Parquet file", good.substr(0, good.size() - 1)},
      {"not a complete Parquet file", ""},
      {"encrypted", good.substr(0, good.size() - 4) + "PARE"},
      {"damaged or incomplete", good.substr(0, 2000) + good.substr(good.size() - 8)},
  };
  for (const Case& one : cases) {
    const OwnFolder own;
    EXPECT_THAT(testing::refusalText([&] { (void)parquetPoses(studyOf(own.path(), one.bytes, one.change)); },
                                     ErrorCode::kBadData),
                HasSubstr(one.said));
  }
  const OwnFolder own;
  const ForeignMap csv = readForeignMap(studyOf(own.path(), good), ForeignLayout::kCsv);
  EXPECT_THAT(testing::refusalText([&] {
                (void)readForeignMotion(csv, ForeignLayout::kCsv, csv.recordings.front(),
                                        [](const auto&, auto) {});
              }),
              HasSubstr("this is a Parquet file"));
}

/// Every byte of a small file is changed: an error, or rows; never more memory or a crash. Returns the number
/// of errors.
std::size_t refusedBytes(const std::string& good, const std::vector<std::string>& columns) {
  const OwnFolder own;
  const fs::path file = own.path() / "damaged.parquet";
  std::size_t refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = '\xFF';
    std::ofstream(file, std::ios::binary) << bad;
    try {
      ParquetTable table(file, "damaged.parquet", columns);
      std::vector<std::string> cells;
      for (int rows = 0; rows < 1000 && table.next(cells); ++rows) {
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadData);
      ++refused;
    }
  }
  return refused;
}

TEST(ForeignParquet, SurvivesEachDamagedByte) {
  const std::string marks = readFile(kFiles / "marks.parquet");
  EXPECT_GT(refusedBytes(marks, {"recording", "rater", "score"}), marks.size() / 4);
  const OwnFolder own;
  writeParquet(own.path() / "lists.parquet",
               {{"time", std::vector<float>{0.0F, 1.0F, 2.0F}},
                {"state", ParquetLists<double>{.length = 2, .values = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}}}});
  const std::string lists = readFile(own.path() / "lists.parquet");
  EXPECT_GT(refusedBytes(lists, {"time", "state[0]", "state[1]"}), lists.size() / 4);
}

}  // namespace
}  // namespace torsio
