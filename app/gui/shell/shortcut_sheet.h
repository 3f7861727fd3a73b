// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QDialog>
#include <QString>

class QWidget;

namespace torsio::gui {

class Desk;

/// What and with which key.
using KeyLine = std::pair<QString, QString>;

/// Every key of a page that can be read off its commands, in the order in which they were made.
[[nodiscard]] std::vector<KeyLine> keysOf(const QWidget& page);

/// One sheet with the keys of the program and those of the page that is open. `?` and F1 show it.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  /// `desk`: null before anybody signed in.
  explicit ShortcutSheet(Desk* desk, QWidget* parent = nullptr);
};

}  // namespace torsio::gui
