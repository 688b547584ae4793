// ---------------------------------------------------------------- film

function decoded(text, Type) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(bytes.buffer);
}

/** Plays deflection_film(): the whole plate, drawn from the part that is
    computed, seen from any side. */
class Film {
  constructor(holder, { film, patch, symmetric }, mesh) {
    Object.assign(this, { holder, film, patch, symmetric, mesh, frame: 0, azimuth: 0.6, elevation: 0.55, zoom: 1, isAtContact: false,
      field: 'deflection', timer: null });
    this.deflections = decoded(film.deflections, Int16Array);
    this.cellErrors = decoded(film.cellErrors, Int16Array);
    this.largest = this.deflections.reduce((a, b) => Math.max(a, Math.abs(b)), 1);
    // the frame of the largest force says most
    this.frame = film.forces.indexOf(Math.max(...film.forces));
    this.makePatches();
    this.makeControls();
    this.draw();
  }

  /** Quadrilaterals to draw, with their nodes, for all mirror images. */
  makePatches() {
    const { film, mesh: { vertices, cells } } = this;
    const nine = film.nodesPerCell === 9;
    // with the corners along which a quadrilateral borders on other cells
    const quads = nine ?
      [[[0, 1, 4, 3], [3, 0, 1]], [[1, 2, 5, 4], [0, 1, 2]], [[3, 4, 7, 6], [0, 3, 2]], [[4, 5, 8, 7], [1, 2, 3]]] :
      [[[0, 1, 3, 2], [0, 1, 2, 3, 0]]];
    const side = nine ? 3 : 2;
    const mirrored = this.symmetric.map((is) => (is ? [1, -1] : [1]));
    const begin = [Infinity, Infinity], end = [-Infinity, -Infinity];
    vertices.forEach((c, i) => mirrored[i % 2].forEach((sign) => {
      begin[i % 2] = Math.min(begin[i % 2], sign * c);
      end[i % 2] = Math.max(end[i % 2], sign * c);
    }));
    const half = begin.map((b, d) => (end[d] - b) / 2);
    this.centre = begin.map((b, d) => (end[d] + b) / 2);
    this.extent = Math.max(...half);
    this.radius = Math.hypot(...half);
    this.lift = Math.max(0.45 * Math.min(...half), 0.1 * this.extent) / this.largest;
    this.nodes = new Float32Array(2 * film.cells * film.nodesPerCell);
    for (let cell = 0; cell < film.cells; ++cell)
      for (let n = 0; n < film.nodesPerCell; ++n) {
        const s = (n % side) / (side - 1), t = Math.floor(n / side) / (side - 1);
        for (let d = 0; d < 2; ++d) {
          const c = (v) => vertices[2 * cells[4 * cell + v] + d];
          this.nodes[2 * (cell * film.nodesPerCell + n) + d] =
            (1 - t) * ((1 - s) * c(0) + s * c(1)) + t * ((1 - s) * c(2) + s * c(3));
        }
      }
    this.patches = [];
    for (const mirrorX of mirrored[0]) for (const mirrorY of mirrored[1])
      for (let cell = 0; cell < film.cells; ++cell)
        for (const [quad, border] of quads)
          this.patches.push({ cell, mirrorX, mirrorY, border, nodes: quad.map((n) => cell * film.nodesPerCell + n) });
    this.struck = this.nodeAt(0, 0);
  }

  /** The node nearest to a point. */
  nodeAt(x, y) {
    let best = 0, least = Infinity;
    for (let n = 0; n < this.nodes.length / 2; ++n) {
      const distance = Math.hypot(this.nodes[2 * n] - x, this.nodes[2 * n + 1] - y);
      if (distance < least) [best, least] = [n, distance];
    }
    return best;
  }

  makeControls() {
    const { holder, film } = this;
    const add = (name, properties, parent) => {
      parent.append(element(name, properties));
      return parent.lastChild;
    };
    this.canvas = add('canvas', { tabIndex: 0, role: 'img',
      'aria-label': 'The deflected plate. Arrow keys turn it, + and - change its size.' }, holder);
    const controls = add('div', { className: 'controls' }, holder);
    this.button = add('button', { type: 'button', textContent: '▶ Play' }, controls);
    this.slider = add('input', { type: 'range', min: 0, max: film.times.length - 1, value: this.frame, 'aria-label': 'Time' }, controls);
    controls.append(selection('Colour: ', ['deflection', 'local error ratio ξ'], (chosen) => {
      this.field = ['deflection', 'error'][chosen];
      this.draw();
    }));
    const contact = () => {
      // five radii to either side, or a part of the plate under a point load
      this.isAtContact = true;
      this.zoom = this.radius / (this.patch.radius > 0 ? 5 * this.patch.radius : this.radius / 16);
      this.enlarge(1);
    };
    addZoomButtons(controls, (factor) => this.enlarge(factor), () => this.showWhole(), contact);
    this.readout = add('div', { className: 'readout', 'aria-live': 'off' }, holder);
    this.scale = add('div', {}, holder);
    add('figcaption', { textContent: `Deflection magnified ${formatted(this.lift / film.deflectionUnit, 3)} times; the largest is ` +
      `${withUnit(this.largest * film.deflectionUnit, 'm')}. ξ is the error of a cell over what the target allows it at that time. ` +
      'Drag or arrow keys turn the plate; wheel (after a click), two fingers, + and − change its size.' }, holder);

    this.slider.addEventListener('input', () => { this.frame = Number(this.slider.value); this.draw(); });
    this.button.addEventListener('click', () => this.toggle());
    const fingers = makeZoomable(this.canvas, (factor) => this.enlarge(factor), () => this.showWhole());
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons && fingers() < 2) this.turn(-0.01 * event.movementX, 0.01 * event.movementY);
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

  enlarge(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), 1e4);
    // what is looked at closely is the contact
    this.isAtContact = this.zoom > 1;
    this.draw();
  }

  showWhole() {
    this.zoom = 1;
    this.enlarge(1);
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
    return value === -32768 ? 'rgb(255,255,255)' : colourAt(ratioScale.palette, ratioScale.place(10 ** (value / 1e4)));
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
    const highest = this.lift * this.largest;
    const scale = this.zoom * Math.min(width / (2.05 * this.radius), height / (2.05 * (this.radius * sinE + highest * cosE)));
    const offset = this.frame * film.cells * film.nodesPerCell;
    // in the middle: that of the whole plate, or the contact, the origin, on the deflected one
    const share = this.isAtContact ? Math.min(1, (this.zoom - 1) / 2) : 0;
    const middle = this.centre.map((c) => c - share * c);
    const level = share * this.lift * this.deflections[offset + this.struck];
    const drawn = this.patches.map((patch) => {
      let depth = 0;
      const points = patch.nodes.map((node) => {
        const x = patch.mirrorX * this.nodes[2 * node] - middle[0], y = patch.mirrorY * this.nodes[2 * node + 1] - middle[1];
        const u = x * cosA - y * sinA, v = x * sinA + y * cosA;
        depth += v;
        return [width / 2 + scale * u, height / 2 - scale * (v * sinE - (this.lift * this.deflections[offset + node] - level) * cosE)];
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
      context.strokeStyle = 'rgba(0,0,0,0.25)';
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
      makeScale(ratioScale.palette, ratioScale.labels, 'local error ratio ξ(t)'));
  }
}
