// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/study/cohort.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Cohorts, their curricula and enrolments.
class CohortsPage : public Page {
  Q_OBJECT

 public:
  explicit CohortsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

 private:
  void read();
  void showContent();
  void showMembers();
  void addNew();
  void enrol();
  void follow();
  void changeState();
  void rename();
  void changeLife();
  /// Shows what the study says about itself, to be changed.
  void state();
  [[nodiscard]] const CohortRow* current() const;
  [[nodiscard]] std::vector<const CohortRow*> chosen(const std::function<bool(const CohortRow&)>& fits) const;

  std::vector<CohortRow> rows_;
  std::vector<Enrolment> enrolments_;
  PageHeading* heading_;
  QPushButton* add_;
  QPushButton* power_;
  DataTable* table_;
  QPushButton* enrol_;
  QPushButton* follow_;
  QPushButton* allocate_;
  QPushButton* rename_;
  QPushButton* life_;
  QPushButton* about_;
  QCheckBox* archived_;
  QLabel* membersTitle_;
  DataTable* members_;
  QPushButton* state_;
};

}  // namespace torsio::gui
