// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace torsio::gui {

/// A page's heading: title, an unobtrusive sentence on its purpose, and main actions at the right.
class PageHeading : public QWidget {
  Q_OBJECT

 public:
  explicit PageHeading(QWidget* parent = nullptr);

  /// `title`: empty if the window's header has the only one.
  void setTexts(const QString& title, const QString& sentence);
  /// Adds a widget at the right, in the order of calls.
  void addAction(QWidget* button);

 private:
  QLabel* title_;
  QLabel* sentence_;
  QHBoxLayout* actions_;
};

}  // namespace torsio::gui
