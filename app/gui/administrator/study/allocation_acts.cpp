// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of AllocationPage: lock, draw, move, open the seal, print, check.
#include <algorithm>
#include <map>
#include <optional>

#include <QComboBox>
#include <QMessageBox>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohort_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/services/access/all_or_none.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"

namespace torsio::gui {

bool AllocationPage::lock(const std::string& supersedeReason) {
  return attempt(shell(), [&] {
    lockAllocation(shell().session(), plan(), supersedeReason);
    read();
    shell().notify(tr("The design is locked and its seed is sealed"));
  });
}

void AllocationPage::askLock() {
  std::string reason;
  if (!designs_.empty() && designs_.back().records > 0) {
    const std::optional<std::string> given =
        askReason(this, tr("Replace the design"),
                  tr("Trainees were already allocated by the present design; they stay where they are."));
    if (!given) {
      return;
    }
    reason = *given;
  } else if (QMessageBox::question(
                 this, tr("Lock the design"),
                 tr("After locking, the design cannot be changed without a trace. Lock it?")) !=
             QMessageBox::Yes) {
    return;
  }
  lock(reason);
}

bool AllocationPage::allocateEverybody() {
  return attempt(shell(), [&] {
    const std::size_t people = allocateAll(shell().session(), chosenId(cohort_));
    read();
    shell().notify(tr("%n trainee(s) allocated", nullptr, static_cast<int>(people)));
  });
}

void AllocationPage::askMove() {
  // The present group of each trainee of the selected records.
  std::map<EnrolmentId, GroupId> present;
  for (const AllocationEntry* record :
       chosenRows(*records_, drawn_, [](const AllocationEntry& one) { return one.id; })) {
    present[record->enrolmentId];
  }
  for (const AllocationEntry& record : drawn_) {
    if (const auto known = present.find(record.enrolmentId); known != present.end()) {
      known->second = record.groupId;
    }
  }
  if (present.empty()) {
    return;
  }
  attempt(shell(), [&] {
    QStringList codes;
    for (const Enrolment& one : enrolments(shell().session(), chosenId(cohort_))) {
      if (present.contains(one.id)) {
        codes << toQString(one.traineeCode);
      }
    }
    std::vector<StudyGroup> groups;
    for (const CohortRow& cohort : cohorts(shell().session())) {
      if (cohort.cohort.id == chosenId(cohort_)) {
        groups = cohort.groups;
      }
    }
    std::erase_if(groups, [&](const StudyGroup& group) {
      return std::all_of(present.begin(), present.end(),
                         [&](const auto& one) { return one.second == group.id; });
    });
    const std::optional<GroupMove> move = askGroupMove(this, firstFew(codes), groups);
    if (!move) {
      return;
    }
    std::erase_if(present, [&](const auto& one) { return one.second == move->groupId; });
    allOrNone(shell().session(), present, [&](const auto& one) {
      overrideAllocation(shell().session(), chosenId(cohort_), one.first, move->groupId, move->reason);
    });
    read();
    shell().notify(
        tr("%n trainee(s) moved by hand; the drawn records stay", nullptr, static_cast<int>(present.size())));
  });
}

bool AllocationPage::reveal(const std::string& reason) {
  return attempt(shell(), [&] {
    if (designs_.empty()) {
      return;
    }
    const DesignId id = designs_.back().stored.id;
    actOrAsk(this, shell(), {.act = DutyAct::kRevealAllocation, .subject = id, .reason = reason},
             [&] { revealSeed(shell().session(), id, reason); });
    read();
  });
}

void AllocationPage::askReveal() {
  const std::optional<std::string> reason =
      askReason(this, tr("Open the seal"),
                tr("From now on anybody can repeat the draw and predict the remaining allocations."));
  if (reason) {
    reveal(*reason);
  }
}

bool AllocationPage::writeCards(const std::filesystem::path& file) {
  return attempt(shell(), [&] {
    writeSealedCards(takeOutCards(shell().session(), chosenId(cohort_)), cohort_->currentText().toStdString(),
                     file);
    shell().notify(tr("Written: %1").arg(toQString(file)));
  });
}

void AllocationPage::askCards() {
  const QString file =
      askFileToSave(this, tr("Sealed cards"), QStringLiteral("cards.pdf"), tr("PDF (*.pdf)"));
  if (!file.isEmpty()) {
    writeCards(toPath(file));
  }
}

void AllocationPage::check() {
  attempt(shell(), [&] {
    const AllocationCheck found = checkAllocation(shell().session(), designs_.back().stored.id);
    QMessageBox::information(
        this, tr("Check of the draw"),
        found.sound ? tr("The whole draw was repeated: every record is as drawn (%1), moved by hand: %2.")
                          .arg(found.records)
                          .arg(found.overrides)
                    : tr("The draw does not match its record: %1").arg(toQString(found.finding)));
  });
}

}  // namespace torsio::gui
