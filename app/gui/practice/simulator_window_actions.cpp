// SPDX-License-Identifier: GPL-3.0-or-later
// Menus, tool bar and their keys.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/practice/simulator_window.h"
#include "app/gui/widgets/icons.h"

namespace torsio::gui {

QAction* SimulatorWindow::addKeyed(const QKeySequence& keys) {
  auto* action = new QAction(this);
  action->setShortcut(keys);
  addAction(action);
  return action;
}

void SimulatorWindow::name(QAction* action, const QString& text, const QString& tip) {
  action->setText(text);
  action->setStatusTip(tip);
  const QKeySequence keys = action->shortcut();
  action->setToolTip(keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
}

void SimulatorWindow::nameActions() {
  const Actions& a = actions_;
  name(a.open, tr("Open organ\u2026"), tr("Use your own mesh instead of a shipped organ"));
  name(a.bring, tr("Import an organ\u2026"),
       tr("Make an organ from your own mesh or scan: view it, check it, save it"));
  name(a.instrument, tr("Instrument\u2026"),
       tr("Show your own instrument; the force felt remains that of the exercise"));
  name(a.picture, tr("Picture\u2026"), tr("Save the scene as a PNG picture"));
  name(a.strip, tr("Film strip\u2026"),
       tr("Save the twist at 0, 30, 60 \u2026 degrees, or the recording that is replayed, as one picture"));
  name(a.record, tr("Record"), tr("Restart the exercise and record it"));
  name(a.replay, tr("Replay\u2026"), tr("Look at a recorded run again"));
  name(a.compare, tr("Compare models"),
       tr("Twist this organ by the twist model, finite elements and springs under one torque"));
  name(a.release, tr("Release"), tr("Release the tissue; it returns to rest"));
  name(a.restart, tr("Restart exercise"), tr("Start the exercise again"));
  name(a.front, tr("Front"), tr("Look from the front"));
  name(a.side, tr("Side"), tr("Look from the patient's left side"));
  name(a.top, tr("Top"), tr("Look from the head"));
  name(a.whole, tr("Whole organ"), tr("Show the whole organ"));
  name(a.lattice, tr("Lattice"), tr("Show ridges and sections on the tissue"));
  name(a.wireframe, tr("Wireframe"), tr("Show the edges of the surface"));
  name(a.shear, tr("Shear stress"), tr("Colour the tissue by its shear stress"));
  name(a.markers, tr("Markers"), tr("Show the marker points of the organ"));
  name(a.ghost, tr("Target pose"), tr("Show the pose to reach as a film over the organ"));
  name(a.keys, tr("Keys\u2026"), tr("Assign the movements of the instrument to other keys"));
  name(a.help, tr("Controls"), tr("How mouse and keys move the instrument"));
  name(a.automatic, tr("Automatic"), tr("As fine as this computer can draw smoothly"));
  name(a.fast, tr("Fast"), tr("Fewer effects, more pictures a second"));
  name(a.fine, tr("Fine"), tr("Shadow, ambient occlusion and antialiasing"));
  name(a.best, tr("Best"), tr("The finest shadow and edges; needs a graphics card"));
  menus_.quality->setTitle(tr("Quality"));
  if (setup_.embedded) {
    menus_.more->setText(tr("More"));
    menus_.more->setToolTip(tr("More commands"));
    menus_.more->setAccessibleName(tr("More commands"));
    return;
  }
  name(a.dark, tr("Dark"), tr("Dark colours for a dark room"));
  name(a.full, tr("Full screen"), tr("Fill the whole screen"));
  name(a.quit, tr("Quit"), tr("End the program"));
  name(a.about, tr("About Torsio"), tr("Version and licence"));
  menus_.file->setTitle(tr("&File"));
  menus_.exercise->setTitle(tr("&Exercise"));
  menus_.view->setTitle(tr("&View"));
  menus_.help->setTitle(tr("&Help"));
}

void SimulatorWindow::createActions() {
  Actions& a = actions_;
  a.open = addKeyed(QKeySequence::Open);
  a.bring = addKeyed(QKeySequence());
  a.instrument = addKeyed(QKeySequence());
  a.picture = addKeyed(Qt::CTRL | Qt::SHIFT | Qt::Key_P);
  a.strip = addKeyed(Qt::CTRL | Qt::SHIFT | Qt::Key_F);
  a.record = addKeyed(Qt::CTRL | Qt::Key_R);
  a.replay = addKeyed(Qt::CTRL | Qt::SHIFT | Qt::Key_R);
  a.compare = addKeyed(QKeySequence());
  a.release = addKeyed(Qt::Key_Escape);
  a.restart = addKeyed(QKeySequence::New);
  a.front = addKeyed(Qt::CTRL | Qt::Key_1);
  a.side = addKeyed(Qt::CTRL | Qt::Key_2);
  a.top = addKeyed(Qt::CTRL | Qt::Key_3);
  a.whole = addKeyed(Qt::CTRL | Qt::Key_0);
  a.lattice = addKeyed(Qt::CTRL | Qt::Key_L);
  a.wireframe = addKeyed(Qt::CTRL | Qt::Key_M);
  a.keys = addKeyed(QKeySequence());
  a.help = addKeyed(setup_.embedded ? QKeySequence() : QKeySequence(QKeySequence::HelpContents));
  a.shear = addKeyed(Qt::CTRL | Qt::Key_T);
  a.markers = addKeyed(Qt::CTRL | Qt::Key_K);
  a.ghost = addKeyed(Qt::CTRL | Qt::Key_G);
  for (QAction* action : {a.lattice, a.wireframe, a.shear, a.markers, a.ghost}) {
    action->setCheckable(true);
  }

  connect(a.open, &QAction::triggered, this, &SimulatorWindow::chooseOrganFile);
  connect(a.bring, &QAction::triggered, this, &SimulatorWindow::organWanted);
  connect(a.instrument, &QAction::triggered, this, &SimulatorWindow::chooseInstrument);
  connect(a.picture, &QAction::triggered, this, &SimulatorWindow::choosePicture);
  connect(a.strip, &QAction::triggered, this, &SimulatorWindow::chooseFilmStrip);
  connect(a.record, &QAction::triggered, this, &SimulatorWindow::toggleRecording);
  connect(a.replay, &QAction::triggered, this, &SimulatorWindow::chooseReplay);
  connect(a.compare, &QAction::triggered, this, [this] { Q_EMIT comparisonWanted(controller_->request()); });
  connect(a.release, &QAction::triggered, controller_.get(), &SimulationController::releaseTissue);
  connect(a.restart, &QAction::triggered, this, [this] { controller_->load(controller_->request()); });
  connect(a.front, &QAction::triggered, this, [this] { look(ViewPreset::kFront); });
  connect(a.side, &QAction::triggered, this, [this] { look(ViewPreset::kSide); });
  connect(a.top, &QAction::triggered, this, [this] { look(ViewPreset::kTop); });
  connect(a.whole, &QAction::triggered, this, &SimulatorWindow::lookWhole);
  connect(a.lattice, &QAction::toggled, this, [this](bool on) { view_->setLattice(on); });
  connect(a.wireframe, &QAction::toggled, this, [this](bool on) { view_->setWireframe(on); });
  connect(a.shear, &QAction::toggled, this, [this](bool on) { view_->setShearVisible(on); });
  connect(a.markers, &QAction::toggled, this, [this](bool on) { view_->setMarkersVisible(on); });
  connect(a.ghost, &QAction::toggled, this, &SimulatorWindow::showGhost);
  connect(a.keys, &QAction::triggered, this, &SimulatorWindow::chooseKeys);
  connect(a.help, &QAction::triggered, this, &SimulatorWindow::showHelp);
}

void SimulatorWindow::createMenus() {
  Actions& a = actions_;
  Menus& m = menus_;
  m.quality = new QMenu(this);
  auto* group = new QActionGroup(this);
  const std::pair<QAction**, RenderQuality> choices[] = {{&a.automatic, RenderQuality::kAutomatic},
                                                         {&a.fast, RenderQuality::kFast},
                                                         {&a.fine, RenderQuality::kFine},
                                                         {&a.best, RenderQuality::kBest}};
  for (const auto& [action, value] : choices) {
    *action = m.quality->addAction(QString());
    (*action)->setCheckable(true);
    (*action)->setChecked(value == RenderQuality::kAutomatic);
    group->addAction(*action);
    connect(*action, &QAction::triggered, this, [this, value = value] { view_->setQuality(value); });
  }
  if (setup_.embedded) {
    setMenuWidget(nullptr);
    return;
  }
  createMenuBar();
}

void SimulatorWindow::createMenuBar() {
  Actions& a = actions_;
  Menus& m = menus_;
  a.dark = addKeyed(Qt::CTRL | Qt::Key_D);
  a.dark->setCheckable(true);
  connect(a.dark, &QAction::toggled, this,
          [this](bool on) { setThemeKind(on ? ThemeKind::kDark : ThemeKind::kLight); });
  a.quit = addKeyed(QKeySequence::Quit);
  a.quit->setMenuRole(QAction::QuitRole);
  connect(a.quit, &QAction::triggered, this, &QWidget::close);
  a.full = addKeyed(Qt::Key_F11);
  connect(a.full, &QAction::triggered, this,
          [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  a.about = addKeyed({});
  a.about->setMenuRole(QAction::AboutRole);
  connect(a.about, &QAction::triggered, this, &SimulatorWindow::showAbout);

  m.file = menuBar()->addMenu(QString());
  m.file->addActions({a.open, a.instrument, a.picture, a.strip});
  m.file->addSeparator();
  m.file->addAction(a.quit);
  m.exercise = menuBar()->addMenu(QString());
  m.exercise->addActions({a.restart, a.release});
  m.exercise->addSeparator();
  m.exercise->addActions({a.record, a.replay});
  m.view = menuBar()->addMenu(QString());
  m.view->addActions({a.front, a.side, a.top, a.whole});
  m.view->addSeparator();
  m.view->addActions({a.lattice, a.wireframe, a.shear, a.markers, a.ghost});
  m.view->addSeparator();
  m.view->addMenu(m.quality);
  m.view->addAction(a.dark);
  m.view->addSeparator();
  m.view->addAction(a.full);
  m.help = menuBar()->addMenu(QString());
  m.help->addActions({a.help, a.keys, a.about});
}

void SimulatorWindow::createToolBar() {
  const Actions& a = actions_;
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->setIconSize({20, 20});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto group = [bar](std::initializer_list<QAction*> actions) {
    for (QAction* action : actions) {
      bar->addAction(action);
    }
    bar->addSeparator();
  };
  group({a.record, a.replay, a.release});
  group({a.front, a.side, a.top, a.whole});
  group({a.lattice, a.shear, a.ghost});
  if (setup_.embedded) {
    // Beside a navigation there is less room: the directions are known by their signs.
    for (QAction* action : {a.front, a.side, a.top, a.whole}) {
      if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action))) {
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      }
    }
  }
  bar->addAction(a.picture);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  if (!setup_.embedded) {
    bar->addAction(a.dark);
    return;
  }
  menus_.more = new QToolButton(bar);
  menus_.more->setPopupMode(QToolButton::InstantPopup);
  menus_.more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  menus_.more->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(menus_.more);
  menu->addActions({a.restart, a.open, a.bring, a.instrument, a.compare, a.strip});
  menu->addSeparator();
  menu->addActions({a.wireframe, a.markers});
  menu->addMenu(menus_.quality);
  menu->addSeparator();
  menu->addAction(a.help);
  menu->addAction(a.keys);
  menus_.more->setMenu(menu);
  bar->addWidget(menus_.more);
}

void SimulatorWindow::applyIcons() {
  const Theme& colours = theme(themeKind_);
  const Actions& a = actions_;
  const std::pair<QAction*, const char*> icons[] = {
      {a.open, "open"},       {a.picture, "picture"}, {a.strip, "filmstrip"},     {a.replay, "replay"},
      {a.release, "release"}, {a.front, "front"},     {a.side, "side"},           {a.top, "top"},
      {a.whole, "fit"},       {a.lattice, "lattice"}, {a.wireframe, "wireframe"}, {a.shear, "stress"},
      {a.ghost, "ghost"},     {a.markers, "markers"}, {a.compare, "compare"},     {a.dark, "theme"},
      {a.help, "help"}};
  for (const auto& [action, file] : icons) {
    if (action != nullptr) {
      action->setIcon(icon(QLatin1String(file), colours));
    }
  }
  if (menus_.more != nullptr) {
    menus_.more->setIcon(icon(QStringLiteral("more"), colours));
  }
  const bool recording = controller_->mode() == SimulationController::Mode::kRecording;
  a.record->setIcon(recording ? icon(QStringLiteral("stop"), colours.recording)
                              : icon(QStringLiteral("record"), colours));
}

}  // namespace torsio::gui
