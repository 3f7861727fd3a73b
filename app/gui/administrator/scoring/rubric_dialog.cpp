// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/rubric_dialog.h"

#include <algorithm>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/scoring/rubric_form.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

constexpr int kRubricWidth = 1240;
constexpr int kRubricHeight = 680;
constexpr int kPreviewWidth = 460;

}  // namespace

RubricDialog::RubricDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      revision_(named(new QComboBox(this), "revision")),
      form_(named(new RubricForm(this), "form")),
      preview_(named(new SheetEditorPanel(false, this), "preview")),
      problem_(named(sentence(this, false), "problem")),
      import_(named(new QPushButton(tr("&Import\u2026"), this), "import")),
      export_(named(new QPushButton(tr("&Export\u2026"), this), "export")),
      publish_(named(new QPushButton(tr("&Publish\u2026"), this), "publish")) {
  setObjectName(QStringLiteral("rubric"));
  resize(kRubricWidth, kRubricHeight);
  build();
  connect(revision_, &QComboBox::currentIndexChanged, this, &RubricDialog::showRevision);
  connect(form_, &RubricForm::edited, this, &RubricDialog::changed);
  connect(form_, &RubricForm::shown, this, &RubricDialog::changed);
  connect(publish_, &QPushButton::clicked, this, &RubricDialog::publish);
  connect(import_, &QPushButton::clicked, this, [this] {
    const QString file = askFileToOpen(this, tr("Import a scoring sheet"), tr("Scoring sheet (*.json)"));
    if (!file.isEmpty()) {
      importFrom(toPath(file));
    }
  });
  connect(export_, &QPushButton::clicked, this, [this] {
    const QString file =
        askFileToSave(this, tr("Export the scoring sheet"),
                      tr("%1, revision %2").arg(toQString(Text(rubric_.name))).arg(form_->revision().number),
                      tr("Scoring sheet (*.json)"));
    if (!file.isEmpty()) {
      exportTo(toPath(file));
    }
  });
  read();
}

void RubricDialog::build() {
  QVBoxLayout* column = pageColumn(this);
  QHBoxLayout* top = rowOf();
  revision_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  nameField(addField(top, revision_), tr("&Revision"));
  QLabel* said = sentence(
      this,
      tr("A change becomes the next revision, for raters who are asked from then on. Sheets that were asked "
         "for keep theirs."));
  top->addWidget(said, 1);
  column->addLayout(top);
  QHBoxLayout* middle = rowOf({}, 2 * kSpace);
  middle->addWidget(form_, 1);
  auto* right = new QVBoxLayout;
  preview_->setFixedWidth(kPreviewWidth);
  preview_->setTheme(theme(shell_.themeKind()));
  preview_->retranslate();
  nameField(addField(right, preview_), tr("As the rater sees it"));
  right->setStretchFactor(preview_, 1);
  middle->addLayout(right);
  column->addLayout(middle, 1);
  setLook(problem_, "caution", true);
  column->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(import_, QDialogButtonBox::ActionRole);
  buttons->addButton(export_, QDialogButtonBox::ActionRole);
  buttons->addButton(publish_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
  publish_->setProperty("primary", true);
  connect(buttons, &QDialogButtonBox::rejected, this, &RubricDialog::reject);
  column->addWidget(buttons);
  pressNothingByEnter(*this);
}

void RubricDialog::read() {
  attempt(shell_, [&] {
    const std::vector<RubricRow> all = rubrics(shell_.session());
    rubric_ = all.empty() ? RubricRow{} : all.front();
  });
  setWindowTitle(tr("Scoring sheet: %1").arg(toQString(Text(rubric_.name))));
  {
    const QSignalBlocker quiet(revision_);
    revision_->clear();
    for (auto one = rubric_.revisions.rbegin(); one != rubric_.revisions.rend(); ++one) {
      revision_->addItem(one->note.empty() ? QString::number(one->number)
                                           : tr("%1: %2").arg(one->number).arg(toQString(one->note)));
    }
  }
  showRevision();
}

bool RubricDialog::newest() const {
  return !rubric_.revisions.empty() && revision_->currentIndex() == 0;
}

bool RubricDialog::edited() const {
  return newest() &&
         rubricText(rubric_.name, form_->revision()) != rubricText(rubric_.name, rubric_.revisions.back());
}

void RubricDialog::showRevision() {
  if (rubric_.revisions.empty()) {
    return;
  }
  const auto back = static_cast<std::size_t>(std::max(0, revision_->currentIndex()));
  form_->setRevision(rubric_.revisions[rubric_.revisions.size() - 1 - back]);
  form_->setReadOnly(!newest());
  changed();
}

void RubricDialog::changed() {
  const std::vector<RubricProblem> elsewhere = form_->showProblems();
  bool sound = true;
  try {
    checkRubric(form_->revision());
    preview_->beginSheet(form_->revision(), {});
  } catch (const Error&) {
    sound = false;
  }
  // Errors in other criteria than the one shown are listed with the criterion's name.
  QString said;
  if (!elsewhere.empty()) {
    const RubricProblem& first = elsewhere.front();
    said = tr("%1: %2").arg(toQString(first.where), translatedLine(Error(ErrorCode::kBadParameter, first.what,
                                                                         first.where, first.remedy)));
  }
  problem_->setText(said);
  problem_->setVisible(!said.isEmpty());
  import_->setEnabled(newest());
  publish_->setEnabled(sound && edited());
}

bool RubricDialog::importFrom(const std::filesystem::path& file) {
  return attempt(shell_, [&] {
    RubricTemplate taken = parseRubric(readFile(file), file.stem().string());
    taken.revision.number = form_->revision().number;
    form_->setRevision(taken.revision);
    changed();
  });
}

bool RubricDialog::exportTo(const std::filesystem::path& file) {
  return attempt(shell_, [&] { writeFileAtomically(file, rubricText(rubric_.name, form_->revision())); });
}

void RubricDialog::publish() {
  const std::optional<std::string> note =
      askReason(this, tr("Publish"),
                tr("Raters who are asked from now on fill in this sheet. Sheets that were asked for before "
                   "stay as they are; every revision is kept for good. What has changed?"));
  if (!note) {
    return;
  }
  const bool done = attempt(shell_, [&] {
    reviseRubric(shell_.session(), rubric_.id, form_->revision(), *note);
    shell_.notify(tr("%1: revision %2 is used from now on")
                      .arg(toQString(Text(rubric_.name)))
                      .arg(rubric_.revisions.back().number + 1));
  });
  if (done) {
    read();
  }
}

void RubricDialog::reject() {
  if (!edited() || mayLoseChanges(this)) {
    QDialog::reject();
  }
}

}  // namespace torsio::gui
