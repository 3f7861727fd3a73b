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

/// Puts a card `width` wide in the middle of `ground`, for the screens before the desk; it grows where a
/// button would be cut. Returns where its content goes.
QVBoxLayout* centredCard(QWidget* ground, int width);

/// Adds a label and its field to `layout`: above it in a column, beside it in a row. A mnemonic of the label
/// leads to the field. Returns the label, whose text the caller sets.
QLabel* addField(QBoxLayout* layout, QWidget* field);
/// Text of such a label; the field's accessible name is the same without its mnemonic.
void nameField(QLabel* label, const QString& text);

/// Hides what is typed, and keeps it from input methods that learn.
QLineEdit* secretField(QWidget* parent);
QPushButton* primaryButton(QWidget* parent);
QPushButton* linkButton(QWidget* parent);
/// Wraps, and takes no more height than it needs.
QLabel* sentence(QWidget* parent, bool quiet = true);
/// Sets one of the dynamic properties of the style sheet ("caution", "good", "quiet") and shows it at once.
void setLook(QWidget* widget, const char* property, bool on);

}  // namespace torsio::gui
