// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/connectors/foreign/foreign_samples.h"

#include <array>
#include <iomanip>
#include <numbers>
#include <sstream>

#include <nlohmann/json.hpp>

#include "sim/core/file_io.h"

namespace torsio {

namespace {

constexpr double kJawOpen = 1.2;
constexpr double kJawClosed = -0.3;

std::array<double, 9> rowsOf(const Quat& q) {
  const Vec3 x = rotate(q, {1.0, 0.0, 0.0});
  const Vec3 y = rotate(q, {0.0, 1.0, 0.0});
  const Vec3 z = rotate(q, {0.0, 0.0, 1.0});
  return {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
}

double jawReading(std::size_t line) {
  return kJawOpen + (kJawClosed - kJawOpen) * foreignJaw(line);
}

std::ostringstream exactStream() {
  std::ostringstream out;
  out << std::setprecision(17);
  return out;
}

}  // namespace

Pose foreignPose(std::size_t line) {
  const double share = static_cast<double>(line) / static_cast<double>(kForeignLines - 1);
  return {{0.1 + 0.2 * share, -0.05, 0.3}, axisAngle({0.0, 0.0, 1.0}, 0.5 * std::numbers::pi * share)};
}

double foreignJaw(std::size_t line) {
  return static_cast<double>(line) / static_cast<double>(kForeignLines - 1);
}

std::string jigsawsText() {
  std::ostringstream out = exactStream();
  for (std::size_t line = 0; line < kForeignLines; ++line) {
    for (int arm = 0; arm < 4; ++arm) {
      const bool moves = arm == 3;
      const Pose pose = moves ? foreignPose(line) : Pose{};
      out << "   " << pose.position_m.x << "  " << pose.position_m.y << "  " << pose.position_m.z;
      for (const double number : rowsOf(pose.orientation)) {
        out << "  " << number;
      }
      out << "  0 0 0  0 0 0  " << (moves ? jawReading(line) : 0.0);
    }
    out << " \n";
  }
  return out.str();
}

std::string rosmaText() {
  std::ostringstream out = exactStream();
  out << "PSM1_position_x, PSM1_position_y, PSM1_position_z, PSM1_orientation_x, PSM1_orientation_y,"
         "PSM1_orientation_z, PSM1_orientation_w, PSM1_joint_position_1, PSM1_gripper, PSM2_position_x\n";
  for (std::size_t line = 0; line < kForeignLines; ++line) {
    const auto [place, turn] = foreignPose(line);
    out << place.x << ", " << place.y << ", " << place.z << ", " << turn.x << ", " << turn.y << "," << turn.z
        << ", " << turn.w << ", 0.5, " << jawReading(line) << ", 7\n";
  }
  return out.str();
}

std::string perkTutorText() {
  std::ostringstream out = exactStream();
  out << "<TransformRecorderLog>\n";
  for (std::size_t line = 0; line < kForeignLines; ++line) {
    const auto [place, turn] = foreignPose(line);
    const std::array<double, 9> m = rowsOf(turn);
    const std::size_t ms = 20 * line + 990;
    const auto stamp = [&](const char* device) {
      out << "  <log TimeStampSec=\"" << 1'000 + ms / 1'000 << "\" TimeStampNSec=\"" << ms % 1'000 * 1'000'000
          << "\" type=\"transform\" DeviceName=\"" << device << "\" transform=\"";
    };
    stamp("Needle");
    out << m[0] << " " << m[1] << " " << m[2] << " " << 1e3 * place.x << " " << m[3] << " " << m[4] << " "
        << m[5] << " " << 1e3 * place.y << " " << m[6] << " " << m[7] << " " << m[8] << " " << 1e3 * place.z
        << " 0 0 0 1 \" />\n";
    stamp("Probe");
    out << "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\" />\n";
  }
  out << "  <log TimeStampSec=\"1009\" TimeStampNSec=\"0\" type=\"message\" message=\"end\" />\n"
         "</TransformRecorderLog>\n";
  return out.str();
}

std::string foreignCsv() {
  std::ostringstream out = exactStream();
  out << "t_ms,x,y,z,qw,qx,qy,qz,jaw\r\n";
  for (std::size_t line = 0; line < kForeignLines; ++line) {
    const auto [place, turn] = foreignPose(line);
    out << 500 + 20 * line << "," << place.x << "," << place.y << "," << place.z << "," << turn.w << ","
        << turn.x << "," << turn.y << "," << turn.z << "," << jawReading(line) << "\r\n";
  }
  return out.str();
}

std::filesystem::path writeForeignStudy(const std::filesystem::path& folder, const std::string& layout,
                                        bool marks) {
  nlohmann::ordered_json map = {
      {"cohort", "Suturing elsewhere"},
      {"source", "made for a test, CC0-1.0"},
      {"frame", "base of the robot, right-handed, z up"},
      {"unit", layout == "perktutor" ? "mm" : "m"},
      {"groups", {{{"code", "N"}, {"label", "novices"}}, {{"code", "E"}, {"label", "experts"}}}},
      {"people", {{{"name", "B"}, {"group", "N"}, {"level", "novice"}}, {{"name", "C"}, {"group", "E"}}}}};
  std::string text;
  if (layout == "csv" || layout == "parquet") {  // in Parquet the caller writes the recordings
    text = foreignCsv();
    map["time"] = {{"column", "t_ms"}, {"unit", "ms"}};
    map["position"] = {"x", "y", "z"};
    map["rotation"] = "quaternion wxyz";
    map["rotation_columns"] = {"qw", "qx", "qy", "qz"};
    map["grip"] = {{"column", "jaw"}, {"open", kJawOpen}, {"closed", kJawClosed}};
  } else if (layout == "jigsaws") {
    text = jigsawsText();
    map["rate_Hz"] = kForeignRate_Hz;
    map["instrument"] = "slave right";
    map["rotation"] = "matrix rows";
    map["grip"] = {{"open", kJawOpen}, {"closed", kJawClosed}};
  } else if (layout == "rosma") {
    text = rosmaText();
    map["rate_Hz"] = kForeignRate_Hz;
    map["instrument"] = "PSM1";
    map["rotation"] = "quaternion xyzw";
    map["grip"] = {{"open", kJawOpen}, {"closed", kJawClosed}};
  } else {
    text = perkTutorText();
    map["instrument"] = "Needle";
    map["rotation"] = "matrix rows";
  }
  std::string table = "recording,rater,score\n";
  for (const char* person : {"B", "C"}) {
    for (const char* trial : {"1", "2"}) {
      const std::string name = "S_" + std::string(person) + trial + ".txt";
      writeFileAtomically(folder / name, text);
      map["recordings"].push_back({{"file", name},
                                   {"person", person},
                                   {"task", "suturing"},
                                   {"phase", "trial " + std::string(trial)},
                                   {"occasion", "trial " + std::string(trial)},
                                   {"started", "2020-03-0" + std::string(trial) + "T09:30:00Z"}});
      for (const char* rater : {"GRS 1", "GRS 2"}) {
        const int score = 10 + (*person == 'C' ? 9 : 0) + (*trial - '0') + (rater[4] - '0');
        table += name + "," + rater + "," + std::to_string(score) + "\n";
      }
    }
  }
  if (marks) {
    writeFileAtomically(folder / "marks.csv", table);
    map["raters"] = {{{"name", "GRS 1"}, {"class", "chief"}}, {{"name", "GRS 2"}, {"class", "chief"}}};
    map["marks"] = {{"table", "marks.csv"}, {"lowest", 6}, {"highest", 30}, {"steps_per_point", 1}};
  }
  writeFileAtomically(folder / "map.json", map.dump(2));
  return folder / "map.json";
}

}  // namespace torsio
