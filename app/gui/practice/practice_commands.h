// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include <QList>
#include <QObject>

#include "app/gui/scene/scene_canvas.h"

class QAction;
class QMainWindow;
class QMenu;
class QToolButton;

namespace torsio::gui {

struct Theme;

/// Commands of free practice.
enum class Command {
  kOpen,
  kBring,
  kInstrument,
  kPicture,
  kStrip,
  kRecord,
  kReplay,
  kCompare,
  kRelease,
  kRestart,
  kFront,
  kSide,
  kTop,
  kWhole,
  kLattice,
  kWireframe,
  kShear,
  kMarkers,
  kGhost,
  kKeys,
  kHelp,
  kAutomatic,
  kFast,
  kFine,
  kBest,
  kDark,
  kFull,
  kQuit,
  kAbout,
};
inline constexpr std::size_t kCommands = static_cast<std::size_t>(Command::kAbout) + 1;

/// The commands of free practice with names, keys and icons, in menus and a tool bar. It executes none of
/// them: connect to the action.
class PracticeCommands : public QObject {
  Q_OBJECT

 public:
  /// `embedded`: in a page of another window, without menu bar and program-wide commands (the last four are
  /// then never triggered).
  PracticeCommands(QMainWindow& window, bool embedded);

  [[nodiscard]] QAction& action(Command command) const noexcept {
    return *actions_[static_cast<std::size_t>(command)];
  }
  void showRecording(bool recording);
  void applyIcons(const Theme& theme);
  void retranslate();

 Q_SIGNALS:
  void qualityChosen(torsio::gui::RenderQuality quality);

 private:
  struct Row;
  [[nodiscard]] static std::array<Row, kCommands> rows();
  [[nodiscard]] QList<QAction*> actions(std::initializer_list<Command> commands) const;
  void createQuality();
  void createMenuBar();
  void createToolBar();

  QMainWindow& window_;
  const bool embedded_;
  bool recording_ = false;
  std::array<QAction*, kCommands> actions_{};
  std::array<QMenu*, 4> menus_{};  // of the menu bar
  QMenu* quality_ = nullptr;
  QToolButton* more_ = nullptr;
};

}  // namespace torsio::gui
