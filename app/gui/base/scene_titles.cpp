// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/scene_titles.h"

#include <utility>

#include "app/gui/base/translated_text.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {

namespace {

/// Formats an id for display: "small_bowel" becomes "Small bowel".
QString readable(const std::string& id) {
  QString text = toQString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  return text;
}

QString titleOrId(const std::string& title, const std::string& id) {
  return title.empty() ? readable(id) : toQString(Text(title));
}

}  // namespace

SceneTitles::SceneTitles(std::filesystem::path assets) : assets_(std::move(assets)) {}

const SceneTitles::English& SceneTitles::of(const std::string& sceneId) {
  const auto [known, isNew] = read_.try_emplace(sceneId);
  if (isNew) {
    try {
      const SceneDescription file = readSceneFile(assets_, sceneId);
      known->second.title = file.title;
      for (const PatternDescription& one : file.patterns) {
        known->second.patterns[one.pattern.id] = one.pattern.title;
      }
    } catch (const Error&) {
      // A scene of another installation or an unfinished file: shows the id.
    }
  }
  return known->second;
}

QString SceneTitles::scene(const std::string& id) {
  return titleOrId(of(id).title, id);
}

QString SceneTitles::pattern(const std::string& sceneId, const std::string& patternId) {
  const std::map<std::string, std::string>& patterns = of(sceneId).patterns;
  const auto found = patterns.find(patternId);
  return titleOrId(found == patterns.end() ? std::string() : found->second, patternId);
}

}  // namespace torsio::gui
