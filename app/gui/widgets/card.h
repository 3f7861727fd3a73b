// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QVBoxLayout;

namespace torsio::gui {

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

}  // namespace torsio::gui
