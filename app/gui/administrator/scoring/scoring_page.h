// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/people/people_service.h"
#include "app/services/review/adjudicator.h"
#include "app/services/study/scoring_plan.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Scoring progress: trainees and occasions against raters. Shows no marks.
class ScoringPage : public Page {
  Q_OBJECT

 public:
  explicit ScoringPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  /// Asks raters to score every trainee of the cohort at these occasions.
  bool ask(const std::vector<RaterId>& raterIds, const std::vector<std::string>& occasionCodes,
           std::optional<std::int64_t> dueUtc_us = std::nullopt);

 private:
  void read();
  void showContent();
  void showButtons();
  void showSheet();
  void inviteRaters();
  void copyReminders();
  [[nodiscard]] QString cellText(const ScoringCell& cell) const;
  void reassignSheets();
  [[nodiscard]] std::vector<PersonRow> activeRaters();
  void release();
  void assignAdjudicators();
  void showCalibration();
  [[nodiscard]] std::string rubricRevision();

  std::optional<ScoringMatrix> matrix_;
  std::vector<ReleaseState> releases_;
  std::vector<AdjudicatorRequest> adjudicatorRequests_;
  PageHeading* heading_;
  QPushButton* calibration_;
  QPushButton* revise_;
  QPushButton* invite_;
  QLabel* cohortLabel_ = nullptr;
  QComboBox* cohort_;
  QLabel* summary_;
  DataTable* table_;
  QPushButton* reassign_;
  QPushButton* remind_;
  QPushButton* mail_;
  QPushButton* release_;
  QPushButton* adjudicator_;
};

}  // namespace torsio::gui
