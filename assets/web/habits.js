// SPDX-License-Identifier: GPL-3.0-or-later
// User preferences stored in the browser.

const kAdvance = 'torsio.advance';

/// True if the next row is to be selected after each figure.
export function remembersAdvancing() {
  try {
    return localStorage.getItem(kAdvance) === 'yes';
  } catch {
    return false; // no storage
  }
}

export function rememberAdvancing(advancing) {
  try {
    localStorage.setItem(kAdvance, advancing ? 'yes' : 'no');
  } catch {
    // no storage: applies to this case only
  }
}
