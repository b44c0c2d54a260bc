'use strict';
// The engine of Cambrian as WebAssembly: it computes what the program computes, to the last bit.

const HEAD = 11, PART = 12, TICK = 1 / 60;  // numbers of a moment and of each part in it; s

// The bytes of a dense text: 13 bits in two characters; the first four bytes are their number.
function denseBytes(text) {
  const digit = at => { const c = text.charCodeAt(at); return c - 33 - (c > 60) - (c > 92) - (c > 96); };
  const bytes = new Uint8Array(text.length);
  let held = 0, bits = 0, end = 0;
  for (let i = 0; i + 1 < text.length; i += 2) {
    held |= digit(i) + 91 * digit(i + 1) << bits;
    for (bits += 13; bits >= 8; bits -= 8, held >>= 8) bytes[end++] = held;
  }
  return bytes.subarray(4, 4 + new DataView(bytes.buffer).getUint32(0, true));
}

// The bytes of a zlib stream in a dense text.
async function unpacked(text) {
  const stream = new Blob([denseBytes(text.trim())]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

async function compileEngine(text) {
  if (typeof WebAssembly !== 'object' || typeof DecompressionStream !== 'function')
    throw Error('this browser cannot run it');
  return WebAssembly.compile(await unpacked(text));
}

// Returns an engine of its own memory. Methods throw what the engine says about bad files.
async function startEngine(module) {
  const imports = {};
  for (const i of WebAssembly.Module.imports(module)) (imports[i.module] ??= {})[i.name] = () => 0;
  const e = (await WebAssembly.instantiate(module, imports)).exports;
  e._initialize();
  const text = at => {
    const all = new Uint8Array(e.memory.buffer);
    return new TextDecoder().decode(all.subarray(at, all.indexOf(0, at)));
  };
  const must = at => { const error = text(at); if (error) throw Error(error); };
  const put = words => {
    const bytes = new TextEncoder().encode(words), at = e.engine_room(bytes.length);
    new Uint8Array(e.memory.buffer, at, bytes.length).set(bytes);
  };
  let parts = 0;
  return {
    read(file) {
      put(file);
      must(e.engine_read());
      must(e.engine_begin());
      const told = JSON.parse(text(e.engine_describe()));
      parts = told.parts.length;
      return told;
    },
    begin: () => must(e.engine_begin()),
    moment: () => new Float64Array(e.memory.buffer, e.engine_moment(), HEAD + PART * parts),
    tick: () => e.engine_tick(),
    disturbed: () => e.engine_disturbed() === 1,
    hold: (part, place) => e.engine_hold(part, ...place),
    letGo: () => e.engine_hold(-1, 0, 0, 0),
    drag: place => e.engine_drag(...place),
    world: (gravity, friction) => e.engine_world(gravity, friction),
    verify: () => JSON.parse(text(e.engine_verify())),
    settings(lines) { put(lines); must(e.engine_settings()); },
    // Goes on with the generation; returns how many trials it needs for that, or 0 if it is evaluated.
    needs: () => e.engine_needs(),
    run: trial => text(e.engine_run(trial)),  // its result, for take() of other engines
    take(trial, result) { put(result); must(e.engine_take(trial)); },
    // An evaluated generation: what the engine tells of it, and the file of its best creature.
    generation() {
      const said = text(e.engine_generation()), end = said.indexOf('\n');
      return { ...JSON.parse(said.slice(0, end)), file: said.slice(end + 1) };
    },
  };
}

// A motion that was recorded at 20 Hz, where the engine does not run: the same moments without physics.
function playRecorded(recorded, told) {
  const raw = new Int16Array(denseBytes(recorded.data).slice().buffer), count = told.parts.length, space = told.dimensions === 3;
  const each = space ? 7 : 4, stride = each * count;  // of a part: place, then attitude; in the plane only what is not 0
  const frames = Math.floor(raw.length / stride), row = new Float64Array(HEAD + PART * count);
  let ticks = 0;
  const show = () => {
    const at = Math.min(ticks / 3, frames - 1.001), first = Math.floor(at), share = at - first;
    row.fill(0, 0, 3);
    row[3] = ticks * TICK;
    row[4] = ticks / 3 >= frames - 1 ? 2 : 0;
    let mass = 0;
    for (let k = 0; k < count; k++) {
      const value = j => {
        const a = raw[first * stride + each * k + j], b = raw[(first + 1) * stride + each * k + j];
        return a + share * (b - a);
      };
      const o = HEAD + PART * k, half = told.parts[k].half, own = half[0] * half[1] * (told.dimensions === 3 ? half[2] : 1);
      for (let j = 0; j < (space ? 3 : 2); j++) {
        row[o + j] = value(j) * recorded.unit;
        row[j] += own * row[o + j];
      }
      const turn = space ? [3, 4, 5, 6].map(value) : [value(2), 0, 0, value(3)], length = Math.hypot(...turn) || 1;
      turn.forEach((v, j) => { row[o + 3 + j] = v / length; });
      half.forEach((v, j) => { row[o + 7 + j] = v; });
      mass += own;
    }
    for (let j = 0; j < 3; j++) row[j] /= mass;
  };
  show();
  return {
    recorded: true, moment: () => row, disturbed: () => false, begin() { ticks = 0; show(); },
    tick() { ticks = ticks / 3 > frames + 20 ? 0 : ticks + 1; show(); return 256; },
    hold() {}, letGo() {}, drag() {}, world() {},
  };
}
