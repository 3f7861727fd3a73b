// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include "app/gui/widgets/theme.h"

class QLabel;
class QLayout;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace torsio::gui {

class PageHeading;

/// Round the contents of a page.
inline constexpr int kPageMargin = 3 * kSpace;

/// A page that scrolls when it is larger than the window: heading above, everything else in the column that
/// is returned. Margins are those of all pages.
struct PageColumn {
  PageHeading* heading = nullptr;
  QVBoxLayout* column = nullptr;
};
[[nodiscard]] PageColumn pageColumn(QWidget* page, int widest = 0);

/// Removes and deletes all that a layout holds.
void emptyLayout(QLayout* layout);

[[nodiscard]] QLabel* plainLabel(QWidget* parent, const char* look = nullptr);
/// A large figure for a countdown.
void makeHuge(QLabel* label, double points);

/// An icon of the theme as a label of text height.
void showIcon(QLabel* label, const QString& icon, const QColor& colour, int size = 20);

}  // namespace torsio::gui
