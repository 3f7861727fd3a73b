// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps unsaved work in the tab's session storage, so that a reload loses nothing.

const kPrefix = 'torsio.unsaved.';

function keyOf(login, label) {
  return `${kPrefix}${login}.${label}`;
}

export function keepUnsaved(login, label, sheet) {
  try {
    sessionStorage.setItem(keyOf(login, label), JSON.stringify(sheet));
  } catch {
    // full or forbidden: the page still has it, and asks before it is left
  }
}

export function dropUnsaved(login, label) {
  try {
    sessionStorage.removeItem(keyOf(login, label));
  } catch {
    // nothing stored
  }
}

/// Returns the stored sheet, or null.
export function unsavedSheet(login, label) {
  try {
    return JSON.parse(sessionStorage.getItem(keyOf(login, label)));
  } catch {
    return null;
  }
}

/// Removes everything, on signing out.
export function forgetUnsaved() {
  try {
    for (const key of Object.keys(sessionStorage)) {
      if (key.startsWith(kPrefix)) sessionStorage.removeItem(key);
    }
  } catch {
    // nothing stored
  }
}
