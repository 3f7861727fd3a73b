// SPDX-License-Identifier: GPL-3.0-or-later
// Texts about a sheet's history.
import { dayText } from './numbers.js';
import { t } from './texts.js';

/// Names the step that undo or redo would perform. `change`: of SheetEditor; `view` names the rows.
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

/// Lists the submitted versions with time and reason, one line each.
export function versionsText(versions) {
  return versions.map(({ version, submitted_utc_us: sealed_us, reason, after_panel: afterPanel }) => {
    const day = dayText(sealed_us);
    if (!reason) return t('Version %1, %2', version, day);
    return afterPanel
      ? t("Version %1, %2, moved after the panel's marks were open: %3", version, day, reason)
      : t('Version %1, %2: %3', version, day, reason);
  }).join('\n');
}
