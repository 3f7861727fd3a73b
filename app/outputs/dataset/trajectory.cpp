// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/trajectory.h"

#include <array>
#include <functional>
#include <ostream>
#include <utility>

#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/device_sample.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/time_units.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

struct Line {
  const Sample& sample;
  ToolState tool;
};

struct StoredChannel {
  ExportColumn column;
  std::function<double(const Line&)> value;

  /// Returns whether other equipment also records this column: instrument path and jaw.
  [[nodiscard]] bool isMotion() const {
    return column.name == "time_s" || column.name == "grip" || column.name.starts_with("tool_");
  }
};

void addVector(std::vector<StoredChannel>& all, const std::string& name, const std::string& unit,
               const std::array<Text, 3>& titles, const std::function<Vec3(const Line&)>& value) {
  const std::string ending = unit == "m" ? "_m" : "_N";
  all.push_back({{name + "_x" + ending, titles[0], ColumnKind::kNumber, unit},
                 [value](const Line& at) { return value(at).x; }});
  all.push_back({{name + "_y" + ending, titles[1], ColumnKind::kNumber, unit},
                 [value](const Line& at) { return value(at).y; }});
  all.push_back({{name + "_z" + ending, titles[2], ColumnKind::kNumber, unit},
                 [value](const Line& at) { return value(at).z; }});
}

std::vector<StoredChannel> makeStoredChannels() {
  const auto number = ColumnKind::kNumber;
  std::vector<StoredChannel> all;
  all.push_back({{"time_s", Text::tr("time since the recording began"), number, "s"}, [](const Line& at) {
                   return static_cast<double>(at.sample.device.time_us) / static_cast<double>(kSecond_us);
                 }});
  addVector(all, "tool", "m",
            {Text::tr("tip of the instrument, x"), Text::tr("tip of the instrument, y"),
             Text::tr("tip of the instrument, z")},
            [](const Line& at) { return at.tool.pose.position_m; });
  all.push_back({{"tool_qw", Text::tr("rotation of the instrument, quaternion, real part"), number},
                 [](const Line& at) { return at.tool.pose.orientation.w; }});
  all.push_back({{"tool_qx", Text::tr("rotation of the instrument, quaternion, x"), number},
                 [](const Line& at) { return at.tool.pose.orientation.x; }});
  all.push_back({{"tool_qy", Text::tr("rotation of the instrument, quaternion, y"), number},
                 [](const Line& at) { return at.tool.pose.orientation.y; }});
  all.push_back({{"tool_qz", Text::tr("rotation of the instrument, quaternion, z"), number},
                 [](const Line& at) { return at.tool.pose.orientation.z; }});
  all.push_back({{"roll_rad", Text::tr("turn about the stylus, unwrapped"), number, "rad"},
                 [](const Line& at) { return at.tool.roll_rad; }});
  all.push_back({{"grip", Text::tr("closure of the jaw, 0 open to 1 closed"), number},
                 [](const Line& at) { return at.tool.grip; }});
  all.push_back({{"twist_deg", Text::tr("twist of the held section"), number, "deg"},
                 [](const Line& at) { return degrees(at.sample.response.angle_rad); }});
  all.push_back({{"torque_Nm", Text::tr("torque that holds the twist"), number, "N m"},
                 [](const Line& at) { return at.sample.response.torque_Nm; }});
  addVector(all, "tissue_force", "N",
            {Text::tr("force of the tissue, x"), Text::tr("force of the tissue, y"),
             Text::tr("force of the tissue, z")},
            [](const Line& at) { return at.sample.response.force_N; });
  addVector(all, "device_force", "N",
            {Text::tr("force commanded to the device, x"), Text::tr("force commanded to the device, y"),
             Text::tr("force commanded to the device, z")},
            [](const Line& at) { return at.sample.force_N; });
  all.push_back({{"stage",
                  Text::tr("stage of the exercise"),
                  number,
                  "",
                  {{0, Text::tr("moves freely")},
                   {1, Text::tr("touches")},
                   {2, Text::tr("holds and twists")},
                   {3, Text::tr("has released")}}},
                 [](const Line& at) { return static_cast<double>(at.sample.phase); }});
  all.push_back({{"contact", Text::tr("contacts, sum of: 1 jaw, 2 shaft, 4 tissue is held"), number},
                 [](const Line& at) { return static_cast<double>(at.sample.contact); }});
  all.push_back({{"device_status", Text::tr("state of the device, 0 is sound"), number},
                 [](const Line& at) { return static_cast<double>(at.tool.status); }});
  return all;
}

const std::vector<StoredChannel>& storedChannels() {
  static const std::vector<StoredChannel> all = makeStoredChannels();
  return all;
}

}  // namespace

const std::vector<ExportColumn>& trajectoryColumns() {
  static const std::vector<ExportColumn> columns = [] {
    std::vector<ExportColumn> made;
    for (const StoredChannel& one : storedChannels()) {
      made.push_back(one.column);
    }
    return made;
  }();
  return columns;
}

namespace {

/// Calls `take` with each row in turn, so that a long recording is never held as a whole.
template <typename Take>
void eachRow(const Trial& trial, std::int64_t every, const Take& take) {
  TORSIO_EXPECTS(every >= 1);
  const bool foreign = isForeign(trial.header.sceneId);
  std::vector<std::optional<double>> row(storedChannels().size());
  for (const TrialChunk& chunk : trial.chunks) {
    for (const Sample& sample : decodeChunk(chunk)) {
      if (sample.tick % every != 0) {
        continue;
      }
      const Line at{sample, toolState(sample.device)};
      for (std::size_t c = 0; c < row.size(); ++c) {
        const StoredChannel& one = storedChannels()[c];
        row[c] = foreign && !one.isMotion() ? std::nullopt : std::optional(one.value(at));
      }
      take(row);
    }
  }
}

}  // namespace

std::vector<std::vector<std::optional<double>>> trajectoryValues(const Trial& trial, std::int64_t every) {
  std::vector<std::vector<std::optional<double>>> columns(storedChannels().size());
  eachRow(trial, every, [&](const std::vector<std::optional<double>>& row) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      columns[c].push_back(row[c]);
    }
  });
  return columns;
}

std::int64_t writeTrajectory(const Trial& trial, std::int64_t every, TrajectoryForm form, std::ostream& out) {
  const bool csv = form == TrajectoryForm::kCsv;
  const char* const between = csv ? "," : "\t";
  const char* const end = csv ? "\r\n" : "\n";
  const char* separator = "";
  if (csv) {
    for (const ExportColumn& column : trajectoryColumns()) {
      out << separator << column.name;
      separator = between;
    }
    out << end;
  }
  std::int64_t lines = 0;
  eachRow(trial, every, [&](const std::vector<std::optional<double>>& row) {
    separator = "";
    for (const std::optional<double>& value : row) {
      out << separator << (value ? formatExact(*value) : csv ? "" : "n/a");
      separator = between;
    }
    out << end;
    ++lines;
  });
  return lines;
}

}  // namespace torsio
