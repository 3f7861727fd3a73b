// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace torsio::gui {

/// Centres a card of this width in `ground`, for screens before the desk; it grows if a button would be
/// clipped. Returns the column for its content.
QVBoxLayout* centredCard(QWidget* ground, int width);

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
/// Sets a dynamic property of the style sheet ("caution", "good", "quiet") and updates the style.
void setLook(QWidget* widget, const char* property, bool on);

}  // namespace torsio::gui
