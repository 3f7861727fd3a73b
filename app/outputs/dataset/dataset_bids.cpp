// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/dataset_bids.h"

#include <cctype>
#include <map>
#include <ostream>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "app/outputs/dataset/trajectory.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// BIDS name of a trajectory column; columns without a BIDS type are MISC.
struct Channel {
  const char* component;
  const char* type;
  const char* point;
  const char* unit;
};

Channel channelOf(const ExportColumn& column) {
  static const std::map<std::string, Channel> kKnown = {
      {"time_s", {"n/a", "LATENCY", "n/a", "s"}},
      {"tool_x_m", {"x", "POS", "instrument", "m"}},
      {"tool_y_m", {"y", "POS", "instrument", "m"}},
      {"tool_z_m", {"z", "POS", "instrument", "m"}},
      {"tool_qw", {"quat_w", "ORNT", "instrument", "n/a"}},
      {"tool_qx", {"quat_x", "ORNT", "instrument", "n/a"}},
      {"tool_qy", {"quat_y", "ORNT", "instrument", "n/a"}},
      {"tool_qz", {"quat_z", "ORNT", "instrument", "n/a"}},
  };
  const auto known = kKnown.find(column.name);
  return known != kKnown.end() ? known->second : Channel{"n/a", "MISC", "n/a", ""};
}

/// BIDS allows no empty value.
std::string given(const std::string& word) {
  return word.empty() ? "n/a" : word;
}

std::string channelsText() {
  std::string text = "name\tcomponent\ttype\ttracked_point\tunits\tdescription\n";
  for (const ExportColumn& column : trajectoryColumns()) {
    const Channel channel = channelOf(column);
    const std::string unit = *channel.unit != '\0' ? channel.unit : given(column.unit);
    text += column.name + "\t" + channel.component + "\t" + channel.type + "\t" + channel.point + "\t" +
            unit + "\t" + column.title.str() + "\n";
  }
  return text;
}

std::int64_t channelsOfType(const std::string& type) {
  std::int64_t count = 0;
  for (const ExportColumn& column : trajectoryColumns()) {
    count += channelOf(column).type == type ? 1 : 0;
  }
  return count;
}

/// Keeps letters and digits, the only characters allowed in a BIDS label.
std::string labelOf(const std::string& word) {
  std::string label;
  for (const char letter : word) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
      label += letter;
    }
  }
  return label.empty() ? "x" : label;
}

/// Unique labels of people.
class SubjectLabels {
 public:
  const std::string& of(const std::string& trainee) {
    const auto [at, isNew] = labels_.try_emplace(trainee);
    if (isNew) {
      at->second = labelOf(trainee);
      for (int number = 2; !taken_.insert(at->second).second; ++number) {
        at->second = labelOf(trainee) + "n" + std::to_string(number);
      }
    }
    return at->second;
  }
  [[nodiscard]] const std::map<std::string, std::string>& all() const { return labels_; }

 private:
  std::map<std::string, std::string> labels_;
  std::set<std::string> taken_;
};

std::string motionJson(const TrialHeader& head, double rate_Hz, const std::string& task) {
  const Json json{{"TaskName", task},
                  {"SamplingFrequency", rate_Hz},
                  {"TrackingSystemName", "torsio"},
                  {"Manufacturer", "n/a"},
                  {"ManufacturersModelName", given(head.deviceModel)},
                  {"SoftwareVersions", given(head.softwareVersion)},
                  {"TrackedPointsCount", 1},
                  {"MotionChannelCount", std::ssize(trajectoryColumns())},
                  {"POSChannelCount", channelsOfType("POS")},
                  {"ORNTChannelCount", channelsOfType("ORNT")},
                  {"LATENCYChannelCount", channelsOfType("LATENCY")},
                  {"MISCChannelCount", channelsOfType("MISC")}};
  return json.dump(2) + "\n";
}

/// Row of *_scans.tsv under kScansHead from a recording's header.
constexpr const char* kScansHead = "filename\torgan\tpattern\ttarget_deg\torgan_hash\tparameter_hash\n";

std::string scanLine(const std::string& file, const TrialHeader& head) {
  const bool foreign = isForeign(head.sceneId);
  return file + "\t" + given(head.sceneId.text()) + "\t" + given(head.patternId.text()) + "\t" +
         (foreign ? "n/a" : formatExact(degrees(head.targetAngle_rad))) + "\t" +
         (foreign ? "n/a" : given(head.organHash)) + "\t" + given(head.parameterHash) + "\n";
}

std::string scansJson() {
  const Json json{
      {"organ", {{"Description", "Organ that was twisted"}}},
      {"pattern", {{"Description", "Pattern of twist"}}},
      {"target_deg", {{"Description", "Target of the angle"}, {"Units", "degree"}}},
      {"organ_hash", {{"Description", "BLAKE2b-256 of the organ's file"}}},
      {"parameter_hash", {{"Description", "Parameters of the tissue model: derivatives/torsio/parameters"}}}};
  return json.dump(2) + "\n";
}

std::string descriptionJson(const DatasetContents& contents) {
  const DatasetAbout& about = contents.about;
  Json json{{"Name", about.title},
            {"BIDSVersion", "1.9.0"},
            {"DatasetType", "raw"},
            {"License", about.licence},
            {"GeneratedBy", {{{"Name", "Torsio"}, {"Version", contents.softwareVersion}}}}};
  if (!contents.origin.empty()) {
    json["Keywords"] = contents.origin;
  }
  if (!about.creator.empty()) {
    json["Authors"] = {about.creator};
  }
  if (!about.citation.empty()) {
    json["HowToAcknowledge"] = about.citation;
  }
  return json.dump(2) + "\n";
}

std::string readme(const DatasetContents& contents) {
  const DatasetAbout& about = contents.about;
  std::string origin;
  for (const std::string& sentence : contents.origin) {
    origin += sentence + "\n\n";
  }
  return about.title + "\n\n" + origin + (about.description.empty() ? "" : about.description + "\n\n") +
         "Licence: " + about.licence + "\n" +
         (about.citation.empty() ? "" : "\nPlease cite: " + about.citation + "\n") +
         "\nMotion of the instrument, twist of the organ and forces: sub-*/motion, in the frame LPS (x to "
         "the "
         "patient's\nleft, y to the back, z to the head). What was trained: sub-*/*_scans.tsv. Parameters of "
         "the "
         "tissue models,\nmarks and computed numbers: derivatives/torsio.\n";
}

}  // namespace

std::vector<fs::path> writeBids(const DatasetContents& contents, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto write = [&](const fs::path& name, const std::string& text) {
    files.push_back(folder / name);
    writeFileAtomically(files.back(), text);
  };
  ensureFolder(folder);
  SubjectLabels subjects;
  std::map<std::string, int> runs;           // by subject and task
  std::map<std::string, std::string> scans;  // by subject
  std::set<std::string> parameters;
  for (std::size_t i = 0; i < contents.recordings.size(); ++i) {
    const DatasetRecording& recording = contents.recordings[i];
    tellRecording(contents, i);
    const Trial trial = recording.load();
    const std::string& subject = subjects.of(recording.trainee);
    const std::string task = labelOf(trial.header.patternId.text());
    std::string run = std::to_string(++runs[subject + " " + task]);
    run.insert(0, run.size() < 2 ? 1 : 0, '0');
    const fs::path place = fs::path("sub-" + subject) / "motion";
    const std::string name = "sub-" + subject + "_task-" + task + "_tracksys-torsio_run-" + run;
    ensureFolder(folder / place);
    files.push_back(folder / place / (name + "_motion.tsv"));
    const std::int64_t every = linesEvery(trial.header, contents.every);
    writeFileAtomically(
        files.back(), [&](std::ostream& out) { writeTrajectory(trial, every, TrajectoryForm::kBids, out); });
    const double rate_Hz = 1e6 / static_cast<double>(trial.header.tickPeriod_us) / static_cast<double>(every);
    write(place / (name + "_motion.json"), motionJson(trial.header, rate_Hz, task));
    write(place / (name + "_channels.tsv"), channelsText());
    scans[subject] += scanLine("motion/" + name + "_motion.tsv", trial.header);
    if (parameters.insert(trial.header.parameterHash).second) {
      const fs::path models = fs::path("derivatives") / "torsio" / "parameters";
      ensureFolder(folder / models);
      write(models / (trial.header.parameterHash + ".json"), trial.header.parametersJson);
    }
  }
  for (const auto& [subject, lines] : scans) {
    write(fs::path("sub-" + subject) / ("sub-" + subject + "_scans.tsv"), kScansHead + lines);
  }
  write("scans.json", scansJson());
  // Everybody takes part, recorded or not.
  std::map<std::string, std::string> groups;
  for (const auto& [trainee, group] : contents.participants) {
    (void)subjects.of(trainee);
    groups[trainee] = group;
  }
  std::string people = "participant_id\tcode\tgroup\n";
  for (const auto& [trainee, label] : subjects.all()) {
    people +=
        "sub-" + label + "\t" + trainee + "\t" + (groups[trainee].empty() ? "n/a" : groups[trainee]) + "\n";
  }
  write("participants.tsv", people);
  write("participants.json", Json{{"code", {{"Description", "Name of the person in derivatives/torsio"}}},
                                  {"group", {{"Description", "Group of the cohort"}}}}
                                     .dump(2) +
                                 "\n");
  write("dataset_description.json", descriptionJson(contents));
  write("README", readme(contents));
  return files;
}

}  // namespace torsio
