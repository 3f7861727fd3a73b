// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "sim/core/pose.h"

namespace torsio::testing {

inline constexpr double kForeignRate_Hz = 50.0;
inline constexpr std::size_t kForeignLines = 201;  ///< four seconds

/// The motion that every sample file holds: a quarter of a turn about z while the tip goes 0.2 m along x at
/// an even speed; the jaw closes.
[[nodiscard]] Pose foreignPose(std::size_t line);
[[nodiscard]] double foreignJaw(std::size_t line);  ///< 0 open .. 1 closed

/// The motion in the form of each layout, metres: files of their own making, of nobody's data.
[[nodiscard]] std::string jigsawsText();    ///< of the arm "slave right"; the others stand still
[[nodiscard]] std::string rosmaText();      ///< of PSM1 and of the jaw of MTML, header with blanks
[[nodiscard]] std::string perkTutorText();  ///< millimetres; device "Needle" among another and a message
[[nodiscard]] std::string foreignCsv();     ///< t_ms, x, y, z, qw, qx, qy, qz, jaw

/// Two people of two groups with two recordings each as the map of `layout` describes them ("jigsaws",
/// "rosma", "perktutor", "csv"), and marks of two raters where `marks`. Returns the map's file.
std::filesystem::path writeForeignStudy(const std::filesystem::path& folder, const std::string& layout,
                                        bool marks = false);

}  // namespace torsio::testing
