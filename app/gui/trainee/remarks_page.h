// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/training/remarks.h"
#include "assessment/domain/ids.h"

class QLabel;
class QListWidget;
class QVBoxLayout;

namespace torsio::gui {

class Card;
class PageHeading;

/// Physicians' remarks on one's runs, at their moments; replies; one's own marks first, then the gap.
class RemarksPage : public Page {
  Q_OBJECT

 public:
  explicit RemarksPage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 private:
  void readAll();
  void fillList();
  void fillRemarks();
  void fillMarks();
  void addRemark(const TraineeRemark& remark, bool reply);
  /// Changes the record and rereads it.
  void change(const std::function<void(SessionContext&)>& action);
  [[nodiscard]] const TrialRemarks* chosen() const;

  std::vector<TrialRemarks> all_;
  const Theme* theme_;
  PageHeading* heading_;
  QListWidget* list_;
  QLabel* empty_;
  QWidget* right_;
  Card* remarks_;
  QVBoxLayout* threads_;
  Card* marks_;
  QVBoxLayout* sheet_;
};

}  // namespace torsio::gui
