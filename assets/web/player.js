// SPDX-License-Identifier: GPL-3.0-or-later
// Player of a recording: stage, traces and controls.
import { api } from './api.js';
import { readContainer } from './container.js';
import { button, h, say, show } from './dom.js';
import { FilmStrip } from './film_strip.js';
import { icon } from './icons.js';
import { clockTenths, figure, pointsText } from './numbers.js';
import { organOf, skinOf } from './organ.js';
import { joined, kJump_us, kStep_us, Playback } from './playback.js';
import { Stage } from './stage.js';
import { followInput } from './stage_input.js';
import { t } from './texts.js';
import { sizeText } from './trace_lane.js';
import { Traces } from './traces.js';

export class Player {
  #last_ms = 0;
  #watched = [];

  /// `opened`: answer of GET /api/cases/H, or of it task (if missing, from the recording), watched,
  /// length_us, rules and digest. `on`: played({from_us, to_us, speed}), paused().
  constructor(path, opened, on) {
    Object.assign(this, { path, opened, on });
    this.#watched = opened.watched ?? [];
    this.playback = new Playback(opened.length_us ?? 0, opened.rules.speeds);
    this.stage = new Stage();
    this.traces = new Traces((position_us) => this.seek(position_us));
    this.sentence = h('p', { class: 'sentence', role: 'status' });
    this.views = h('div', { class: 'views', role: 'group', 'aria-label': t('View') },
      button(t('Front'), () => this.stage.look('front')),
      button(t('Top'), () => this.stage.look('top')),
      button(t('Side'), () => this.stage.look('side')),
      button(t('Fit'), () => this.stage.fit()));
    this.waiting = h('p', { class: 'waiting', role: 'status' });
    this.stagePlace = h('div', { class: 'stage' }, this.stage.canvas, this.waiting, this.views);
    this.asked = h('p', { class: 'task' }, opened.task ? taskText(opened.task) : '');
    this.element = h('section', { class: 'player', 'aria-label': t('Recording') },
      this.asked, this.stagePlace, this.sentence, this.traces.canvas,
      this.#transport());
    this.#showOrgan(false);
    this.#showState();
  }
  #showOrgan(shown) {
    if (shown) say(this.waiting, '');
    for (const one of [this.stage.canvas, this.views]) show(one, shown);
  }
  get ready() {
    return this.recording !== undefined;
  }
  get position_us() {
    return this.playback.position_us;
  }

  /// Loads the recording, then the organ. Throws Refusal, NoConnection.
  async load() {
    // Reserve its space, so that nothing moves under the pointer.
    show(this.stagePlace, true);
    say(this.sentence, '');
    say(this.waiting, t('The recording is being opened. You may score meanwhile.'));
    try {
      await this.#bring();
    } catch (error) {
      show(this.stagePlace, false);
      throw error;
    } finally {
      say(this.waiting, '');
    }
  }
  async #bring() {
    const recording = readContainer(await api.file(`${this.path}/recording`));
    this.playback.length_us = recording.meta.length_us;
    this.recording = recording;
    const task = this.opened.task ?? recording.meta.task;
    say(this.asked, taskText(task));
    this.traces.setRecording(recording, task);
    if (this.opened.digest) this.digest.textContent = t('Recording %1, unchanged', this.opened.digest);
    this.#showState();
    if (!recording.meta.picture) {
      show(this.stagePlace, false);
      say(this.sentence, t('The organ of this recording is not on this machine; the traces are complete.'));
      return;
    }
    const tissue = api.file('/quick_tissue.frag').then((bytes) => new TextDecoder().decode(bytes));
    tissue.catch(() => {}); // handled where it is awaited
    const organ = await organOf(this.path);
    this.#showOrgan(true);
    if (!this.stage.open()) {
      this.film = new FilmStrip(recording, organ, (position_us) => this.seek(position_us));
      this.stagePlace.replaceWith(this.film.element);
      say(this.sentence, t('This browser draws nothing in three dimensions (no WebGL 2): a film strip shows some moments; the traces are complete.'));
      this.#showState();
      return;
    }
    this.stage.canvas.setAttribute('role', 'application');
    this.stage.canvas.setAttribute('aria-label', t('The organ in three dimensions. Arrows turn it, plus and minus zoom'));
    followInput(this.stage);
    this.stage.setCase(recording, organ, await tissue);
    const skin = await skinOf(organ.meta.skin);
    if (skin) this.stage.setSkin(skin);
  }

  seek(position_us) {
    if (!this.ready) return;
    this.playback.seek(position_us);
    this.#showState();
  }
  toggle() {
    if (!this.ready) return;
    this.playback.toggle();
    this.#transportChanged();
    if (!this.playback.playing) return;
    this.#last_ms = performance.now();
    requestAnimationFrame((now_ms) => this.#frame(now_ms));
  }
  pause() {
    if (this.playback.playing) this.toggle();
  }
  setBookmarks(times_us) {
    this.traces.setBookmarks(times_us);
  }
  /// Shows the stretches that the server counts as watched, plus those not yet reported.
  setWatched(stretches, unreported) {
    this.#watched = joined([...stretches, ...unreported.map(({ from_us, to_us }) => [from_us, to_us])]);
    this.traces.setWatched(this.#watched);
  }

  /// Returns false if the key is not the player's.
  key(event) {
    switch (event.key) {
      case ' ':
        this.toggle();
        return true;
      case 'k':
      case 'K':
        this.pause();
        return true;
      case 'l':
      case 'L':
        if (this.playback.playing) {
          this.#changeSpeed(+1);
        } else {
          this.toggle();
        }
        return true;
      case 'j':
      case 'J':
        if (this.playback.playing && !this.playback.slowest) {
          this.#changeSpeed(-1);
        } else {
          this.seek(this.position_us - kJump_us);
        }
        return true;
      case ',':
      case '.':
        this.pause();
        this.seek(this.position_us + (event.key === ',' ? -kStep_us : kStep_us));
        return true;
      case 'Home':
      case 'End':
        this.pause();
        this.seek(event.key === 'Home' ? 0 : this.playback.length_us);
        return true;
      default:
        return false;
    }
  }

  #frame(now_ms) {
    const stretch = this.playback.advance((now_ms - this.#last_ms) / 1000);
    this.#last_ms = now_ms;
    if (!stretch) return;
    this.on.played(stretch);
    this.#showState();
    if (this.playback.playing) {
      requestAnimationFrame((next_ms) => this.#frame(next_ms));
    } else {
      this.#transportChanged();
    }
  }
  #changeSpeed(direction) {
    this.playback.changeSpeed(direction);
    this.#showSpeed();
  }
  #transportChanged() {
    const { playing } = this.playback;
    this.play.replaceChildren(icon(playing ? 'pause' : 'play'), playing ? t('Pause') : t('Play'));
    if (!playing) this.on.paused();
  }

  #transport() {
    this.back = button(t('5 s back'), () => this.seek(this.position_us - kJump_us), { title: t('Jumps five seconds back (J)') });
    this.forward = button(t('5 s forward'), () => this.seek(this.position_us + kJump_us), {
      title: t('Jumps five seconds on; what is skipped does not count as watched'),
    });
    this.play = button([icon('play'), t('Play')], () => this.toggle(), { class: 'play', title: t('Plays or pauses (Space)') });
    this.time = h('span', { class: 'time' });
    this.digest = h('span', {
      class: 'quiet digest',
      title: t('Proves that this is the recording as it was stored. It reveals nothing else and differs for each physician'),
    });
    const { speeds } = this.playback;
    this.speed = speeds.length === 1
      ? h('span', { class: 'quiet', title: t('Scored recordings play as they happened') })
      : h('select', {
        'aria-label': t('Speed'), title: t('J slower, L faster; the speed is kept with the mark'),
        onchange: () => {
          this.playback.speed = Number(this.speed.value);
          this.speed.blur(); // returns the focus to the sheet
        },
      }, speeds.map((one) => h('option', { value: one }, t('%1 ×', pointsText(one)))));
    this.#showSpeed();
    return h('div', { class: 'transport' }, this.back, this.play, this.forward, this.time, this.speed, this.digest);
  }
  #showSpeed() {
    if (this.speed.tagName === 'SELECT') {
      this.speed.value = String(this.playback.speed);
    } else {
      say(this.speed, t('%1 ×, locked', pointsText(this.playback.speed)));
    }
  }
  #showState() {
    for (const one of [this.back, this.play, this.forward]) one.disabled = !this.ready;
    if (!this.ready) return;
    this.stage.setTime(this.position_us / 1e6);
    this.traces.setPosition(this.position_us);
    this.film?.setPosition(this.position_us);
    say(this.time, t('%1 of %2', clockTenths(this.position_us), clockTenths(this.playback.length_us)));
  }
}

function taskText(task) {
  const parts = [];
  if (task.untwisting) {
    parts.push(t('Undo the twist, then hands off'));
  } else {
    parts.push(t('Twist to %1° and release within ±%2°', figure(task.target_deg), pointsText(task.tolerance_deg)));
    if (task.hold_s > 0) parts.push(t('hold for %1 s', pointsText(task.hold_s)));
    if (task.least_twists > 1) parts.push(t('at least %1 {twist|twists}', task.least_twists));
  }
  if (task.force.limit !== null) parts.push(t('force up to %1', sizeText(task.force, task.force.limit)));
  if (task.torque.limit !== null) parts.push(t('torque up to %1', sizeText(task.torque, task.torque.limit)));
  return t('Asked for: %1', parts.join('  \u00b7  '));
}
