// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, touch and keys on the stage: drag rotates, two fingers or the right button pan, wheel and pinch
// zoom.

const kKeyTurn_px = 24;
const kPinchStep = 0.08; // relative change of the finger distance per notch

export function followInput(stage) {
  const { canvas, camera } = stage;
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const [right_px, down_px] = [event.clientX - before.x, event.clientY - before.y];
    if (pointers.size === 2) {
      const apart = spread();
      Object.assign(before, { x: event.clientX, y: event.clientY });
      camera.pan(0.5 * right_px, 0.5 * down_px, canvas.clientHeight);
      if (apart > 0) camera.zoom(Math.log(spread() / apart) / kPinchStep);
    } else {
      Object.assign(before, { x: event.clientX, y: event.clientY });
      const moves = event.buttons & 6 || event.shiftKey;
      if (moves) {
        camera.pan(right_px, down_px, canvas.clientHeight);
      } else {
        camera.orbit(right_px, down_px);
      }
    }
    stage.redraw();
  });
  for (const end of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener('mousedown', (event) => event.preventDefault()); // the sheet keeps the focus
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const notch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3;
      camera.zoom(-event.deltaY / notch);
      stage.redraw();
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const turns = {
      ArrowLeft: [-kKeyTurn_px, 0],
      ArrowRight: [kKeyTurn_px, 0],
      ArrowUp: [0, -kKeyTurn_px],
      ArrowDown: [0, kKeyTurn_px],
    };
    if (event.key in turns) {
      camera.orbit(...turns[event.key]);
    } else if (event.key === '+' || event.key === '=') {
      camera.zoom(1);
    } else if (event.key === '-') {
      camera.zoom(-1);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation(); // the sheet has its own arrow keys
    stage.redraw();
  });
}
