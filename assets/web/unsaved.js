// SPDX-License-Identifier: GPL-3.0-or-later
// Holds in this tab what could not be brought to the server yet, so that a reload loses nothing. Gone with the tab.

const kPrefix = 'torsio.unsaved.';

function keyOf(login, label) {
  return `${kPrefix}${login}.${label}`;
}

export function keepUnsaved(login, label, sheet) {
  try {
    sessionStorage.setItem(keyOf(login, label), JSON.stringify(sheet));
  } catch {
    // full or forbidden: the page itself still holds it, and asks before it is left
  }
}

export function dropUnsaved(login, label) {
  try {
    sessionStorage.removeItem(keyOf(login, label));
  } catch {
    // nothing was kept
  }
}

/// The sheet that was kept, or null.
export function unsavedSheet(login, label) {
  try {
    return JSON.parse(sessionStorage.getItem(keyOf(login, label)));
  } catch {
    return null;
  }
}

/// Everything of everybody: somebody signs out.
export function forgetUnsaved() {
  try {
    for (const key of Object.keys(sessionStorage)) {
      if (key.startsWith(kPrefix)) sessionStorage.removeItem(key);
    }
  } catch {
    // nothing was kept
  }
}
