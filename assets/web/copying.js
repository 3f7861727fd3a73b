// SPDX-License-Identifier: GPL-3.0-or-later
// Copies texts for messages outside Torsio.
import { show } from './dom.js';

/// Copies the text of a field, as field() of dom.js makes it. If the browser refuses, shows the field with its
/// text selected, to be copied by hand. True: copied.
export async function copyText({ row, input }) {
  try {
    await navigator.clipboard.writeText(input.value);
    return true;
  } catch {
    show(row, true);
    input.focus();
    input.select();
    return false;
  }
}
