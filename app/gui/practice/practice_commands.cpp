// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/practice_commands.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

#define TORSIO_COMMAND(text) QT_TRANSLATE_NOOP("torsio::gui::PracticeCommands", text)

struct CommandRow {
  Command command;
  QKeySequence keys;
  const char* icon;  // null: none
  const char* text;
  const char* tip;
  bool checkable = false;
};

std::array<CommandRow, kCommands> commandRows() {
  constexpr auto kCtrl = Qt::CTRL;
  constexpr auto kCtrlShift = Qt::CTRL | Qt::SHIFT;
  return {{
      {Command::kOpen, QKeySequence::Open, "open", TORSIO_COMMAND("Open organ\u2026"),
       TORSIO_COMMAND("Use your own mesh instead of a shipped organ")},
      {Command::kBring,
       {},
       nullptr,
       TORSIO_COMMAND("Import an organ\u2026"),
       TORSIO_COMMAND("Make an organ from your own mesh or scan: view it, check it, save it")},
      {Command::kInstrument,
       {},
       nullptr,
       TORSIO_COMMAND("Instrument\u2026"),
       TORSIO_COMMAND("Show your own instrument; the force felt remains that of the exercise")},
      {Command::kPicture, kCtrlShift | Qt::Key_P, "picture", TORSIO_COMMAND("Picture\u2026"),
       TORSIO_COMMAND("Save the scene as a PNG picture")},
      {Command::kStrip, kCtrlShift | Qt::Key_F, "filmstrip", TORSIO_COMMAND("Film strip\u2026"),
       TORSIO_COMMAND(
           "Save the twist at 0, 30, 60 \u2026 degrees, or the recording that is replayed, as one picture")},
      {Command::kRecord, kCtrl | Qt::Key_R, "record", TORSIO_COMMAND("Record"),
       TORSIO_COMMAND("Restart the exercise and record it")},
      {Command::kReplay, kCtrlShift | Qt::Key_R, "replay", TORSIO_COMMAND("Replay\u2026"),
       TORSIO_COMMAND("Look at a recorded run again")},
      {Command::kCompare,
       {},
       "compare",
       TORSIO_COMMAND("Compare models"),
       TORSIO_COMMAND("Twist this organ by the twist model, finite elements and springs under one torque")},
      {Command::kRelease, Qt::Key_Escape, "release", TORSIO_COMMAND("Release"),
       TORSIO_COMMAND("Release the tissue; it returns to rest")},
      {Command::kRestart, QKeySequence::New, nullptr, TORSIO_COMMAND("Restart exercise"),
       TORSIO_COMMAND("Start the exercise again")},
      {Command::kFront, kCtrl | Qt::Key_1, "front", TORSIO_COMMAND("Front"),
       TORSIO_COMMAND("Look from the front")},
      {Command::kSide, kCtrl | Qt::Key_2, "side", TORSIO_COMMAND("Side"),
       TORSIO_COMMAND("Look from the patient's left side")},
      {Command::kTop, kCtrl | Qt::Key_3, "top", TORSIO_COMMAND("Top"), TORSIO_COMMAND("Look from the head")},
      {Command::kWhole, kCtrl | Qt::Key_0, "fit", TORSIO_COMMAND("Whole organ"),
       TORSIO_COMMAND("Show the whole organ")},
      {Command::kLattice, kCtrl | Qt::Key_L, "lattice", TORSIO_COMMAND("Lattice"),
       TORSIO_COMMAND("Show ridges and sections on the tissue"), true},
      {Command::kWireframe, kCtrl | Qt::Key_M, "wireframe", TORSIO_COMMAND("Wireframe"),
       TORSIO_COMMAND("Show the edges of the surface"), true},
      {Command::kShear, kCtrl | Qt::Key_T, "stress", TORSIO_COMMAND("Shear stress"),
       TORSIO_COMMAND("Colour the tissue by its shear stress"), true},
      {Command::kMarkers, kCtrl | Qt::Key_K, "markers", TORSIO_COMMAND("Markers"),
       TORSIO_COMMAND("Show the marker points of the organ"), true},
      {Command::kGhost, kCtrl | Qt::Key_G, "ghost", TORSIO_COMMAND("Target pose"),
       TORSIO_COMMAND("Show the pose to reach as a film over the organ"), true},
      {Command::kKeys,
       {},
       nullptr,
       TORSIO_COMMAND("Keys\u2026"),
       TORSIO_COMMAND("Assign the movements of the instrument to other keys")},
      {Command::kHelp, QKeySequence::HelpContents, "help", TORSIO_COMMAND("Controls"),
       TORSIO_COMMAND("How mouse and keys move the instrument")},
      {Command::kAutomatic,
       {},
       nullptr,
       TORSIO_COMMAND("Automatic"),
       TORSIO_COMMAND("As fine as this computer can draw smoothly"),
       true},
      {Command::kFast,
       {},
       nullptr,
       TORSIO_COMMAND("Fast"),
       TORSIO_COMMAND("Fewer effects, more pictures a second"),
       true},
      {Command::kFine,
       {},
       nullptr,
       TORSIO_COMMAND("Fine"),
       TORSIO_COMMAND("Shadow, ambient occlusion and antialiasing"),
       true},
      {Command::kBest,
       {},
       nullptr,
       TORSIO_COMMAND("Best"),
       TORSIO_COMMAND("The finest shadow and edges; needs a graphics card"),
       true},
      {Command::kDark, kCtrl | Qt::Key_D, "theme", TORSIO_COMMAND("Dark"),
       TORSIO_COMMAND("Dark colours for a dark room"), true},
      {Command::kFull, Qt::Key_F11, nullptr, TORSIO_COMMAND("Full screen"),
       TORSIO_COMMAND("Fill the whole screen")},
      {Command::kQuit, QKeySequence::Quit, nullptr, TORSIO_COMMAND("Quit"),
       TORSIO_COMMAND("End the program")},
      {Command::kAbout, {}, nullptr, TORSIO_COMMAND("About Torsio"), TORSIO_COMMAND("Version and licence")},
  }};
}

#undef TORSIO_COMMAND

/// Not in a window that is a part of another: that one has them.
bool ofTheProgram(Command command) {
  return command >= Command::kDark;
}

}  // namespace

PracticeCommands::PracticeCommands(QMainWindow& window, bool embedded)
    : QObject(&window), window_(window), embedded_(embedded) {
  for (const CommandRow& row : commandRows()) {
    auto* made = new QAction(&window);
    made->setCheckable(row.checkable);
    actions_[static_cast<std::size_t>(row.command)] = made;
    if (!embedded || !(ofTheProgram(row.command) || row.command == Command::kHelp)) {
      made->setShortcut(row.keys);
    }
    if (!embedded || !ofTheProgram(row.command)) {
      window.addAction(made);
    }
  }
  createQuality();
  if (embedded) {
    window.setMenuWidget(nullptr);
  } else {
    createMenuBar();
  }
  createToolBar();
}

QList<QAction*> PracticeCommands::actions(std::initializer_list<Command> commands) const {
  QList<QAction*> all;
  for (const Command command : commands) {
    all << &action(command);
  }
  return all;
}

void PracticeCommands::createQuality() {
  quality_ = new QMenu(&window_);
  auto* group = new QActionGroup(this);
  const std::pair<Command, RenderQuality> choices[] = {{Command::kAutomatic, RenderQuality::kAutomatic},
                                                       {Command::kFast, RenderQuality::kFast},
                                                       {Command::kFine, RenderQuality::kFine},
                                                       {Command::kBest, RenderQuality::kBest}};
  for (const auto& [command, value] : choices) {
    quality_->addAction(&action(command));
    group->addAction(&action(command));
    connect(&action(command), &QAction::triggered, this,
            [this, value = value] { Q_EMIT qualityChosen(value); });
  }
  action(Command::kAutomatic).setChecked(true);
}

void PracticeCommands::createMenuBar() {
  for (QMenu*& menu : menus_) {
    menu = window_.menuBar()->addMenu(QString());
  }
  auto& [file, exercise, view, help] = menus_;
  file->addActions(actions({Command::kOpen, Command::kInstrument, Command::kPicture, Command::kStrip}));
  file->addSeparator();
  file->addAction(&action(Command::kQuit));
  exercise->addActions(actions({Command::kRestart, Command::kRelease}));
  exercise->addSeparator();
  exercise->addActions(actions({Command::kRecord, Command::kReplay}));
  view->addActions(actions({Command::kFront, Command::kSide, Command::kTop, Command::kWhole}));
  view->addSeparator();
  view->addActions(
      actions({Command::kLattice, Command::kWireframe, Command::kShear, Command::kMarkers, Command::kGhost}));
  view->addSeparator();
  view->addMenu(quality_);
  view->addAction(&action(Command::kDark));
  view->addSeparator();
  view->addAction(&action(Command::kFull));
  help->addActions(actions({Command::kHelp, Command::kKeys, Command::kAbout}));
  action(Command::kQuit).setMenuRole(QAction::QuitRole);
  action(Command::kAbout).setMenuRole(QAction::AboutRole);
}

void PracticeCommands::createToolBar() {
  QToolBar* bar = window_.addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->setIconSize({20, 20});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const QList<QAction*> directions =
      actions({Command::kFront, Command::kSide, Command::kTop, Command::kWhole});
  for (const QList<QAction*>& group :
       {actions({Command::kRecord, Command::kReplay, Command::kRelease}), directions,
        actions({Command::kLattice, Command::kShear, Command::kGhost})}) {
    bar->addActions(group);
    bar->addSeparator();
  }
  bar->addAction(&action(Command::kPicture));
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  if (!embedded_) {
    bar->addAction(&action(Command::kDark));
    return;
  }
  // Beside a navigation there is less room: the directions are known by their signs.
  for (QAction* direction : directions) {
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(direction))) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
  }
  more_ = new QToolButton(bar);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more_->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(more_);
  menu->addActions(actions({Command::kRestart, Command::kOpen, Command::kBring, Command::kInstrument,
                            Command::kCompare, Command::kStrip}));
  menu->addSeparator();
  menu->addActions(actions({Command::kWireframe, Command::kMarkers}));
  menu->addMenu(quality_);
  menu->addSeparator();
  menu->addActions(actions({Command::kHelp, Command::kKeys}));
  more_->setMenu(menu);
  bar->addWidget(more_);
}

void PracticeCommands::showRecording(bool recording) {
  recording_ = recording;
  action(Command::kRecord).setText(recording ? tr("Stop") : tr("Record"));
}

void PracticeCommands::applyIcons(const Theme& theme) {
  for (const CommandRow& row : commandRows()) {
    if (row.icon != nullptr) {
      action(row.command).setIcon(icon(QLatin1String(row.icon), theme));
    }
  }
  if (more_ != nullptr) {
    more_->setIcon(icon(QStringLiteral("more"), theme));
  }
  if (recording_) {
    action(Command::kRecord).setIcon(icon(QStringLiteral("stop"), theme.recording));
  }
}

void PracticeCommands::retranslate() {
  for (const CommandRow& row : commandRows()) {
    QAction& named = action(row.command);
    const QString tip = tr(row.tip);
    named.setText(tr(row.text));
    named.setStatusTip(tip);
    named.setToolTip(named.shortcut().isEmpty()
                         ? tip
                         : tr("%1 (%2)").arg(tip, named.shortcut().toString(QKeySequence::NativeText)));
  }
  showRecording(recording_);
  quality_->setTitle(tr("Quality"));
  if (embedded_) {
    more_->setText(tr("More"));
    more_->setToolTip(tr("More commands"));
    more_->setAccessibleName(tr("More commands"));
    return;
  }
  auto& [file, exercise, view, help] = menus_;
  file->setTitle(tr("&File"));
  exercise->setTitle(tr("&Exercise"));
  view->setTitle(tr("&View"));
  help->setTitle(tr("&Help"));
}

}  // namespace torsio::gui
