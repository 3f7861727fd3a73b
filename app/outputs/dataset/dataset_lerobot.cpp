// SPDX-License-Identifier: GPL-3.0-or-later
// The layout: https://huggingface.co/docs/lerobot/lerobot-dataset-v3. Names of files, columns and fields
// below are its own.
#include "app/outputs/dataset/dataset_lerobot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/outputs/dataset/parquet_file.h"
#include "app/outputs/dataset/trajectory.h"
#include "assessment/results/number_format.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using LerobotJson = nlohmann::ordered_json;

constexpr std::size_t kMaxFileBytes = 100'000'000;  // as LeRobot's own writer
constexpr int kFilesPerChunk = 1000;
constexpr const char* kFilePattern = "/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet";
constexpr std::array<std::pair<const char*, double>, 5> kStatsQuantiles = {
    {{"q01", 0.01}, {"q10", 0.10}, {"q50", 0.50}, {"q90", 0.90}, {"q99", 0.99}}};

std::string filePath(const std::string& root, std::int64_t chunk, std::int64_t file) {
  const auto digits = [](std::int64_t number) {
    const std::string text = std::to_string(number);
    return std::string(text.size() < 3 ? 3 - text.size() : 0, '0') + text;
  };
  return root + "/chunk-" + digits(chunk) + "/file-" + digits(file) + ".parquet";
}

/// Positions of the columns of a trajectory in a vector of LeRobot.
std::vector<std::size_t> columnsWhere(bool (*wanted)(const std::string& name)) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < trajectoryColumns().size(); ++c) {
    if (wanted(trajectoryColumns()[c].name)) {
      found.push_back(c);
    }
  }
  return found;
}

const std::vector<std::size_t>& stateColumns() {
  static const std::vector<std::size_t> all =
      columnsWhere([](const std::string& name) { return name != "time_s"; });
  return all;
}

/// What the hand commands: where the instrument is next.
const std::vector<std::size_t>& actionColumns() {
  static const std::vector<std::size_t> all = columnsWhere([](const std::string& name) {
    return name.starts_with("tool_") || name == "roll_rad" || name == "grip";
  });
  return all;
}

struct FeatureStats {
  std::vector<double> min, max, mean, std;
  std::array<std::vector<double>, kStatsQuantiles.size()> quantiles;
  std::int64_t count = 0;
};

/// Of one episode; `values` holds vectors of `size` numbers. There is at least one.
FeatureStats statsOf(const std::vector<double>& values, std::size_t size) {
  FeatureStats stats;
  stats.count = static_cast<std::int64_t>(values.size() / size);
  for (std::size_t d = 0; d < size; ++d) {
    std::vector<double> own;
    for (std::size_t i = d; i < values.size(); i += size) {
      own.push_back(values[i]);
    }
    const double mean = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(own.size());
    double squares = 0.0;
    for (const double value : own) {
      squares += (value - mean) * (value - mean);
    }
    std::sort(own.begin(), own.end());
    stats.min.push_back(own.front());
    stats.max.push_back(own.back());
    stats.mean.push_back(mean);
    stats.std.push_back(std::sqrt(squares / static_cast<double>(own.size())));
    for (std::size_t q = 0; q < kStatsQuantiles.size(); ++q) {
      stats.quantiles[q].push_back(*quantile(own, kStatsQuantiles[q].second));
    }
  }
  return stats;
}

/// Joins statistics of episodes as LeRobot does: moments are weighted, quantiles are bounds.
FeatureStats joined(const std::vector<FeatureStats>& all) {
  FeatureStats sum = all.front();
  for (std::size_t d = 0; d < sum.mean.size(); ++d) {
    double count = 0.0;
    double mean = 0.0;
    for (const FeatureStats& one : all) {
      count += static_cast<double>(one.count);
      mean += static_cast<double>(one.count) * one.mean[d];
      sum.min[d] = std::min(sum.min[d], one.min[d]);
      sum.max[d] = std::max(sum.max[d], one.max[d]);
      for (std::size_t q = 0; q < kStatsQuantiles.size(); ++q) {
        const double other = one.quantiles[q][d];
        double& bound = sum.quantiles[q][d];
        bound = kStatsQuantiles[q].second <= 0.5 ? std::min(bound, other) : std::max(bound, other);
      }
    }
    mean /= count;
    double squares = 0.0;
    for (const FeatureStats& one : all) {
      const double off = one.mean[d] - mean;
      squares += static_cast<double>(one.count) * (one.std[d] * one.std[d] + off * off);
    }
    sum.mean[d] = mean;
    sum.std[d] = std::sqrt(squares / count);
    sum.count = static_cast<std::int64_t>(count);
  }
  return sum;
}

/// A column of the frames.
struct Feature {
  std::string name;
  bool whole = false;                ///< int64; otherwise float32
  std::vector<std::string> names{};  ///< of a vector's numbers; empty: one number
};

std::vector<Feature> lerobotFeatures() {
  const auto namesOf = [](const std::vector<std::size_t>& columns) {
    std::vector<std::string> names;
    for (const std::size_t c : columns) {
      names.push_back(trajectoryColumns()[c].name);
    }
    return names;
  };
  return {{"observation.state", false, namesOf(stateColumns())},
          {"action", false, namesOf(actionColumns())},
          {"timestamp"},
          {"frame_index", true},
          {"episode_index", true},
          {"index", true},
          {"task_index", true}};
}

class LerobotWriter {
 public:
  LerobotWriter(const DatasetContents& contents, const fs::path& folder)
      : contents_(contents), folder_(folder), features_(lerobotFeatures()), stats_(features_.size()) {}

  void write() {
    for (std::size_t i = 0; i < contents_.recordings.size(); ++i) {
      tellRecording(contents_, i);
      const Trial trial = contents_.recordings[i].load();
      if (isForeign(trial.header.sceneId)) {
        ++leftOut_;
        continue;
      }
      if (parameters_.insert(trial.header.parameterHash).second) {
        writeFileAtomically(place("torsio/parameters/" + trial.header.parameterHash + ".json"),
                            trial.header.parametersJson);
      }
      fps_ = std::llround(1e6 / static_cast<double>(trial.header.tickPeriod_us * contents_.every));
      addEpisode(contents_.recordings[i], trial);
    }
    if (episodes_ == 0) {
      refuse(Text::tr("there is no recording of the simulator"), contents_.about.title,
             Text::tr("Choose another form: LeRobot has no place for other equipment's recordings"));
    }
    finishFile();
    writeTasks();
    writeEpisodes();
    writeMeta();
    writeReadme();
  }
  [[nodiscard]] const std::vector<fs::path>& files() const noexcept { return files_; }

 private:
  /// Names a file and makes its folder.
  fs::path place(const std::string& path) {
    const fs::path file = folder_ / path;
    ensureFolder(file.parent_path());
    files_.push_back(file);
    return file;
  }

  void addEpisode(const DatasetRecording& recording, const Trial& trial) {
    const std::vector<std::vector<std::optional<double>>> columns = trajectoryValues(trial, contents_.every);
    const std::size_t frames = columns.front().size();
    if (frames == 0) {
      ++leftOut_;
      return;
    }
    const std::string task = trial.header.sceneId.text() + ": " + trial.header.patternId.text() +
                             ", target " + formatFixed(degrees(trial.header.targetAngle_rad), 0) + " degrees";
    const std::int64_t taskIndex = tasks_.emplace(task, std::ssize(tasks_)).first->second;
    std::vector<std::vector<double>> values(features_.size());
    const auto gather = [&](std::size_t frame, const std::vector<std::size_t>& wanted,
                            std::vector<double>& to) {
      for (const std::size_t c : wanted) {
        to.push_back(static_cast<double>(static_cast<float>(columns[c][frame].value_or(0.0))));
      }
    };
    for (std::size_t f = 0; f < frames; ++f) {
      gather(f, stateColumns(), values[0]);
      gather(std::min(f + 1, frames - 1), actionColumns(), values[1]);
      // Counts frames; a sample that was lost leaves its gap.
      const double place = std::round((*columns[0][f] - *columns[0][0]) * static_cast<double>(fps_));
      values[2].push_back(static_cast<double>(static_cast<float>(place / static_cast<double>(fps_))));
      values[3].push_back(static_cast<double>(f));
      values[4].push_back(static_cast<double>(episodes_));
      values[5].push_back(static_cast<double>(frames_ + static_cast<std::int64_t>(f)));
      values[6].push_back(static_cast<double>(taskIndex));
    }
    addFrames(values);
    lengths_.push_back(static_cast<std::int64_t>(frames));
    starts_.push_back(frames_);
    taskOf_.push_back(task);
    trials_.emplace_back(recording.name);
    people_.emplace_back(recording.trainee);
    chunks_.push_back(chunk_);
    fileNumbers_.push_back(file_);
    frames_ += static_cast<std::int64_t>(frames);
    ++episodes_;
  }

  void addFrames(const std::vector<std::vector<double>>& values) {
    std::vector<ParquetColumn> group;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const std::size_t size = std::max<std::size_t>(1, features_[i].names.size());
      stats_[i].push_back(statsOf(values[i], size));
      bytes += values[i].size() * (features_[i].whole ? sizeof(std::int64_t) : sizeof(float));
      if (features_[i].whole) {
        group.push_back({features_[i].name, std::vector<std::int64_t>(values[i].begin(), values[i].end())});
      } else if (features_[i].names.empty()) {
        group.push_back({features_[i].name, std::vector<float>(values[i].begin(), values[i].end())});
      } else {
        group.push_back({features_[i].name,
                         ParquetLists<float>{size, std::vector<float>(values[i].begin(), values[i].end())}});
      }
    }
    if (data_ && data_->bytes() + bytes > kMaxFileBytes) {
      finishFile();
      chunk_ += file_ == kFilesPerChunk - 1 ? 1 : 0;
      file_ = file_ == kFilesPerChunk - 1 ? 0 : file_ + 1;
    }
    if (!data_) {
      data_.emplace();
    }
    data_->add(group);
  }

  void finishFile() {
    std::move(*data_).write(place(filePath("data", chunk_, file_)));
    data_.reset();
  }

  void writeTasks() {
    std::vector<std::optional<std::string>> words(tasks_.size());
    std::vector<std::int64_t> numbers(tasks_.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    for (const auto& [task, number] : tasks_) {
      words[static_cast<std::size_t>(number)] = task;
    }
    const auto column = [](const char* name, const char* type, const char* storage) {
      return LerobotJson{{"name", name},
                         {"field_name", name},
                         {"pandas_type", type},
                         {"numpy_type", storage},
                         {"metadata", nullptr}};
    };
    // LeRobot looks tasks up by the index of a table of pandas.
    const LerobotJson pandas{
        {"index_columns", {"task"}},
        {"column_indexes", LerobotJson::array()},
        {"columns", {column("task_index", "int64", "int64"), column("task", "unicode", "object")}}};
    writeParquet(place("meta/tasks.parquet"), {{"task_index", numbers}, {"task", words}},
                 {{"pandas", pandas.dump()}});
  }

  void writeEpisodes() {
    std::vector<std::int64_t> numbers(lengths_.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<std::int64_t> ends;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      ends.push_back(starts_[i] + lengths_[i]);
    }
    const std::vector<std::int64_t> first(lengths_.size(), 0);
    std::vector<ParquetColumn> columns{{"episode_index", numbers},
                                       {"tasks", ParquetLists<std::string>{1, taskOf_}},
                                       {"length", lengths_},
                                       {"trial", trials_},
                                       {"participant", people_},
                                       {"data/chunk_index", chunks_},
                                       {"data/file_index", fileNumbers_},
                                       {"dataset_from_index", starts_},
                                       {"dataset_to_index", ends},
                                       {"meta/episodes/chunk_index", first},
                                       {"meta/episodes/file_index", first}};
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const std::string prefix = "stats/" + features_[i].name + "/";
      const auto add = [&](const char* name, const auto& numbersOf) {
        ParquetLists<double> lists{std::max<std::size_t>(1, features_[i].names.size()), {}};
        for (const FeatureStats& one : stats_[i]) {
          const std::vector<double>& own = numbersOf(one);
          lists.values.insert(lists.values.end(), own.begin(), own.end());
        }
        columns.push_back({prefix + name, std::move(lists)});
      };
      add(
          "min", [](const FeatureStats& one) -> const auto& { return one.min; });
      add(
          "max", [](const FeatureStats& one) -> const auto& { return one.max; });
      add(
          "mean", [](const FeatureStats& one) -> const auto& { return one.mean; });
      add(
          "std", [](const FeatureStats& one) -> const auto& { return one.std; });
      columns.push_back({prefix + "count", ParquetLists<std::int64_t>{1, lengths_}});
      for (std::size_t q = 0; q < kStatsQuantiles.size(); ++q) {
        add(
            kStatsQuantiles[q].first, [q](const FeatureStats& one) -> const auto& {
              return one.quantiles[q];
            });
      }
    }
    writeParquet(place(filePath("meta/episodes", 0, 0)), columns);
  }

  void writeMeta() {
    LerobotJson features;
    LerobotJson stats;
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const Feature& feature = features_[i];
      features[feature.name] = {
          {"dtype", feature.whole ? "int64" : "float32"},
          {"shape", {std::max<std::size_t>(1, feature.names.size())}},
          {"names", feature.names.empty() ? LerobotJson() : LerobotJson(feature.names)}};
      const FeatureStats all = joined(stats_[i]);
      LerobotJson& own = stats[feature.name];
      own = {{"min", all.min}, {"max", all.max}, {"mean", all.mean}, {"std", all.std}};
      own["count"] = std::vector<std::int64_t>{all.count};
      for (std::size_t q = 0; q < kStatsQuantiles.size(); ++q) {
        own[kStatsQuantiles[q].first] = all.quantiles[q];
      }
    }
    const LerobotJson info{{"codebase_version", "v3.0"},
                           {"robot_type", "torsio"},
                           {"total_episodes", episodes_},
                           {"total_frames", frames_},
                           {"total_tasks", tasks_.size()},
                           {"chunks_size", kFilesPerChunk},
                           {"data_files_size_in_mb", kMaxFileBytes / 1'000'000},
                           {"video_files_size_in_mb", 200},
                           {"fps", fps_},
                           {"splits", {{"train", "0:" + std::to_string(episodes_)}}},
                           {"data_path", std::string("data") + kFilePattern},
                           {"video_path", nullptr},
                           {"features", features}};
    writeFileAtomically(place("meta/info.json"), info.dump(2) + "\n");
    writeFileAtomically(place("meta/stats.json"), stats.dump(2) + "\n");
  }

  void writeReadme() {
    const DatasetAbout& about = contents_.about;
    std::string licence = about.licence;
    std::transform(licence.begin(), licence.end(), licence.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    std::string text = "---\nlicense: " + licence +
                       "\ntask_categories:\n- robotics\ntags:\n- LeRobot\nconfigs:\n- config_name: default\n"
                       "  data_files: data/*/*.parquet\n---\n\n# " +
                       about.title + "\n\n";
    for (const std::string& paragraph :
         {about.description, about.citation.empty() ? "" : "Please cite: " + about.citation}) {
      text += paragraph.empty() ? "" : paragraph + "\n\n";
    }
    for (const std::string& sentence : contents_.origin) {
      text += "**" + sentence + "**\n\n";
    }
    text +=
        "A data set of LeRobot, version 3.0. Each episode is one recording of a training simulator for "
        "surgical "
        "twists; `trial` and `participant` of `meta/episodes` name it as the tables in `torsio/` do.\n\n"
        "- `observation.state`: instrument, twist, torque, forces, stage. Lengths in metres, forces in "
        "newtons; "
        "the frame is LPS (x to the patient's left, y to the back, z to the head); quaternions have their "
        "real "
        "part first.\n"
        "- `action`: pose, turn and jaw of the instrument in the next frame; in the last frame its own.\n"
        "- `timestamp`: seconds since the first frame; where samples were lost, it leaves a gap.\n\n";
    if (leftOut_ > 0) {
      text += "Recordings of other equipment, which are not in it: " + std::to_string(leftOut_) + ".\n\n";
    }
    writeFileAtomically(place("README.md"), text + "Written by Torsio " + contents_.softwareVersion + ".\n");
  }

  const DatasetContents& contents_;
  const fs::path& folder_;
  std::vector<Feature> features_;
  std::vector<std::vector<FeatureStats>> stats_;  ///< by feature and episode
  std::optional<ParquetFile> data_;
  std::map<std::string, std::int64_t> tasks_;
  std::set<std::string> parameters_;
  std::vector<std::int64_t> lengths_, starts_, chunks_, fileNumbers_;  ///< by episode, as are the next three
  std::vector<std::string> taskOf_;
  std::vector<std::optional<std::string>> trials_, people_;
  std::vector<fs::path> files_;
  std::int64_t fps_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t episodes_ = 0;
  std::int64_t chunk_ = 0;
  std::int64_t file_ = 0;
  std::size_t leftOut_ = 0;
};

}  // namespace

std::vector<fs::path> writeLerobot(const DatasetContents& contents, const fs::path& folder) {
  LerobotWriter writer(contents, folder);
  writer.write();
  return writer.files();
}

}  // namespace torsio
