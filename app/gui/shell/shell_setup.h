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
#include "sim/core/text.h"

namespace torsio::gui {

/// Configuration of the program's window.
struct ShellSetup {
  std::filesystem::path assets;
  std::string station;
  QString locator;   ///< of the database; overridden by the station's choice, unless it is set
  Text recordSetBy;  ///< file and line that set the database for this computer; empty: the station chooses
  std::function<std::vector<PageGroup>()> groups = [] { return std::vector<PageGroup>(); };
  std::optional<ThemeKind> theme;  ///< from the command line; empty: the user's, else the role's
  bool systemIsDark = false;
  bool kiosk = false;
  bool remember = true;
  std::optional<IdleLimits> idle;  ///< empty: the centre's
  const Clock* clock = nullptr;    ///< of the idle lock; null: the system's
  PasswordCost passwordCost = PasswordCost::kFull;
  LinePatience linePatience;
  /// Fills a record with simulated people; empty: the paper's protocol demonstration.
  std::function<std::vector<StartAccount>(SessionContext&, const ProgressCallback&)> simulatedPeople;
  std::chrono::milliseconds lessonsAgain = std::chrono::minutes(1);  ///< between checks of the outbox
  std::filesystem::path unstored;  ///< recordings waiting for their database; empty: unstoredFolder()
};

}  // namespace torsio::gui
