// SPDX-License-Identifier: GPL-3.0-or-later
// Modal dialogs.
import { button, field, h, say } from './dom.js';
import { scoreText } from './numbers.js';
import { t } from './texts.js';

/// Shows a modal dialog; resolves with what its buttons pass to `finish`, or null if it was closed.
function ask(title, fill, { mayCancel = true } = {}) {
  return new Promise((resolve) => {
    let answer = null;
    const dialog = h('dialog', { 'aria-labelledby': 'dialog-title' }, h('h2', { id: 'dialog-title' }, title));
    const finish = (given) => {
      answer = given;
      dialog.close();
    };
    dialog.append(fill(finish));
    dialog.addEventListener('cancel', (event) => {
      if (!mayCancel) event.preventDefault();
    });
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(answer);
    });
    document.body.append(dialog);
    dialog.showModal();
  });
}

/// Resolves with the signer's password, or null. `problem`: why the last one was rejected.
export function askSignature({ meaning, login, problem }) {
  return ask(t('Sign'), (finish) => {
    const secret = field(t('Your password'), { type: 'password', autocomplete: 'current-password', required: true, autofocus: true });
    const said = h('p', { class: 'said caution', role: 'alert' });
    say(said, problem);
    return h('form', {
      class: 'stack', novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        if (secret.input.value) finish(secret.input.value);
      },
    },
      h('p', { class: 'meaning' }, t('“%1”', meaning)),
      h('p', { class: 'quiet' }, t('You sign this as %1. Your name, the time and this meaning are kept with it for good.', login)),
      h('input', { type: 'text', autocomplete: 'username', value: login, hidden: true }),
      secret.row, said,
      h('div', { class: 'actions' },
        h('button', { type: 'submit', class: 'primary' }, t('Sign')),
        button(t('Cancel'), () => finish(null))));
  });
}

/// Resolves with the words typed, or null.
export function askReason(title, words) {
  return ask(title, (finish) => {
    const why = field(t('Reason'), { maxlength: '400', autocomplete: 'off', required: true, autofocus: true });
    return h('form', {
      class: 'stack', novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        if (why.input.value.trim()) finish(why.input.value.trim());
      },
    },
      h('p', {}, words), why.row,
      h('div', { class: 'actions' },
        h('button', { type: 'submit', class: 'primary' }, title),
        button(t('Cancel'), () => finish(null))));
  });
}

/// Resolves with 'newer' or 'mine', or null if the page was locked.
export function askConflict({ mine, newer, rubric, nameOf }) {
  const scaleOf = (code) => rubric.rows.find((row) => row.code === code)?.scale ?? rubric.overall;
  const text = (code, { score_steps: steps, not_assessable: reason }) =>
    steps !== null ? scoreText(steps, scaleOf(code)) : reason ? t('not assessable') : '\u2013';
  const overall = (sheet) => ({ score_steps: sheet.overall_steps, not_assessable: sheet.overall_not_assessable ?? '' });
  const lines = mine.rows.map((row) => {
    const there = newer.rows.find((one) => one.code === row.code) ?? { score_steps: null, not_assessable: '' };
    return [nameOf(row.code), text(row.code, row), text(row.code, there)];
  });
  if (rubric.overall) lines.push([nameOf(''), text('', overall(mine)), text('', overall(newer))]);
  lines.push([t('Comment for the trainee'), mine.comment || '\u2013', newer.comment || '\u2013']);
  return ask(t('This sheet was changed elsewhere'), (finish) => h('div', { class: 'stack' },
    h('p', {}, t('It was changed in another window or at the desk, and that version is newer. Which one do you want to keep?')),
    h('table', {},
      h('thead', {}, h('tr', {}, h('td', {}), h('th', { scope: 'col' }, t('Here')), h('th', { scope: 'col' }, t('Newer')))),
      h('tbody', {}, lines.map(([name, here, there]) =>
        h('tr', { class: here === there ? '' : 'differs' }, h('th', { scope: 'row' }, name), h('td', {}, here), h('td', {}, there))))),
    h('div', { class: 'actions' },
      button(t('Use the newer one'), () => finish('newer'), { class: 'take-newer' }),
      button(t('Keep mine'), () => finish('mine'), { class: 'keep-mine' }))), { mayCancel: false });
}
