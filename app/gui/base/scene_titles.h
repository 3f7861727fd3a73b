// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <QString>

namespace torsio::gui {

/// Titles of scenes and patterns in the present language, from a folder of assets, for lists. A centre's own
/// titles are not translated; scenes not in the folder (recordings from elsewhere) are named by their
/// formatted ids. Reads each file once. GUI thread.
class SceneTitles {
 public:
  explicit SceneTitles(std::filesystem::path assets);

  /// Returns the title of a scene.
  [[nodiscard]] QString scene(const std::string& id);
  /// Returns the title of a scene's pattern.
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
