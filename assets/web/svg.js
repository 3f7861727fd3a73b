// SPDX-License-Identifier: GPL-3.0-or-later
// Creates SVG elements.
const kSpace = 'http://www.w3.org/2000/svg';

export function svg(tag, attributes, ...children) {
  const element = document.createElementNS(kSpace, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

const kQuiet = 4; // quiet zone around a QR code, in modules

/// Draws a QR code from rows of 0 and 1.
export function qrPicture(rows, label) {
  const side = rows.length + 2 * kQuiet;
  const squares = rows.flatMap((row, y) => [...row].map((one, x) => (one === '1' ? `M${x + kQuiet} ${y + kQuiet}h1v1h-1z` : '')));
  return svg('svg', { viewBox: `0 0 ${side} ${side}`, class: 'qr', role: 'img', 'aria-label': label, 'shape-rendering': 'crispEdges' },
    svg('path', { d: squares.join('') }));
}
