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
/// take a parameter called what, why, remedy, problem or sentence. Folders: sim, db, assessment, app/session,
/// app/report and app/gui.
[[nodiscard]] ServiceTexts readServiceTexts(const std::filesystem::path& root);

/// The same for one source.
void readServiceTexts(const std::string& source, const std::string& file, ServiceTexts& texts);

}  // namespace torsio
