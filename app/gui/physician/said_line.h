// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

#include <QLabel>
#include <QString>

#include "app/gui/widgets/form.h"

namespace torsio::gui {

/// A page's status message; again() repeats it in the present language. The label belongs to its parent. GUI
/// thread.
class SaidLine {
 public:
  explicit SaidLine(QLabel* label) : label_(label) {}

  /// `words` returns the sentence in the present language. `caution`: it needs action.
  void say(std::function<QString()> words, bool caution = false) {
    words_ = std::move(words);
    setLook(label_, "caution", caution);
    again();
  }
  void clear() { say({}); }
  void again() { label_->setText(words_ ? words_() : QString()); }
  [[nodiscard]] QLabel* label() const noexcept { return label_; }

 private:
  QLabel* label_;
  std::function<QString()> words_;
};

}  // namespace torsio::gui
