'use strict';
// The page: shows a creature that the engine moves, proves that its score is the recorded one, and
// evolves populations in workers.

const $ = id => document.getElementById(id);
const view = $('view'), g = view.getContext('2d', { alpha: false }), page = JSON.parse($('page').textContent);
const dark = matchMedia('(prefers-color-scheme:dark)');
let module = null;       // the compiled engine
let engine, body, file;  // of the creature that is on display
let checks = '';         // check bytes of its trial's ticks, in hexadecimal
let place = null, camera = null, scale = 1, turn = 0.6;
let chosen = 0;          // of the page's creatures
let before, now, rest = 0, last = 0, paused = false, held = null, pointer = null, marked = 0;

// ---- the creature on display

// The direction in which a creature travels in its trial.
function wayOf(start, end, ground) {
  const d = [end[0] - start[0], end[1] - start[1]], length = Math.hypot(...d);
  if (length < 0.3) return [1, 0];
  return ground ? [d[0] < 0 ? -1 : 1, 0] : d.map(v => v / length);
}

function show(text, recorded) {
  file = text;
  const scored = JSON.parse(text).scored;
  checks = (scored && scored.ticks || []).join('');
  let told, start, way;
  if (module) {
    told = engine.read(text);
    start = engine.moment().slice();
    for (let n = 0; n < 4000 && engine.moment()[4] !== 2 && engine.tick() !== 256; n++);
    way = wayOf(start, engine.moment(), told.ground);
    engine.begin();
  } else {
    told = recorded.told;
    engine = playRecorded(recorded, told);
    start = engine.moment().slice();
    way = recorded.way;
  }
  body = bodyOf(told, start, way);
  place = null;
  for (const [id, value] of [['gravity', told.gravity], ['friction', told.friction]]) {
    $(id).value = value;
    $(id).disabled = !module;
  }
  label();
  begin();
}

function begin() {
  engine.begin();
  now = engine.moment().slice();
  before = now.slice();
  rest = 0;
  camera = null;
  marked = 0;
  const strip = $('strip');
  strip.width = Math.max(1, checks.length / 2);
  strip.getContext('2d').clearRect(0, 0, strip.width, strip.height);
}

// One column of the strip for each tick: whether the motion is still the recorded one.
function mark(check) {
  if (check > 255 || 2 * marked >= checks.length) return;
  const same = check === parseInt(checks.substr(2 * marked, 2), 16), g = $('strip').getContext('2d');
  g.fillStyle = engine.disturbed() ? '#d9a441' : same ? '#2fa860' : '#d0402f';
  g.fillRect(marked++, 0, 1, 10);
}

function step() {
  before.set(now);
  const check = engine.tick();
  now.set(engine.moment());
  mark(check);
}

// The moment between two ticks, for screens that are not at 60 Hz.
function between(share) {
  const row = now.slice();
  for (let i = 0; i < row.length; i++) row[i] = before[i] + share * (now[i] - before[i]);
  for (let k = 0; k < body.parts.length; k++) {
    const o = HEAD + PART * k + 3;
    let same = 0;
    for (let j = 0; j < 4; j++) same += before[o + j] * now[o + j];
    const sign = same < 0 ? -1 : 1;
    let length = 0;
    for (let j = 0; j < 4; j++) length += (row[o + j] = before[o + j] + share * (sign * now[o + j] - before[o + j])) ** 2;
    for (let j = 0; j < 4; j++) row[o + j] /= Math.sqrt(length);
  }
  for (const i of [4, 5, 6, 10]) row[i] = now[i];
  return row;
}

// ---- the picture

function fit() {
  const ratio = Math.min(2, devicePixelRatio || 1), w = Math.round(view.clientWidth * ratio), h = Math.round(w * 9 / 16);
  if (!w || place && place.width === w) return;
  view.width = w;
  view.height = h;
  place = placeFor(body.told, w, h);
  scale = w / (body.told.ground ? 5.4 : 5) / body.size * (body.space ? 1.5 : 1);
}

function draw(row, time, passed) {
  const ground = body.told.ground, [w, h] = [view.width, view.height];
  const land = ground ? landAt(row[0]) : 0;
  const goal = [row[0], ground ? land + Math.max(0, row[1] - land - 1.5 * body.size) : row[1], row[2]];
  if (!camera) camera = goal;
  const follow = 1 - Math.exp(-5 * passed);
  camera = camera.map((c, i) => c + follow * (goal[i] - c));
  const origin = [w / 2 - camera[0] * scale, (ground ? HORIZON : 0.5) * h + camera[1] * scale];
  const to = p => [origin[0] + p[0] * scale, origin[1] - p[1] * scale];
  g.setTransform(1, 0, 0, 1, 0, 0);
  drawPlace(g, place, camera, scale, time);
  draw.to = to;
  if (body.space) {
    draw.view = spaceView([camera[0], ground ? 0.35 * body.size : camera[1], camera[2]], turn, PITCH, scale, w, h);
    if (ground) {
      drawFloor(g, draw.view, camera, w, h, place.kind === 'night');
      drawShadows(g, body, row, draw.view);
    }
    drawBoxes(g, body, row, draw.view);
  } else {
    if (ground) drawGround(row, to, w);
    if (row[10]) drawWall(row[10], to);
    if (row[6]) drawLamp(to([row[7], row[8]]), h);
    drawBody(g, body, row, to, scale, time, pointer || (row[6] ? to([row[7], row[8]]) : null));
  }
  if (held && pointer) drawPull(row);
  g.font = `600 ${Math.round(h * 0.026)}px system-ui,sans-serif`;
  g.textAlign = 'left';
  g.fillStyle = 'rgba(255,255,255,0.92)';
  const phase = engine.recorded ? 'recorded' : row[4] === 1 ? 'settling' : row[4] === 2 ? 'beyond the trial' : '';
  g.fillText([`${row[3].toFixed(1)} s`, phase, engine.disturbed() ? 'disturbed' : ''].filter(Boolean).join('   '), 0.018 * w, 0.05 * h);
}

// The height of the ground at a place.
function heightAt(x) {
  const line = body.told.surface;
  let i = 1;
  while (i < line.length - 1 && line[i][0] < x) i++;
  if (line.length < 2) return 0;
  const [a, b] = [line[i - 1], line[i]];
  return b[0] > a[0] ? a[1] + (b[1] - a[1]) * clamp((x - a[0]) / (b[0] - a[0]), 0, 1) : b[1];
}

// The height of the land around a place, without its bumps.
function landAt(x) {
  if (!body.told.surface.length) return 0;
  let sum = 0;
  for (let i = -8; i <= 8; i++) sum += (9 - Math.abs(i)) * heightAt(x + 0.35 * i);
  return sum / 81;
}

// Ground with a shape: turf over soil.
function drawSurface(to, w, h) {
  const half = 0.6 * w / scale, line = body.told.surface.filter(p => Math.abs(p[0] - camera[0]) < half);
  const ends = [-half, half].map(d => [camera[0] + d, heightAt(camera[0] + d)]);
  const points = [ends[0], ...line, ends[1]].map(to), turf = Math.max(4, 0.018 * h);
  g.fillStyle = gradient(g, 0, 0.4 * h, 0, 1.1 * h, ['#8a5a3a', '#4a2f1f']);
  const land = new Path2D(), far = 2 * turf;
  land.moveTo(points[0][0] - far, h + far);
  points.forEach(p => land.lineTo(...p));
  land.lineTo(points[points.length - 1][0] + far, h + far);
  land.closePath();
  g.fill(land);
  g.save();
  g.clip(land);  // only the half of the line within the ground is seen
  g.strokeStyle = '#569638';
  g.lineWidth = 2 * turf;
  g.stroke(land);
  g.restore();
}

function drawGround(row, to, w) {
  const h = view.height, metres = scale < 40 ? 5 : 1, heightOf = x => to([x, heightAt(x)])[1];
  if (body.told.surface.length) drawSurface(to, w, h);
  g.font = `600 ${Math.round(h * 0.024)}px system-ui,sans-serif`;
  g.textAlign = 'center';
  g.fillStyle = 'rgba(255,250,235,0.75)';
  for (let m = Math.ceil((camera[0] - w / 2 / scale) / metres) * metres; to([m, 0])[0] < w + 40; m += metres) {
    const x = to([m, 0])[0], y = heightOf(m);
    g.fillRect(x - 1.5, y - 1, 3, 0.022 * h);
    g.fillText(`${m} m`, x, y + 0.055 * h);
  }
  body.parts.forEach((p, k) => {  // shadows
    const angle = angleOf(row, k), c = Math.abs(Math.cos(angle)), s = Math.abs(Math.sin(angle)), at = placeOf(row, k);
    const wide = c * p.half[0] + s * p.half[1], low = at[1] - s * p.half[0] - c * p.half[1] - heightAt(at[0]), strength = clamp(0.34 - 0.5 * low / body.size, 0, 0.34);
    if (strength <= 0) return;
    g.fillStyle = `rgba(20,30,10,${0.55 * strength})`;
    g.beginPath();
    g.ellipse(to(at)[0], heightOf(at[0]) + 3, 1.05 * wide * scale, Math.max(2, 0.011 * h), 0, 0, 7);
    g.fill();
  });
}

// The wall of a trial: courses of stones, 1 m high.
function drawWall(x, to) {
  for (let course = 0; course < 7; course++) {
    const seam = 0.3 + 0.4 * Math.abs(Math.sin(7 * course + 3)), ends = [0, seam, 1];
    for (let k = 0; k < 2; k++) {
      const low = to([x - 0.15 + 0.3 * ends[k], course / 7]), high = to([x - 0.15 + 0.3 * ends[k + 1], (course + 1) / 7]);
      g.fillStyle = oklch(0.22, 0.5 + 0.12 * Math.sin(5 * course + 2 * k), 0.02);
      g.beginPath();
      g.roundRect(low[0] + 1, high[1] + 1, high[0] - low[0] - 2, low[1] - high[1] - 2, 0.03 * scale);
      g.fill();
    }
  }
}

function drawLamp([x, y], h) {
  const glow = g.createRadialGradient(x, y, 0, x, y, 0.35 * h);
  glow.addColorStop(0, 'rgba(255,236,160,0.95)');
  glow.addColorStop(0.08, 'rgba(255,226,140,0.5)');
  glow.addColorStop(1, 'rgba(255,226,140,0)');
  g.fillStyle = glow;
  g.fillRect(x - h, y - h, 2 * h, 2 * h);
}

// Where the held point of a part is.
const gripOf = row => turned(attitudeOf(row, held.part), held.grip).map((v, i) => v + placeOf(row, held.part)[i]);

function drawPull(row) {
  const from = body.space ? draw.view.see(gripOf(row)) : draw.to(gripOf(row));
  g.strokeStyle = 'rgba(255,255,255,0.9)';
  g.lineWidth = 3;
  g.setLineDash([7, 5]);
  g.beginPath();
  g.moveTo(from[0], from[1]);
  g.lineTo(...pointer);
  g.stroke();
  g.setLineDash([]);
}

function frame(time) {
  const passed = Math.min(0.1, last ? (time - last) / 1000 : TICK);
  last = time;
  try {
    if (body) {
      fit();
      if (!paused) {
        rest += passed;
        for (let n = 0; rest >= TICK && n < 6; n++, rest -= TICK) step();
        if (rest > TICK) rest = 0;
      }
      draw(between(rest / TICK), time / 1000, passed);
    }
  } catch (error) {
    fall(error);
  }
  requestAnimationFrame(frame);
}

// Goes on with the recorded motion, if there is one, where the engine fails.
function fall(error) {
  const made = page.creatures && page.creatures[0];
  if (engine && engine.recorded || !made) {
    body = null;
    $('verdict').textContent = 'This page does not run here.';
    $('proof-text').textContent = String(error.message || error);
    return;
  }
  module = null;
  $('evolution').hidden = true;
  show($(made.id).textContent, made.recorded);
  $('verdict').textContent = 'A recorded motion.';
  $('proof-text').textContent = `The engine does not run here: ${error.message || error}.`;
  $('hint').textContent = '';
  $('strip').hidden = true;
}

// ---- the proof

function newWorker() {
  const source = [$('engine-script').textContent, $('worker-script').textContent];
  return new Worker(URL.createObjectURL(new Blob(source, { type: 'text/javascript' })));
}

function prove() {
  const proof = $('proof'), proved = file, worker = newWorker();
  proof.className = 'card';
  $('verdict').textContent = 'Computing the complete trial …';
  $('proof-text').textContent = '';
  worker.onmessage = ({ data: told }) => {
    worker.terminate();
    if (proved !== file) return;
    if (told.error) return fall(Error(told.error));
    if (!told.scored) {
      $('verdict').textContent = 'This creature has no score to check.';
      return;
    }
    proof.className = told.same ? 'card good' : 'card bad';
    $('verdict').textContent = told.same ? 'The same bits in your browser.' : 'Other bits than in the file.';
    const ticks = !told.recordedTicks ? 'no ticks recorded' : told.differentTick ? `tick ${told.differentTick} differs` : `all ${told.ticks} ticks equal`;
    $('proof-text').textContent = `The trial of ${body.told.duration} s took ${told.took.toFixed(0)} ms here: ${told.digest} ${told.same ? '=' : '≠'} ` +
      `${told.recorded} of the file; ${Number(told.score.toPrecision(6))} ${told.unit}; ${ticks}; simulator ${told.simulator}.`;
    proof.dataset.result = JSON.stringify(told);
  };
  worker.onerror = event => fall(Error(event.message));
  worker.postMessage({ module, file });
}

// ---- evolution

const GOALS = { walking: 'walking', jumping: 'jumping', swimming: 'swimming', seeking: 'seeking a lamp', flying: 'flying', escape: 'escaping a wall', fleeing: 'fleeing from a hunter', climbing: 'climbing stairs', course: 'an obstacle course', 'swimming-3d': 'swimming in space' };
let evolving = { workers: [], curve: [] };

function startEvolution() {
  stopEvolution();
  const seed = Math.round(+$('seed').value) || 0, size = clamp(Math.round(+$('size').value) || 100, 10, 1000);
  const count = clamp(Math.round(+$('workers').value) || 1, 1, 8), goal = $('goal').value;
  const own = goal === 'page' ? page.evolve.settings
    : goal === 'swimming-3d' ? 'environment.dimensions=3\ngoal.behavior=swimming\n' : `goal.behavior=${goal}\n`;
  const asGiven = goal === 'page' && seed === page.evolve.seed && size === page.evolve.size;
  const one = evolving = { workers: Array.from({ length: count }, newWorker), curve: [], same: true };
  let best = -Infinity, waiting = null, since = 0, begun = performance.now();
  $('evolve').textContent = 'Stop';
  $('equal').textContent = '';
  $('progress').textContent = 'The first generation …';
  const tell = told => {
    if (one !== evolving) return;
    one.curve.push([told.best, told.median]);
    drawCurves();
    $('progress').textContent = `Generation ${told.generation}, ${size} creatures, seed ${seed}: best ${Number(told.best.toPrecision(4))}, median ${Number(told.median.toPrecision(3))}; ` +
      `${told.trials} trials in ${(performance.now() - begun).toFixed(0)} ms; digest of the population ${told.digest}`;
    begun = performance.now();
    if (asGiven) compare(told, one);
    if (told.best > best) {
      best = told.best;
      waiting = { file: told.file, generation: told.generation, seed };
    }
    if (waiting && !held && (!body || performance.now() - since > 4000)) {
      showChampion(waiting);
      waiting = null;
      since = performance.now();
    }
    document.body.dataset.generation = told.generation;
  };
  const fail = error => {
    if (one !== evolving) return;
    stopEvolution();
    $('progress').textContent = `The evolution does not run here: ${error.message}`;
  };
  evolveTogether(one.workers, module, `${own}run.seed=${seed}\npopulation.size=${size}\n`, tell, fail);
}

function stopEvolution() {
  evolving.workers.forEach(worker => worker.terminate());
  evolving = { workers: [], curve: evolving.curve };
  $('evolve').textContent = 'Evolve';
}

// The program that made the page told the digests of its first generations.
function compare(told, one) {
  const expected = page.evolve.digests[told.generation];
  if (!expected) return;
  one.same = one.same && expected === told.digest;
  $('equal').textContent = one.same ? `All ${told.generation + 1} generations equal those of the program that made this page.`
    : 'Another evolution than that of the program that made this page.';
  $('equal').style.color = one.same ? 'var(--good)' : 'var(--bad)';
}

const counted = (count, noun) => `${count} ${noun}${count === 1 ? '' : 's'}`;

function showChampion({ file, generation, seed }) {
  show(file);
  $('name').textContent = `The best of generation ${generation}`;
  $('facts').textContent = `${body.told.goal}, ${counted(body.parts.length, 'part')}, ${counted(body.told.neurons, 'neuron')}; evolved in this page from seed ${seed}`;
  prove();
}

function drawCurves() {
  const plot = $('curve'), c = plot.getContext('2d'), { curve } = evolving, all = curve.flat(), top = Math.max(...all, 1e-9) * 1.08, low = Math.min(...all, 0);
  const style = getComputedStyle(document.documentElement);
  plot.width = 2 * plot.clientWidth;
  plot.height = 180;
  const length = Math.max(30, curve.length);
  [['--soft', 2.5], ['--warm', 4]].forEach(([name, thick], i) => {
    c.strokeStyle = style.getPropertyValue(name);
    c.lineWidth = thick;
    c.beginPath();
    curve.forEach((row, n) => c[n ? 'lineTo' : 'moveTo'](4 + n * (plot.width - 8) / (length - 1), 174 - 166 * (row[1 - i] - low) / (top - low)));
    c.stroke();
  });
}

// ---- the course of a run

// Round values from low to high, at most six.
function roundSteps(low, high) {
  const least = (high - low) / 5 || 1, power = 10 ** Math.floor(Math.log10(least)), step = [1, 2, 5, 10].find(n => n * power >= least) * power, values = [];
  for (let v = Math.ceil(low / step - 1e-9) * step; v <= high + 1e-9 * step; v += step) values.push(Number(v.toPrecision(6)));
  return values;
}

// Draws best and median of every generation, and a dot for each champion of the page.
function drawCourse() {
  const { unit, rows } = page.course, plot = $('course-plot'), c = plot.getContext('2d'), ratio = devicePixelRatio || 1;
  const width = plot.clientWidth, height = plot.clientHeight, style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(name);
  const known = rows.flatMap(row => row.slice(1)).filter(v => v !== null), high = Math.max(...known, 1e-9), low = Math.min(...known, 0), last = Math.max(1, rows[rows.length - 1][0]);
  const x = generation => 56 + generation / last * (width - 72), y = value => height - 26 - (value - low) / (high - low || 1) * (height - 44);
  plot.width = Math.round(width * ratio);
  plot.height = Math.round(height * ratio);
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.font = '12px system-ui,sans-serif';
  c.lineWidth = 1;
  c.fillStyle = colour('--soft');
  c.strokeStyle = dark.matches ? 'rgba(255,255,255,0.1)' : 'rgba(0,0,0,0.1)';
  c.textAlign = 'right';
  for (const value of roundSteps(low, high)) {
    c.fillText(value, 48, y(value) + 4);
    c.beginPath();
    c.moveTo(56, y(value));
    c.lineTo(width - 16, y(value));
    c.stroke();
  }
  c.textAlign = 'center';
  for (const generation of roundSteps(0, last).filter(Number.isInteger)) c.fillText(generation, x(generation), height - 6);
  c.textAlign = 'left';
  c.fillText(unit, 4, 11);
  [[1, '--warm', 2.5, 'best'], [2, '--soft', 1.5, 'median']].forEach(([column, name, thick, words]) => {
    c.strokeStyle = colour(name);
    c.lineWidth = thick;
    c.beginPath();
    const drawn = rows.filter(row => row[column] !== null);
    drawn.forEach((row, i) => c[i ? 'lineTo' : 'moveTo'](x(row[0]), y(row[column])));
    c.stroke();
    if (!drawn.length) return;
    c.fillStyle = colour(name);
    c.textAlign = 'right';
    c.fillText(words, width - 16, y(drawn[drawn.length - 1][column]) + (column === 1 ? 20 : -7));
  });
  const best = generation => rows.reduce((a, b) => Math.abs(b[0] - generation) < Math.abs(a[0] - generation) ? b : a)[1];
  page.creatures.forEach((made, i) => {
    made.place = [x(made.generation), y(best(made.generation) ?? low)];
    c.beginPath();
    c.arc(...made.place, i === chosen ? 6.5 : 4, 0, 7);
    c.fillStyle = colour(i === chosen ? '--warm' : '--card');
    c.strokeStyle = colour('--warm');
    c.lineWidth = 2;
    c.fill();
    c.stroke();
  });
}

function showCourse() {
  const last = page.course.rows[page.course.rows.length - 1], words = `Best and median of each generation. The last, ${last[0]}, has a best of ${Number((last[1] ?? 0).toPrecision(4))} ${page.course.unit}. Press a dot for its champion.`;
  $('course').hidden = false;
  $('course-text').textContent = words;
  $('course-plot').setAttribute('aria-label', words);
  $('course-plot').onclick = event => {
    const near = made => Math.hypot(made.place[0] - event.offsetX, made.place[1] - event.offsetY);
    const nearest = page.creatures.reduce((best, made, i) => near(made) < near(page.creatures[best]) ? i : best, 0);
    if (near(page.creatures[nearest]) < 40) choose(nearest);
  };
  new ResizeObserver(drawCourse).observe($('course-plot'));
}

// ---- controls

function label() {
  $('gravity-text').textContent = `${(+$('gravity').value).toFixed(2)} m/s²`;
  $('friction-text').textContent = (+$('friction').value).toFixed(2);
}

function pixels(event) {
  const r = view.getBoundingClientRect();
  return [(event.clientX - r.left) * view.width / r.width, (event.clientY - r.top) * view.height / r.height];
}

// The part at these pixels and the point of it, or nothing.
function partAt(point) {
  let best = null, least = (body.space ? 40 : 0.3 * body.size * scale);
  body.parts.forEach((p, k) => {
    const at = placeOf(now, k), half = halfOf(now, k), q = attitudeOf(now, k), inverse = [q[0], -q[1], -q[2], -q[3]];
    const world = body.space ? draw.view.at(...point, at) : [(point[0] - draw.to([0, 0])[0]) / scale, (draw.to([0, 0])[1] - point[1]) / scale, 0];
    const local = turned(inverse, world.map((v, i) => v - at[i])), grip = local.map((v, i) => clamp(v, -half[i], half[i]));
    if (!body.space) grip[2] = 0;
    const far = Math.hypot(...local.map((v, i) => body.space || i < 2 ? v - grip[i] : 0)) * scale;
    if (far < least) [least, best] = [far, { part: k, grip }];
  });
  return best;
}

const pulledTo = point => body.space ? draw.view.at(...point, gripOf(now)) : [(point[0] - draw.to([0, 0])[0]) / scale, (draw.to([0, 0])[1] - point[1]) / scale, 0];

let orbit = null;
view.addEventListener('pointerdown', event => {
  if (!body || !module) return;
  const point = pixels(event);
  held = partAt(point);
  view.setPointerCapture(event.pointerId);
  if (!held) {
    orbit = body.space ? [point[0], turn] : null;
    return;
  }
  pointer = point;
  view.className = 'held';
  engine.hold(held.part, gripOf(now));
  engine.drag(pulledTo(point));
});
view.addEventListener('pointermove', event => {
  if (orbit) turn = orbit[1] - (pixels(event)[0] - orbit[0]) * 4 / view.width;
  if (!held) return;
  pointer = pixels(event);
  engine.drag(pulledTo(pointer));
});
for (const end of ['pointerup', 'pointercancel']) view.addEventListener(end, () => {
  orbit = null;
  if (!held) return;
  held = pointer = null;
  view.className = '';
  engine.letGo();
});
$('restart').onclick = () => { if (body) { begin(); for (const id of ['gravity', 'friction']) $(id).value = body.told[id]; label(); } };
$('pause').onclick = () => { paused = !paused; $('pause').textContent = paused ? 'Go on' : 'Pause'; };
for (const id of ['gravity', 'friction']) $(id).oninput = () => { label(); engine.world(+$('gravity').value, +$('friction').value); };
$('save').onclick = () => {
  if (!file) return;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([file], { type: 'application/json' }));
  link.download = `${(JSON.parse(file).name || 'creature').replace(/[^\w-]+/g, '_')}.creature.json`;
  link.click();
};
$('evolve').onclick = () => evolving.workers.length ? stopEvolution() : startEvolution();
dark.onchange = () => { if (page.course) drawCourse(); if (evolving.curve.length) drawCurves(); };

// The creature that the address names, as in #Walker, or -1.
function named() {
  const name = decodeURIComponent(location.hash.slice(1)).toLowerCase();
  return page.creatures.findIndex(made => made.label.toLowerCase() === name);
}
addEventListener('hashchange', () => { if (named() >= 0 && named() !== chosen) choose(named()); });

function choose(number) {
  const made = page.creatures[number];
  chosen = number;
  [...$('gallery').children].forEach((button, i) => button.setAttribute('aria-pressed', i === number));
  show($(made.id).textContent, made.recorded);
  $('facts').textContent = made.facts;
  if (!page.course) $('name').textContent = made.label;
  if (page.creatures.length > 1 && location.hash !== '#recorded') history.replaceState(null, '', `#${encodeURIComponent(made.label)}`);
  if (module) prove();
  if (page.course) drawCourse();
}

function fillGallery() {
  const gallery = $('gallery');
  gallery.hidden = false;
  page.creatures.forEach((made, i) => {
    const button = document.createElement('button');
    button.textContent = made.label;
    button.setAttribute('aria-pressed', i === 0);
    button.onclick = () => choose(i);
    gallery.append(button);
  });
}

(async () => {
  try {
    if (location.hash === '#recorded') throw Error('the address asks for the recorded motion');
    const text = $('engine').textContent;
    if (!text.trim()) throw Error('the program that made this page had no engine to put in');
    module = await compileEngine(text);
    engine = await startEngine(module);
  } catch (error) {
    module = null;
    fall(error);
  }
  if (module && page.creatures.length) {
    try {
      show($(page.creatures[0].id).textContent, page.creatures[0].recorded);
      prove();
    } catch (error) {
      fall(error);
    }
  }
  if ($('licences').textContent && typeof DecompressionStream === 'function') {
    $('notices').hidden = false;
    $('notices').ontoggle = async () => {
      $('notice-text').textContent = new TextDecoder().decode(await unpacked($('licences').textContent));
    };
  }
  if (page.creatures.length > 1) {
    fillGallery();
    if (named() > 0) choose(named());
  }
  if (page.course) showCourse();
  if (module && page.evolve) {
    $('evolution').hidden = false;
    for (const [id, words] of Object.entries({ page: page.evolve.label, ...GOALS })) $('goal').add(new Option(words, id));
    $('size').value = page.evolve.size;
    $('seed').value = page.evolve.seed;
    $('workers').value = clamp(navigator.hardwareConcurrency || 1, 1, 4);
    if (!page.creatures.length) {
      $('verdict').textContent = 'Whatever evolves here is checked here.';
      startEvolution();
    }
  }
  requestAnimationFrame(frame);
})();
