// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QPushButton;

namespace torsio::gui {

/// One line that stands for a list, with a button that shows the list and takes it away again. What the line
/// has no room for ends with an ellipsis and stands in its tip.
class FoldLine : public QWidget {
  Q_OBJECT

 public:
  explicit FoldLine(QWidget* parent);

  void setText(const QString& text);
  /// Without a list there is no button.
  void setFoldable(bool foldable);
  void setOpen(bool open);
  [[nodiscard]] bool isOpen() const noexcept { return open_; }
  /// Where the text stands, for its look and name.
  [[nodiscard]] QLabel* label() const noexcept { return label_; }
  void retranslate();

 Q_SIGNALS:
  /// Somebody pressed the button.
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
