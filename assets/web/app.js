// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the pages: texts, who is signed in, which page the address names.
import { api, useToken, whenSignedOut } from './api.js';
import { CasePage } from './case_page.js';
import { button, h, say, show } from './dom.js';
import { draftsUnderway, stopDrafts } from './drafts_underway.js';
import { Gate } from './gate.js';
import { IdleWatch } from './idle.js';
import { problemText } from './problem.js';
import { QueuePage } from './queue_page.js';
import { putSignInForm } from './sign_in_form.js';
import { chooseLanguage, language, locale, t, useTexts, wantedLanguage } from './texts.js';
import { forgetUnsaved } from './unsaved.js';

const kLanguageNames = { en: 'English', zh_CN: '\u7b80\u4f53\u4e2d\u6587' };
const kUsualIdle_s = 300;
const kNotice_ms = 6000;
const kWarning_ms = 60_000;

const main = h('main', { id: 'main', tabindex: '-1' });
const said = h('div', { class: 'notice', role: 'status' });
const who = h('span', { class: 'who' });
const leave = button('', signOut);
const head = h('header', { class: 'top' });
const foot = h('footer', { class: 'foot' });
const behind = h('div', { class: 'behind' }, head, main, foot);
const gate = new Gate(behind, signOut);
const idle = new IdleWatch({
  warned: (left_s) => frame.notify(t('Nobody here? The screen will be locked in %1 s. Press any key to stay', left_s), kWarning_ms),
  back: () => frame.notify(''),
  idle: lock,
});
let user = null;
let page = null;

/// What pages may ask of the frame they stand in.
const frame = {
  /// Says something in passing.
  notify(text, for_ms = kNotice_ms) {
    say(said, text);
    show(said, text !== '');
    clearTimeout(frame.timer);
    frame.timer = setTimeout(() => show(said, false), for_ms);
  },
  open(hash) {
    if (window.location.hash === hash) {
      route();
    } else {
      window.location.hash = hash;
    }
  },
  active: () => idle.note(),
  get login() {
    return user?.login ?? '';
  },
};

async function start() {
  document.body.append(behind, gate.element, said);
  show(said, false);
  try {
    await begin(await api.get('/api/texts', { inLanguage: wantedLanguage() }));
  } catch (error) {
    main.replaceChildren(h('div', { class: 'card narrow', role: 'alert' }, h('p', {}, problemText(error)),
      button(t('Try again'), () => window.location.reload())));
  }
}

async function begin(texts) {
  useTexts(texts);
  document.documentElement.lang = locale();
  drawFrame(texts);
  window.addEventListener('hashchange', route);
  window.addEventListener('keydown', (event) => {
    if (!gate.closed && !document.querySelector('dialog[open]')) page?.key?.(event);
  });
  window.addEventListener('beforeunload', (event) => {
    if (somethingUnsaved()) event.preventDefault();
  });
  window.addEventListener('pagehide', () => page?.left?.());
  window.addEventListener('pageshow', (event) => {
    if (event.persisted) window.location.reload(); // by the button "back": what was left is over
  });
  whenSignedOut(() => {
    if (user) gate.close(user.login, null, comeBack);
  });
  try {
    const me = await api.get('/api/me', { quiet: true });
    enter(me, me.idle_s);
  } catch (error) {
    if (!error.needsSignIn) frame.notify(problemText(error));
    showSignIn();
  }
}

function drawFrame({ centre, languages }) {
  const choice = h('select', { 'aria-label': t('Language'), onchange: () => changeLanguage(choice.value) });
  for (const one of languages) {
    choice.append(h('option', { value: one, lang: one.replace('_', '-'), selected: one === language() }, kLanguageNames[one] ?? one));
  }
  say(leave, t('Sign out'));
  show(leave, false);
  head.replaceChildren(
    h('a', { class: 'skip', href: '#main', onclick: skip }, t('To the content')),
    h('a', { class: 'brand', href: '#' }, 'Torsio'),
    h('span', { class: 'centre' }, centre ?? ''),
    who, choice, leave,
  );
  foot.replaceChildren(t('A training tool and not a medical device. No patient data.'));
}

function skip(event) {
  event.preventDefault(); // the address names pages
  main.focus();
}

async function changeLanguage(chosen) {
  chooseLanguage(chosen);
  await page?.settle?.();
  window.location.reload();
}

function somethingUnsaved() {
  return Boolean(page?.unsaved) || draftsUnderway();
}

function showSignIn() {
  idle.stop();
  document.title = `${t('Sign in')} \u2013 Torsio`;
  say(who, '');
  show(leave, false);
  const place = h('div', {});
  main.replaceChildren(h('div', { class: 'card narrow' },
    h('h1', {}, t('Sign in')), place));
  putSignInForm(place, { onSignedIn: (answer) => enter(answer) });
}

function enter(answer, idle_s) {
  useToken(answer.token);
  user = answer.user;
  say(who, user.login);
  show(leave, true);
  watchIdle(idle_s);
  route();
}

/// A sign-in does not say for how long somebody may be idle; /api/me does.
async function watchIdle(idle_s) {
  idle.start(idle_s ?? kUsualIdle_s);
  if (idle_s !== undefined) return;
  try {
    idle.start((await api.get('/api/me', { quiet: true })).idle_s);
  } catch {
    // then the usual time holds, and the server's own end of the session
  }
}

/// The same person again: the page goes on with what it holds. Another one: a fresh page.
function comeBack(answer) {
  if (answer.user.login !== user.login) {
    page?.left?.();
    page = null;
    enter(answer);
    return;
  }
  useToken(answer.token);
  watchIdle();
  page?.resume?.();
}

function lock() {
  if (user && !gate.closed) gate.close(user.login, endSession(), comeBack);
}

/// Brings what was typed to the server, then ends the session there: what is locked does not open by a reload.
async function endSession() {
  await page?.settle?.();
  try {
    await api.post('/api/sign-out', {}, { quiet: true });
  } catch {
    // the server ends it by itself
  }
}

async function signOut() {
  if (gate.closed) gate.open();
  await page?.settle?.();
  if (somethingUnsaved() && !window.confirm(t('Something is not saved yet and would be lost. Sign out all the same?'))) return;
  page?.left?.();
  stopDrafts();
  forgetUnsaved();
  page = null;
  user = null;
  try {
    await api.post('/api/sign-out', {}, { quiet: true });
  } catch (error) {
    frame.notify(problemText(error));
  }
  useToken('');
  window.history.replaceState(null, '', '/');
  showSignIn();
}

async function route() {
  if (!user) return;
  const found = /^#case\/(.+)$/.exec(window.location.hash);
  page?.left?.();
  page = found ? new CasePage(frame, decodeURIComponent(found[1])) : new QueuePage(frame);
  const opened = page;
  main.replaceChildren(page.element);
  window.scrollTo(0, 0);
  try {
    await opened.load();
  } catch (error) {
    if (page !== opened) return;
    if (error.needsSignIn) {
      opened.resume = route; // signed in again, it is opened anew
      return;
    }
    showProblem(error);
  }
  if (page === opened) document.title = `${opened.title} \u2013 Torsio`;
}

function showProblem(error) {
  main.replaceChildren(h('div', { class: 'card narrow', role: 'alert' },
    h('h1', {}, t('This page could not be opened')),
    h('p', {}, problemText(error)),
    h('div', { class: 'actions' },
      button(t('Try again'), route, { class: 'primary' }),
      button(t('Your queue'), () => frame.open('#')))));
}

start();
