// SPDX-License-Identifier: GPL-3.0-or-later
// Creates elements. Texts become text nodes, never markup, so that user input cannot become code.

/// h('button', {class: 'primary', onclick: f}, 'Sign in'). Attributes that are null, undefined or false are
/// omitted, true is an empty attribute, functions are listeners; children may be elements, texts, arrays,
/// null.
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') {
      element.addEventListener(name.slice(2), value);
    } else {
      element.setAttribute(name, value === true ? '' : String(value));
    }
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/// Creates a button that does not submit a form.
export function button(text, onclick, attributes = {}) {
  return h('button', { type: 'button', onclick, ...attributes }, text);
}

let fields = 0;

/// Creates a field with a label above: {row, input}.
export function field(label, attributes = {}, tag = 'input') {
  const id = attributes.id ?? `field-${++fields}`;
  const input = h(tag, { ...attributes, id });
  return { row: h('div', { class: 'field' }, h('label', { for: id }, label), input), input };
}

export function show(element, visible) {
  element.hidden = !visible;
}

/// Scrolls a box, and not the page, so that an element inside is in its middle.
export function bringIntoView(element, box) {
  const at = element.getBoundingClientRect();
  const seen = box.getBoundingClientRect();
  box.scrollBy(at.left - seen.left + (at.width - seen.width) / 2, at.top - seen.top + (at.height - seen.height) / 2);
}

/// Sets the text only if it differs: otherwise a screen reader would repeat it.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
