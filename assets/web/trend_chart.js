// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts at a module, one point each, with threshold and fitted curve. SVG; a table has the same content.
import { h } from './dom.js';
import { figure } from './numbers.js';
import { svg } from './svg.js';
import { t } from './texts.js';

const kWidth = 640;
const kHeight = 200;
const kEdge = 12;
const kMarks = { passed: 'passed', not_judged: 'not-judged' };

/// `module`: of GET /api/own.
export function trendChart(module) {
  const defined = module.points.filter((point) => point.value !== null);
  const values = [...defined.map((point) => point.value), ...module.curve.map(([, value]) => value)];
  if (module.threshold !== null) values.push(module.threshold);
  if (defined.length === 0) return h('p', { class: 'quiet' }, t('No try has this figure yet.'));
  const [low, high] = [Math.min(0, ...values), Math.max(...values, 1e-9)];
  const last = Math.max(...module.points.map((point) => point.attempt), 2);
  const x = (attempt) => kEdge + ((attempt - 1) / (last - 1)) * (kWidth - 2 * kEdge);
  const y = (value) => kHeight - kEdge - ((value - low) / (high - low || 1)) * (kHeight - 2 * kEdge);
  const chart = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, class: 'trend', role: 'img',
    'aria-label': t('%1 over %2 {try|tries}: first %3, last %4', module.metric, figure(defined.length), defined[0].told, defined.at(-1).told) });
  if (module.threshold !== null) {
    chart.append(svg('line', { x1: kEdge, x2: kWidth - kEdge, y1: y(module.threshold), y2: y(module.threshold), class: 'threshold' }));
  }
  if (module.curve.length > 1) {
    chart.append(svg('polyline', { points: module.curve.map(([at, value]) => `${x(at)},${y(value)}`).join(' '), class: 'curve' }));
  }
  for (const point of defined) {
    chart.append(svg('circle', { cx: x(point.attempt), cy: y(point.value), r: point.counted ? 5 : 3, class: kMarks[point.outcome.code] ?? 'tried' }));
  }
  return chart;
}
