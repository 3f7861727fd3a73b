// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace torsio::gui {

/// Head of a page: its title, one quiet sentence on what it is for, and its main actions at the right.
class PageHeading : public QWidget {
  Q_OBJECT

 public:
  explicit PageHeading(QWidget* parent = nullptr);

  /// `title`: empty where the header of the window bears the only one.
  void setTexts(const QString& title, const QString& sentence);
  /// To the right, in the order of the calls.
  void addAction(QWidget* button);

 private:
  QLabel* title_;
  QLabel* sentence_;
  QHBoxLayout* actions_;
};

}  // namespace torsio::gui
