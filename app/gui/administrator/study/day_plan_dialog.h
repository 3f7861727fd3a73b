// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include <QDialog>
#include <QString>
#include <QStringList>
#include <QTime>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"

class QDateEdit;
class QLabel;
class QLineEdit;
class QLocale;
class QMenu;
class QPushButton;
class QSpinBox;
class QTimeEdit;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Returns the time of a slot, with the date unless it is today.
[[nodiscard]] QString slotTime(std::int64_t utc_us, const QLocale& locale);

/// The plan of a day: trainees by time and station or room. Adds, removes and prints slots. GUI thread.
class DayPlanDialog : public QDialog {
  Q_OBJECT

 public:
  using Trainees = std::vector<std::pair<EnrolmentId, QString>>;  ///< with their codes

  /// `trainees`: to be planned in this order; `places`: known training places, already entered; `others`:
  /// further places to add by a click.
  DayPlanDialog(ShellContext& shell, const CohortId& cohortId, Trainees trainees, const QStringList& places,
                const QStringList& others, QWidget* parent);

  /// Prints the slots of the day shown, by place. Throws Error{kFileUnwritable}.
  void print(const std::filesystem::path& file) const;

 private:
  void build(const QStringList& places, const QStringList& others);
  [[nodiscard]] QLayout* placesRow(const QStringList& places, const QStringList& others);
  void read();
  [[nodiscard]] QStringList namedPlaces() const;
  /// Offers the places not entered yet.
  void offerPlaces();
  /// Shows when the last slot would end, and whether that is the same day.
  void showOutlook();
  void suggestFirst();
  void plan();
  void remove();
  void askPrint();

  ShellContext& shell_;
  CohortId cohortId_;
  Trainees trainees_;
  std::vector<DaySlot> slots_;
  QDateEdit* day_;
  QTimeEdit* first_;
  QTime suggested_{};
  QSpinBox* minutes_;
  QSpinBox* pause_;
  QLineEdit* places_;
  QPushButton* more_;
  QMenu* offered_;
  QLabel* outlook_;
  QPushButton* plan_;
  DataTable* table_;
  QPushButton* remove_;
  QPushButton* print_;
};

}  // namespace torsio::gui
