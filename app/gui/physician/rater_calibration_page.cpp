// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/rater_calibration_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio::gui {

namespace {

constexpr double kNear_points = 0.5;  // smaller differences count as agreement

/// Reduces a rubric to the overall mark, the only one that a panel has agreed on.
RubricRevision withoutRows(RubricRevision rubric) {
  rubric.rows.clear();
  return rubric;
}

}  // namespace

RaterCalibrationPage::RaterCalibrationPage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      goOn_(new QPushButton(this)),
      choices_(new ChoiceRow(this)),
      replay_(named(new ReplayPanel(shell.assets(), this), "replay")),
      sheet_(new SheetEditorPanel(false, this)),
      compare_(primaryButton(this)),
      resultCard_(new Card(QString(), this)),
      result_(sentence(this, false)),
      sum_(sentence(this)),
      rubricCard_(new Card(QString(), this)),
      anchors_(sentence(this)) {
  sheet_->setScoresOnly(RowShape::kLarge);
  heading_->addAction(goOn_);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, kSpace);
  column->addWidget(heading_);
  column->addWidget(choices_);
  QHBoxLayout* row = rowOf({}, 2 * kSpace);
  row->addWidget(replay_, 3);
  auto* right = new QVBoxLayout;
  sheet_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // a single row
  right->addWidget(sheet_);
  right->addWidget(compare_);
  resultCard_->content()->addWidget(result_);
  resultCard_->content()->addWidget(sum_);
  right->addWidget(resultCard_);
  anchors_->setAlignment(Qt::AlignTop);
  anchorsArea_ = new QScrollArea(rubricCard_);
  anchorsArea_->setWidgetResizable(true);
  anchorsArea_->setFrameShape(QFrame::NoFrame);
  anchorsArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  anchorsArea_->setWidget(anchors_);
  rubricCard_->content()->addWidget(anchorsArea_);
  right->addWidget(rubricCard_, 1);
  right->addStretch(0);
  row->addLayout(right, 2);
  column->addLayout(row, 1);
  connect(choices_, &ChoiceRow::chosen, this, [this](std::size_t at) { openRun(at + 1); });
  connect(compare_, &QPushButton::clicked, this, &RaterCalibrationPage::compare);
  // On success the recording is shown afterwards; failure and cancellation end here.
  connect(&shell, &ShellContext::jobEnded, this, [this] {
    if (number_ > 0 && !replay_->ready()) {
      replay_->showSentence(tr("The recording could not be opened."));
    }
  });
  connect(goOn_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kQueue); });
  connect(sheet_, &SheetPanel::edited, this, &RaterCalibrationPage::showResult);
  connect(sheet_, &SheetEditorPanel::finishWanted, this, &RaterCalibrationPage::compare);
}

RaterCalibrationPage::~RaterCalibrationPage() = default;

void RaterCalibrationPage::enter(const QVariant&) {
  calibration_ = raterCalibration(shell().session());
  std::size_t first = calibration_.runs.empty() ? 0 : 1;
  for (const CalibrationRun& run : calibration_.runs) {
    if (run.own_steps) {
      continue;
    }
    first = run.number;
    break;
  }
  openRun(first);
}

bool RaterCalibrationPage::leave() {
  replay_->pause();
  ++loads_;
  replay_->show(nullptr);
  return true;
}

void RaterCalibrationPage::openRun(std::size_t number) {
  number_ = number;
  replay_->show(nullptr);
  sheet_->endSheet();
  showRuns();
  if (number_ == 0) {
    replay_->showSentence(tr("No reference run has been chosen yet. You may begin with your queue."));
    showResult();
    return;
  }
  Sheet last;
  last.overall_steps = calibration_.runs[number_ - 1].own_steps;
  sheet_->beginSheet(withoutRows(calibration_.rubric), last);
  sheet_->takeFocus();
  showResult();
  replay_->showSentence(tr("The recording is being opened. You may score meanwhile."));
  const std::uint64_t ticket = ++loads_;
  shell().run(
      this, tr("Opening reference %1").arg(static_cast<int>(number_)),
      [number, assets = shell().assets()](SessionContext& own, const ProgressCallback&) {
        return loadForShowing(loadReferenceRun(own, number), assets);
      },
      [this, ticket](std::shared_ptr<LoadedRecording> loaded) {
        if (ticket == loads_) {
          replay_->show(std::move(loaded));
        }
      });
}

void RaterCalibrationPage::showRuns() {
  std::vector<QString> texts;
  for (const CalibrationRun& run : calibration_.runs) {
    const int number = static_cast<int>(run.number);
    texts.push_back(run.own_steps ? tr("Reference %1, scored").arg(number) : tr("Reference %1").arg(number));
  }
  choices_->setChoices(texts, number_ - 1);  // 0: no run is open, no button is pressed
}

void RaterCalibrationPage::showResult() {
  const bool any = number_ > 0;
  compare_->setVisible(any);
  compare_->setEnabled(any && sheet_->editor() != nullptr &&
                       sheet_->editor()->answer(kOverallRow).score_steps.has_value());
  goOn_->setText(tr("&Queue"));
  const std::size_t next = nextNumber();
  compare_->setText(!compared() ? tr("&Compare with the panel")
                    : next > 0  ? tr("Continue with reference %1").arg(static_cast<int>(next))
                                : tr("On to the queue"));
  anchors_->setText(anchorText());
  rubricCard_->setVisible(any && !anchors_->text().isEmpty());
  const CalibrationRun* run = any ? &calibration_.runs[number_ - 1] : nullptr;
  resultCard_->setVisible(any);
  if (run == nullptr) {
    return;
  }
  if (!run->offset_points) {
    result_->setText(tr("Score first; then the panel's mark is shown."));
    sum_->clear();
    return;
  }
  const double off = *run->offset_points;
  const QString figures =
      tr("You: %1. Panel of %2: %3.")
          .arg(scoreText(*run->own_steps, calibration_.rubric.overall), QString::number(run->panelRaters),
               pointsText(std::round(*run->panel_points * 10.0) / 10.0));
  const QString reading = std::abs(off) < kNear_points ? tr("That is as the panel sees it.")
                          : off < 0.0
                              ? tr("You are stricter by %1.").arg(pointsText(std::round(-off * 10.0) / 10.0))
                              : tr("You are milder by %1.").arg(pointsText(std::round(off * 10.0) / 10.0));
  result_->setText(joinedSentences({figures, reading}));
  const auto mean = calibration_.meanOffset_points();
  sum_->setText(calibration_.complete() && mean
                    ? tr("Over all reference runs: %1 points from the panel. You may score a run "
                         "again; every try is kept.")
                          .arg(signedText(*mean))
                    : tr("You may score it again, or go on with the next run."));
}

void RaterCalibrationPage::compare() {
  if (sheet_->editor() == nullptr || number_ == 0) {
    return;
  }
  const auto score = sheet_->editor()->answer(kOverallRow).score_steps;
  if (!score) {
    return;
  }
  if (compared()) {
    return goNext();
  }
  attempt(shell(), [&] {
    scoreReferenceRun(shell().session(), number_, *score);
    calibration_ = raterCalibration(shell().session());
  });
  showRuns();
  showResult();
}

bool RaterCalibrationPage::compared() const {
  return number_ > 0 && sheet_->editor() != nullptr && calibration_.runs[number_ - 1].own_steps.has_value() &&
         sheet_->editor()->answer(kOverallRow).score_steps == calibration_.runs[number_ - 1].own_steps;
}

std::size_t RaterCalibrationPage::nextNumber() const {
  const auto open = std::find_if(calibration_.runs.begin(), calibration_.runs.end(),
                                 [](const CalibrationRun& run) { return !run.own_steps.has_value(); });
  return open == calibration_.runs.end() ? 0 : open->number;
}

void RaterCalibrationPage::goNext() {
  if (const std::size_t next = nextNumber(); next > 0) {
    openRun(next);
  } else {
    shell().open(PageId::kQueue);
  }
}

QString RaterCalibrationPage::anchorText() const {
  QStringList lines;
  for (const RubricLine& row : calibration_.rubric.rows) {
    QStringList points;
    for (const RubricAnchor& anchor : row.anchors) {
      points << tr("%1: %2").arg(scoreText(anchor.score_steps, row.scale), toQString(Text(anchor.meaning)));
    }
    if (!points.isEmpty()) {
      lines << tr("%1. %2").arg(toQString(Text(row.label)),
                                points.join(QStringLiteral("\u00a0\u00a0\u00b7  ")));
    }
  }
  return lines.join(QStringLiteral("\n\n"));
}

void RaterCalibrationPage::retranslate() {
  heading_->setTexts(tr("Rater calibration"),
                     tr("Score the reference runs before the real cases and see your own offset from the "
                        "panel. Nobody else sees it."));
  compare_->setToolTip(tr("Ctrl+Enter"));
  resultCard_->setTitle(tr("Your offset"));
  rubricCard_->setTitle(tr("What the rubric asks for"));
  anchorsArea_->setAccessibleName(tr("What the rubric asks for"));
  replay_->retranslate();
  sheet_->retranslate();
  showRuns();
  showResult();
}

std::vector<std::pair<QString, QString>> RaterCalibrationPage::keys() const {
  std::vector<std::pair<QString, QString>> all = replayKeys();
  for (auto& one : sheetKeys()) {
    all.push_back(std::move(one));
  }
  all.back().first = tr("Compare with the panel");
  return all;
}

void RaterCalibrationPage::applyTheme(const Theme& theme) {
  replay_->setTheme(theme);
  sheet_->setTheme(theme);
}

void RaterCalibrationPage::keyPressEvent(QKeyEvent* event) {
  if (sheet_->handleCommand(event)) {
    return;
  }
  if ((event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0 &&
      replay_->handleKey(event->key())) {
    return;
  }
  if (event->key() != Qt::Key_N && sheet_->handleKey(event->key(), event->modifiers())) {
    return;
  }
  Page::keyPressEvent(event);
}

}  // namespace torsio::gui
