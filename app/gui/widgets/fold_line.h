// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QPushButton;

namespace torsio::gui {

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
