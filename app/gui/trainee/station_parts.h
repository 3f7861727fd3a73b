// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include "app/gui/widgets/theme.h"

class QLabel;
class QLayout;
class QScrollArea;
class QVBoxLayout;

namespace torsio::gui {

class FoldLine;
class PageHeading;

/// Margin of a page's content.
inline constexpr int kPageMargin = 3 * kSpace;

/// A page that scrolls if larger than the window: a heading, and the column for everything else. Has the
/// common margins.
struct PageColumn {
  PageHeading* heading = nullptr;
  QVBoxLayout* column = nullptr;
};
[[nodiscard]] PageColumn pageColumn(QWidget* page, int widest = 0);

/// Removes and deletes all items of a layout.
void emptyLayout(QLayout* layout);

[[nodiscard]] QLabel* plainLabel(QWidget* parent, const char* look = nullptr);
/// Enlarges a label for a countdown.
void makeHuge(QLabel* label, double points);

/// A line such as "How often is this wrong?" that unfolds its answer below.
class FoldedText : public QWidget {
  Q_OBJECT

 public:
  explicit FoldedText(QWidget* parent);

  /// Keeps what is unfolded.
  void setTexts(const QString& line, const QString& text);

 private:
  FoldLine* line_;
  QLabel* text_;
};

/// Shows a theme's icon in a label, at text height.
void showIcon(QLabel* label, const QString& icon, const QColor& colour, int size = 20);

}  // namespace torsio::gui
