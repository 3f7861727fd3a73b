// SPDX-License-Identifier: GPL-3.0-or-later
// Icons of buttons.
import { svg } from './svg.js';

const kPaths = {
  play: 'M4 2.5v11l9-5.5z',
  pause: 'M4 3h3v10H4zM9 3h3v10H9z',
};

export function icon(name) {
  return svg('svg', { viewBox: '0 0 16 16', class: 'icon', 'aria-hidden': 'true' }, svg('path', { d: kPaths[name] }));
}
