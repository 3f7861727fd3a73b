// SPDX-License-Identifier: GPL-3.0-or-later
// Data sets: all numbers of a recording, a descriptor that matches its files, no partial files. Nobody can
// be identified in pseudonymised data.

#include "app/outputs/dataset/dataset.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/outputs/dataset/trajectory.h"
#include "app/outputs/tables/export_set.h"
#include "app/outputs/tables/pseudonyms.h"
#include "app/outputs/tables/table_files.h"
#include "app/services/base/csv_table.h"
#include "assessment/results/analysed_cohort.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/time_units.h"
#include "sim/record/sample_codec.h"
#include "tests/app/outputs/dataset/foreign_readers.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using testing::OwnFolder;

std::vector<Sample> movedSamples() {
  std::vector<Sample> samples(2'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample& sample = samples[i];
    const double t = static_cast<double>(i) / 1'000.0;
    DeviceReading reading;
    reading.time_us = static_cast<std::int64_t>(i) * 1'000;
    reading.pose.position_m = {0.1 * t, -0.02, 1.0 / 3.0};
    reading.pose.orientation = {0.6, 0.0, 0.8, 0.0};
    reading.roll_rad = 7.0 * t;
    reading.grip = 0.25;
    sample.tick = static_cast<std::int64_t>(i);
    sample.device = quantize(reading, {});
    sample.phase = i < 1'000 ? ExercisePhase::kContact : ExercisePhase::kTwisting;
    sample.contact = kContactJaw | kContactHeld;
    sample.response.angle_rad = radians(10.0 * t);
    sample.response.torque_Nm = 0.1 * t;
    sample.response.force_N = {-0.1, 0.2, 1e-9};
    sample.force_N = {-0.05, 0.1, 0.0};
  }
  return samples;
}

Trial movedTrial() {
  Trial trial;
  trial.header.sceneId = SceneId("stomach");
  trial.header.patternId = PatternId("organo-axial");
  trial.header.parameterHash = "ab12";
  trial.header.parametersJson = "{\"shear_modulus_Pa\": 3000}";
  trial.header.traineeCode = "T-01";
  trial.header.targetAngle_rad = radians(60.0);
  const std::vector<Sample> samples = movedSamples();
  trial.chunks.push_back(encodeChunk(0, std::span(samples).first(1'000)));
  trial.chunks.push_back(encodeChunk(1, std::span(samples).subspan(1'000)));
  return trial;
}

DatasetContents wholeContents(const ExportSet& set) {
  DatasetContents contents;
  contents.about = {.title = "Twists of \"thirty\"",
                    .description = "Simulated.",
                    .licence = "CC-BY-4.0",
                    .citation = "Li, 2026",
                    .creator = "Skills laboratory",
                    .madeUtc_us = 1'767'600'000'000'000};
  contents.tables = tablesOf(set);
  contents.recordings.push_back({"T-0001", "P-aa", [] { return movedTrial(); }});
  contents.recordings.push_back({"T-0002", "P-bb", [] { return movedTrial(); }});
  contents.curriculumJson = "{}";
  contents.softwareVersion = "0.1";
  return contents;
}

TEST(Trajectory, ContainsEveryNumberOfEveryTenthSample) {
  const OwnFolder folder;
  const fs::path file = folder.path() / "a.csv";
  std::ostringstream out;
  EXPECT_EQ(writeTrajectory(movedTrial(), 10, TrajectoryForm::kCsv, out), 200);
  writeFileAtomically(file, out.str());

  const CsvTable table = CsvTable::read(file, {"time_s",
                                               "tool_x_m",
                                               "tool_y_m",
                                               "tool_z_m",
                                               "tool_qw",
                                               "tool_qx",
                                               "tool_qy",
                                               "tool_qz",
                                               "roll_rad",
                                               "grip",
                                               "twist_deg",
                                               "torque_Nm",
                                               "tissue_force_x_N",
                                               "tissue_force_y_N",
                                               "tissue_force_z_N",
                                               "device_force_x_N",
                                               "device_force_y_N",
                                               "device_force_z_N",
                                               "stage",
                                               "contact",
                                               "device_status"});
  ASSERT_EQ(table.rows(), 200U);
  const std::vector<Sample> samples = movedSamples();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Sample stored = inStoredSteps(samples[10 * row]);
    const ToolState tool = toolState(stored.device);
    EXPECT_EQ(table.number(row, "time_s"), static_cast<double>(10 * row) / 1'000.0);
    EXPECT_EQ(table.number(row, "tool_x_m"), tool.pose.position_m.x);
    EXPECT_EQ(table.number(row, "tool_z_m"), tool.pose.position_m.z);
    EXPECT_EQ(table.number(row, "tool_qw"), tool.pose.orientation.w);
    EXPECT_EQ(table.number(row, "tool_qy"), tool.pose.orientation.y);
    EXPECT_EQ(table.number(row, "roll_rad"), tool.roll_rad);
    EXPECT_EQ(table.number(row, "grip"), 0.25);
    EXPECT_EQ(table.number(row, "twist_deg"), degrees(stored.response.angle_rad));
    EXPECT_EQ(table.number(row, "torque_Nm"), stored.response.torque_Nm);
    EXPECT_EQ(table.number(row, "tissue_force_x_N"), stored.response.force_N.x);
    EXPECT_EQ(table.number(row, "device_force_y_N"), stored.force_N.y);
    EXPECT_EQ(table.number(row, "stage"), row < 100 ? 1.0 : 2.0);
    EXPECT_EQ(table.number(row, "contact"), 5.0);
  }
}

TEST(Dataset, DescribesEachOfItsFiles) {
  const OwnFolder own;
  const fs::path folder = own.path() / "set";
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  const std::vector<fs::path> files = writeDataset(wholeContents(set), DatasetLayout::kRoCrate, folder);

  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    found += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(found, files.size());
  const json package = json::parse(readFile(folder / "datapackage.json"));
  EXPECT_EQ(package["title"], "Twists of \"thirty\"");
  EXPECT_EQ(package["licenses"][0]["name"], "CC-BY-4.0");
  EXPECT_EQ(package["created"], "2026-01-05T08:00:00.000000Z");
  ASSERT_EQ(package["resources"].size(), tablesOf(set).size() + 3);  // two trajectories and their headers
  for (const json& resource : package["resources"]) {
    const std::string text = readFile(folder / resource["path"].get<std::string>());
    std::string heading;
    for (const json& field : resource["schema"]["fields"]) {
      heading += (heading.empty() ? "" : ",") + field["name"].get<std::string>();
    }
    EXPECT_EQ(text.substr(0, text.find("\r\n")), heading) << resource["name"];
  }
  const json crate = json::parse(readFile(folder / "ro-crate-metadata.json"))["@graph"];
  EXPECT_EQ(crate[0]["conformsTo"]["@id"], "https://w3id.org/ro/crate/1.1");
  std::vector<std::string> listed;
  for (const json& entity : crate) {
    if (entity["@type"] == "File") {
      listed.push_back(entity["@id"]);
      EXPECT_EQ(entity["contentSize"], std::to_string(fs::file_size(folder / listed.back())));
    }
  }
  EXPECT_EQ(listed.size(), files.size() - 1);  // all except the descriptor itself
  const CsvTable heads =
      CsvTable::read(folder / "data" / "recordings.csv",
                     {"trial", "participant", "organ", "pattern", "target_deg", "organ_hash", "parameters",
                      "device", "largest_device_force_N", "software", "rate_Hz", "lines", "trajectory"});
  ASSERT_EQ(heads.rows(), 2U);
  EXPECT_EQ(heads.cell(1, "participant"), "P-bb");
  EXPECT_EQ(heads.number(1, "rate_Hz"), 100.0);
  EXPECT_EQ(heads.number(1, "lines"), 200.0);
  EXPECT_EQ(readFile(folder / heads.cell(1, "parameters")), movedTrial().header.parametersJson);
  EXPECT_THAT(readFile(folder / "README.md"), HasSubstr("Please cite: Li, 2026"));
}

TEST(Dataset, OfBidsHasAColumnForEachChannelAndALabelForEachPerson) {
  const OwnFolder own;
  const fs::path folder = own.path() / "set";
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  DatasetContents contents = wholeContents(set);
  contents.recordings[1].trainee = "P-a.a";  // the same letters as the first
  contents.recordings.push_back({"T-0003", "P-aa", [] { return movedTrial(); }});
  contents.participants = {{"P-aa", "Group 1"}, {"P-zz", "Group 2"}};
  writeDataset(contents, DatasetLayout::kBids, folder);

  EXPECT_EQ(readFile(folder / "participants.tsv"),
            "participant_id\tcode\tgroup\nsub-Paan2\tP-a.a\tn/a\nsub-Paa\tP-aa\tGroup 1\n"
            "sub-Pzz\tP-zz\tGroup 2\n")
      << "with somebody who was never recorded";
  for (const char* name : {"sub-Paa/motion/sub-Paa_task-organoaxial_tracksys-torsio_run-01",
                           "sub-Paa/motion/sub-Paa_task-organoaxial_tracksys-torsio_run-02",
                           "sub-Paan2/motion/sub-Paan2_task-organoaxial_tracksys-torsio_run-01"}) {
    const std::string stem = (folder / name).string();
    const std::string lines = readFile(stem + "_motion.tsv");
    const std::string channels = readFile(stem + "_channels.tsv");
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 200) << name;
    EXPECT_EQ(
        std::count(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(lines.find('\n')), '\t') + 2,
        std::count(channels.begin(), channels.end(), '\n'))
        << name;
    const json motion = json::parse(readFile(stem + "_motion.json"));
    EXPECT_EQ(motion["SamplingFrequency"], 100.0);
    EXPECT_EQ(motion["POSChannelCount"], 3);
    EXPECT_EQ(motion["ORNTChannelCount"], 4);
    EXPECT_EQ(motion["MotionChannelCount"],
              motion["POSChannelCount"].get<int>() + motion["ORNTChannelCount"].get<int>() +
                  motion["LATENCYChannelCount"].get<int>() + motion["MISCChannelCount"].get<int>());
  }
  EXPECT_THAT(readFile(folder / "sub-Paa" / "sub-Paa_scans.tsv"),
              HasSubstr("run-02_motion.tsv\tstomach\torgano-axial\t"));
  EXPECT_EQ(readFile(folder / "derivatives" / "torsio" / "parameters" / "ab12.json"),
            movedTrial().header.parametersJson);
  EXPECT_TRUE(fs::exists(folder / "derivatives" / "torsio" / "datapackage.json"));
}

TEST(Dataset, LeavesNoPartialFilesAndMixesNothing) {
  const OwnFolder own;
  const fs::path folder = own.path() / "set";
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  DatasetContents contents = wholeContents(set);
  contents.recordings[1].load = []() -> Trial {
    throw Error(ErrorCode::kBadData, Text::tr("the recording is damaged"), std::string("T-0002"), Text());
  };
  EXPECT_THROW(writeDataset(contents, DatasetLayout::kFrictionless, folder), Error);
  EXPECT_FALSE(fs::exists(folder));

  contents = wholeContents(set);
  contents.progress = [](const Progress& progress) {
    if (progress.step.str() == "Writing recording 2 of 2") {
      throw Error(ErrorCode::kUsage, Text::verbatim("given up"), "", "");
    }
  };
  EXPECT_THROW(writeDataset(contents, DatasetLayout::kRoCrate, folder), Error);
  EXPECT_THROW(writeDataset(contents, DatasetLayout::kBids, folder), Error);
  EXPECT_FALSE(fs::exists(folder));

  contents = wholeContents(set);
  for (const char* licence : {"", "all rights", "CC BY"}) {
    contents.about.licence = licence;
    EXPECT_THROW(writeDataset(contents, DatasetLayout::kFrictionless, folder), Error) << licence;
  }
  EXPECT_FALSE(fs::exists(folder));

  contents = wholeContents(set);
  fs::create_directories(folder);
  writeFileAtomically(folder / "mine.txt", "mine");
  EXPECT_THROW(writeDataset(contents, DatasetLayout::kFrictionless, folder), Error);
  EXPECT_EQ(readFile(folder / "mine.txt"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

/// Returns whether node finds an npm package (NODE_PATH; set by judges_test.py).
bool hasModule(const std::string& name, const fs::path& folder) {
  const std::string asks = "node -e \"require.resolve('" + name + "/package.json')\"";
  return testing::hasProgram("node") && testing::outputOf(asks, folder).empty();
}

TEST(Dataset, IsAcceptedByTheValidatorOfBids) {
  const OwnFolder own;
  if (!hasModule("bids-validator", own.path())) {
    GTEST_SKIP() << "npm's bids-validator is not installed (NODE_PATH)";
  }
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  writeDataset(wholeContents(set), DatasetLayout::kBids, own.path() / "set");

  const json found = json::parse(
      testing::outputOf("NODE_NO_WARNINGS=1 node \"$NODE_PATH/bids-validator/bin/bids-validator\" --json '" +
                            (own.path() / "set").string() + "'",
                        own.path()));

  EXPECT_EQ(found["issues"]["errors"], json::array());
  for (const json& warning : found["issues"]["warnings"]) {
    // It treats the first line of a motion file as a header, which BIDS forbids there, and wants more
    // authors.
    EXPECT_THAT(warning["key"], ::testing::AnyOf("CUSTOM_COLUMN_WITHOUT_DESCRIPTION", "TOO_FEW_AUTHORS"));
  }
  EXPECT_EQ(found["summary"]["subjects"].size(), 2U) << found["summary"];
  EXPECT_EQ(found["summary"]["tasks"], json::array({"organoaxial"}));
}

TEST(Dataset, IsReadByTheReferenceLibraryOfFrictionless) {
  const OwnFolder own;
  if (!hasModule("datapackage", own.path())) {
    GTEST_SKIP() << "npm's datapackage is not installed (NODE_PATH)";
  }
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  writeDataset(wholeContents(set), DatasetLayout::kFrictionless, own.path() / "set");
  writeFileAtomically(own.path() / "read.js", R"(const {Package} = require('datapackage');
(async () => {
  const all = await Package.load('set/datapackage.json');
  if (!all.valid) console.log(all.errors.map(String).join('\n'));
  for (const one of all.resources) {
    try { await one.read({keyed: true}); } catch (error) { console.log(one.name, String(error), error.errors); }
  }
  console.log('read', all.resources.length);
})();
)");
  EXPECT_EQ(testing::outputOf("cd '" + own.path().string() + "' && node read.js", own.path()),
            "read " + std::to_string(tablesOf(set).size() + 3) + "\n");
}

/// A cell as the script below prints it.
json printedCell(const ExportCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return *text;
  }
  if (const auto* number = std::get_if<double>(&cell)) {
    return *number;
  }
  const auto* time_us = std::get_if<std::int64_t>(&cell);
  return time_us == nullptr ? json() : json(*time_us / 1000);  // a Date of JavaScript has milliseconds
}

TEST(Dataset, AsParquetIsReadByAnotherReader) {
  const OwnFolder own;
  const char* const modules =
      std::getenv("NODE_PATH");  // a module of ES that require.resolve() does not find
  if (modules == nullptr || !fs::exists(fs::path(modules) / "hyparquet" / "package.json")) {
    GTEST_SKIP() << "npm's hyparquet is not installed (NODE_PATH)";
  }
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  writeDataset(wholeContents(set), DatasetLayout::kParquet, own.path() / "set");
  writeDataset(wholeContents(set), DatasetLayout::kFrictionless, own.path() / "csv");
  writeFileAtomically(own.path() / "read.js", R"(const fs = require('fs');
const url = require('url').pathToFileURL(process.env.NODE_PATH + '/hyparquet/src/node.js');
(async () => {
  const {asyncBufferFromFile, parquetReadObjects} = await import(url);
  const package = JSON.parse(fs.readFileSync('set/datapackage.json'));
  const all = {};
  for (const one of package.resources) {
    const rows = await parquetReadObjects({file: await asyncBufferFromFile('set/' + one.path)});
    all[one.name] = rows.map((row) => one.schema.fields.map((field) => {
      const value = row[field.name];
      return value instanceof Date ? value.getTime() : value ?? null;
    }));
  }
  console.log(JSON.stringify(all));
})();
)");

  const json read =
      json::parse(testing::outputOf("cd '" + own.path().string() + "' && node read.js", own.path()));

  ASSERT_EQ(read.size(), tablesOf(set).size() + 3);
  for (const ExportTable* table : tablesOf(set)) {
    json expected = json::array();
    for (const std::vector<ExportCell>& row : table->rows) {
      expected.push_back(json::array());
      for (const ExportCell& cell : row) {
        expected.back().push_back(printedCell(cell));
      }
    }
    EXPECT_EQ(read[table->name], expected) << table->name;
  }
  const std::vector<CsvRecord> lines =
      csvRecords(readFile(own.path() / "csv" / "trajectories" / "T-0001.csv"), "csv");
  const json& moved = read["trajectory-t-0001"];
  ASSERT_EQ(moved.size(), lines.size() - 1);
  for (std::size_t r = 0; r < moved.size(); ++r) {
    for (std::size_t c = 0; c < moved[r].size(); ++c) {
      EXPECT_EQ(moved[r][c].get<double>(), std::stod(lines[r + 1].values[c])) << r << " " << c;
    }
  }
}

TEST(Dataset, AsLerobotIsReadByAnotherReaderAsItsDescriptionSays) {
  const OwnFolder own;
  const char* const modules = std::getenv("NODE_PATH");
  if (modules == nullptr || !fs::exists(fs::path(modules) / "hyparquet" / "package.json")) {
    GTEST_SKIP() << "npm's hyparquet is not installed (NODE_PATH)";
  }
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  DatasetContents contents = wholeContents(set);
  contents.recordings.push_back({"T-0003", "P-bb", [] {
                                   Trial other = movedTrial();
                                   other.header.sceneId = SceneId(std::string(kForeignScene));
                                   return other;
                                 }});
  writeDataset(contents, DatasetLayout::kLerobot, own.path() / "set");
  writeFileAtomically(own.path() / "read.js", R"(const fs = require('fs');
const url = require('url').pathToFileURL(process.env.NODE_PATH + '/hyparquet/src/node.js');
(async () => {
  const {asyncBufferFromFile, parquetReadObjects, parquetMetadataAsync} = await import(url);
  const all = {};
  const plain = (key, value) => (typeof value === 'bigint' ? Number(value) : value);
  for (const name of ['data/chunk-000/file-000', 'meta/episodes/chunk-000/file-000', 'meta/tasks']) {
    const file = await asyncBufferFromFile('set/' + name + '.parquet');
    all[name] = {rows: await parquetReadObjects({file}), about: await parquetMetadataAsync(file)};
  }
  console.log(JSON.stringify(all, plain));
})();
)");

  const json read =
      json::parse(testing::outputOf("cd '" + own.path().string() + "' && node read.js", own.path()));

  const json info = json::parse(readFile(own.path() / "set" / "meta" / "info.json"));
  EXPECT_EQ(info["codebase_version"], "v3.0");
  EXPECT_EQ(info["fps"], 100);
  EXPECT_EQ(info["total_episodes"], 2);
  EXPECT_EQ(info["total_frames"], 400);
  EXPECT_EQ(info["data_path"], "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet");
  const json& frames = read["data/chunk-000/file-000"]["rows"];
  ASSERT_EQ(frames.size(), 400U);
  EXPECT_EQ(read["data/chunk-000/file-000"]["about"]["row_groups"].size(), 2U) << "one per episode";
  const json names = info["features"]["observation.state"]["names"];
  const auto trajectory = trajectoryValues(movedTrial(), 10);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const json& frame = frames[f];
    ASSERT_EQ(frame.size(), info["features"].size());
    for (const auto& [name, feature] : info["features"].items()) {
      ASSERT_TRUE(frame.contains(name)) << name;
      ASSERT_EQ(frame[name].is_array() ? frame[name].size() : 1U, feature["shape"][0].get<std::size_t>())
          << name;
      ASSERT_EQ(feature["dtype"] == "int64", frame[name].is_number_integer() && name.ends_with("index"))
          << name;
    }
    const std::size_t row = f % 200;
    EXPECT_EQ(frame["index"], f);
    EXPECT_EQ(frame["frame_index"], row);
    EXPECT_EQ(frame["episode_index"], f / 200);
    EXPECT_EQ(frame["task_index"], 0);
    EXPECT_FLOAT_EQ(frame["timestamp"].get<float>(), static_cast<float>(row) / 100.0F);
    for (std::size_t c = 1; c < trajectory.size(); ++c) {
      ASSERT_EQ(names[c - 1], trajectoryColumns()[c].name);
      EXPECT_EQ(frame["observation.state"][c - 1].get<float>(), static_cast<float>(*trajectory[c][row]));
    }
    const json& next = frames[row == 199 ? f : f + 1];
    for (std::size_t c = 0; c < 9; ++c) {
      EXPECT_EQ(info["features"]["action"]["names"][c], names[c]);
      EXPECT_EQ(frame["action"][c], next["observation.state"][c]);
    }
  }
  const json& episodes = read["meta/episodes/chunk-000/file-000"]["rows"];
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_EQ(episodes[1]["trial"], "T-0002");
  EXPECT_EQ(episodes[1]["length"], 200);
  EXPECT_EQ(episodes[1]["dataset_from_index"], 200);
  EXPECT_EQ(episodes[1]["dataset_to_index"], 400);
  EXPECT_EQ(episodes[1]["tasks"], json::array({"stomach: organo-axial, target 60 degrees"}));
  EXPECT_EQ(episodes[1]["stats/timestamp/max"], json::array({static_cast<double>(1.99F)}));
  const json stats = json::parse(readFile(own.path() / "set" / "meta" / "stats.json"));
  EXPECT_EQ(stats["index"]["mean"], json::array({199.5}));
  EXPECT_NEAR(stats["index"]["std"][0].get<double>(), std::sqrt((400.0 * 400.0 - 1.0) / 12.0), 1e-9);
  EXPECT_EQ(stats["observation.state"]["q50"].size(), names.size());
  EXPECT_EQ(stats["action"]["count"], json::array({400}));
  const json& tasks = read["meta/tasks"];
  EXPECT_EQ(tasks["rows"],
            json::array({{{"task_index", 0}, {"task", "stomach: organo-axial, target 60 degrees"}}}));
  EXPECT_EQ(tasks["about"]["key_value_metadata"][0]["key"], "pandas");
  EXPECT_THAT(readFile(own.path() / "set" / "README.md"),
              HasSubstr("other equipment, which are not in it: 1."));
  EXPECT_TRUE(fs::exists(own.path() / "set" / "torsio" / "datapackage.json"));
}

TEST(Dataset, AsLerobotNeedsARecordingOfTheSimulator) {
  const OwnFolder own;
  const ExportSet set = exportSet(analysedCohort(testing::awkwardCohort()), {});
  DatasetContents contents = wholeContents(set);
  contents.recordings.clear();
  EXPECT_THROW(writeDataset(contents, DatasetLayout::kLerobot, own.path() / "set"), Error);
  EXPECT_FALSE(fs::exists(own.path() / "set"));
}

using testing::awkwardCohort;

const std::string kKey(64, 'k');

struct Hidden {
  CohortInputs before = awkwardCohort();
  std::map<TrialId, std::int64_t> startsBefore;
  std::map<TrialId, std::int64_t> starts;
  PseudonymReport report;
  CohortInputs after;

  explicit Hidden(const std::string& key = kKey, bool withFreeText = false) {
    before.trainees.front().level = "professor";
    std::int64_t start_us = 1'767'600'000'000'000;
    for (const TrialSummaryRow& trial : before.trials) {
      startsBefore[trial.trialId] = start_us;
      start_us += 3'600'000'000;
    }
    starts = startsBefore;
    after = pseudonymised(before, starts, Pseudonyms(key), withFreeText, report);
  }
};

TEST(Pseudonyms, AreTheSameForOneKeyAndDifferForAnother) {
  const Pseudonyms one(kKey);
  EXPECT_EQ(one.of("P", "T-01"), Pseudonyms(kKey).of("P", "T-01"));
  EXPECT_NE(one.of("P", "T-01"), one.of("P", "T-02"));
  EXPECT_NE(one.of("P", "T-01").substr(2), one.of("R", "T-01").substr(2));
  EXPECT_NE(one.of("P", "T-01"), Pseudonyms(Pseudonyms::freshKey()).of("P", "T-01"));
  EXPECT_NE(Pseudonyms::freshKey(), Pseudonyms::freshKey());
  EXPECT_THROW(Pseudonyms("short"), Error);
}

TEST(Pseudonyms, ShiftTimesByWholeDaysForEachPersonAndNeverByZero) {
  const Pseudonyms names(kKey);
  std::set<std::int64_t> shifts;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t shift_us = names.shift_us("T-" + std::to_string(i));
    EXPECT_NE(shift_us, 0);
    EXPECT_EQ(shift_us % kDay_us, 0);
    EXPECT_LE(std::abs(shift_us), 182 * kDay_us);
    shifts.insert(shift_us);
  }
  EXPECT_GT(shifts.size(), 300U);

  const Hidden hidden;
  std::map<std::string, std::set<std::int64_t>> moves;  // of each person's recordings
  for (const TrialSummaryRow& trial : hidden.before.trials) {
    const TrialId opaque(names.of("T", trial.trialId.text()));
    moves[trial.trainee].insert(hidden.starts.at(opaque) - hidden.startsBefore.at(trial.trialId));
  }
  for (const auto& [person, ofPerson] : moves) {
    EXPECT_EQ(ofPerson, std::set<std::int64_t>{names.shift_us(person)}) << person;  // intervals are preserved
  }
}

/// What somebody who knows the centre knows of a person, and what the data contain of one.
struct Trace {
  std::set<std::int64_t> days{};  ///< of recordings and deviations
  std::set<std::string> texts{};
  std::size_t recordings = 0;
  std::size_t marks = 0;
  std::size_t deviations = 0;

  [[nodiscard]] auto counts() const { return std::tuple(recordings, marks, deviations); }
};

std::map<std::string, Trace> tracesIn(const CohortInputs& in, const std::map<TrialId, std::int64_t>& starts) {
  std::map<std::string, Trace> traces;
  for (const CohortTrainee& trainee : in.trainees) {
    traces[trainee.code];
  }
  for (const TrialSummaryRow& trial : in.trials) {
    ++traces[trial.trainee].recordings;
    traces[trial.trainee].days.insert(starts.at(trial.trialId) / kDay_us);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    ++traces[mark.trainee].marks;
  }
  for (const CohortDeviation& one : in.deviations) {
    if (!one.trainee.empty()) {
      ++traces[one.trainee].deviations;
      traces[one.trainee].days.insert(one.happenedUtc_us / kDay_us);
      traces[one.trainee].texts.insert(one.description);
    }
  }
  return traces;
}

TEST(Pseudonyms, AnAttackByDatesCountsAndTextsIdentifiesNobody) {
  const Hidden hidden;
  const Pseudonyms names(kKey);
  const std::map<std::string, Trace> known = tracesIn(hidden.before, hidden.startsBefore);
  const std::map<std::string, Trace> found = tracesIn(hidden.after, hidden.starts);
  ASSERT_GT(known.at(hidden.before.deviations[0].trainee).deviations, 1U);  // nobody else has two
  for (const auto& [person, trace] : known) {
    std::size_t sameDays = 0;
    std::size_t sameCounts = 0;
    std::size_t sameTexts = 0;
    for (const auto& [opaque, other] : found) {
      sameDays += !trace.days.empty() && other.days == trace.days ? 1 : 0;
      sameCounts += other.counts() == trace.counts() ? 1 : 0;
      for (const std::string& text : trace.texts) {
        sameTexts += other.texts.contains(text) ? 1 : 0;
      }
    }
    EXPECT_EQ(sameDays, 0U) << person;
    EXPECT_EQ(sameTexts, 0U) << person;
    EXPECT_TRUE(sameCounts == 0 || sameCounts >= static_cast<std::size_t>(kSmallestCell))
        << person << " is one of " << sameCounts;
  }
  EXPECT_EQ(hidden.report.deviationsUnlinked, 3);
}

TEST(Pseudonyms, LeaveNoTraceOfTheCentreInAnyFile) {
  const Hidden hidden;
  const ExportSet set = exportSet(analysedCohort(hidden.after), hidden.starts);
  const OwnFolder folder;
  std::string all;
  for (const TableFormat format : {TableFormat::kCsv, TableFormat::kSpss}) {
    for (const std::filesystem::path& file : writeTables(tablesOf(set), format, folder.path() / "out")) {
      all += readFile(file);
    }
  }
  std::set<std::string> secrets;
  for (const CohortTrainee& trainee : hidden.before.trainees) {
    secrets.insert(trainee.code);
  }
  for (const TrainingMark& mark : hidden.before.trainingMarks) {
    secrets.insert(mark.rater);
  }
  for (const ModelRatings& model : hidden.before.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      secrets.insert(sheet.rater);
    }
  }
  for (const TrialSummaryRow& trial : hidden.before.trials) {
    secrets.insert(trial.trialId.text());
    if (!trial.contentHash.empty()) {
      secrets.insert(trial.contentHash);
    }
  }
  for (const CohortDeviation& deviation : hidden.before.deviations) {
    secrets.insert(deviation.description);
  }
  for (const CohortGroup& group : hidden.before.groups) {
    secrets.insert(group.protocol.str());
  }
  secrets.insert("2026-01-05");
  secrets.insert("2026-01-06");
  ASSERT_GT(secrets.size(), 60U);
  for (const std::string& secret : secrets) {
    EXPECT_EQ(all.find(secret), std::string::npos) << secret;
  }
}

TEST(Pseudonyms, PreserveEveryNumberAndEveryCount) {
  const Hidden hidden;
  const ExportSet before = exportSet(analysedCohort(hidden.before), {});
  const ExportSet after = exportSet(analysedCohort(hidden.after), hidden.starts);
  ASSERT_EQ(after.marks.rows.size(), before.marks.rows.size());
  std::multiset<double> marksBefore;
  std::multiset<double> marksAfter;
  for (std::size_t i = 0; i < before.marks.rows.size(); ++i) {
    marksBefore.insert(std::get<double>(before.marks.rows[i][5]));
    marksAfter.insert(std::get<double>(after.marks.rows[i][5]));
  }
  EXPECT_EQ(marksBefore, marksAfter);
  EXPECT_EQ(after.trials.rows.size(), before.trials.rows.size());
  ASSERT_EQ(after.comparison.rows.size(), before.comparison.rows.size());
  std::multiset<std::int64_t> leftBefore;  // of single trainees, ordered by code
  std::multiset<std::int64_t> leftAfter;
  const auto rounded = [](double value) { return std::llround(value * 1e6); };
  for (std::size_t i = 0; i < before.comparison.rows.size(); ++i) {
    const auto* value = std::get_if<double>(&before.comparison.rows[i][6]);
    if (value == nullptr) {
      continue;
    }
    const double now = std::get<double>(after.comparison.rows[i][6]);
    if (before.comparison.rows[i][0] == ExportCell("all")) {
      EXPECT_NEAR(now, *value, 1e-9 * (1.0 + std::abs(*value)));
    } else {
      leftBefore.insert(rounded(*value));
      leftAfter.insert(rounded(now));
    }
  }
  EXPECT_EQ(leftBefore, leftAfter);
}

TEST(Pseudonyms, HidePropertiesSharedByFewAndReportHowFew) {
  Hidden hidden;
  EXPECT_LT(hidden.report.smallestBefore, kSmallestCell);
  EXPECT_GE(hidden.report.smallestAfter, kSmallestCell);
  EXPECT_GT(hidden.report.levelsHidden, 0);
  EXPECT_EQ(hidden.report.textsLeftOut, 3);
  const Hidden told(kKey, true);
  EXPECT_EQ(told.report.textsLeftOut, 0);
  EXPECT_EQ(told.after.deviations.size(), 3U);
}

}  // namespace

}  // namespace torsio
