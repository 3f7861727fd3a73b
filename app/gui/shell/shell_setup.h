// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/gui/shell/desk.h"
#include "app/services/access/first_run.h"
#include "app/services/access/idle_guard.h"
#include "app/services/base/progress.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

/// What the program's window needs from outside.
struct ShellSetup {
  std::filesystem::path assets;
  std::string station;
  QString locator;  ///< of the database; the station's choice of the first run overrides it
  std::function<std::vector<PageGroup>()> groups = [] { return std::vector<PageGroup>(); };
  std::optional<ThemeKind> theme;  ///< given on the command line; nothing: the user's, else the role's
  bool systemIsDark = false;
  bool kiosk = false;
  bool remember = true;
  std::optional<IdleLimits> idle;  ///< nothing: those of the centre
  const Clock* clock = nullptr;    ///< of the idle lock; null: the machine's
  PasswordCost passwordCost = PasswordCost::kModerate;
  LinePatience linePatience;
  /// Fills a record with simulated people; empty: the demonstration of the paper's protocol.
  std::function<std::vector<StartAccount>(SessionContext&, const ProgressCallback&)> simulatedPeople;
  std::chrono::milliseconds lessonsAgain = std::chrono::minutes(1);  ///< between two looks into the outbox
  std::filesystem::path unstored;  ///< where recordings wait for their database; empty: unstoredFolder()
};

}  // namespace torsio::gui
