// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/widgets/page_parts.h"

class QVBoxLayout;

namespace torsio::gui {

class ShellContext;

/// Trainees' unread replies to one's remarks, in a physician's queue. Hidden if there are none.
class RepliesCard : public Card {
  Q_OBJECT

 public:
  explicit RepliesCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Rereads the replies; the caller handles exceptions.
  void read();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  ShellContext& shell_;
  QVBoxLayout* list_;
};

}  // namespace torsio::gui
