// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"
#include "app/services/study/campaign_service.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Nine-index evaluations of tissue models: raters and progress.
class CampaignsPage : public Page {
  Q_OBJECT

 public:
  explicit CampaignsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  bool add(const CampaignPlan& plan);

 private:
  void read();
  void showContent();
  void showRaters();
  void askNew();

  std::vector<CampaignRow> rows_;
  PageHeading* heading_;
  QPushButton* add_;
  DataTable* table_;
  QLabel* ratersTitle_;
  DataTable* raters_;
};

}  // namespace torsio::gui
