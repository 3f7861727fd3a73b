// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QFrame>

class QLabel;
class QPushButton;

namespace torsio::gui {

/// Whose desk somebody sees who looks round among simulated people.
enum class VisitedDesk { kTrainee, kPhysician, kAdministrator };

/// The line over the desk of a visitor: one button a desk, the one that is seen pressed in.
class VisitBar : public QFrame {
  Q_OBJECT

 public:
  explicit VisitBar(QWidget* parent = nullptr);

  void setSeen(VisitedDesk desk);
  [[nodiscard]] VisitedDesk seen() const noexcept { return seen_; }

 Q_SIGNALS:
  /// Another desk is wanted; which one is seen stays until setSeen().
  void wanted(VisitedDesk desk);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  VisitedDesk seen_ = VisitedDesk::kAdministrator;
  QLabel* sentence_;
  std::map<VisitedDesk, QPushButton*> desks_;
};

}  // namespace torsio::gui
