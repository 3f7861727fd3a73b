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

/// Returns whether the command belongs to the enclosing window if embedded.
bool ofTheProgram(Command command) {
  return command >= Command::kDark;
}

}  // namespace

struct PracticeCommands::Row {
  Command command;
  QKeySequence keys;
  const char* icon;  // null if none
  const char* text;
  const char* tip;
  bool checkable = false;
};

std::array<PracticeCommands::Row, kCommands> PracticeCommands::rows() {
  constexpr auto kCtrl = Qt::CTRL;
  const QKeySequence noKeys;
  constexpr auto kCtrlShift = Qt::CTRL | Qt::SHIFT;
  return {{
      {Command::kOpen, QKeySequence::Open, "open", QT_TR_NOOP("Open organ\u2026"),
       QT_TR_NOOP("Use your own mesh instead of a shipped organ")},
      {Command::kBring, noKeys, nullptr, QT_TR_NOOP("Import an organ\u2026"),
       QT_TR_NOOP("Make an organ from your own mesh or scan: view it, check it, save it")},
      {Command::kInstrument, noKeys, nullptr, QT_TR_NOOP("Instrument\u2026"),
       QT_TR_NOOP("Show your own instrument; the force felt remains that of the exercise")},
      {Command::kPicture, kCtrlShift | Qt::Key_P, "picture", QT_TR_NOOP("Picture\u2026"),
       QT_TR_NOOP("Save the scene as a PNG picture")},
      {Command::kStrip, kCtrlShift | Qt::Key_F, "filmstrip", QT_TR_NOOP("Film strip\u2026"),
       QT_TR_NOOP(
           "Save the twist at 0, 30, 60 \u2026 degrees, or the recording that is replayed, as one picture")},
      {Command::kRecord, kCtrl | Qt::Key_R, "record", QT_TR_NOOP("Record"),
       QT_TR_NOOP("Restart the exercise and record it")},
      {Command::kReplay, kCtrlShift | Qt::Key_R, "replay", QT_TR_NOOP("Replay\u2026"),
       QT_TR_NOOP("Look at a recorded run again")},
      {Command::kCompare, noKeys, "compare", QT_TR_NOOP("Compare models"),
       QT_TR_NOOP("Twist this organ by the twist model, finite elements and springs under one torque")},
      {Command::kRelease, Qt::Key_Escape, "release", QT_TR_NOOP("Release"),
       QT_TR_NOOP("Release the tissue; it returns to rest")},
      {Command::kRestart, QKeySequence::New, nullptr, QT_TR_NOOP("Restart exercise"),
       QT_TR_NOOP("Start the exercise again")},
      {Command::kFront, kCtrl | Qt::Key_1, "front", QT_TR_NOOP("Front"), QT_TR_NOOP("Look from the front")},
      {Command::kSide, kCtrl | Qt::Key_2, "side", QT_TR_NOOP("Side"),
       QT_TR_NOOP("Look from the patient's left side")},
      {Command::kTop, kCtrl | Qt::Key_3, "top", QT_TR_NOOP("Top"), QT_TR_NOOP("Look from the head")},
      {Command::kWhole, kCtrl | Qt::Key_0, "fit", QT_TR_NOOP("Whole organ"),
       QT_TR_NOOP("Show the whole organ")},
      {Command::kLattice, kCtrl | Qt::Key_L, "lattice", QT_TR_NOOP("Lattice"),
       QT_TR_NOOP("Show ridges and sections on the tissue"), true},
      {Command::kWireframe, kCtrl | Qt::Key_M, "wireframe", QT_TR_NOOP("Wireframe"),
       QT_TR_NOOP("Show the edges of the surface"), true},
      {Command::kShear, kCtrl | Qt::Key_T, "stress", QT_TR_NOOP("Shear stress"),
       QT_TR_NOOP("Colour the tissue by its shear stress"), true},
      {Command::kMarkers, kCtrl | Qt::Key_K, "markers", QT_TR_NOOP("Markers"),
       QT_TR_NOOP("Show the marker points of the organ"), true},
      {Command::kGhost, kCtrl | Qt::Key_G, "ghost", QT_TR_NOOP("Target pose"),
       QT_TR_NOOP("Show the pose to reach as a film over the organ"), true},
      {Command::kKeys, noKeys, nullptr, QT_TR_NOOP("Keys\u2026"),
       QT_TR_NOOP("Assign the movements of the instrument to other keys")},
      {Command::kHelp, QKeySequence::HelpContents, "help", QT_TR_NOOP("Controls"),
       QT_TR_NOOP("How mouse and keys move the instrument")},
      {Command::kAutomatic, noKeys, nullptr, QT_TR_NOOP("Automatic"),
       QT_TR_NOOP("As fine as this computer can draw smoothly"), true},
      {Command::kFast, noKeys, nullptr, QT_TR_NOOP("Fast"),
       QT_TR_NOOP("Fewer effects, more pictures a second"), true},
      {Command::kFine, noKeys, nullptr, QT_TR_NOOP("Fine"),
       QT_TR_NOOP("Shadow, ambient occlusion and antialiasing"), true},
      {Command::kBest, noKeys, nullptr, QT_TR_NOOP("Best"),
       QT_TR_NOOP("The finest shadow and edges; needs a graphics card"), true},
      {Command::kDark, kCtrl | Qt::Key_D, "theme", QT_TR_NOOP("Dark"),
       QT_TR_NOOP("Dark colours for a dark room"), true},
      {Command::kFull, Qt::Key_F11, nullptr, QT_TR_NOOP("Full screen"), QT_TR_NOOP("Fill the whole screen")},
      {Command::kQuit, QKeySequence::Quit, nullptr, QT_TR_NOOP("Quit"), QT_TR_NOOP("End the program")},
      {Command::kAbout, noKeys, nullptr, QT_TR_NOOP("About Torsio"), QT_TR_NOOP("Version and licence")},
  }};
}

PracticeCommands::PracticeCommands(QMainWindow& window, bool embedded)
    : QObject(&window), window_(window), embedded_(embedded) {
  for (const Row& row : rows()) {
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
  // Beside a navigation there is less room: the directions only show their icons.
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
  for (const Row& row : rows()) {
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
  for (const Row& row : rows()) {
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
