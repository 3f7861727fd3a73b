// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <QString>

namespace torsio::gui {

/// Titles of scenes and of their patterns, as their files in a folder of assets say them, in the present
/// language: what a list shows in place of an id. A title of a centre's own stays as it is; what the folder
/// lacks (a recording from elsewhere) is named by its id, made readable. Each file is read once. GUI thread.
class SceneTitles {
 public:
  explicit SceneTitles(std::filesystem::path assets);

  /// Returns the title of the scene with this id.
  [[nodiscard]] QString scene(const std::string& id);
  /// Returns the title of a pattern of the scene with this id.
  [[nodiscard]] QString pattern(const std::string& sceneId, const std::string& patternId);

 private:
  struct English {
    std::string title;
    std::map<std::string, std::string> patterns;  // title by id
  };
  const English& of(const std::string& sceneId);

  std::filesystem::path assets_;
  std::map<std::string, English> read_;
};

}  // namespace torsio::gui
