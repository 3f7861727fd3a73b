// SPDX-License-Identifier: GPL-3.0-or-later
// Sign-in form: name and password; then the code of a second factor; a new password at the first visit or if
// it must be changed. Also used to unlock.
import { api, NoConnection } from './api.js';
import { button, field, h, say, show } from './dom.js';
import { clockTime, joinedSentences } from './numbers.js';
import { problemText } from './problem.js';
import { putCodeForm, putSetUp } from './second_factor.js';
import { t } from './texts.js';

export const kShortestPassword = 15;
const kPatience_ms = 60_000; // many may sign in at once: their passwords are checked one after the other
const kSoon_ms = 3000;
const kAgain_ms = 1500;

/// Calls `send` until the server answers: it may be busy, or just starting. `tell(words)`: what is going on.
async function patiently(send, tell) {
  const soon = setTimeout(() => tell(t('Many sign in now. Yours is in the queue; please wait')), kSoon_ms);
  try {
    for (;;) {
      try {
        return await send();
      } catch (error) {
        const again = error instanceof NoConnection || error.status >= 500;
        if (!again) throw error;
        tell(joinedSentences([problemText(error), t('Trying again by itself…')]));
        await new Promise((done) => setTimeout(done, Math.max(kAgain_ms, 1000 * (error.wait_s ?? 0))));
      }
    }
  } finally {
    clearTimeout(soon);
  }
}

/// Shows the form in `place`. `login`: only this person (unlocking). `ready`: awaited before anything is
/// sent. `onSignedIn({token, user})`.
export function putSignInForm(place, { login = '', action = t('Sign in'), ready = null, onSignedIn }) {
  const name = field(t('Sign-in name'), {
    name: 'login', autocomplete: 'username', autocapitalize: 'none', spellcheck: 'false', required: true, value: login,
  });
  const secret = field(t('Password'), {
    name: 'password', type: 'password', autocomplete: 'current-password', required: true,
  });
  show(name.row, login === '');
  const said = h('p', { class: 'said caution', role: 'alert' });
  const go = h('button', { class: 'primary', type: 'submit' }, action);
  const form = h('form', { class: 'stack', novalidate: true, onsubmit: send }, name.row, secret.row, said, go);
  place.replaceChildren(form);
  (login ? secret : name).input.focus();

  async function send(event) {
    event.preventDefault();
    if (go.disabled) return;
    const given = { login: name.input.value.trim(), password: secret.input.value };
    const missing = [name, secret].find((one) => one.input.value.trim() === '');
    if (missing) {
      say(said, t('Give your sign-in name and your password.'));
      missing.input.focus();
      return;
    }
    go.disabled = true;
    say(said, '');
    try {
      await ready;
      const answer = await patiently(() => api.post('/api/sign-in', given, { quiet: true, patience_ms: kPatience_ms }),
        (words) => say(said, words));
      say(said, '');
      secret.input.value = '';
      goOn(place, answer, {
        given,
        action,
        onBack: () => putSignInForm(place, { login, action, onSignedIn }),
        onSignedIn,
      });
    } catch (error) {
      say(said, problemText(error));
      waitFor(error.status === 429 ? error.wait_s : 0);
      secret.input.select();
      secret.input.focus();
    }
  }
  /// Too many wrong attempts: enables the button again after the wait.
  function waitFor(seconds) {
    if (seconds <= 0) {
      go.disabled = false;
      return;
    }
    say(said, t('Too many wrong tries. Please wait %1', clockTime(1e6 * Math.ceil(seconds))));
    setTimeout(() => {
      go.disabled = false;
      say(said, t('You may try again now'));
    }, 1000 * seconds);
  }
}

/// What follows a right password: nothing more, a new password, the code of the second factor, or setting that
/// up. `given`: {login, password} that were right.
function goOn(place, answer, { given, action, onBack, onSignedIn }) {
  const again = (next) => goOn(place, next, { given, action, onBack, onSignedIn });
  if (answer.outcome === 'must_change') {
    putPasswordForm(place, { login: given.login, oldPassword: given.password, onSignedIn });
  } else if (answer.outcome === 'code_needed') {
    putCodeForm(place, {
      action,
      send: async (code) => again(await api.post('/api/sign-in', { ...given, code }, { quiet: true, patience_ms: kPatience_ms })),
      onBack,
    });
  } else if (answer.outcome === 'must_enrol') {
    putSetUp(place, {
      offer: answer.offer,
      why: t('The centre asks you for a second factor: signing in takes your password and a code from your phone.'),
      password: given.password,
      send: (wish) => api.post('/api/second-factor', wish, { quiet: true, patience_ms: kPatience_ms }),
      onDone: (entered) => (entered.token ? onSignedIn(entered) : onBack()), // no page here for this person
      onBack,
    });
  } else {
    onSignedIn(answer);
  }
}

function putPasswordForm(place, { login, oldPassword, onSignedIn }) {
  putNewPassword(place, {
    title: t('Choose a new password'),
    words: t('An administrator set your password. Choose your own: at least fifteen characters, a short sentence for example.'),
    login,
    send: (newPassword) => api.post('/api/password', { login, oldPassword, newPassword }, { quiet: true, patience_ms: kPatience_ms }),
    onBack: () => putSignInForm(place, { onSignedIn }),
    onSignedIn,
  });
}

/// First visit by an invitation link. `link`: the part after #; empty: typed from a card. `onBack()`: back to
/// the sign-in.
export function putJoinForm(place, { link, onBack, onSignedIn }) {
  const typed = field(t('The part of the link after the #'), { name: 'link', autocapitalize: 'none', spellcheck: 'false', autocomplete: 'off' });
  const code = field(t('The code that you were given besides the link'), { name: 'code', autocapitalize: 'none', spellcheck: 'false', autocomplete: 'off' });
  const fields = link ? [] : [typed];
  if (!link || isByTwo(link)) fields.push(code);
  putNewPassword(place, {
    title: t('Welcome'),
    heading: 'h1',
    words: t('Choose a password that only you know: at least fifteen characters, a short sentence for example. The link works once.'),
    fields,
    send: (newPassword) => {
      const given = (link || typed.input.value).trim().replace(/^.*#/, '');
      return api.post('/api/join', { token: given.replace(/^2\./, ''), code: code.input.value.trim(), newPassword }, { quiet: true, patience_ms: kPatience_ms });
    },
    onBack,
    onSignedIn,
  });
}

/// True if two people made the invitation: its code is delivered separately.
function isByTwo(link) {
  return link.startsWith('2.');
}

/// `fields`: additional fields. `send(newPassword)`.
function putNewPassword(place, { title, heading = 'h2', words, login = '', fields = [], send, onBack, onSignedIn }) {
  const one = { type: 'password', autocomplete: 'new-password', required: true };
  const fresh = field(t('New password'), { ...one, name: 'new' });
  const again = field(t('Repeat password'), { ...one, name: 'again' });
  const said = h('p', { class: 'said caution', role: 'alert' });
  const go = h('button', { class: 'primary', type: 'submit' }, t('Save password'));
  const form = h(
    'form',
    { class: 'stack', novalidate: true, onsubmit: store },
    h(heading, {}, title),
    h('p', {}, words),
    // Lets password managers store the new password under the right name.
    h('input', { type: 'text', autocomplete: 'username', value: login, hidden: true }),
    fields.map((field) => field.row),
    fresh.row, again.row, said, go,
    button(t('Back to sign-in'), onBack),
  );
  place.replaceChildren(form);
  (fields[0] ?? fresh).input.focus();

  async function store(event) {
    event.preventDefault();
    if (go.disabled) return;
    if ([...fresh.input.value].length < kShortestPassword) {
      say(said, t('At least fifteen characters, a short sentence for example. Nothing else is asked for.'));
      fresh.input.focus();
      return;
    }
    if (fresh.input.value !== again.input.value) {
      say(said, t('The two are not the same yet'));
      again.input.focus();
      return;
    }
    go.disabled = true;
    try {
      const answer = await send(fresh.input.value);
      goOn(place, answer, {
        given: { login: login || answer.offer?.login, password: fresh.input.value },
        action: t('Sign in'),
        onBack,
        onSignedIn,
      });
    } catch (error) {
      say(said, problemText(error));
      go.disabled = false;
    }
  }
}
