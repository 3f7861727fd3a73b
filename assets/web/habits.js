// SPDX-License-Identifier: GPL-3.0-or-later
// What a person is used to, kept by the browser.

const kAdvance = 'torsio.advance';

/// Whether the next row is marked by itself after each figure.
export function remembersAdvancing() {
  try {
    return localStorage.getItem(kAdvance) === 'yes';
  } catch {
    return false; // a browser that keeps nothing
  }
}

export function rememberAdvancing(advancing) {
  try {
    localStorage.setItem(kAdvance, advancing ? 'yes' : 'no');
  } catch {
    // then it holds for this case
  }
}
