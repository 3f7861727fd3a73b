// SPDX-License-Identifier: GPL-3.0-or-later
// Menus, tool bar and their keys.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "app/gui/look/icons.h"
#include "app/gui/main_window.h"

namespace torsio::gui {

QAction* MainWindow::addNamed(const QString& text, const QString& tip, const QKeySequence& keys) {
  auto* action = new QAction(text, this);
  action->setShortcut(keys);
  action->setStatusTip(tip);
  action->setToolTip(keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
  addAction(action);
  return action;
}

void MainWindow::createActions() {
  Actions& a = actions_;
  a.open = addNamed(tr("Open organ\u2026"), tr("Use a mesh of your own instead of a shipped organ"),
                    QKeySequence::Open);
  a.picture =
      addNamed(tr("Picture\u2026"), tr("Save the scene as a PNG picture"), QKeySequence(tr("Ctrl+Shift+P")));
  a.record = addNamed(tr("Record"), tr("Start the exercise anew and record it"), QKeySequence(tr("Ctrl+R")));
  a.replay =
      addNamed(tr("Replay\u2026"), tr("Look at a recorded trial again"), QKeySequence(tr("Ctrl+Shift+R")));
  a.release =
      addNamed(tr("Release"), tr("Let go of the tissue; it returns to rest"), QKeySequence(Qt::Key_Escape));
  a.restart = addNamed(tr("Restart exercise"), tr("Begin the exercise anew"), QKeySequence::New);
  a.front = addNamed(tr("Front"), tr("Look from the front"), QKeySequence(tr("Ctrl+1")));
  a.side = addNamed(tr("Side"), tr("Look from the patient's left side"), QKeySequence(tr("Ctrl+2")));
  a.top = addNamed(tr("Top"), tr("Look from the head"), QKeySequence(tr("Ctrl+3")));
  a.whole = addNamed(tr("Whole organ"), tr("Show the whole organ"), QKeySequence(tr("Ctrl+0")));
  a.lattice =
      addNamed(tr("Lattice"), tr("Show ridges and sections on the tissue"), QKeySequence(tr("Ctrl+L")));
  a.wireframe = addNamed(tr("Wireframe"), tr("Show the edges of the surface"), QKeySequence(tr("Ctrl+M")));
  a.dark = addNamed(tr("Dark"), tr("Dark colours for a dark room"), QKeySequence(tr("Ctrl+D")));
  a.help = addNamed(tr("Controls"), tr("How mouse and keys move the instrument"), QKeySequence::HelpContents);
  for (QAction* action : {a.lattice, a.wireframe, a.dark}) action->setCheckable(true);

  connect(a.open, &QAction::triggered, this, &MainWindow::chooseOrganFile);
  connect(a.picture, &QAction::triggered, this, &MainWindow::choosePicture);
  connect(a.record, &QAction::triggered, this, &MainWindow::toggleRecording);
  connect(a.replay, &QAction::triggered, this, &MainWindow::chooseReplay);
  connect(a.release, &QAction::triggered, controller_.get(), &SimulationController::releaseTissue);
  connect(a.restart, &QAction::triggered, this, [this] { controller_->load(controller_->request()); });
  connect(a.front, &QAction::triggered, this, [this] { look(ViewPreset::kFront); });
  connect(a.side, &QAction::triggered, this, [this] { look(ViewPreset::kSide); });
  connect(a.top, &QAction::triggered, this, [this] { look(ViewPreset::kTop); });
  connect(a.whole, &QAction::triggered, this, &MainWindow::lookWhole);
  connect(a.lattice, &QAction::toggled, this, [this](bool on) { view_->setLattice(on); });
  connect(a.wireframe, &QAction::toggled, this, [this](bool on) { view_->setWireframe(on); });
  connect(a.dark, &QAction::toggled, this,
          [this](bool on) { setThemeKind(on ? ThemeKind::kDark : ThemeKind::kLight); });
  connect(a.help, &QAction::triggered, this, &MainWindow::showHelp);
}

void MainWindow::createMenus() {
  const Actions& a = actions_;
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(a.open);
  file->addAction(a.picture);
  file->addSeparator();
  QAction* quit = file->addAction(tr("Quit"), QKeySequence::Quit, this, &QWidget::close);
  quit->setMenuRole(QAction::QuitRole);

  QMenu* exercise = menuBar()->addMenu(tr("&Exercise"));
  exercise->addAction(a.restart);
  exercise->addAction(a.release);
  exercise->addSeparator();
  exercise->addAction(a.record);
  exercise->addAction(a.replay);

  QMenu* view = menuBar()->addMenu(tr("&View"));
  for (QAction* action : {a.front, a.side, a.top, a.whole}) view->addAction(action);
  view->addSeparator();
  view->addAction(a.lattice);
  view->addAction(a.wireframe);
  view->addSeparator();
  QMenu* quality = view->addMenu(tr("Quality"));
  auto* group = new QActionGroup(this);
  const std::pair<QString, RenderQuality> choices[] = {{tr("Automatic"), RenderQuality::kAutomatic},
                                                       {tr("Fast"), RenderQuality::kFast},
                                                       {tr("Fine"), RenderQuality::kFine}};
  for (const auto& [name, value] : choices) {
    QAction* action = quality->addAction(name);
    action->setCheckable(true);
    action->setChecked(value == RenderQuality::kAutomatic);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, value = value] { view_->setQuality(value); });
  }
  view->addAction(a.dark);
  view->addSeparator();
  QAction* full = view->addAction(tr("Full screen"), QKeySequence(Qt::Key_F11), this,
                                  [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setStatusTip(tr("Fill the whole screen"));

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(a.help);
  QAction* about = help->addAction(tr("About Torsio"), this, &MainWindow::showAbout);
  about->setMenuRole(QAction::AboutRole);
}

void MainWindow::createToolBar() {
  const Actions& a = actions_;
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->setIconSize({20, 20});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto group = [bar](std::initializer_list<QAction*> actions) {
    for (QAction* action : actions) bar->addAction(action);
    bar->addSeparator();
  };
  group({a.record, a.replay, a.release});
  group({a.front, a.side, a.top, a.whole});
  group({a.lattice, a.wireframe});
  bar->addAction(a.picture);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(a.dark);
}

void MainWindow::applyIcons() {
  const Theme& colours = theme(themeKind_);
  const Actions& a = actions_;
  const std::pair<QAction*, const char*> icons[] = {
      {a.open, "open"},       {a.picture, "picture"},     {a.replay, "replay"}, {a.release, "release"},
      {a.front, "front"},     {a.side, "side"},           {a.top, "top"},       {a.whole, "fit"},
      {a.lattice, "lattice"}, {a.wireframe, "wireframe"}, {a.dark, "theme"},    {a.help, "help"}};
  for (const auto& [action, name] : icons) action->setIcon(icon(QLatin1String(name), colours));
  const bool recording = controller_->mode() == SimulationController::Mode::kRecording;
  a.record->setIcon(recording ? icon(QStringLiteral("stop"), colours.recording)
                              : icon(QStringLiteral("record"), colours));
}

}  // namespace torsio::gui
