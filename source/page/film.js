// ---------------------------------------------------------------- film

function decoded(text, Type) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(bytes.buffer);
}

/** A value with the prefix that makes it easy to read. */
function withUnit(value, unit) {
  if (value === 0) return '0 ' + unit;
  const power = Math.min(4, Math.max(-4, Math.floor(Math.log10(Math.abs(value)) / 3 + 1e-9)));
  const everyday = Math.abs(value) >= 1 && Math.abs(value) < 1e5;
  return everyday ? formatted(value, 4) + ' ' + unit :
    formatted(value * 10 ** (-3 * power), 4) + ' ' + ['p', 'n', 'µ', 'm', '', 'k', 'M', 'G', 'T'][power + 4] + unit;
}

/** Plays deflection_film(): the whole plate, drawn from the quarter that is
    computed, seen from any side. */
class Film {
  constructor(holder, film) {
    Object.assign(this, { holder, film, frame: 0, azimuth: 0.6, elevation: 0.55, field: 'deflection', timer: null });
    this.deflections = decoded(film.deflections, Int16Array);
    this.cellErrors = decoded(film.cellErrors, Int16Array);
    this.corners = decoded(film.corners, Float32Array);
    this.largest = this.deflections.reduce((a, b) => Math.max(a, Math.abs(b)), 1);
    // the frame of the largest force says most
    this.frame = film.forces.indexOf(Math.max(...film.forces));
    this.makePatches();
    this.makeControls();
    this.draw();
  }

  /** Quadrilaterals to draw, with their nodes, for all four quarters. */
  makePatches() {
    const { film, corners } = this;
    const nine = film.nodesPerCell === 9;
    // with the corners along which a quadrilateral borders on other cells
    const quads = nine ?
      [[[0, 1, 4, 3], [3, 0, 1]], [[1, 2, 5, 4], [0, 1, 2]], [[3, 4, 7, 6], [0, 3, 2]], [[4, 5, 8, 7], [1, 2, 3]]] :
      [[[0, 1, 3, 2], [0, 1, 2, 3, 0]]];
    const side = nine ? 3 : 2;
    const sides = [0, 0];
    corners.forEach((c, i) => { sides[i % 2] = Math.max(sides[i % 2], c); });
    this.extent = Math.max(...sides);
    this.lift = Math.max(0.45 * Math.min(...sides), 0.1 * this.extent) / this.largest;
    this.nodes = new Float32Array(2 * film.cells * film.nodesPerCell);
    for (let cell = 0; cell < film.cells; ++cell)
      for (let n = 0; n < film.nodesPerCell; ++n) {
        const s = (n % side) / (side - 1), t = Math.floor(n / side) / (side - 1);
        for (let d = 0; d < 2; ++d) {
          const c = (v) => corners[8 * cell + 2 * v + d];
          this.nodes[2 * (cell * film.nodesPerCell + n) + d] =
            (1 - t) * ((1 - s) * c(0) + s * c(1)) + t * ((1 - s) * c(2) + s * c(3));
        }
      }
    this.patches = [];
    const quarters = film.cells > 4000 ? [[1, 1]] : [[1, 1], [-1, 1], [1, -1], [-1, -1]];
    for (const [mirrorX, mirrorY] of quarters)
      for (let cell = 0; cell < film.cells; ++cell)
        for (const [quad, border] of quads)
          this.patches.push({ cell, mirrorX, mirrorY, border, nodes: quad.map((n) => cell * film.nodesPerCell + n) });
  }

  makeControls() {
    const { holder, film } = this;
    const add = (name, properties, parent) => {
      const element = Object.assign(document.createElement(name), properties);
      parent.append(element);
      return element;
    };
    this.canvas = add('canvas', { tabIndex: 0 }, holder);
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'The deflected plate. Arrow keys turn it.');
    const controls = add('div', { className: 'controls' }, holder);
    this.button = add('button', { type: 'button', textContent: '▶ Play' }, controls);
    this.slider = add('input', { type: 'range', min: 0, max: film.times.length - 1, value: this.frame }, controls);
    this.slider.setAttribute('aria-label', 'Time');
    const label = add('label', { textContent: 'Colour: ' }, controls);
    this.select = add('select', {}, label);
    for (const [value, text] of [['deflection', 'deflection'], ['error', 'local error ratio ξ']])
      add('option', { value, textContent: text }, this.select);
    this.readout = add('div', { className: 'readout' }, holder);
    this.readout.setAttribute('aria-live', 'off');
    this.scale = add('div', {}, holder);
    add('figcaption', { textContent: `Deflection magnified; the largest is ${withUnit(this.largest * film.deflectionUnit, 'm')}. ` +
      'ξ is the error of a cell over what the target allows it at that time. Drag or arrow keys turn the plate.' }, holder);

    this.slider.addEventListener('input', () => { this.frame = Number(this.slider.value); this.draw(); });
    this.select.addEventListener('change', () => { this.field = this.select.value; this.draw(); });
    this.button.addEventListener('click', () => this.toggle());
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons) this.turn(-0.01 * event.movementX, 0.01 * event.movementY);
    });
    this.canvas.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (!step) return;
      event.preventDefault();
      this.turn(...step);
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    matchMedia('print').addEventListener('change', () => this.draw());
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(Math.PI / 2, Math.max(0.05, this.elevation + elevation));
    this.draw();
  }

  toggle() {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
    } else {
      const last = this.film.times.length - 1;
      if (this.frame === last) this.show(0);
      this.timer = setInterval(() => { if (this.frame === last) this.toggle(); else this.show(this.frame + 1); }, 90);
    }
    this.button.textContent = this.timer ? '❚❚ Pause' : '▶ Play';
  }

  show(frame) {
    this.frame = frame;
    this.slider.value = frame;
    this.draw();
  }

  colourOf(patch, offset) {
    if (this.field === 'deflection') {
      let sum = 0;
      for (const node of patch.nodes) sum += this.deflections[offset + node];
      return colourAt(palettes.diverging, 0.5 + sum / 4 / this.largest / 2);
    }
    const value = this.cellErrors[this.frame * this.film.cells + patch.cell];
    return value === -32768 ? 'rgb(255,255,255)' : colourAt(palettes.diverging, 0.5 + value / 20000);
  }

  draw() {
    const { canvas, film } = this;
    const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0) return;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    const sinA = Math.sin(this.azimuth), cosA = Math.cos(this.azimuth);
    const sinE = Math.sin(this.elevation), cosE = Math.cos(this.elevation);
    const quarter = film.cells > 4000;
    const scale = Math.min(width / 2.9, height / 1.8) / this.extent * (quarter ? 1.6 : 1);
    const centre = quarter ? this.extent / 2 : 0;
    const offset = this.frame * film.cells * film.nodesPerCell;
    const drawn = this.patches.map((patch) => {
      let depth = 0;
      const points = patch.nodes.map((node) => {
        const x = patch.mirrorX * this.nodes[2 * node] - centre, y = patch.mirrorY * this.nodes[2 * node + 1] - centre;
        const u = x * cosA - y * sinA, v = x * sinA + y * cosA;
        depth += v;
        return [width / 2 + scale * u, 0.45 * height - scale * (v * sinE - this.lift * this.deflections[offset + node] * cosE)];
      });
      return { patch, points, depth };
    });
    drawn.sort((a, b) => b.depth - a.depth);
    context.lineWidth = 0.6;
    for (const { patch, points } of drawn) {
      const trace = (corners) => {
        context.beginPath();
        corners.forEach((corner, i) => (i === 0 ? context.moveTo(...points[corner]) : context.lineTo(...points[corner])));
      };
      trace([0, 1, 2, 3, 0]);
      // the line hides the seam between two fillings
      context.fillStyle = context.strokeStyle = this.colourOf(patch, offset);
      context.fill();
      context.stroke();
      trace(patch.border);
      context.strokeStyle = 'rgba(0,0,0,0.45)';
      context.stroke();
    }
    this.readout.textContent = `t = ${withUnit(film.times[this.frame], 's')},  F = ${withUnit(film.forces[this.frame], 'N')},  ` +
      `η(t) = ${formatted(100 * film.errors[this.frame], 4)} %`;
    this.slider.setAttribute('aria-valuetext', this.readout.textContent);
    this.drawScale();
  }

  drawScale() {
    if (this.scaleField === this.field) return;
    this.scaleField = this.field;
    const top = withUnit(this.largest * this.film.deflectionUnit, 'm');
    this.scale.replaceChildren(this.field === 'deflection' ?
      makeScale(palettes.diverging, ['−' + top, '0', top], 'deflection, positive in the direction of impact') :
      makeScale(palettes.diverging, ['0.01', '0.1', '1', '10', '100'], 'local error ratio ξ(t)'));
  }
}

document.querySelectorAll('[data-film]').forEach((holder) => new Film(holder, data.film));
