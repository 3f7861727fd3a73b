// SPDX-License-Identifier: GPL-3.0-or-later
// Dispatches keys on a page with a case or a recording.

/// Passes a key to its target and prevents the browser's default.
export function pressKey(page, event) {
  if (event.isComposing || event.defaultPrevented) return;
  const typing = ['INPUT', 'TEXTAREA', 'SELECT'].includes(event.target.tagName) && event.target.type !== 'checkbox';
  if (command(page, event) || (!typing && plainKey(page, event))) event.preventDefault();
}

function command(page, event) {
  if (event.altKey && !event.ctrlKey && event.code === 'KeyM') {
    page.view.comment.focus();
    return true;
  }
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  const key = event.key.toLowerCase();
  if (key === 'enter') {
    page.bar.go();
    return true;
  }
  // The sheet shares one undo history; remark fields have their own.
  if (event.target.tagName === 'INPUT' && !page.view.element.contains(event.target)) return false;
  if (key === 'z' && !event.shiftKey) {
    page.view.undo();
  } else if (key === 'y' || (key === 'z' && event.shiftKey)) {
    page.view.redo();
  } else {
    return false;
  }
  return true;
}

function plainKey(page, event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  if (event.key === 'Escape') return page.bar.cancel();
  const pressesButton = event.target.closest('button, a, summary, [type=checkbox]') && event.key === ' ';
  if (pressesButton) return false;
  if (!page.player) return page.view.key(event); // a live sheet
  switch (event.key) {
    case '?':
      page.keys.open = !page.keys.open;
      return true;
    case 'b':
    case 'B':
      page.remarks.addBookmark();
      return true;
    case 'r':
      page.remarks.ask();
      return true;
    case 'R':
      page.remarks.editNearest();
      return true;
    default:
      return page.player.key(event) || page.view.key(event);
  }
}

/// Keys of a page with a player and rows to score, but no case: Ctrl+Enter continues, the others play and
/// score. `page`: go(), view, and a player once it is loaded.
export function playedKeys(page, event) {
  if (event.isComposing || event.defaultPrevented) return;
  if ((event.ctrlKey || event.metaKey) && event.key === 'Enter') {
    event.preventDefault();
    page.go();
    return;
  }
  if (event.ctrlKey || event.altKey || event.metaKey || ['INPUT', 'SELECT'].includes(event.target.tagName)) return;
  if (event.target.closest('button, a') && event.key === ' ') return;
  if (page.player?.key(event) || page.view.key(event)) event.preventDefault();
}
