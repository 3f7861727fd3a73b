// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/group_move_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"

namespace torsio::gui {

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
  auto* group = new QComboBox(&asked);
  group->setObjectName(QStringLiteral("group"));
  for (const StudyGroup& one : groups) {
    group->addItem(toQString(one.code), toQString(one.id));
  }
  auto* reason = new QLineEdit(&asked);
  reason->setObjectName(QStringLiteral("reason"));
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

}  // namespace torsio::gui
