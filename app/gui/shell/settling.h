// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QObject>

#include "app/gui/base/background.h"
#include "sim/core/text.h"

namespace torsio::gui {

class OpenRecord;
class ShellContext;
struct ShellSetup;

/// Stores the recordings of this station that wait in files: at the start and after a database outage. GUI
/// thread.
class Settling : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  Settling(Background& background, const OpenRecord& record, const ShellSetup& setup, QObject* parent);

  /// Can take long; until ended() nobody may sign in. The first time, also closes files readable by others.
  void begin();
  /// Stores what was kept during a database outage.
  void again();
  /// Shows the recordings that could not be stored, once.
  void tellKept(ShellContext& shell);

 Q_SIGNALS:
  /// begin() is done. `said`: sentence for the sign-in; may be empty.
  void ended(const QString& said, bool trouble);
  /// again() has stored recordings.
  void stored();
  /// Whether again() must be called once more.
  void dueChanged(bool due);

 private:
  [[nodiscard]] std::filesystem::path folder() const;

  Background& background_;
  const OpenRecord& record_;
  const ShellSetup& setup_;
  bool filesClosed_ = false;  ///< files readable by others have been searched since the start
  std::vector<Text> kept_;    ///< recordings that could not be stored; shown until somebody signs in
};

}  // namespace torsio::gui
