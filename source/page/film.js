// ---------------------------------------------------------------- film

const decoded = (text, Type) => new Type(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

/** Splits a quadrilateral along the limits of the bands that its field passes.
    @param points  of the four corners, in turn
    @param places  of the field there, on a scale from 0 to 1
    @param fill    called with a polygon and the number of its band */
function fillBands(points, places, nBands, fill) {
  const band = (place) => Math.min(nBands - 1, Math.max(0, Math.floor(place * nBands)));
  const first = band(Math.min(...places)), last = band(Math.max(...places));
  if (first === last) return fill(points, first);
  const mean = (values) => values.reduce((sum, value) => sum + value / 4, 0);
  const centre = { point: [0, 1].map((d) => mean(points.map((point) => point[d]))), place: mean(places) };
  for (let side = 0; side < 4; ++side) {
    const triangle = [side, (side + 1) % 4].map((i) => ({ point: points[i], place: places[i] })).concat(centre);
    for (let k = first; k <= last; ++k) {
      const above = k === first ? triangle : clipped(triangle, k / nBands, 1);
      const polygon = k === last ? above : clipped(above, (k + 1) / nBands, -1);
      if (polygon.length > 2) fill(polygon.map(({ point }) => point), k);
    }
  }
}

/** The part of a polygon at or beyond a limit, upwards or downwards. */
function clipped(polygon, limit, sign) {
  const kept = [];
  polygon.forEach((end, i) => {
    const begin = polygon.at(i - 1), a = sign * (begin.place - limit), b = sign * (end.place - limit);
    if (a * b < 0) {
      const s = a / (a - b), between = (from, to) => from + s * (to - from);
      kept.push({ place: limit, point: [0, 1].map((d) => between(begin.point[d], end.point[d])) });
    }
    if (b >= 0) kept.push(end);
  });
  return kept;
}

/** Plays deflection_film(): the whole plate, drawn from the part that is
    computed, seen from any side, coloured by one of its fields. */
class Film {
  constructor(holder, { film, patch, symmetric }, mesh) {
    Object.assign(this, { film, patch, symmetric, mesh, azimuth: 0.6, elevation: 0.55, zoom: 1 });
    this.deflections = decoded(film.deflections, Int16Array);
    this.cellErrors = decoded(film.cellErrors, Int16Array);
    this.nodesPerCell = film.nodesPerSide ** 2;
    this.largest = this.deflections.reduce((a, b) => Math.max(a, Math.abs(b)), 1);
    this.fields = this.makeFields();
    // the frame of the largest force says most
    this.frame = film.forces.indexOf(Math.max(...film.forces));
    this.makePatches();
    this.makeControls(holder);
    this.colourBy(0);
  }

  /** What the plate may be coloured by: places of the nodes on a scale, and what mirrors do to them. */
  makeFields() {
    const { film } = this, top = withUnit(this.largest * film.deflectionUnit, 'm');
    const deflection = { name: 'deflection', isOdd: [false, false], palette: palettes.diverging,
      title: 'deflection, positive in the direction of impact', labels: ['−' + top, '0', top],
      place: (node, sign) => 0.5 + sign * this.deflections[node] / this.largest / 2 };
    const stresses = film.fields.map((field) => {
      const roots = decoded(field.values, Int8Array), scale = rootScale(field, field.largest, roots.some((root) => root < 0));
      return { ...field, ...scale,
        place: scale.isSigned ? (node, sign) => 0.5 + sign * roots[node] / 254 : (node, sign) => sign * roots[node] / 127 };
    });
    return [deflection, { ...ratioScale, name: 'local error ratio ξ', title: 'local error ratio ξ(t)', place: null }, ...stresses];
  }

  /** Quadrilaterals to draw, with their nodes, for all mirror images. */
  makePatches() {
    const { film, mesh: { vertices, cells } } = this;
    const side = film.nodesPerSide, quads = [];
    for (let j = 0; j + 1 < side; ++j)
      for (let i = 0; i + 1 < side; ++i) {
        const nodes = [j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i];
        // edges, by their first corner, that border on other cells
        const border = [j === 0, i + 2 === side, j + 2 === side, i === 0].flatMap((is, edge) => (is ? [edge] : []));
        quads.push([nodes, border]);
      }
    const mirrored = this.symmetric.map((is) => (is ? [1, -1] : [1]));
    const ranges = mirrored.map((signs, d) => rangeOf(vertices.filter((_, i) => i % 2 === d).flatMap((c) => signs.map((sign) => sign * c))));
    const half = ranges.map(([low, high]) => (high - low) / 2);
    this.centre = ranges.map(([low, high]) => (high + low) / 2);
    this.extent = Math.max(...half);
    this.radius = Math.hypot(...half);
    this.lift = Math.max(0.45 * Math.min(...half), 0.1 * this.extent) / this.largest;
    this.nodes = new Float32Array(2 * film.cells * this.nodesPerCell);
    for (let cell = 0; cell < film.cells; ++cell)
      for (let n = 0; n < this.nodesPerCell; ++n) {
        const s = (n % side) / (side - 1), t = Math.floor(n / side) / (side - 1);
        for (let d = 0; d < 2; ++d) {
          const c = (v) => vertices[2 * cells[4 * cell + v] + d];
          this.nodes[2 * (cell * this.nodesPerCell + n) + d] =
            (1 - t) * ((1 - s) * c(0) + s * c(1)) + t * ((1 - s) * c(2) + s * c(3));
        }
      }
    this.patches = [];
    for (const mirrorX of mirrored[0]) for (const mirrorY of mirrored[1])
      for (let cell = 0; cell < film.cells; ++cell)
        for (const [quad, border] of quads)
          this.patches.push({ cell, mirrorX, mirrorY, border, nodes: quad.map((n) => cell * this.nodesPerCell + n) });
    const fromImpact = (n) => Math.hypot(this.nodes[2 * n], this.nodes[2 * n + 1]);
    this.struck = Array.from({ length: this.nodes.length / 2 }, (_, n) => n).reduce((a, b) => (fromImpact(b) < fromImpact(a) ? b : a));
  }

  makeControls(holder) {
    const { film } = this, zoom = (factor) => this.show({ zoom: factor * this.zoom }), reset = () => this.show({ zoom: 1 });
    // five radii to either side, or a part of the plate under a point load
    const contact = () => this.show({ zoom: this.radius / (this.patch.radius > 0 ? 5 * this.patch.radius : this.radius / 16) });
    const turn = (azimuth, elevation) => this.show({ azimuth: this.azimuth + azimuth, elevation: this.elevation + elevation });
    this.canvas = element('canvas', { tabIndex: 0, role: 'img',
      'aria-label': 'The deflected plate. Arrow keys turn it, + and - change its size.' });
    this.button = button('▶ Play', () => this.toggle());
    this.slider = element('input', { type: 'range', min: 0, max: film.times.length - 1, value: this.frame, 'aria-label': 'Time',
      oninput: () => this.show({ frame: Number(this.slider.value) }) });
    this.readout = element('div', { className: 'readout', 'aria-live': 'off' });
    this.scale = element('div');
    holder.append(this.canvas, element('div', { className: 'controls' }, this.button, this.slider,
      selection('Colour: ', this.fields.map(({ name }) => name), (chosen) => this.colourBy(chosen)),
      button('from above', () => turn(-this.azimuth, Math.PI), { title: 'x to the right, y upwards' }), zoomButtons(zoom, reset, contact)),
    this.readout, this.scale,
    element('figcaption', {}, `Deflection magnified ${formatted(this.lift / film.deflectionUnit, 3)} times; the largest is ` +
      `${withUnit(this.largest * film.deflectionUnit, 'm')}. ξ is the error of a cell divided by the error that the target allows it at that time. ` +
      'Drag or arrow keys turn the plate; wheel (after a click), two fingers, + and − change its size.'));
    makeZoomable(this.canvas, { zoom, reset,
      drag: (right, down) => turn(-0.01 * right, 0.01 * down), step: (right, down) => turn(-0.1 * right, 0.1 * down) });
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    for (const medium of ['(prefers-color-scheme: dark)', 'print']) matchMedia(medium).addEventListener('change', () => this.draw());
  }

  /** @param change  of frame, zoom, azimuth, elevation */
  show(change) {
    Object.assign(this, change);
    this.zoom = Math.min(Math.max(this.zoom, 1), 1e4);
    this.elevation = Math.min(Math.PI / 2, Math.max(0.05, this.elevation));
    this.slider.value = this.frame;
    this.draw();
  }

  colourBy(chosen) {
    this.field = this.fields[chosen];
    const { palette, labels, title, place } = this.field;
    this.scale.replaceChildren(makeScale(palette, labels, title, place !== null));
    this.draw();
  }

  toggle() {
    const last = this.film.times.length - 1;
    if (this.timer) this.timer = clearInterval(this.timer); // to nothing
    else {
      if (this.frame === last) this.show({ frame: 0 });
      this.timer = setInterval(() => { if (this.frame === last) this.toggle(); else this.show({ frame: this.frame + 1 }); }, 90);
    }
    this.button.textContent = this.timer ? '❚❚ Pause' : '▶ Play';
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
    const offset = this.frame * film.cells * this.nodesPerCell;
    // in the middle: that of the whole plate, or, when looked at closely, the contact, the origin, on the deflected one
    const share = Math.min(1, (this.zoom - 1) / 2);
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
    const { field } = this, nBands = bandsOf(field.palette);
    const fill = (polygon, colour) => {
      context.beginPath();
      polygon.forEach((point, i) => (i === 0 ? context.moveTo(...point) : context.lineTo(...point)));
      context.closePath();
      // the line hides the seam between two fillings
      context.fillStyle = context.strokeStyle = colour;
      context.fill();
      context.stroke();
    };
    for (const { patch, points } of drawn) {
      if (field.place) {
        const sign = (field.isOdd[0] ? patch.mirrorX : 1) * (field.isOdd[1] ? patch.mirrorY : 1);
        fillBands(points, patch.nodes.map((node) => field.place(offset + node, sign)), nBands,
          (polygon, band) => fill(polygon, bandColour(field.palette, band)));
      } else {
        const error = this.cellErrors[this.frame * film.cells + patch.cell];
        fill(points, error === -32768 ? 'rgb(255,255,255)' : colourAt(field.palette, ratioScale.place(10 ** (error / 1e4))));
      }
      context.strokeStyle = 'rgba(0,0,0,0.25)';
      for (const edge of patch.border) {
        context.beginPath();
        context.moveTo(...points[edge]);
        context.lineTo(...points[(edge + 1) % 4]);
        context.stroke();
      }
    }
    this.readout.textContent = `t = ${withUnit(film.times[this.frame], 's')},  F = ${withUnit(film.forces[this.frame], 'N')},  ` +
      `η(t) = ${formatted(100 * film.errors[this.frame], 4)} %`;
    this.slider.setAttribute('aria-valuetext', this.readout.textContent);
  }
}
