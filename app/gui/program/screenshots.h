// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QSize>
#include <QString>

#include "app/gui/base/language.h"
#include "app/gui/widgets/theme.h"
#include "app/services/base/progress.h"

class QWidget;

namespace torsio::gui {

struct ScreenshotsRequest {
  std::filesystem::path out;
  std::filesystem::path assets;
  std::vector<QSize> sizes;
  std::vector<Language> languages;
  std::vector<ThemeKind> themes;
  QString only;  ///< part of the name; empty: all
  ProgressCallback progress;
  /// Called with each screen instead of writing a picture; empty: pictures are written.
  std::function<void(const QString& name, QWidget& window)> look;
};

/// Takes screenshots of all screens with the demonstration cohort, and writes an index.html for them. Uses a
/// temporary record, deleted afterwards. On a display without OpenGL, a sentence replaces the scene. Returns
/// the number of pictures. Throws Error.
int takeAllScreenshots(const ScreenshotsRequest& request);

/// Takes the screenshots in a separate application object and prints their number.
void runScreenshots(ScreenshotsRequest request);

}  // namespace torsio::gui
