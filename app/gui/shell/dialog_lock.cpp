// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/dialog_lock.h"

#include <QApplication>
#include <QEvent>
#include <QFrame>
#include <QVBoxLayout>

#include "app/gui/shell/lock_panel.h"

namespace torsio::gui {

namespace {

constexpr auto kVeilName = "lockVeil";

QFrame* veilOf(const QWidget& dialog) {
  return dialog.findChild<QFrame*>(QLatin1String(kVeilName), Qt::FindDirectChildrenOnly);
}

}  // namespace

DialogLock::DialogLock(QWidget* window)
    : QDialog(window, Qt::Dialog | Qt::CustomizeWindowHint | Qt::WindowTitleHint),
      panel_(new LockPanel(this)) {
  setWindowModality(Qt::ApplicationModal);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(panel_);
}

std::vector<QDialog*> DialogLock::openDialogs() const {
  std::vector<QDialog*> open;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    auto* dialog = qobject_cast<QDialog*>(widget);
    if (dialog != nullptr && dialog != this && dialog->isVisible()) {
      open.push_back(dialog);
    }
  }
  return open;
}

void DialogLock::cover() {
  const std::vector<QDialog*> open = openDialogs();
  if (open.empty()) {
    return;
  }
  for (QDialog* dialog : open) {
    auto* veil = new QFrame(dialog);
    veil->setObjectName(QLatin1String(kVeilName));
    veil->setAutoFillBackground(true);
    veil->setGeometry(dialog->rect());
    veil->show();
    veil->raise();
    dialog->installEventFilter(this);
  }
  setWindowTitle(parentWidget()->windowTitle());
  resize(panel_->sizeHint());
  show();
  raise();
  activateWindow();
}

void DialogLock::uncover() {
  hide();
  for (QDialog* dialog : openDialogs()) {
    dialog->removeEventFilter(this);
    delete veilOf(*dialog);
  }
}

void DialogLock::closeOthers() {
  const std::vector<QDialog*> open = openDialogs();
  hide();
  // Newest first: each returns to the one that opened it.
  for (auto dialog = open.rbegin(); dialog != open.rend(); ++dialog) {
    (*dialog)->done(QDialog::Rejected);
  }
}

bool DialogLock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    auto* dialog = static_cast<QWidget*>(watched);
    if (QFrame* veil = veilOf(*dialog)) {
      veil->setGeometry(dialog->rect());
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace torsio::gui
