// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/evaluation_page.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/review/watched_time.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr qint64 kKeepWatchedEvery_us = 5'000'000;

}  // namespace

EvaluationPage::EvaluationPage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      campaigns_(new QComboBox(this)),
      choices_(new ChoiceRow(this)),
      scaleText_(sentence(this)),
      definition_(named(sentence(this, false), "definition")),
      sheet_(new SheetEditorPanel(false, this)),
      replay_(new ReplayPanel(shell.assets(), this)),
      said_(sentence(this)),
      submit_(primaryButton(this)) {
  sheet_->setScoresOnly();
  heading_->addAction(campaigns_);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, kSpace);
  column->addWidget(heading_);
  column->addWidget(choices_);
  column->addWidget(scaleText_);
  definition_->setMinimumHeight(fontMetrics().height());
  column->addWidget(definition_);
  auto* middle = new QHBoxLayout;
  sheet_->setMaximumWidth(110 * fontMetrics().averageCharWidth());
  middle->setSpacing(2 * kSpace);
  middle->addWidget(replay_, 1);
  middle->addWidget(sheet_, 1);
  middle->addStretch(0);
  column->addLayout(middle, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(replay_->proof());
  foot->addWidget(said_.label(), 1);
  foot->addWidget(submit_);
  column->addLayout(foot);
  connect(choices_, &ChoiceRow::chosen, this, &EvaluationPage::openModel);
  connect(sheet_, &SheetPanel::edited, this, &EvaluationPage::edited);
  connect(sheet_, &SheetPanel::rowChanged, this, &EvaluationPage::showDefinition);
  connect(sheet_, &SheetEditorPanel::finishWanted, this, &EvaluationPage::submit);
  connect(sheet_, &SheetEditorPanel::heldBack, this,
          [this] { this->shell().notify(tr("This is the next model. Change its sheet first")); });
  connect(submit_, &QPushButton::clicked, this, &EvaluationPage::submit);
  connect(replay_, &ReplayPanel::played, this, [this](qint64 from, qint64 to, double speed) {
    watched().played(from, to, speed);
    sheet_->touched();
    if (from / kKeepWatchedEvery_us != to / kKeepWatchedEvery_us) {
      keepWatched();
    }
    showWatched();
  });
  connect(campaigns_, &QComboBox::activated, this, [this](int at) {
    campaign_ = static_cast<std::size_t>(at);
    openFirst();
  });
}

EvaluationPage::~EvaluationPage() = default;

const EvaluationForm* EvaluationPage::form() const {
  return campaign_ < forms_.size() ? &forms_[campaign_] : nullptr;
}

WatchLog& EvaluationPage::watched() {
  return watched_[{form()->campaignId, model()->hiddenLabel}];
}

/// Replaces what was played here by what counts of it; tried again later while the record cannot be reached.
void EvaluationPage::keepWatched() {
  const std::pair key{form()->campaignId, model()->hiddenLabel};
  try {
    watched_[key] = watchedInWindow(shell().session(), modelRecording(key.first.text(), key.second),
                                    kept_[key], watched_[key]);
    kept_[key] = watched_[key];
  } catch (const Error&) {
    return;
  }
}

void EvaluationPage::showWatched() {
  replay_->setWatched(watched().spans());
}

const EvaluationFormModel* EvaluationPage::model() const {
  const EvaluationForm* one = form();
  return one != nullptr && model_ < one->models.size() ? &one->models[model_] : nullptr;
}

void EvaluationPage::enter(const QVariant&) {
  read();
  campaign_ = 0;
  while (campaign_ + 1 < forms_.size() && forms_[campaign_].complete()) {
    ++campaign_;
  }
  openFirst();
}

void EvaluationPage::read() {
  forms_ = evaluationForms(shell().session());
  const QSignalBlocker quiet(campaigns_);
  campaigns_->clear();
  for (const EvaluationForm& one : forms_) {
    campaigns_->addItem(toQString(Text(one.title)));
  }
}

void EvaluationPage::openFirst() {
  std::size_t at = 0;
  const EvaluationForm* one = form();
  while (one != nullptr && at + 1 < one->models.size() && one->models[at].submitted) {
    ++at;
  }
  openModel(at);
}

void EvaluationPage::openModel(std::size_t at) {
  model_ = at;
  sheet_->endSheet();
  said_.clear();
  if (const EvaluationFormModel* one = model()) {
    sheet_->beginSheet(evaluationRubric(*form()), evaluationSheet(*one), false);
    sheet_->takeFocus();
  }
  openRecording();
  showModels();
  showAll();
}

void EvaluationPage::openRecording() {
  const std::uint64_t ticket = ++loads_;
  const EvaluationFormModel* one = model();
  replay_->show(nullptr);
  replay_->setVisible(one != nullptr);
  if (one == nullptr) {
    return;
  }
  if (!one->recorded) {
    replay_->showSentence(
        tr("There is no recording of this model here: score what you experienced at the station. An "
           "administrator can provide a recording for each model."));
    return;
  }
  replay_->showSentence(tr("The recording is being opened. You may score meanwhile."));
  shell().run(
      this, tr("Opening the recording of model %1").arg(toQString(one->hiddenLabel)),
      [id = form()->campaignId, label = one->hiddenLabel, assets = shell().assets()](
          SessionContext& own, const ProgressCallback&) {
        return loadForShowing(loadEvaluationRecording(own, id, label), assets);
      },
      [this, ticket](std::shared_ptr<LoadedRecording> loaded) {
        if (ticket != loads_) {
          return;
        }
        if (watched().length_us() == 0) {
          watched() = WatchLog(loaded->playback.duration_us());
          kept_[{form()->campaignId, model()->hiddenLabel}] = watched();
        }
        replay_->setSpeeds(evaluationRules(this->shell().session()).speeds);
        replay_->show(std::move(loaded));
        showWatched();
      });
}

bool EvaluationPage::leave() {
  ++loads_;
  replay_->pause();
  replay_->show(nullptr);
  return true;
}

void EvaluationPage::customEvent(QEvent* event) {
  if (event->type() == databaseAnsweredEvent() && sheet_->unsaved()) {
    edited();
  }
}

void EvaluationPage::edited() {
  EvaluationFormModel& stored = forms_[campaign_].models[model_];
  sheet_->save(
      shell(), said_, [] { return tr("Saved"); },
      [&] {
        for (std::size_t i = 0; i < stored.scores.size(); ++i) {
          const auto score = sheet_->editor()->sheet().rows[i].score_steps;
          if (score == stored.scores[i]) {
            continue;
          }
          saveEvaluationScore(shell().session(), form()->campaignId, stored.hiddenLabel, i, score);
          stored.scores[i] = score;
        }
      });
  showAll();
}

void EvaluationPage::submit() {
  const EvaluationFormModel* one = model();
  if (one == nullptr || one->submitted) {
    return;
  }
  const auto open = std::find(one->scores.begin(), one->scores.end(), std::nullopt);
  if (open != one->scores.end()) {
    const auto left = static_cast<int>(std::count(one->scores.begin(), one->scores.end(), std::nullopt));
    said_.say([left, all = one->scores.size()] { return tr("Still open: %1 of %2").arg(left).arg(all); },
              true);
    sheet_->setCurrentRow(std::to_string(open - one->scores.begin() + 1));
    sheet_->takeFocus();
    return;
  }
  const ViewingRules rules = evaluationRules(shell().session());
  keepWatched();
  const SheetCheck check = checkEvaluation(*form(), *one, watched(), rules);
  if (!check.mayBeSubmitted()) {
    said_.say(
        [check, least = rules.minimumWatched] {
          return check.watchedTooLittle ? tr("Watched %1 % so far; at least %2 % is asked.")
                                              .arg(std::floor(check.watchedShare * 100.0))
                                              .arg(std::round(least * 100.0))
                                        : tr("It was played at a speed that is not allowed.");
        },
        true);
    return;
  }
  if (!sheet_->asking()) {
    sheet_->setAsking(true);
    said_.say([check] {
      return check.allTheSame
                 ? tr("All nine have the same mark. Is that intended? Press again to seal them.")
                 : tr("All nine are scored. Press again to seal them; sealed marks stay as they are.");
    });
    return;
  }
  if (!readyToSign(this, shell(), SignatureMeaning::kScored)) {
    return;
  }
  attempt(shell(), [&] {
    submitEvaluation(shell().session(), form()->campaignId, one->hiddenLabel, watched());
    shell().notify(tr("Model %1 is submitted and sealed").arg(toQString(one->hiddenLabel)));
    read();
    openFirst();
    sheet_->waitForTouch();
  });
}

void EvaluationPage::showModels() {
  std::vector<QString> texts;
  if (const EvaluationForm* one = form()) {
    for (const EvaluationFormModel& model : one->models) {
      const QString label = toQString(model.hiddenLabel);
      const std::size_t number = texts.size() + 1;
      texts.push_back(model.submitted ? tr("%1. Model %2, submitted").arg(number).arg(label)
                                      : tr("%1. Model %2").arg(number).arg(label));
    }
  }
  choices_->setChoices(texts, model_);
}

void EvaluationPage::showAll() {
  const EvaluationForm* one = form();
  const EvaluationFormModel* now = model();
  campaigns_->setVisible(forms_.size() > 1);
  {
    const QSignalBlocker quiet(campaigns_);
    campaigns_->setCurrentIndex(static_cast<int>(campaign_));
  }
  sheet_->setVisible(now != nullptr);
  submit_->setVisible(now != nullptr && !now->submitted);
  sheet_->setReadOnly(now == nullptr || now->submitted);
  showDefinition();
  if (now == nullptr) {
    scaleText_->setText(tr("No evaluation is waiting for you at present."));
    return;
  }
  const ScoreScale& scale = one->scale;
  scaleText_->setText(
      tr("%1: %2 to %3; keys 0 to 9 score, arrows left and right fine-tune, with Shift in steps of %4.")
          .arg(toQString(Text(one->title)), scoreText(scale.lo, scale), scoreText(scale.hi, scale),
               pointsText(1.0 / static_cast<double>(scale.stepsPerPoint))));
  if (now->submitted) {
    said_.say([all = one->complete()] {
      return all ? tr("All models are submitted. Thank you.") : tr("Submitted and sealed");
    });
  }
}

void EvaluationPage::showDefinition() {
  const EvaluationForm* one = form();
  const auto row = static_cast<std::size_t>(std::atoi(sheet_->currentRow().c_str()));
  const bool known = one != nullptr && model() != nullptr && row >= 1 && row <= one->indexIds.size();
  const std::optional<IndexMeaning> meaning = known ? indexMeaning(one->indexIds[row - 1]) : std::nullopt;
  definition_->setVisible(meaning.has_value());
  if (meaning) {
    definition_->setText(
        tr("%1. %2").arg(toQString(Text(one->indices[row - 1])), toQString(meaning->definition)));
  }
}

void EvaluationPage::retranslate() {
  heading_->setTexts(tr("Evaluation"), tr("Nine indices for each model, after each run. The letters hide the "
                                          "models; the order is drawn for you alone."));
  campaigns_->setAccessibleName(tr("Evaluation"));
  submit_->setText(tr("Submit this model"));
  submit_->setToolTip(tr("Ctrl+Enter"));
  sheet_->retranslate();
  replay_->retranslate();
  showModels();
  said_.again();
  showAll();
}

std::vector<std::pair<QString, QString>> EvaluationPage::keys() const {
  return sheetKeys();
}

void EvaluationPage::applyTheme(const Theme& theme) {
  sheet_->setTheme(theme);
  replay_->setTheme(theme);
}

void EvaluationPage::keyPressEvent(QKeyEvent* event) {
  if (!sheet_->handle(event) && !(replay_->isVisible() && replay_->handleKey(event->key()))) {
    Page::keyPressEvent(event);
  }
}

}  // namespace torsio::gui
