// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/file_choice.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>

namespace torsio::gui {

namespace {

constexpr auto kFolderKey = "files/folder";

QString folder() {
  const QString last = QSettings().value(QLatin1String(kFolderKey)).toString();
  if (!last.isEmpty() && QDir(last).exists()) {
    return last;
  }
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}

QString remembered(const QString& file) {
  if (!file.isEmpty()) {
    QSettings().setValue(QLatin1String(kFolderKey), QFileInfo(file).absolutePath());
  }
  return file;
}

}  // namespace

QString askFileToSave(QWidget* parent, const QString& title, const QString& name, const QString& filter,
                      QString* chosenFilter) {
  static const QRegularExpression kNotInNames(QStringLiteral("[/\\\\:*?\"<>|]"));
  const QString proposal = QDir(folder()).filePath(QString(name).replace(kNotInNames, QStringLiteral("-")));
  return remembered(QFileDialog::getSaveFileName(parent, title, proposal, filter, chosenFilter));
}

QString askFileToOpen(QWidget* parent, const QString& title, const QString& filter, const QString& begin) {
  return remembered(QFileDialog::getOpenFileName(parent, title, begin.isEmpty() ? folder() : begin, filter));
}

QString askFolder(QWidget* parent, const QString& title) {
  const QString chosen = QFileDialog::getExistingDirectory(parent, title, folder());
  if (!chosen.isEmpty()) {
    QSettings().setValue(QLatin1String(kFolderKey), chosen);
  }
  return chosen;
}

}  // namespace torsio::gui
