// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/widgets/card.h"

class QVBoxLayout;

namespace torsio::gui {

class ShellContext;

/// In a physician's queue: what trainees answered to one's remarks, until it was read. Hidden while there is
/// nothing.
class RepliesCard : public Card {
  Q_OBJECT

 public:
  explicit RepliesCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Reads them anew; the caller's catch reports.
  void read();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  ShellContext& shell_;
  QVBoxLayout* list_;
};

}  // namespace torsio::gui
