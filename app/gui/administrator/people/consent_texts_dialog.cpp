// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/consent_texts_dialog.h"

#include <algorithm>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/first_run.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"

namespace torsio::gui {

namespace {

constexpr int kTextsWidth = 960;
constexpr int kTextsHeight = 600;
constexpr int kListWidth = 240;

/// Returns a language's own name; its code if unknown.
QString nameOfLanguage(const std::string& code) {
  if (const auto known = languageOf(toQString(code))) {
    return languageName(*known);
  }
  const QString own = QLocale(toQString(code)).nativeLanguageName();
  return own.isEmpty() ? toQString(code) : own;
}

bool sameTexts(const std::vector<ConsentWords>& a, const std::vector<ConsentWords>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ConsentWords& x, const ConsentWords& y) {
    return x.language == y.language &&
           std::equal(x.texts.begin(), x.texts.end(), y.texts.begin(), y.texts.end(),
                      [](const ConsentText& left, const ConsentText& right) {
                        return left.purpose == right.purpose && left.title == right.title &&
                               left.text == right.text;
                      });
  });
}

}  // namespace

ConsentTextsDialog::ConsentTextsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      version_(named(new QComboBox(this), "version")),
      language_(named(new QComboBox(this), "language")),
      addLanguage_(named(new QPushButton(tr("Add a &language\u2026"), this), "addLanguage")),
      purposes_(named(new QListWidget(this), "purposes")),
      addPurpose_(named(new QPushButton(tr("&Add"), this), "addPurpose")),
      removePurpose_(named(new QPushButton(tr("&Remove"), this), "removePurpose")),
      title_(named(new QLineEdit(this), "title")),
      text_(named(new QPlainTextEdit(this), "text")),
      print_(named(new QPushButton(tr("Print &forms\u2026"), this), "printForms")),
      publish_(named(new QPushButton(tr("&Publish\u2026"), this), "publish")) {
  setObjectName(QStringLiteral("consentTexts"));
  setWindowTitle(tr("Consent texts"));
  resize(kTextsWidth, kTextsHeight);
  build();
  connect(version_, &QComboBox::currentIndexChanged, this, &ConsentTextsDialog::showVersion);
  connect(language_, &QComboBox::currentIndexChanged, this, &ConsentTextsDialog::showPurposes);
  connect(purposes_, &QListWidget::currentRowChanged, this, &ConsentTextsDialog::showText);
  connect(title_, &QLineEdit::textEdited, this, &ConsentTextsDialog::takeText);
  connect(text_, &QPlainTextEdit::textChanged, this, &ConsentTextsDialog::takeText);
  connect(addPurpose_, &QPushButton::clicked, this, &ConsentTextsDialog::addPurpose);
  connect(removePurpose_, &QPushButton::clicked, this, &ConsentTextsDialog::removePurpose);
  connect(addLanguage_, &QPushButton::clicked, this, &ConsentTextsDialog::addLanguage);
  connect(publish_, &QPushButton::clicked, this, &ConsentTextsDialog::publish);
  connect(print_, &QPushButton::clicked, this, &ConsentTextsDialog::print);
  read();
}

void ConsentTextsDialog::build() {
  QVBoxLayout* column = pageColumn(this);
  QLabel* said = sentence(
      this,
      tr("What people are asked to agree to, in each language. A change becomes the next version; what was "
         "agreed to before stays under its own. Let your data protection officer read it first."));
  column->addWidget(said);
  QHBoxLayout* top = rowOf();
  version_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  language_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  nameField(addField(top, version_), tr("&Version"));
  nameField(addField(top, language_), tr("La&nguage"));
  top->addWidget(addLanguage_);
  top->addStretch(1);
  column->addLayout(top);
  languageHint_ = fieldHint(this);
  column->addWidget(languageHint_);
  QHBoxLayout* middle = rowOf({}, 2 * kSpace);
  auto* left = new QVBoxLayout;
  purposes_->setFixedWidth(kListWidth);
  nameField(addField(left, purposes_), tr("P&urposes"));
  auto* tools = new QHBoxLayout;
  tools->addWidget(addPurpose_);
  tools->addWidget(removePurpose_);
  left->addLayout(tools);
  middle->addLayout(left);
  auto* right = new QVBoxLayout;
  nameField(addField(right, title_), tr("&Title"));
  titleHint_ = fieldHint(this);
  right->addWidget(titleHint_);
  nameField(addField(right, text_), tr("Te&xt"));
  textHint_ = fieldHint(this);
  right->addWidget(textHint_);
  middle->addLayout(right, 1);
  column->addLayout(middle, 1);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(print_, QDialogButtonBox::ActionRole);
  buttons->addButton(publish_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
  publish_->setProperty("primary", true);
  connect(buttons, &QDialogButtonBox::rejected, this, &ConsentTextsDialog::reject);
  column->addWidget(buttons);
  pressNothingByEnter(*this);
}

void ConsentTextsDialog::read() {
  attempt(shell_, [&] { versions_ = consentVersions(shell_.session(), shell_.assets()); });
  {
    const QSignalBlocker quiet(version_);
    version_->clear();
    for (auto version = versions_.rbegin(); version != versions_.rend(); ++version) {
      version_->addItem(version->note.empty()
                            ? tr("%1 (as it ships)").arg(toQString(version->id))
                            : tr("%1: %2").arg(toQString(version->id), toQString(version->note)));
    }
  }
  showVersion();
}

bool ConsentTextsDialog::newest() const {
  return !versions_.empty() && version_->currentIndex() == 0;
}

bool ConsentTextsDialog::edited() const {
  return newest() && !sameTexts(shown_.languages, versions_.back().languages);
}

ConsentWords* ConsentTextsDialog::words() {
  const auto at = static_cast<std::size_t>(std::max(0, language_->currentIndex()));
  return at < shown_.languages.size() ? &shown_.languages[at] : nullptr;
}

void ConsentTextsDialog::showVersion() {
  if (versions_.empty()) {
    return;
  }
  shown_ = versions_[versions_.size() - 1 - static_cast<std::size_t>(std::max(0, version_->currentIndex()))];
  showLanguages();
}

void ConsentTextsDialog::showLanguages() {
  const QString before =
      language_->currentIndex() < 0 ? languageCode(presentLanguage()) : language_->currentData().toString();
  {
    const QSignalBlocker quiet(language_);
    language_->clear();
    for (const ConsentWords& one : shown_.languages) {
      language_->addItem(nameOfLanguage(one.language), toQString(one.language));
    }
    language_->setCurrentIndex(std::max(0, language_->findData(before)));
  }
  showPurposes();
}

void ConsentTextsDialog::showPurposes() {
  const int before = std::max(0, purposes_->currentRow());
  {
    const QSignalBlocker quiet(purposes_);
    purposes_->clear();
    if (const ConsentWords* present = words()) {
      for (const ConsentText& text : present->texts) {
        purposes_->addItem(text.title.empty() ? tr("(no title)") : toQString(text.title));
      }
    }
    purposes_->setCurrentRow(std::min(before, purposes_->count() - 1));
  }
  showText();
}

void ConsentTextsDialog::showText() {
  filling_ = true;
  const ConsentWords* present = words();
  const auto at = static_cast<std::size_t>(std::max(0, purposes_->currentRow()));
  const bool any = present != nullptr && at < present->texts.size();
  title_->setText(any ? toQString(present->texts[at].title) : QString());
  text_->setPlainText(any ? toQString(present->texts[at].text) : QString());
  filling_ = false;
  showButtons();
}

bool ConsentTextsDialog::showHints() {
  const ConsentWords* present = words();
  const auto at = static_cast<std::size_t>(std::max(0, purposes_->currentRow()));
  const auto whole = [](const ConsentText& text) { return !text.title.empty() && !text.text.empty(); };
  const ConsentText* shown = present != nullptr && at < present->texts.size() ? &present->texts[at] : nullptr;
  sayHint(titleHint_, shown != nullptr && shown->title.empty() ? tr("Give the purpose a title.") : QString());
  sayHint(textHint_, shown != nullptr && shown->text.empty() ? tr("Enter what people agree to.") : QString());
  QString elsewhere;
  bool sound = shown == nullptr || whole(*shown);
  for (const ConsentWords& one : shown_.languages) {
    for (std::size_t i = 0; i < one.texts.size(); ++i) {
      if (whole(one.texts[i]) || &one.texts[i] == shown) {
        continue;
      }
      sound = false;
      if (elsewhere.isEmpty()) {
        elsewhere = tr("Purpose %1 has no title or no text in this language yet: %2.")
                        .arg(i + 1)
                        .arg(nameOfLanguage(one.language));
      }
    }
  }
  sayHint(languageHint_, elsewhere);
  return sound;
}

void ConsentTextsDialog::showButtons() {
  const bool editable = newest() && shell_.may(Operation::kSettingsEdit);
  const ConsentWords* present = words();
  const auto at = static_cast<std::size_t>(std::max(0, purposes_->currentRow()));
  const bool any = present != nullptr && at < present->texts.size();
  title_->setReadOnly(!editable);
  text_->setReadOnly(!editable);
  addPurpose_->setEnabled(editable);
  addLanguage_->setEnabled(editable);
  removePurpose_->setEnabled(editable && any && present->texts[at].purpose != kTrainingRecord);
  removePurpose_->setToolTip(tr("The training record stays: without it nothing may be recorded"));
  const bool sound = showHints();
  publish_->setEnabled(editable && edited() && sound);
  print_->setEnabled(any && !edited());
  print_->setToolTip(edited() ? tr("Publish first: a form names the version of its text") : QString());
}

void ConsentTextsDialog::takeText() {
  ConsentWords* present = words();
  const auto at = static_cast<std::size_t>(std::max(0, purposes_->currentRow()));
  if (filling_ || !newest() || present == nullptr || at >= present->texts.size()) {
    return;
  }
  present->texts[at].title = title_->text().trimmed().toStdString();
  present->texts[at].text = text_->toPlainText().trimmed().toStdString();
  purposes_->currentItem()->setText(title_->text().isEmpty() ? tr("(no title)") : title_->text());
  showButtons();
}

void ConsentTextsDialog::addPurpose() {
  for (ConsentWords& one : shown_.languages) {
    one.texts.emplace_back();
  }
  showPurposes();
  purposes_->setCurrentRow(purposes_->count() - 1);
  title_->setFocus();
}

void ConsentTextsDialog::removePurpose() {
  const auto at = static_cast<std::ptrdiff_t>(purposes_->currentRow());
  for (ConsentWords& one : shown_.languages) {
    one.texts.erase(one.texts.begin() + at);
  }
  showPurposes();
}

void ConsentTextsDialog::addLanguage() {
  QuestionDialog dialog(this, tr("Add a language"),
                        tr("Its code as on web pages, such as de, fr or pt_BR. The texts of the language "
                           "that is shown are copied for you to translate."));
  auto* code = named(new QLineEdit(&dialog), "code");
  nameField(addField(dialog.column(), code), tr("&Code"));
  QPushButton* ok = dialog.finish(tr("Add"));
  const auto check = [&] {
    const QString typed = code->text().trimmed();
    const bool taken =
        std::any_of(shown_.languages.begin(), shown_.languages.end(),
                    [&typed](const ConsentWords& one) { return toQString(one.language) == typed; });
    ok->setEnabled(!taken && QLocale(typed).language() != QLocale::C);
  };
  connect(code, &QLineEdit::textChanged, &dialog, check);
  check();
  const ConsentWords* present = words();
  if (dialog.exec() != QDialog::Accepted || present == nullptr) {
    return;
  }
  ConsentWords added{code->text().trimmed().toStdString(), present->texts};
  shown_.languages.push_back(std::move(added));
  showLanguages();
  language_->setCurrentIndex(language_->count() - 1);
}

void ConsentTextsDialog::publish() {
  const std::optional<std::string> note =
      askReason(this, tr("Publish"),
                tr("From now on everybody is asked with these texts. Earlier decisions stay; people who "
                   "decided on an earlier text see this on their page. What has changed?"));
  if (!note) {
    return;
  }
  const bool done = attempt(shell_, [&] {
    const std::string id = publishConsent(shell_.session(), shell_.assets(), shown_.languages, *note);
    shell_.notify(tr("%1 is asked from now on").arg(toQString(id)));
  });
  if (done) {
    read();
  }
}

void ConsentTextsDialog::print() {
  const ConsentWords* present = words();
  if (present == nullptr) {
    return;
  }
  const QString file =
      askFileToSave(this, tr("Consent forms to sign"), QStringLiteral("consent-forms"), tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell_, [&] {
    std::vector<std::string> codes;
    for (const PersonRow& row : people(shell_.session())) {
      const bool given =
          std::find(row.consents.begin(), row.consents.end(), kTrainingRecord) != row.consents.end();
      if (row.trainee && row.person.state == PersonState::kActive && !given) {
        codes.push_back(row.person.code);
      }
    }
    codes.emplace_back();  // a blank form for latecomers
    writeConsentForms(shown_, *present, codes,
                      toQString(centreSign(shell_.session().connectionWithoutRight()).name), toPath(file));
    shell_.notify(
        tr("%n form(s) written, the last one without a code", nullptr, static_cast<int>(codes.size())));
  });
}

void ConsentTextsDialog::reject() {
  if (!edited() || mayLoseChanges(this)) {
    QDialog::reject();
  }
}

}  // namespace torsio::gui
