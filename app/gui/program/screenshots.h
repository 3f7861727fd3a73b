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
  QString only;  ///< a part of the name; empty: all
  ProgressCallback progress;
  /// Called with each screen as it stands instead of writing a picture; empty: pictures are written.
  std::function<void(const QString& name, QWidget& window)> look;
};

/// Pictures of every screen of the program on the demonstration cohort, and an index.html that shows them.
/// The record lies in a temporary folder and is gone afterwards. On a display without OpenGL the scene is
/// replaced by a sentence. Returns how many pictures were written. Throws Error.
int takeAllScreenshots(const ScreenshotsRequest& request);

/// Takes them in an application of its own and says on standard output how many there are.
void runScreenshots(ScreenshotsRequest request);

}  // namespace torsio::gui
