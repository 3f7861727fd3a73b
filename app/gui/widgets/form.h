// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>

#include <QMargins>
#include <QString>

#include "app/gui/widgets/theme.h"

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace torsio::gui {

/// Centres a card of this width in `ground`, for screens before the desk; it grows if a button would be
/// clipped. Returns the column for its content.
QVBoxLayout* centredCard(QWidget* ground, int width);

/// Creates the layout of a widget, without margins. `spacing`: empty: the style's.
template <typename Layout>
Layout* bareLayout(QWidget* widget, std::optional<int> spacing = std::nullopt) {
  auto* layout = new Layout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  if (spacing) {
    layout->setSpacing(*spacing);
  }
  return layout;
}

/// Gives an object the name by which child() finds it. Returns the object.
template <typename Object>
Object* named(Object* object, const char* name) {
  object->setObjectName(QLatin1String(name));
  return object;
}

/// Sets the range of a spin box or bar. Returns it.
template <typename Box, typename Least, typename Most>
Box* ranged(Box* box, Least least, Most most) {
  box->setRange(least, most);
  return box;
}

/// Makes a row that begins with these widgets.
QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets = {}, int spacing = kSpace);
/// Lays `owner` out as a column; spacing -1: that of the style.
QVBoxLayout* columnOf(QWidget* owner, const QMargins& margins, int spacing = -1);
/// Adds a label and its field to `layout`: above it in a column, beside it in a row. The label's mnemonic
/// focuses the field. Returns the label, whose text the caller sets.
QLabel* addField(QBoxLayout* layout, QWidget* field);
/// Sets the label's text, and the field's accessible name without the mnemonic.
void nameField(QLabel* label, const QString& text);

/// Hides the input, also from input methods that learn.
QLineEdit* secretField(QWidget* parent);
QPushButton* primaryButton(QWidget* parent);
QPushButton* linkButton(QWidget* parent);
/// Creates a wrapping label that takes no more height than needed.
QLabel* sentence(QWidget* parent, bool quiet = true);
QLabel* sentence(QWidget* parent, const QString& text, bool quiet = true);
/// Sets a dynamic property of the style sheet ("caution", "good", "quiet") and updates the style.
void setLook(QWidget* widget, const char* property, bool on);

/// Keeps `content`, the layout of the area's widget, clear of the vertical scroll bar if there is one;
/// otherwise it is as wide as what is above and below the area.
void keepOffScrollBar(QScrollArea& area, QLayout& content);

/// Makes a dialog high enough for its wrapped sentences; call when one has changed. Never shrinks it.
void growToSentences(QWidget* dialog);

}  // namespace torsio::gui
