// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the application: texts, user, and the page of the address.
import { api, useToken, whenSignedOut } from './api.js';
import { BoardPage } from './board_page.js';
import { CallWatch } from './calls.js';
import { CalibrationPage } from './calibration_page.js';
import { CasePage } from './case_page.js';
import { bringIntoView, button, h, say, show } from './dom.js';
import { draftsUnderway, stopDrafts } from './drafts_underway.js';
import { DiscrepancyPage } from './discrepancy_page.js';
import { EvaluationPage } from './evaluation_page.js';
import { Gate } from './gate.js';
import { IdleWatch } from './idle.js';
import { LivePage } from './live_page.js';
import { clockTime, figure } from './numbers.js';
import { InvitationsPage } from './invitations_page.js';
import { OwnPage } from './own_page.js';
import { OwnRemarksPage } from './own_remarks_page.js';
import { problemText } from './problem.js';
import { QueuePage } from './queue_page.js';
import { RunPage } from './run_page.js';
import { SeverityPage } from './severity_page.js';
import { SecondFactorPage } from './second_factor_page.js';
import { SessionsPage } from './sessions_page.js';
import { putJoinForm, putSignInForm } from './sign_in_form.js';
import { chooseLanguage, language, locale, t, useTexts, wantedLanguage } from './texts.js';
import { TranscriptPage } from './transcript_page.js';
import { forgetUnsaved } from './unsaved.js';

const kLanguageNames = { en: 'English', zh_CN: '\u7b80\u4f53\u4e2d\u6587' };
const kDefaultIdle_s = 300;
const kNotice_ms = 6000;
const kWarning_ms = 60_000;

const main = h('main', { id: 'main', tabindex: '-1' });
const said = h('div', { class: 'notice', role: 'status' });
const who = h('span', { class: 'who' });
const leave = button('', signOut);
const ways = h('nav', { class: 'ways' });
const head = h('header', { class: 'top' });
const foot = h('footer', { class: 'foot' });
const moved = h('p', { class: 'caution record-notice', role: 'status' });
const behind = h('div', { class: 'behind' }, head, moved, main, foot);
const gate = new Gate(behind, signOut);
const idle = new IdleWatch({
  warned: (left_s) => frame.notify(t('Still there? The screen will be locked in %1. Press any key to stay', clockTime(1e6 * left_s)), kWarning_ms),
  back: () => frame.notify(''),
  idle: lock,
  held: () => (calls.goesOn && page instanceof LivePage) || Boolean(page?.callsGoOn),
  present: () => readUser().catch(() => {}), // if the session was ended elsewhere, the gate closes
});
const calls = new CallWatch(followCalls, (since_ms) => page?.callsAway?.(since_ms));
let user = null;
let page = null;
let announced = ''; // the call that was told of last

/// The pages; `of`: the server's name of the required right, none for everybody. "#" opens the first
/// permitted one.
const kPages = [
  { hash: '#queue', of: 'queue', title: () => t('Your queue'), make: () => new QueuePage(frame) },
  { hash: '#live', of: 'queue', title: () => t('Live sheet'), make: () => new LivePage(frame) },
  { hash: '#calibration', of: 'queue', title: () => t('Calibration'), make: () => new CalibrationPage(frame) },
  { hash: '#severity', of: 'queue', title: () => t('My severity'), make: () => new SeverityPage(frame) },
  { hash: '#discrepancies', of: 'queue', title: () => t('Discrepancy review'), make: () => new DiscrepancyPage(frame) },
  { hash: '#own', of: 'own', title: () => t('Your record'), make: () => new OwnPage(frame) },
  { hash: '#remarks', of: 'own', title: () => t('Remarks'), make: () => new OwnRemarksPage(frame) },
  { hash: '#transcript', of: 'own', title: () => t('Transcript'), make: () => new TranscriptPage(frame) },
  { hash: '#evaluation', of: 'evaluation', title: () => t('Evaluation'), make: () => new EvaluationPage(frame) },
  { hash: '#board', of: 'board', title: () => t("Today's sessions"), make: () => new BoardPage(frame, false) },
  { hash: '#scored', of: 'board', title: () => t('Who has scored what'), make: () => new BoardPage(frame, true) },
  { hash: '#invitations', of: 'people', title: () => t('Invitations'), make: () => new InvitationsPage(frame) },
  { hash: '#signed-in', of: 'people', title: () => t('Signed in now'), make: () => new SessionsPage(frame, true) },
  { hash: '#second-factor', of: '', title: () => t('Second factor'), make: () => new SecondFactorPage(frame) },
  { hash: '#sessions', of: '', title: () => t('Your sessions'), make: () => new SessionsPage(frame, false) },
];

/// Services of the frame for its pages.
const frame = {
  /// Shows a passing notice.
  notify(text, for_ms = kNotice_ms, ...more) {
    said.replaceChildren(text, ...more);
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
  /// To be called when the session was opened anew for the same user.
  entered(answer) {
    useToken(answer.token);
    user = answer.user;
  },
  get login() {
    return user?.login ?? '';
  },
  /// Says that requests wait for this administrator as the second person; empty: none.
  get requestsWait() {
    return user?.requests_wait ?? '';
  },
  /// To be called when a request was made or confirmed here.
  requestsChanged: () => readUser().catch(() => {}),
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
  window.addEventListener('online', () => {
    calls.resume();
    page?.online?.();
  });
  window.addEventListener('pagehide', () => page?.left?.());
  window.addEventListener('pageshow', (event) => {
    if (event.persisted) window.location.reload(); // restored by the back button: start afresh
  });
  whenSignedOut(() => {
    if (user) gate.close(user.login, null, comeBack);
  });
  if (window.location.pathname === '/join') {
    showJoin();
    return;
  }
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
    ways, who, choice, leave,
  );
  ways.setAttribute('aria-label', t('Pages'));
  foot.replaceChildren(t('A training tool, not a medical device. No patient data.'));
}

function skip(event) {
  event.preventDefault(); // addresses name pages
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
  showWays();
  const place = h('div', {});
  main.replaceChildren(h('div', { class: 'card narrow' },
    h('h1', {}, t('Sign in')), place));
  putSignInForm(place, { onSignedIn: (answer) => enter(answer) });
}

/// First visit by an invitation link, whoever is signed in.
function showJoin() {
  document.title = `${t('Welcome')} \u2013 Torsio`;
  show(leave, false);
  showWays();
  const link = window.location.hash.slice(1);
  const away = () => window.history.replaceState(null, '', '/'); // removes a used link from the history
  const place = h('div', { class: 'card narrow' });
  main.replaceChildren(place);
  putJoinForm(place, {
    link,
    onBack: () => {
      away();
      showSignIn();
    },
    onSignedIn: (answer) => {
      away();
      enter(answer);
      frame.notify(t('Your sign-in name is %1: with it and your password you come in the next time.', answer.user.login), kWarning_ms);
    },
  });
}

/// Reads again what waits for the user, who is active.
async function readUser() {
  const me = await api.get('/api/me');
  if (!user || me.user.login !== user.login) return;
  user = me.user;
  showWays();
}

/// Shows the links to this person's pages.
function showWays() {
  const known = user
    ? [...kPages.filter((one) => one.of && user.pages.includes(one.of)).map((one) => [one.hash, titleWithCount(one)]),
      ['#sessions', t('Your sessions')]]
    : [];
  const present = pageOf(window.location.hash)?.hash;
  show(ways, known.length > 0);
  const listed = JSON.stringify([known, present]);
  if (listed !== ways.listed) { // links are not moved under a finger
    ways.listed = listed;
    ways.replaceChildren(...known.map(([hash, title]) =>
      h('a', { href: hash, 'aria-current': hash === present ? 'page' : null }, title)));
    const active = ways.querySelector('[aria-current]');
    if (active) bringIntoView(active, ways);
  }
  say(moved, user?.record_notice ?? '');
}

function titleWithCount(one) {
  const count = one.hash === '#invitations' ? (user.invitations_wait ?? 0) : 0;
  return count > 0 ? t('%1 (%2)', one.title(), figure(count)) : one.title();
}

function enter(answer, idle_s) {
  useToken(answer.token);
  user = answer.user;
  say(who, user.login);
  show(leave, true);
  watchIdle(idle_s);
  route();
  watchCalls();
}

function watchCalls() {
  if (user.pages.includes('queue')) calls.start();
}

/// A call opens its sheet on every page, except where something is being scored: there a button leads to it.
async function followCalls(live) {
  if (page?.callsChanged) {
    await page.callsChanged(live);
    return;
  }
  const opened = page;
  const guide = await api.post('/api/live/follow', { shown: '', busy: 0, followed: announced });
  if (page !== opened || gate.closed) return;
  if (!guide.called) {
    if (announced !== '') frame.notify(''); // the call has ended
    announced = '';
  } else if (guide.opens) {
    announced = guide.called.case;
    if (page instanceof CasePage || page?.unsaved) {
      frame.notify(t('Case %1 is called to the real arm: %2', guide.called.label, guide.called.room), kWarning_ms,
        button(t('To the live sheet'), () => frame.open('#live'), { class: 'small' }));
    } else {
      frame.open('#live');
    }
  }
}

/// The sign-in does not return the idle time; /api/me does.
async function watchIdle(idle_s) {
  idle.start(idle_s ?? kDefaultIdle_s);
  if (idle_s !== undefined) return;
  try {
    idle.start((await api.get('/api/me', { quiet: true })).idle_s);
  } catch {
    // keep the default; the server ends the session by itself
  }
}

/// The same person continues on the page; another one gets a fresh page.
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
  watchCalls();
}

function lock() {
  if (user && !gate.closed) gate.close(user.login, endSession(), comeBack);
}

/// Saves what was typed, then ends the session on the server, so that a reload does not unlock it.
async function endSession() {
  calls.stop();
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
  calls.stop();
  try {
    await api.post('/api/sign-out', {}, { quiet: true });
  } catch (error) {
    frame.notify(problemText(error));
  }
  useToken('');
  window.history.replaceState(null, '', '/');
  showSignIn();
}

/// Finds the entry of kPages for an address.
function pageOf(hash) {
  return kPages.find((one) => one.hash === hash) ?? kPages.find((one) => one.of && user?.pages.includes(one.of));
}

async function route() {
  if (!user) return;
  const found = /^#(case|run)\/(.+)$/.exec(window.location.hash);
  page?.left?.();
  page = found ? new (found[1] === 'case' ? CasePage : RunPage)(frame, decodeURIComponent(found[2])) : pageOf(window.location.hash).make();
  showWays();
  const opened = page;
  main.replaceChildren(page.element);
  window.scrollTo(0, 0);
  try {
    await opened.load();
  } catch (error) {
    if (page !== opened) return;
    if (error.needsSignIn) {
      opened.resume = route; // reopened after signing in again
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
      button(t('To the first page'), () => frame.open('#')))));
}

start();
