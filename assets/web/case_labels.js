// SPDX-License-Identifier: GPL-3.0-or-later
// What a case page says of its sheet's history.
import { dayText } from './numbers.js';
import { t } from './texts.js';

/// What undo takes back or redo brings again. `change` of SheetEditor; `view` names the rows.
export function stepName({ kind, row }, view) {
  const name = view.nameOf(row);
  switch (kind) {
    case 'score':
      return t('mark of %1', name);
    case 'cleared':
      return t('clearing of %1', name);
    case 'not_assessable':
      return t('reason for %1', name);
    case 'comment':
      return t('comment');
    default:
      return t('clearing of the sheet');
  }
}

/// What was sealed when and why, a line a version.
export function versionsText(versions) {
  return versions.map(({ version, submitted_utc_us: sealed_us, reason, after_panel: afterPanel }) => {
    const day = dayText(sealed_us);
    if (!reason) return t('Version %1, %2', version, day);
    return afterPanel
      ? t("Version %1, %2, moved after the panel's marks were open: %3", version, day, reason)
      : t('Version %1, %2: %3', version, day, reason);
  }).join('\n');
}
