// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/shown_once_dialog.h"

#include <utility>

#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/error.h"

namespace torsio::gui {

ShownOnceDialog::ShownOnceDialog(const Words& words, std::vector<Row> rows,
                                 std::function<void(const std::filesystem::path&)> write, QWidget* parent)
    : QDialog(parent),
      words_(words),
      write_(std::move(write)),
      table_(new DataTable(QString(), this)),
      buttons_(new QDialogButtonBox(this)),
      cards_(new QPushButton(tr("Save &cards (PDF)\u2026"), this)) {
  setWindowTitle(words_.title);
  resize(640, 500);
  QLabel* said = sentence(this);
  said->setText(words_.said);
  table_->setColumns({{tr("Person")}, {tr("Sign-in name")}, {words_.secret}});
  table_->setRows(std::move(rows));
  buttons_->addButton(cards_, QDialogButtonBox::ActionRole);
  buttons_->addButton(tr("Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  cards_->setDefault(true);
  cards_->setFocus();
  connect(cards_, &QPushButton::clicked, this, &ShownOnceDialog::askCards);
  connect(buttons_, &QDialogButtonBox::rejected, this, &ShownOnceDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(said);
  column->addWidget(table_, 1);
  column->addWidget(buttons_);
}

void ShownOnceDialog::addWay(QPushButton* button) {
  button->setAutoDefault(false);
  buttons_->addButton(button, QDialogButtonBox::ActionRole);
}

void ShownOnceDialog::saveCards(const std::filesystem::path& file) {
  write_(file);
  cards_->setText(tr("Cards saved"));
  noteTaken();
}

void ShownOnceDialog::askCards() {
  const QString file = askFileToSave(this, tr("Save cards"), words_.fileName, tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    saveCards(toPath(file));
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save cards"), translatedLine(error));
  }
}

void ShownOnceDialog::reject() {
  if (!taken_ && QMessageBox::question(this, windowTitle(), words_.question) != QMessageBox::Yes) {
    return;
  }
  QDialog::reject();
}

}  // namespace torsio::gui
