// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "sim/core/pose.h"

namespace torsio {

inline constexpr double kForeignRate_Hz = 50.0;
inline constexpr std::size_t kForeignLines = 201;  ///< four seconds

/// The motion of every sample file: a quarter turn about z while the tip moves 0.2 m along x at constant
/// speed; the jaw closes.
[[nodiscard]] Pose foreignPose(std::size_t line);
[[nodiscard]] double foreignJaw(std::size_t line);  ///< 0 open .. 1 closed

/// The motion in the format of each layout, in metres: synthetic files without real data.
[[nodiscard]] std::string jigsawsText();    ///< of the arm "slave right"; the others do not move
[[nodiscard]] std::string rosmaText();      ///< of PSM1 and of the jaw of MTML, header with spaces
[[nodiscard]] std::string perkTutorText();  ///< millimetres; device "Needle" with another device and a
                                            ///< message
[[nodiscard]] std::string foreignCsv();     ///< t_ms, x, y, z, qw, qx, qy, qz, jaw

/// Writes two people in two groups with two recordings each as described by the map of `layout` ("jigsaws",
/// "rosma", "perktutor", "csv", "parquet"), and marks of two raters if `marks`. Returns the map file.
std::filesystem::path writeForeignStudy(const std::filesystem::path& folder, const std::string& layout,
                                        bool marks = false);

}  // namespace torsio
