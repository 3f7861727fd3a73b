// SPDX-License-Identifier: GPL-3.0-or-later
// Overview of the keys of a case.
import { h } from './dom.js';
import { t } from './texts.js';

export function keysHelp() {
  const keys = [
    ['0 \u2026 9', t('Give the selected row a mark; 1 and then 0 is ten')],
    ['\u2190 \u2192', t('Half a point less or more; with Shift the finest step')],
    ['\u2191 \u2193, Tab', t('Another row')],
    ['N, X', t('Not assessable: type why, Enter')],
    ['Backspace', t('Clear the mark')],
    ['Ctrl+Z, Ctrl+Y', t('Undo, redo')],
    ['Ctrl+Enter', t('Submit; press again to seal')],
    ['Esc', t('Out of the sheet, to the button that submits')],
    [t('Space'), t('Play, pause')],
    ['J, K, L', t('Five seconds back, pause, play')],
    [',  .', t('One picture back, one picture on')],
    ['Home, End', t('Beginning, end of the recording')],
    ['B', t('Bookmark this moment, for yourself')],
    ['R', t('Remark at this moment, for the trainee')],
    ['Shift+R', t('Edit your nearest remark')],
  ];
  return h('details', { class: 'keys unfolds' }, h('summary', {}, t('Keys')),
    h('dl', {}, keys.map(([key, meaning]) => h('div', {}, h('dt', {}, h('kbd', {}, key)), h('dd', {}, meaning)))));
}
