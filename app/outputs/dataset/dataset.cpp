// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/dataset.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/outputs/dataset/dataset_bids.h"
#include "app/outputs/dataset/dataset_lerobot.h"
#include "app/outputs/dataset/dataset_study.h"
#include "app/outputs/dataset/parquet_file.h"
#include "app/outputs/dataset/trajectory.h"
#include "app/outputs/tables/table_files.h"
#include "assessment/catalogue/quantity.h"
#include "db/migrations/file_in_the_making.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/trial_file.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<std::string_view, DatasetLayout>, 5> kLayouts = {
    {{"frictionless", DatasetLayout::kFrictionless},
     {"ro-crate", DatasetLayout::kRoCrate},
     {"parquet", DatasetLayout::kParquet},
     {"bids", DatasetLayout::kBids},
     {"lerobot", DatasetLayout::kLerobot}}};

constexpr const char* kCsv = "text/csv";
constexpr const char* kParquet = "application/vnd.apache.parquet";

/// A file of the data set and its contents.
struct Part {
  std::string path;  ///< relative to the data set's folder
  std::string title;
  std::string media;
};

Json fieldOf(const ExportColumn& column) {
  Json field{{"name", column.name}, {"title", column.title.str()}};
  switch (column.kind) {
    case ColumnKind::kText:
      field["type"] = "string";
      break;
    case ColumnKind::kNumber:
      field["type"] = "number";
      break;
    case ColumnKind::kTime:
      field["type"] = "datetime";
      field["format"] = "any";  // ISO 8601 with fractions of seconds
      break;
  }
  if (!column.unit.empty()) {
    field["unit"] = column.unit;
  }
  std::string meaning;
  for (const auto& [value, label] : column.labels) {
    meaning += (meaning.empty() ? "" : "; ") + cellText(value) + " = " + label.str();
  }
  if (!meaning.empty()) {
    field["description"] = meaning;
  }
  return field;
}

Json resourceOf(const std::string& name, const Part& part, const std::string& description,
                const std::vector<ExportColumn>& columns) {
  Json fields = Json::array();
  for (const ExportColumn& column : columns) {
    fields.push_back(fieldOf(column));
  }
  const bool csv = part.media == kCsv;
  Json resource{{"profile", csv ? "tabular-data-resource" : "data-resource"},
                {"name", name},
                {"path", part.path},
                {"title", part.title},
                {"description", description},
                {"format", csv ? "csv" : "parquet"},
                {"mediatype", part.media}};
  if (csv) {
    resource["encoding"] = "utf-8";
    resource["dialect"] = {{"delimiter", ","},
                           {"lineTerminator", "\r\n"},
                           {"quoteChar", "\""},
                           {"doubleQuote", true},
                           {"header", true}};
  }
  resource["schema"] = {{"fields", std::move(fields)}, {"missingValues", {""}}};
  return resource;
}

ExportTable recordingsTable() {
  const auto text = ColumnKind::kText;
  const auto number = ColumnKind::kNumber;
  return {"recordings",
          Text::tr("Recordings"),
          Text::tr("The head of each recording: what was trained, with what, and where its trajectory lies."),
          {{"trial", Text::tr("Recording"), text},
           {"participant", Text::tr("trainee"), text},
           {"organ", Text::tr("organ"), text},
           {"pattern", Text::tr("pattern of twist"), text},
           {"target_deg", Text::tr("target angle"), number, "deg"},
           {"organ_hash", Text::tr("BLAKE2b-256 of the organ's file"), text},
           {"parameters", Text::tr("file of the tissue model's parameters"), text},
           {"device", Text::tr("input device"), text},
           {"largest_device_force_N", Text::tr("largest force of the device"), number, "N"},
           {"software", Text::tr("program that recorded"), text},
           {"rate_Hz", Text::tr("lines of the trajectory a second"), number, "Hz"},
           {"lines", Text::tr("lines of the trajectory"), number},
           {"trajectory", Text::tr("file of the trajectory"), text}},
          {}};
}

class DatasetWriter {
 public:
  DatasetWriter(const DatasetContents& contents, const fs::path& folder, bool parquet)
      : contents_(contents), folder_(folder), parquet_(parquet) {}

  /// Writes everything except the descriptors.
  void write() {
    ensureFolder(folder_ / "data");
    for (const ExportTable* table : contents_.tables) {
      addTable(*table);
    }
    addRecordings();
    if (!contents_.studyJson.empty()) {
      addText({kDatasetStudyFile, "What another record needs besides", "application/json"},
              contents_.studyJson);
    }
    if (!contents_.studySeal.empty()) {
      addText({kDatasetSealFile, "Signature of the study", "application/json"}, contents_.studySeal);
    }
    addText({"metrics.json", "Definition of each metric", "application/json"}, metricsJson());
    if (!contents_.curriculumJson.empty()) {
      addText({"curriculum.json", "Curriculum of the cohort", "application/json"}, contents_.curriculumJson);
    }
    addText({"README.md", "What this data set holds", "text/markdown"}, readme());
    addText({"datapackage.json", "Descriptor of the data package", "application/json"}, packageJson());
  }
  void writeCrate() {
    addText({"ro-crate-metadata.json", "Descriptor of the crate", "application/ld+json"}, crateJson());
  }

  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    for (const Part& part : parts_) {
      all.push_back(folder_ / part.path);
    }
    return all;
  }

 private:
  void addText(const Part& part, const std::string& text) {
    parts_.push_back(part);
    writeFileAtomically(folder_ / part.path, text);
  }

  void addTable(const ExportTable& table) {
    const Part part = tablePart("data/" + table.name, table.title.str());
    if (parquet_) {
      parts_.push_back(part);
      writeParquet(folder_ / part.path, parquetColumns(table), {{"title", part.title}});
    } else {
      addText(part, tableText(table));
    }
    resources_.push_back(resourceOf(table.name, part, table.source.str(), table.columns));
  }

  [[nodiscard]] Part tablePart(const std::string& path, const std::string& title) const {
    return {path + (parquet_ ? ".parquet" : ".csv"), title, parquet_ ? kParquet : kCsv};
  }

  /// Returns the number of lines.
  [[nodiscard]] std::int64_t writeTrajectoryTo(const fs::path& file, const Trial& trial,
                                               std::int64_t every) const {
    if (parquet_) {
      std::vector<std::vector<std::optional<double>>> values = trajectoryValues(trial, every);
      const std::int64_t lines = std::ssize(values.front());
      std::vector<ParquetColumn> columns;
      for (std::size_t c = 0; c < values.size(); ++c) {
        columns.push_back({trajectoryColumns()[c].name, std::move(values[c])});
      }
      writeParquet(file, columns);
      return lines;
    }
    std::int64_t lines = 0;
    writeFileAtomically(
        file, [&](std::ostream& out) { lines = writeTrajectory(trial, every, TrajectoryForm::kCsv, out); });
    return lines;
  }

  void addRecordings() {
    if (contents_.recordings.empty()) {
      return;
    }
    ensureFolder(folder_ / "trajectories");
    ensureFolder(folder_ / "parameters");
    ExportTable heads = recordingsTable();
    std::set<std::string> parameters;
    for (std::size_t i = 0; i < contents_.recordings.size(); ++i) {
      const DatasetRecording& recording = contents_.recordings[i];
      tellRecording(contents_, i);
      const Trial trial = recording.load();
      const TrialHeader& head = trial.header;
      const std::string model = "parameters/" + head.parameterHash + ".json";
      if (parameters.insert(model).second) {
        addText({model, "Parameters of a tissue model", "application/json"}, head.parametersJson);
      }
      if (!contents_.studyJson.empty()) {
        addWhole(recording.name, trial);
      }
      const Part part = tablePart("trajectories/" + recording.name, "Trajectory " + recording.name);
      const std::int64_t every = linesEvery(head, contents_.every);
      parts_.push_back(part);
      const std::int64_t lines = writeTrajectoryTo(folder_ / part.path, trial, every);
      std::string name = "trajectory-" + recording.name;
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
      resources_.push_back(
          resourceOf(name, part, "Motion, force and twist of one recording.", trajectoryColumns()));
      const double rate_Hz = 1e6 / static_cast<double>(head.tickPeriod_us) / static_cast<double>(every);
      const bool foreign = isForeign(head.sceneId);
      heads.rows.push_back({recording.name, recording.trainee, head.sceneId.text(), head.patternId.text(),
                            foreign ? ExportCell() : ExportCell(degrees(head.targetAngle_rad)),
                            head.organHash, model, head.deviceModel,
                            foreign ? ExportCell() : ExportCell(head.deviceLimits.maxForce_N),
                            head.softwareVersion, rate_Hz, static_cast<double>(lines), part.path});
    }
    addTable(heads);
  }

  /// Adds a complete recording.
  void addWhole(const std::string& name, const Trial& trial) {
    ensureFolder(folder_ / "recordings");
    const Part part{"recordings/" + name + ".torsio", "Recording " + name, "application/octet-stream"};
    parts_.push_back(part);
    TrialFileSink sink(folder_ / part.path);
    sink.begin(trial.header);
    for (const TrialChunk& chunk : trial.chunks) {
      sink.append(chunk);
    }
    sink.finish(trial.summary);
  }

  [[nodiscard]] static std::string metricsJson() {
    Json cards = Json::array();
    for (const QuantityRow& row : quantityRows()) {
      cards.push_back({{"id", row.id},
                       {"name", row.name.english()},
                       {"meaning", row.meaning.english()},
                       {"formula", row.formula.english()},
                       {"unit", row.unit},
                       {"window", row.window.english()},
                       {"version", row.version}});
    }
    return cards.dump(2) + "\n";
  }

  [[nodiscard]] std::string readme() const {
    const DatasetAbout& about = contents_.about;
    std::string text = "# " + about.title + "\n\n";
    if (!about.description.empty()) {
      text += about.description + "\n\n";
    }
    for (const std::string& sentence : contents_.origin) {
      text += "**" + sentence + "**\n\n";
    }
    text += "Licence: " + about.licence + "\n";
    if (!about.citation.empty()) {
      text += "\nPlease cite: " + about.citation + "\n";
    }
    text += "\n| file | what it holds |\n|---|---|\n";
    for (const Part& part : parts_) {
      if (!part.path.starts_with("trajectories/") && !part.path.starts_with("parameters/") &&
          !part.path.starts_with("recordings/")) {
        text += "| `" + part.path + "` | " + part.title + " |\n";
      }
    }
    if (!contents_.recordings.empty()) {
      text +=
          "| `trajectories/` | one file a recording, listed in `data/recordings.csv` |\n"
          "| `parameters/` | the parameters of the tissue models |\n"
          "\nThe frame of positions and forces is LPS: x to the patient's left, y to the back, z to the "
          "head. "
          "Rotations are unit quaternions that turn a vector from the frame of the instrument to it.\n";
    }
    if (!contents_.studyJson.empty()) {
      text +=
          "\n`recordings/` holds the recordings as Torsio made them; `torsio dataset import` reads them.\n";
    }
    return text + "\nColumns are described in `datapackage.json`. Written by Torsio " +
           contents_.softwareVersion + ".\n";
  }

  [[nodiscard]] std::string packageJson() const {
    const DatasetAbout& about = contents_.about;
    Json package{{"profile", "tabular-data-package"},
                 {"name", "torsio-dataset"},
                 {"title", about.title},
                 {"description", about.description},
                 {"created", cellText(about.madeUtc_us)},
                 {"licenses", {{{"name", about.licence}}}},
                 {"resources", resources_}};
    if (!contents_.origin.empty()) {
      package["origin"] = contents_.origin;
    }
    if (!about.creator.empty()) {
      package["contributors"] = {{{"title", about.creator}, {"role", "author"}}};
    }
    if (!about.citation.empty()) {
      package["citation"] = about.citation;
    }
    return package.dump(2) + "\n";
  }

  [[nodiscard]] std::string crateJson() const {
    const DatasetAbout& about = contents_.about;
    Json root{{"@id", "./"},
              {"@type", "Dataset"},
              {"name", about.title},
              {"description", about.description.empty() ? about.title : about.description},
              {"datePublished", cellText(about.madeUtc_us).substr(0, 10)},
              {"license", {{"@id", "https://spdx.org/licenses/" + about.licence}}},
              {"hasPart", Json::array()}};
    Json files = Json::array();
    for (const Part& part : parts_) {
      root["hasPart"].push_back({{"@id", part.path}});
      files.push_back({{"@id", part.path},
                       {"@type", "File"},
                       {"name", part.title},
                       {"encodingFormat", part.media},
                       {"contentSize", std::to_string(fs::file_size(folder_ / part.path))}});
    }
    Json graph = Json::array();
    graph.push_back({{"@id", "ro-crate-metadata.json"},
                     {"@type", "CreativeWork"},
                     {"about", {{"@id", "./"}}},
                     {"conformsTo", {{"@id", "https://w3id.org/ro/crate/1.1"}}}});
    if (!contents_.origin.empty()) {
      root["abstract"] = contents_.origin;
    }
    if (!about.creator.empty()) {
      root["author"] = {{"@id", "#creator"}};
    }
    if (!about.citation.empty()) {
      root["creditText"] = about.citation;
    }
    graph.push_back(root);
    graph.push_back({{"@id", "https://spdx.org/licenses/" + about.licence},
                     {"@type", "CreativeWork"},
                     {"name", about.licence}});
    if (!about.creator.empty()) {
      graph.push_back({{"@id", "#creator"}, {"@type", "Organization"}, {"name", about.creator}});
    }
    graph.insert(graph.end(), files.begin(), files.end());
    return Json{{"@context", "https://w3id.org/ro/crate/1.1/context"}, {"@graph", graph}}.dump(2) + "\n";
  }

  const DatasetContents& contents_;
  const fs::path& folder_;
  bool parquet_;  // in place of CSV
  std::vector<Part> parts_;
  Json resources_ = Json::array();
};

std::vector<fs::path> writePackage(const DatasetContents& contents, DatasetLayout layout,
                                   const fs::path& folder) {
  DatasetWriter writer(contents, folder, layout == DatasetLayout::kParquet);
  writer.write();
  if (layout == DatasetLayout::kRoCrate) {
    writer.writeCrate();
  }
  return writer.files();
}

bool isSpdx(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '-' || letter == '.' || letter == '+';
  });
}

/// Writes all files of the data set into `folder`.
std::vector<fs::path> writeLayout(const DatasetContents& contents, DatasetLayout layout,
                                  const fs::path& folder) {
  const bool bids = layout == DatasetLayout::kBids;
  if (!bids && layout != DatasetLayout::kLerobot) {
    return writePackage(contents, layout, folder);
  }
  std::vector<fs::path> files = bids ? writeBids(contents, folder) : writeLerobot(contents, folder);
  DatasetContents tables = contents;
  tables.recordings.clear();  // they are in the folders of the layout
  const fs::path place = bids ? folder / "derivatives" / "torsio" : folder / "torsio";
  for (const fs::path& file : writePackage(tables, DatasetLayout::kFrictionless, place)) {
    files.push_back(file);
  }
  return files;
}

}  // namespace

DatasetLayout datasetLayout(const std::string& word) {
  for (const auto& [name, layout] : kLayouts) {
    if (name == word) {
      return layout;
    }
  }
  throw Error(ErrorCode::kUsage, Text::tr("there is no such form of a data set"), word,
              Text::tr("Use frictionless, ro-crate, parquet, bids or lerobot"));
}

void requireWhole(const DatasetAbout& about) {
  if (about.title.empty()) {
    refuseParameter(Text::tr("the data set has no title"), std::string("title"), Text::tr("Give it a title"));
  }
  if (!isSpdx(about.licence)) {
    refuseParameter(Text::tr("the licence is missing or is not an SPDX identifier"), about.licence,
                    Text::tr("Name the licence, for example CC-BY-4.0"));
  }
}

std::vector<fs::path> writeDataset(const DatasetContents& contents, DatasetLayout layout,
                                   const fs::path& folder) {
  requireWhole(contents.about);
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder))) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the folder of the data set is not empty"),
                folder.string(), Text::tr("Choose a new folder, so that nothing is mixed"));
  }
  if (folder.has_parent_path()) {
    ensureFolder(folder.parent_path());
  }
  const FileInTheMaking making(folder);
  std::vector<fs::path> files = writeLayout(contents, layout, making.path());
  std::error_code failed;
  fs::rename(making.path(), folder, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable,
                Text::tr("the data set cannot be given its name: %1", failed.message()), folder.string(),
                Text::tr("Choose a folder in which you may write"));
  }
  for (fs::path& file : files) {
    file = folder / file.lexically_relative(making.path());
  }
  return files;
}

}  // namespace torsio
