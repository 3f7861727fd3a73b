// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace torsio {

/// A sentence that is put together with `+` where it should have places (`Text("... %1", x)`).
struct GluedText {
  std::string file;
  int line = 0;
  std::string literal;
};

/// What the sources below `root` say through Text and Error.
struct ServiceTexts {
  std::set<std::string> patterns;
  std::vector<GluedText> glued;
};

/// Reads the literals that stand in calls of Error, DbError and Text, and of functions of the same file that
/// take a parameter called what, why, remedy, problem or sentence; what the sections of the cohort report
/// write into its titles, columns, notes and other members that hold texts; the reasons why a statistic is
/// not defined; and the titles, labels, meanings and descriptions of the curricula and rubrics that are
/// shipped. Numerical parts of the simulator are left out, and the refusals of the statistics: they are told
/// by their ErrorCode, the sentence is in the details.
[[nodiscard]] ServiceTexts readServiceTexts(const std::filesystem::path& root);

/// Reads the texts of one source, and of one file of assets.
void readServiceTexts(const std::string& source, const std::string& file, ServiceTexts& texts);
void readAssetTexts(const std::string& json, ServiceTexts& texts);

}  // namespace torsio
