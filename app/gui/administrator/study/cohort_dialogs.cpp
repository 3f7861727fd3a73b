// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/study/cohort_dialogs.h"

#include <cmath>

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/statistics/power.h"

namespace torsio::gui {

CohortDialog::CohortDialog(const std::vector<CurriculumRow>& curricula, QWidget* parent)
    : QDialog(parent),
      name_(named(new QLineEdit(this), "name")),
      description_(new QLineEdit(this)),
      curriculum_(new QComboBox(this)),
      groups_(new QLineEdit(this)),
      groupsLabel_(new QLabel(tr("&Groups"), this)),
      margin_(ranged(named(new QDoubleSpinBox(this), "margin"), 0.0, kLargestMargin)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)),
      checks_(new FieldChecks(this)) {
  setWindowTitle(tr("New cohort"));
  curriculum_->addItem(tr("none yet"), QString());
  for (const auto& [id, title] : runningVersions(curricula)) {
    curriculum_->addItem(title, toQString(id));
  }
  curriculum_->setCurrentIndex(curriculum_->count() > 1 ? 1 : 0);
  groups_->setPlaceholderText(tr("Group 1, Group 2, Group 3"));
  groupsLabel_->setBuddy(groups_);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  form->setSpacing(kSpace);
  form->addRow(tr("&Name"), name_);
  checks_->addNeeded(form, name_, tr("Enter a name for the cohort."));
  form->addRow(tr("&Description"), description_);
  form->addRow(tr("&Curriculum"), curriculum_);
  form->addRow(groupsLabel_, groups_);
  checks_->add(form, groups_, [this] {
    return chosenId(curriculum_).empty() && cohort().groups.empty()
               ? tr("Name the groups, with commas between, or choose a curriculum.")
               : QString();
  });
  margin_->setDecimals(2);
  margin_->setSingleStep(0.25);
  margin_->setSpecialValueText(tr("none planned"));
  margin_->setSuffix(tr(" points"));
  form->addRow(tr("Differences that do not &matter, up to"), margin_);
  auto* why = sentence(this);
  why->setText(
      tr("The report then tests whether groups are equal within it. It belongs to the plan: it cannot be "
         "changed later."));
  form->addRow(QString(), why);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Create"));
  form->addRow(buttons_);
  name_->setMinimumWidth(360);
  checks_->decide(buttons_->button(QDialogButtonBox::Ok));
  connect(curriculum_, &QComboBox::currentIndexChanged, this, &CohortDialog::check);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  check();
}

void CohortDialog::check() {
  const bool byName = chosenId(curriculum_).empty();
  groups_->setVisible(byName);
  groupsLabel_->setVisible(byName);
  checks_->check();
}

NewCohort CohortDialog::cohort() const {
  NewCohort out{.name = name_->text().trimmed().toStdString(),
                .description = description_->text().trimmed().toStdString()};
  if (margin_->value() > 0.0) {
    out.equivalenceMargin = margin_->value();
  }
  out.curriculumVersionId = chosenId(curriculum_);
  if (!out.curriculumVersionId.empty()) {
    return out;
  }
  int number = 0;
  for (const QString& label : groups_->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    out.groups.push_back({QStringLiteral("G%1").arg(++number).toStdString(), label.trimmed().toStdString()});
  }
  return out;
}

std::vector<std::pair<std::string, QString>> runningVersions(const std::vector<CurriculumRow>& curricula) {
  std::vector<std::pair<std::string, QString>> out;
  for (const CurriculumRow& row : curricula) {
    for (auto version = row.versions.rbegin(); version != row.versions.rend(); ++version) {
      if (version->state == CurriculumState::kRunning) {
        out.emplace_back(version->id, CohortDialog::tr("%1, version %2")
                                          .arg(toQString(Text(row.curriculum.name)))
                                          .arg(version->number));
      }
    }
  }
  return out;
}

std::optional<std::string> askCohortName(QWidget* parent, const std::string& name) {
  QuestionDialog dialog(parent, CohortDialog::tr("Rename the cohort"),
                        CohortDialog::tr("Earlier reports keep the previous name."));
  auto* field = named(new QLineEdit(toQString(name), &dialog), "name");
  nameField(addField(dialog.column(), field), CohortDialog::tr("&Name"));
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), field, [field, &name] {
    const std::string typed = field->text().trimmed().toStdString();
    return typed.empty()   ? CohortDialog::tr("Enter a name for the cohort.")
           : typed == name ? CohortDialog::tr("This is the present name.")
                           : QString();
  });
  if (!dialog.ask(CohortDialog::tr("Rename"), &checks)) {
    return std::nullopt;
  }
  return field->text().trimmed().toStdString();
}

std::optional<CohortStateChange> askCohortState(QWidget* parent, const QString& names, CohortState state) {
  QuestionDialog dialog(parent, CohortDialog::tr("Close or archive"), names);
  auto* step = named(new QComboBox(&dialog), "step");
  const auto offer = [step](CohortState next, const QString& text) {
    step->addItem(text, static_cast<int>(next));
  };
  if (state == CohortState::kRunning) {
    offer(CohortState::kClosed, CohortDialog::tr("close: no more training, enrolment, calls or new sheets"));
  } else {
    if (state == CohortState::kClosed) {
      offer(CohortState::kArchived, CohortDialog::tr("archive: closed and hidden from lists"));
    }
    offer(CohortState::kRunning, CohortDialog::tr("reopen: training and scoring as before"));
  }
  nameField(addField(dialog.column(), step), CohortDialog::tr("&Step"));
  auto* reason = named(new QLineEdit(&dialog), "reason");
  nameField(addField(dialog.column(), reason), CohortDialog::tr("&Reason"));
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), reason,
             [reason] { return reason->text().trimmed().isEmpty() ? reasonWanted() : QString(); });
  if (!dialog.ask(CohortDialog::tr("Apply"), &checks)) {
    return std::nullopt;
  }
  return CohortStateChange{static_cast<CohortState>(step->currentData().toInt()),
                           reason->text().trimmed().toStdString()};
}

std::optional<std::string> askCurriculum(QWidget* parent, const QString& names,
                                         const std::vector<CurriculumRow>& curricula) {
  const auto running = runningVersions(curricula);
  QStringList titles;
  for (const auto& [id, title] : running) {
    titles << title;
  }
  bool given = false;
  const QString title = QInputDialog::getItem(
      parent, CohortDialog::tr("Follow a curriculum"),
      CohortDialog::tr("The groups of %1 follow its arms in order.").arg(names), titles, 0, false, &given);
  if (!given) {
    return std::nullopt;
  }
  for (const auto& [id, known] : running) {
    if (known == title) {
      return id;
    }
  }
  return std::nullopt;
}

namespace {

struct GroupMoveDialog {
  Q_DECLARE_TR_FUNCTIONS(GroupMoveDialog)
};

}  // namespace

std::optional<GroupMove> askGroupMove(QWidget* parent, const QString& codes,
                                      const std::vector<StudyGroup>& groups) {
  QuestionDialog asked(
      parent, GroupMoveDialog::tr("Move to another group"),
      GroupMoveDialog::tr("%1 was allocated to a group by the draw. A manual move is kept permanently beside "
                          "the drawn record, with its reason, and weakens the study.")
          .arg(codes));
  auto* group = named(new QComboBox(&asked), "group");
  for (const StudyGroup& one : groups) {
    group->addItem(toQString(one.code), toQString(one.id));
  }
  auto* reason = named(new QLineEdit(&asked), "reason");
  auto* form = new QFormLayout;
  form->addRow(GroupMoveDialog::tr("&Group"), group);
  form->addRow(GroupMoveDialog::tr("&Reason"), reason);
  FieldChecks checks(&asked);
  checks.addNeeded(form, reason, reasonWanted());
  asked.column()->addLayout(form);
  checks.decide(asked.finish(GroupMoveDialog::tr("Move")), [group] { return group->count() > 0; });
  if (asked.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return GroupMove{chosenId(group), reason->text().trimmed().toStdString()};
}

namespace {

enum Design { kTwoGroups, kBeforeAfter, kSeveralGroups, kAgreement };

constexpr int kPowerDialogWidth = 560;
constexpr int kMaxRaters = 50;

QDoubleSpinBox* spinOf(QWidget* parent, const char* name, double low, double high, double value) {
  auto* spin = ranged(new QDoubleSpinBox(parent), low, high);
  spin->setObjectName(QString::fromLatin1(name));
  spin->setDecimals(2);
  spin->setSingleStep(0.05);
  spin->setValue(value);
  return spin;
}

double sizeOf(int design, int groups, double effect, double power, double alpha) {
  return design == kTwoGroups     ? sizeTwoSampleT(effect, power, alpha)
         : design == kBeforeAfter ? sizePairedT(effect, power, alpha)
                                  : sizeAnova(groups, effect, power, alpha);
}

double powerOf(int design, int groups, double n, double effect, double alpha) {
  return design == kTwoGroups     ? powerTwoSampleT(n, effect, alpha)
         : design == kBeforeAfter ? powerPairedT(n, effect, alpha)
                                  : powerAnova(groups, n, effect, alpha);
}

double detectableOf(int design, int groups, double n, double power, double alpha) {
  return design == kTwoGroups     ? detectableTwoSampleT(n, power, alpha)
         : design == kBeforeAfter ? detectablePairedT(n, power, alpha)
                                  : detectableAnova(groups, n, power, alpha);
}

}  // namespace

PowerDialog::PowerDialog(QWidget* parent)
    : QDialog(parent),
      design_(named(new QComboBox(this), "design")),
      groups_(ranged(new QSpinBox(this), 3, 10)),
      effect_(spinOf(this, "effect", 0.1, 5.0, 0.8)),
      power_(spinOf(this, "power", 0.5, 0.99, 0.8)),
      alpha_(spinOf(this, "alpha", 0.01, 0.2, kDefaultAlpha)),
      correlation_(spinOf(this, "correlation", 0.0, 0.95, 0.5)),
      icc_(spinOf(this, "icc", 0.05, 0.95, 0.7)),
      width_(spinOf(this, "width", 0.05, 1.0, 0.3)),
      raters_(ranged(named(new QSpinBox(this), "raters"), 2, kMaxRaters)),
      atHand_(ranged(named(new QSpinBox(this), "atHand"), 3, 1000)),
      form_(new QFormLayout),
      needed_(named(sentence(this, false), "needed")),
      shown_(named(sentence(this, false), "shown")) {
  setWindowTitle(tr("How many trainees and raters?"));
  setMinimumWidth(kPowerDialogWidth);
  design_->addItem(tr("two groups (t test, Cohen's d)"));
  design_->addItem(tr("one group before and after (d of the differences)"));
  design_->addItem(tr("several groups (analysis of variance, Cohen's f)"));
  design_->addItem(tr("agreement of raters (ICC, width of its 95 % interval)"));
  raters_->setValue(4);
  atHand_->setValue(10);
  form_->addRow(tr("&Comparison"), design_);
  form_->addRow(tr("&Groups"), groups_);
  form_->addRow(tr("&Effect that must not be missed"), effect_);
  form_->addRow(tr("&Power wanted"), power_);
  form_->addRow(tr("Significance &level"), alpha_);
  form_->addRow(tr("Co&rrelation of the scores before and after"), correlation_);
  form_->addRow(tr("Agreement of one rater e&xpected (ICC)"), icc_);
  form_->addRow(tr("&Width of its interval, at most"), width_);
  form_->addRow(tr("R&aters who score everybody"), raters_);
  form_->addRow(tr("Needed"), needed_);
  form_->addRow(tr("Trainees at &hand, each group"), atHand_);
  form_->addRow(tr("What they show"), shown_);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
  column->addLayout(form_);
  auto* raters = sentence(this);
  raters->setText(
      tr("Once there are marks, Results shows in the section Raters how many raters a mean score needs."));
  column->addWidget(raters);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(design_, &QComboBox::currentIndexChanged, this, &PowerDialog::showAnswer);
  for (QSpinBox* spin : {groups_, raters_, atHand_}) {
    connect(spin, &QSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  for (QDoubleSpinBox* spin : {effect_, power_, alpha_, correlation_, icc_, width_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  showAnswer();
}

void PowerDialog::showAnswer() {
  const int design = design_->currentIndex();
  for (QDoubleSpinBox* of : {effect_, power_, alpha_}) {
    form_->setRowVisible(of, design != kAgreement);
  }
  form_->setRowVisible(groups_, design == kSeveralGroups);
  form_->setRowVisible(correlation_, design == kTwoGroups || design == kSeveralGroups);
  qobject_cast<QLabel*>(form_->labelForField(atHand_))
      ->setText(design == kTwoGroups || design == kSeveralGroups ? tr("Trainees at &hand, each group")
                                                                 : tr("Trainees at &hand"));
  for (QWidget* of :
       {static_cast<QWidget*>(icc_), static_cast<QWidget*>(width_), static_cast<QWidget*>(raters_)}) {
    form_->setRowVisible(of, design == kAgreement);
  }
  if (design == kAgreement) {
    showAgreement();
    return;
  }
  const int groups = groups_->value();
  const double n = atHand_->value();
  const double size = sizeOf(design, groups, effect_->value(), power_->value(), alpha_->value());
  const auto whole = [](double needed) { return static_cast<int>(std::ceil(needed)); };
  needed_->setText(design == kBeforeAfter
                       ? tr("%n trainee(s)", nullptr, whole(size))
                       : tr("%n trainee(s) in each group; %1 when scores are adjusted for the score before",
                            nullptr, whole(size))
                             .arg(whole(sizeWithCovariate(size, correlation_->value()))));
  shown_->setText(tr("power %1 for this effect; with power %2 they detect an effect of %3")
                      .arg(powerOf(design, groups, n, effect_->value(), alpha_->value()), 0, 'f', 2)
                      .arg(power_->value(), 0, 'f', 2)
                      .arg(detectableOf(design, groups, n, power_->value(), alpha_->value()), 0, 'f', 2));
  growToSentences(this);
}

void PowerDialog::showAgreement() {
  const auto sizeFor = [this](int raters) {
    return std::ceil(sizeIccWidth(icc_->value(), raters, width_->value()));
  };
  needed_->setText(tr("%1 trainees, each scored by %2 raters")
                       .arg(QString::number(sizeFor(raters_->value()), 'f', 0))
                       .arg(raters_->value()));
  int raters = 2;
  while (raters < kMaxRaters && sizeFor(raters) > atHand_->value()) {
    ++raters;
  }
  shown_->setText(sizeFor(raters) <= atHand_->value()
                      ? tr("%1 raters are enough for this width").arg(raters)
                      : tr("too few trainees for this width, even with more raters"));
  growToSentences(this);
}

}  // namespace torsio::gui
