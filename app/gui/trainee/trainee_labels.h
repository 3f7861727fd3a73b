// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QCoreApplication>
#include <QString>
#include <QWidget>

#include "app/services/devices/device_readiness.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"
#include "assessment/domain/rating/remark.h"

class QBoxLayout;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

/// Sentences of the station, in the present language. Names, values and verdicts format themselves.
class StationLabels {
  Q_DECLARE_TR_FUNCTIONS(StationLabels)

 public:
  [[nodiscard]] static QString minutes(std::int64_t span_us);
  /// Formats a waiting time: "3 h".
  [[nodiscard]] static QString waited(std::int64_t span_us);

  [[nodiscard]] static QString state(StepState state);
  /// Explains why a module is locked, or what mastery still needs.
  [[nodiscard]] static QString why(const ModuleStep& step);
  [[nodiscard]] static QString lastResult(const ModuleStep& step);
  [[nodiscard]] static QString unlocks(const ModuleStep& step);

  /// Describes a result of the same run under an older version of the definitions.
  [[nodiscard]] static QString earlier(const EarlierMeasure& earlier);

  [[nodiscard]] static QString level(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString levelMeaning(const CompetenceVerdict& verdict);
  /// Explains the rule of competence, and its error rates.
  [[nodiscard]] static QString competenceRule(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString competenceErrors(const CompetenceVerdict& verdict);
  /// What is always shown beside a level: the rule, and in one sentence how often chance decides.
  [[nodiscard]] static QString competenceBeside(const CompetenceVerdict& verdict);
  /// The question that competenceErrors() answers.
  [[nodiscard]] static QString howOftenWrong();
  [[nodiscard]] static QString readiness(const ReadinessFinding& finding);
  [[nodiscard]] static QString light(Light light);
};

/// The latest text of a remark. If it was edited, "edited" unfolds earlier versions; one's own can be edited
/// in place (Ctrl+Enter saves, Esc discards).
class RemarkWords : public QWidget {
  Q_OBJECT

 public:
  explicit RemarkWords(QWidget* parent = nullptr);

  /// `editedUtc_us`: 0 if never edited. `own`: written by the reader, who may edit it.
  void setWords(const QString& text, std::int64_t editedUtc_us, const std::vector<RemarkWording>& earlier,
                bool own);
  /// Sets the text before the remark, such as "You answered"; empty: none.
  void setLead(const QString& lead);

 Q_SIGNALS:
  /// The text was changed; trimmed, never empty.
  void edited(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setEditing(bool editing);
  void save();
  void showText();

  QString words_;
  QString lead_;
  QLabel* text_;
  QPushButton* history_;
  QPushButton* edit_;
  QLabel* earlier_;
  QWidget* editor_;
  QPlainTextEdit* field_;
  QPushButton* save_;
};

}  // namespace torsio::gui
