'use strict';

const data = JSON.parse(document.getElementById('data').textContent);

// ---------------------------------------------------------------- numbers

/** A number of some digits; a dash for none. */
function formatted(value, digits = 4) {
  if (typeof value !== 'number' || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7))
    return value.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, 'e');
  return String(Number(value.toPrecision(digits)));
}

/** A unit of SI with the prefix that makes values easy to read, by the rule of base/text.h:
    1301 N reads better than 1.301 kN. Values may be null. */
function prefixed(unit, values) {
  const largest = values.reduce((a, b) => Math.max(a, Math.abs(b ?? 0)), 0);
  const isEveryday = largest === 0 || unit === '' || (largest >= 1 && largest < 1e5);
  const power = isEveryday ? 0 : Math.min(4, Math.max(-4, Math.floor(Math.log10(largest) / 3 + 1e-9)));
  const factor = 10 ** (-3 * power), name = ['p', 'n', 'µ', 'm', '', 'k', 'M', 'G', 'T'][power + 4] + unit;
  return { name, of: (numbers) => numbers.map((value) => value === null ? null : factor * value),
    text: (value, digits) => `${formatted(factor * value, digits)} ${name}`, factor };
}

function withUnit(value, unit) {
  return prefixed(unit, [value]).text(value);
}

/** A title with its unit in brackets, where there is one. */
function titled(title, unit) {
  return unit && unit !== '-' ? `${title} [${unit}]` : title;
}

function percentage(fraction, digits = 4) {
  return `${formatted(100 * fraction, digits)} %`;
}

/** How far a value is from another: "+0.56 %", or "12.6 times". */
function deviation(value, other) {
  const ratio = value / other;
  if (!(ratio >= 0.5 && ratio <= 2)) return `${formatted(ratio, 3)} times`;
  return `${ratio >= 1 ? '+' : ''}${percentage(ratio - 1, 3)}`;
}

/** The smallest and the largest of some numbers; nothing of null. */
function rangeOf(values) {
  const known = values.filter((value) => value !== null);
  return [known.reduce((a, b) => Math.min(a, b)), known.reduce((a, b) => Math.max(a, b))];
}

/** The largest of 1, 2, 5, 10 ... that is at most a length. */
function roundBelow(length) {
  const decade = 10 ** Math.floor(Math.log10(length));
  return decade * [5, 2, 1].find((lead) => lead * decade <= length * (1 + 1e-9));
}

// ---------------------------------------------------------------- elements

/** An element with its properties or attributes and what is in it: text, elements, lists of them. */
function element(name, properties = {}, ...content) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  made.append(...content.flat().filter((part) => part || part === 0));
  return made;
}

function svgElement(name, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

const paragraph = (text) => element('p', {}, text);
const heading = (text) => element('h3', {}, text);
const notice = (text) => element('p', { className: 'notice', role: 'note' }, text);
const preformatted = (text) => element('pre', { tabIndex: 0 }, text);

/** Adds a section to the page and to its contents; nothing of what is null or false. */
function section(title, ...content) {
  const id = `section-${document.querySelectorAll('section').length + 1}`;
  document.getElementById('content').append(element('section', { id }, element('h2', {}, title), ...content));
  document.querySelector('nav ul').append(element('li', {}, element('a', { href: `#${id}` }, title)));
}

/** What a reader must know first, in a colour and with a sign of its own.
    @param trust  good, doubtful or none */
function verdict({ trust, reasons }, text) {
  return element('div', { className: `verdict ${trust}`, role: 'note' },
    element('span', { className: 'sign', 'aria-hidden': true }, { good: '✓', doubtful: '!' }[trust] ?? '✗'),
    element('div', {}, element('strong', {}, text), reasons.flatMap((reason) => [element('br'), reason])));
}

/** Numbers that a reader looks for first: name, value, note. */
function facts(list) {
  return element('dl', { className: 'facts' }, list.filter(Boolean).map(([name, value, note]) => element('div', {},
    element('dt', {}, name),
    element('dd', {}, element('span', { className: 'value' }, value), element('div', { className: 'note' }, note)))));
}

/** The first cell of a row is its name.
    @param className  words, or sortable by a click on a column */
function table(columns, rows, className = '') {
  const made = element('table', { className },
    element('thead', {}, element('tr', {}, columns.map((column) => element('th', { scope: 'col' }, column)))),
    element('tbody', {}, rows.map(([name, ...cells]) => element('tr', {},
      element('th', { scope: 'row' }, name), cells.map((cell) => element('td', {}, cell))))));
  if (className === 'sortable') makeSortable(made);
  return element('div', { className: 'wide', tabIndex: 0 }, made);
}

function makeSortable({ tHead, tBodies: [body] }) {
  const heads = [...tHead.rows[0].cells];
  // a number may be in parentheses; text sorts behind
  const numberIn = (text) => [parseFloat(text.replace('(', '')), Infinity].find((number) => !Number.isNaN(number));
  heads.forEach((head, column) => head.replaceChildren(button(head.textContent, () => {
    const sign = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
    heads.forEach((other) => other.removeAttribute('aria-sort'));
    head.setAttribute('aria-sort', sign > 0 ? 'ascending' : 'descending');
    body.append(...[...body.rows].sort((...rows) => {
      const texts = rows.map(({ cells }) => cells[column].textContent), [x, y] = texts.map(numberIn);
      return sign * (column === 0 || x === y ? texts[0].localeCompare(texts[1]) : x - y);
    }));
  }, { title: 'Sort' })));
}

function button(text, act, properties = {}) {
  return element('button', { type: 'button', onclick: act, ...properties }, text);
}

/** A choice among titles.
    @param choose  called with the number of the one that is chosen
    @param first   the number of the one that is chosen at first */
function selection(label, titles, choose, first = 0) {
  return element('label', {}, label, element('select', { onchange: ({ target }) => choose(Number(target.value)) },
    titles.map((title, i) => new Option(title, i, i === first, i === first))));
}
