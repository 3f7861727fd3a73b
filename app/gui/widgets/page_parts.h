// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;
class QPushButton;

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

/// A titled area; all cards share margins and fonts.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(const QString& title, QWidget* parent = nullptr);
  void setTitle(const QString& title);
  /// Returns the column for the content, below the title.
  [[nodiscard]] QVBoxLayout* content() const noexcept { return content_; }

 private:
  QVBoxLayout* content_;
  QLabel* heading_;
};

/// One line that summarises a list, with a button to show or hide it. Overlong text ends with an ellipsis and
/// is in the tool tip.
class FoldLine : public QWidget {
  Q_OBJECT

 public:
  explicit FoldLine(QWidget* parent);

  void setText(const QString& text);
  /// Shows the button if there is a list.
  void setFoldable(bool foldable);
  void setOpen(bool open);
  [[nodiscard]] bool isOpen() const noexcept { return open_; }
  /// Returns the label, for style and name.
  [[nodiscard]] QLabel* label() const noexcept { return label_; }
  void retranslate();

 Q_SIGNALS:
  /// The button was pressed.
  void toggled(bool open);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showText();

  QLabel* label_;
  QPushButton* button_;
  QString text_;
  bool open_ = false;
};

}  // namespace torsio::gui
