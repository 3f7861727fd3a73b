// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/connectors/foreign/foreign_rows.h"
#include "app/connectors/foreign/parquet_table.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/pose.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

/// Lines of a file without line ends, and the hash of its bytes.
class HashedLines {
 public:
  explicit HashedLines(const fs::path& file) : in_(file, std::ios::binary) {
    if (!fs::is_regular_file(file)) {
      throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), file.string(),
                  Text::tr("Check the names in the map"));
    }
    if (!in_) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("the file cannot be read"), file.string(),
                  Text::tr("Check its permissions"));
    }
  }
  bool next(std::string_view& line) {
    for (;;) {
      const std::size_t end = buffer_.find('\n', at_);
      if (end != std::string::npos) {
        line = std::string_view(buffer_).substr(at_, end - at_);
        at_ = end + 1;
        break;
      }
      if (!refill()) {
        if (at_ >= buffer_.size()) {
          return false;
        }
        line = std::string_view(buffer_).substr(at_);
        at_ = buffer_.size();
        break;
      }
    }
    ++number_;
    if (!line.empty() && line.back() == '\r') {
      line.remove_suffix(1);
    }
    return true;
  }
  [[nodiscard]] std::size_t number() const noexcept { return number_; }
  [[nodiscard]] std::string hash() const { return digest_.hex(); }

 private:
  bool refill() {
    constexpr std::size_t kBlock = 1U << 20U;
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t before = buffer_.size();
    buffer_.resize(before + kBlock);
    in_.read(buffer_.data() + before, static_cast<std::streamsize>(kBlock));
    buffer_.resize(before + static_cast<std::size_t>(in_.gcount()));
    digest_.update(std::string_view(buffer_).substr(before));
    return buffer_.size() > before;
  }

  std::ifstream in_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  Digest digest_;
};

/// Returns the place in the file; called only for an error message.
using Where = std::function<std::string()>;

[[noreturn]] void refuseRotation(const Where& where) {
  refuse(Text::tr("these numbers are not a rotation"), where(),
         Text::tr("Check the line and the form of rotation that the map names"));
}

Quat matrixRotation(const std::array<double, 9>& m, const Where& where) {
  const std::optional<Quat> rotation = rotationFromRows(m);
  if (!rotation) {
    refuseRotation(where);
  }
  return *rotation;
}

Quat rotationIn(RotationForm form, const std::vector<double>& numbers, const Where& where) {
  if (form == RotationForm::kNone) {
    return {};
  }
  if (form == RotationForm::kMatrixRows || form == RotationForm::kMatrixColumns) {
    std::array<double, 9> m{};
    for (std::size_t i = 0; i < m.size(); ++i) {
      const std::size_t from = form == RotationForm::kMatrixRows ? i : 3 * (i % 3) + i / 3;
      m[i] = numbers[from];
    }
    return matrixRotation(m, where);
  }
  const bool first = form == RotationForm::kQuaternionWxyz;
  const Quat q = first ? Quat{numbers[0], numbers[1], numbers[2], numbers[3]}
                       : Quat{numbers[3], numbers[0], numbers[1], numbers[2]};
  if (std::abs(norm(q) - 1.0) > kRotationSlack) {
    refuseRotation(where);
  }
  return normalized(q);
}

/// Assigns times to poses and checks that they increase.
class PoseClock {
 public:
  explicit PoseClock(std::optional<double> rate_Hz) : rate_Hz_(rate_Hz) {}

  std::int64_t timeOf(const ForeignRow& row, const Where& where) {
    if (rate_Hz_) {
      return std::llround(static_cast<double>(count_++) / *rate_Hz_ * 1e6);
    }
    const std::int64_t now_us = row.time_us - (count_ == 0 ? row.time_us : first_us_);
    if (count_ == 0) {
      first_us_ = row.time_us;
    } else if (now_us <= last_us_) {
      refuse(Text::tr("the time does not rise"), where(),
             Text::tr("Put the lines in order and remove duplicates"));
    }
    last_us_ = now_us;
    ++count_;
    return now_us;
  }
  /// Counts a missing pose.
  void pass() { count_ += rate_Hz_ ? 1 : 0; }
  [[nodiscard]] std::int64_t period_us() const {
    if (rate_Hz_) {
      return std::llround(1e6 / *rate_Hz_);
    }
    return std::max<std::int64_t>(1, last_us_ / std::max<std::int64_t>(1, count_ - 1));
  }
  [[nodiscard]] std::int64_t count() const noexcept { return count_; }

 private:
  std::optional<double> rate_Hz_;
  std::int64_t count_ = 0;
  std::int64_t first_us_ = 0;
  std::int64_t last_us_ = 0;
};

/// Turns rows into poses and passes them on.
class PoseTaker {
 public:
  PoseTaker(const ForeignMap& map, const ForeignRecording& recording,
            const std::function<void(const ForeignPose&, std::size_t line)>& take)
      : map_(map), recording_(recording), take_(take), clock_(map.rate_Hz) {}

  void operator()(const ForeignRow& row, std::size_t line) {
    if (row.gap) {
      clock_.pass();
      return;
    }
    const Where where = [&] { return recording_.name + ", line " + std::to_string(line); };
    ForeignPose pose;
    pose.place = clock_.count();
    pose.time_us = clock_.timeOf(row, where);
    pose.pose.position_m = map_.metresPerUnit * row.position;
    pose.pose.orientation = rotationIn(map_.rotation, row.rotation, where);
    if (map_.grip) {
      const double closed = (row.grip - map_.grip->open) / (map_.grip->closed - map_.grip->open);
      pose.grip = std::clamp(closed, 0.0, 1.0);
    }
    take_(pose, line);
    ++poses_;
  }
  [[nodiscard]] ForeignFile finish(const std::string& hash) const {
    if (poses_ < 2) {
      refuse(Text::tr("the recording has fewer than two lines"), recording_.name,
             Text::tr("Check the instrument and the columns that the map names"));
    }
    return {poses_, clock_.period_us(), hash};
  }

 private:
  const ForeignMap& map_;
  const ForeignRecording& recording_;
  const std::function<void(const ForeignPose&, std::size_t line)>& take_;
  PoseClock clock_;
  std::int64_t poses_ = 0;
};

/// Returns the hash of the file.
std::string takeLines(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
                      PoseTaker& poses) {
  HashedLines lines(recording.file);
  if (isParquet(recording.file)) {
    refuse(Text::tr("this is a Parquet file"), recording.name, Text::tr("Import it as parquet"));
  }
  const std::unique_ptr<ForeignRows> rows = foreignRows(map, layout, recording.name);
  ForeignRow row;
  std::string_view line;
  while (lines.next(line)) {
    if (rows->read(line, lines.number(), row)) {
      poses(row, lines.number());
    }
  }
  return lines.hash();
}

constexpr const char* kEpisodeColumn = "episode_index";  // as LeRobot names it

/// Returns the hash of the file.
std::string takeParquet(const ForeignMap& map, const ForeignRecording& recording, PoseTaker& poses) {
  const std::vector<std::string> columns = tableColumns(map);
  std::vector<std::string> read = columns;
  if (recording.episode) {
    read.push_back(kEpisodeColumn);
  }
  ParquetTable table(recording.file, recording.name, read);
  if (const std::string stated = map.timeColumn.empty() ? "" : table.timeUnit(0);
      !stated.empty() && stated != map.timeUnit) {
    refuse(Text::tr("the file says that its times are in %1, and the map says %2", stated, map.timeUnit),
           recording.name + ", " + map.timeColumn, Text::tr("Write the unit of the file into the map"));
  }
  const std::unique_ptr<ForeignCells> rows = foreignCells(map, recording.name);
  ForeignRow row;
  (void)rows->readCells({columns.begin(), columns.end()}, 0, row);
  std::vector<std::string> cells;
  const std::string episode = recording.episode ? std::to_string(*recording.episode) : std::string();
  bool found = !recording.episode;
  for (std::size_t number = 1; table.next(cells); ++number) {
    if (recording.episode && cells.back() != episode) {
      continue;
    }
    found = true;
    if (rows->readCells({cells.begin(), cells.begin() + std::ssize(columns)}, number, row)) {
      poses(row, number);
    }
  }
  if (!found) {
    refuse(Text::tr("the file has no episode %1", episode), recording.name,
           Text::tr("Check the numbers in its column %1", kEpisodeColumn));
  }
  HashedLines whole(recording.file);
  std::string_view line;
  while (whole.next(line)) {
  }
  return whole.hash();
}

}  // namespace

ForeignFile readForeignMotion(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
                              const std::function<void(const ForeignPose&, std::size_t line)>& take) {
  PoseTaker poses(map, recording, take);
  const std::string hash = layout == ForeignLayout::kParquet ? takeParquet(map, recording, poses)
                                                             : takeLines(map, layout, recording, poses);
  return poses.finish(hash);
}

}  // namespace torsio
