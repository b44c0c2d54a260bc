'use strict';
// How a creature looks: one skin over all parts with the pattern of its kind, and eyes.

const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
const mixed = x => {
  x = Math.imul(x ^ x >>> 16, 0x7feb352d);
  x = Math.imul(x ^ x >>> 15, 0x846ca68b);
  return (x ^ x >>> 16) >>> 0;
};
// A number in [0, 1) that looks random: always the same for two numbers.
const chance = (a, b = 0) => (mixed(a * 9781 + mixed(b + 77)) & 0xffffff) / 0x1000000;

// A colour of Oklch (B. Ottosson, 2020): hue in turns, lightness, chroma, opacity.
function oklch(turns, lightness, chroma, alpha = 1) {
  const a = chroma * Math.cos(2 * Math.PI * turns), b = chroma * Math.sin(2 * Math.PI * turns);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const byte = v => Math.round(255 * (v <= 0.0031308 ? 12.92 * Math.max(v, 0) : 1.055 * Math.min(v, 1) ** (1 / 2.4) - 0.055));
  return `rgba(${byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s)},` +
    `${byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s)},` +
    `${byte(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s)},${alpha})`;
}

// Attitude (w, x, y, z) times vector.
function turned(q, v) {
  const [w, x, y, z] = q, t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
}
const placeOf = (row, k) => row.subarray(HEAD + PART * k, HEAD + PART * k + 3);
const attitudeOf = (row, k) => row.subarray(HEAD + PART * k + 3, HEAD + PART * k + 7);
const halfOf = (row, k) => row.subarray(HEAD + PART * k + 7, HEAD + PART * k + 10);
const angleOf = (row, k) => { const q = attitudeOf(row, k); return 2 * Math.atan2(q[3], q[0]); };

const PATTERNS = ['bands', 'spots', 'stripes', 'chevrons'];

// The pattern of a part as a path in its frame.
function markings(kind, half, wave, k) {
  const [x0, y0] = half, path = new Path2D(), phase = chance(k, 5);
  if (kind === 'spots') {
    for (let i = 0, x = -x0; x < x0 + wave; x += 0.72 * wave, i++)
      for (let j = 0, y = -y0; y < y0 + wave; y += 0.72 * wave, j++) {
        const r = (0.17 + 0.14 * chance(i * 31 + j, k)) * wave;
        const cx = x + (0.36 * (j & 1) + 0.2 * chance(i, j)) * wave, cy = y + 0.2 * wave * chance(j, i + 9);
        path.moveTo(cx + r, cy);
        path.arc(cx, cy, r, 0, 7);
      }
    return path;
  }
  const lengthwise = kind === 'stripes', along = lengthwise ? y0 : x0, across = lengthwise ? x0 : y0;
  const bend = v => kind === 'chevrons' ? 0.75 * Math.abs(v) : 0.18 * wave * Math.sin(9 * 0.45 * v / wave + 12 * phase);
  const point = (u, v, first) => path[first ? 'moveTo' : 'lineTo'](...(lengthwise ? [v, u] : [u, v]));
  for (let u = -along - wave * (1 + phase); u < along + wave; u += lengthwise ? 0.8 * wave : wave) {
    const width = (lengthwise ? 0.36 : 0.5) * wave;
    for (let j = 0; j <= 12; j++) point(u + bend(across * (j / 6 - 1)), across * (j / 6 - 1), j === 0);
    for (let j = 12; j >= 0; j--) point(u + width + bend(across * (j / 6 - 1)), across * (j / 6 - 1), false);
    path.closePath();
  }
  return path;
}

// The creature that is on display, made from what the engine tells of it, a moment at its start and
// the direction in which it travels.
function bodyOf(told, start, way) {
  const space = told.dimensions === 3;
  const size = Math.sqrt(told.parts.reduce((sum, p) => sum + 4 * p.half[0] * p.half[1], 0));
  const pattern = PATTERNS[mixed(Math.round(told.hue * 1e6) + told.parts.length) % PATTERNS.length];
  const parts = told.parts.map((p, k) => {
    const shift = 0.5 + 0.6180339887 * p.node, hue = told.hue + 0.15 * (shift - Math.floor(shift) - 0.5);
    const light = Math.min(0.8, 0.66 + 0.03 * p.depth) - (p.mirrored ? 0.04 : 0);
    const skin = new Path2D();
    skin.roundRect(-p.half[0], -p.half[1], 2 * p.half[0], 2 * p.half[1], 0.62 * Math.min(p.half[0], p.half[1]));
    const joint = p.parent < 0 ? 0 : 0.92 * Math.min(p.half[1], ...told.parts[p.parent].half.slice(0, 2), 1.3 * p.half[0]);
    return {
      ...p, skin, joint, hue, light, marks: markings(pattern, p.half, 0.17 * size, k),
      fill: oklch(hue, light, 0.105), dark: oklch(hue, light - 0.13, 0.09), ink: oklch(hue, 0.24, 0.05),
    };
  });
  return { told, parts, size, way, eyes: eyesOf(told, parts, start, way, size), look: [0, 0], space };
}

// Eyes sit on a part that senses light, otherwise on the foremost one: above each other on ground,
// side by side in water and air.
function eyesOf(told, parts, row, way, size) {
  let best = -Infinity, on = 0;
  parts.forEach((p, k) => {
    const angle = angleOf(row, k), c = Math.cos(angle), s = Math.sin(angle), place = placeOf(row, k);
    const dx = place[0] - row[0], dy = place[1] - row[1];
    const reach = Math.abs(c * way[0] + s * way[1]) * p.half[0] + Math.abs(-s * way[0] + c * way[1]) * p.half[1];
    let worth = dx * way[0] + dy * way[1] + reach + 0.35 * dy;
    if (Math.min(p.half[0], p.half[1]) < 0.042 * size) worth -= 0.5 * size;
    if (!told.ground) worth -= 0.9 * Math.abs(-dx * way[1] + dy * way[0]);
    if (p.eye) worth += 100;
    if (worth > best) [best, on] = [worth, k];
  });
  const [x, y] = parts[on].half, angle = angleOf(row, on), c = Math.cos(angle), s = Math.sin(angle);
  const least = Math.min(x, y), r = Math.min(clamp(0.5 * least, 0.055 * size, 0.125 * size), 0.8 * least);
  const ahead = [c * way[0] + s * way[1], -s * way[0] + c * way[1]];
  if (!told.ground) {
    const far = Math.abs(ahead[0]) * x + Math.abs(ahead[1]) * y - 0.75 * r;
    return { on, r, at: [0.98, -0.98].map(side => [far * ahead[0] - side * r * ahead[1], far * ahead[1] + side * r * ahead[0]]) };
  }
  const corners = [-1, 1].flatMap(a => [-1, 1].map(b => [a * Math.max(0, x - 0.85 * r), b * Math.max(0, y - 0.75 * r)]));
  const worth = q => q[0] * (ahead[0] + 0.75 * s) + q[1] * (ahead[1] + 0.75 * c);
  const front = corners.reduce((a, b) => worth(b) > worth(a) ? b : a);
  return { on, r, at: [[clamp(front[0] - 1.45 * r * ahead[0], -x, x), clamp(front[1] - 1.45 * r * ahead[1], -y, y)], front] };
}

// Draws the creature of the plane. `to` gives the pixels of a place, `scale` pixels per metre, `gaze`
// the pixels at which it looks, if at any.
function drawBody(g, body, row, to, scale, now, gaze) {
  const { parts, size } = body, ink = Math.max(2.2, 0.022 * size * scale), outline = new Path2D();
  const frames = parts.map((p, k) => {
    const angle = angleOf(row, k), half = halfOf(row, k), c = Math.cos(angle) * scale, s = Math.sin(angle) * scale;
    const fx = half[0] / p.half[0], fy = half[1] / p.half[1], [x, y] = to(placeOf(row, k));
    const frame = [c * fx, -s * fx, -s * fy, -c * fy, x, y];
    outline.addPath(p.skin, new DOMMatrix(frame));
    if (!p.joint) return { frame };
    const joint = [x - c * half[0], y + s * half[0]], disc = new Path2D();
    disc.arc(...joint, p.joint * scale, 0, 2 * Math.PI, true);
    outline.addPath(disc);
    return { frame, joint };
  });
  g.lineJoin = 'round';
  g.strokeStyle = parts[0].ink;
  g.lineWidth = 2 * ink;
  g.stroke(outline);
  g.save();
  g.clip(outline);
  for (let k = parts.length - 1; k >= 0; k--) {
    const p = parts[k], { frame, joint } = frames[k];
    g.save();
    g.setTransform(...frame);
    g.shadowColor = 'rgba(25,12,4,0.5)';
    g.shadowBlur = 0.07 * size * scale;
    g.fillStyle = p.fill;
    g.fill(p.skin);
    g.restore();
    if (joint) {
      g.fillStyle = p.fill;
      g.beginPath();
      g.arc(...joint, 0.98 * p.joint * scale, 0, 7);
      g.fill();
    }
    g.save();
    g.setTransform(...frame);
    g.clip(p.skin);
    g.globalAlpha = 0.55;
    g.fillStyle = p.dark;
    g.fill(p.marks);
    g.globalAlpha = 1;
    g.setTransform(1, 0, 0, 1, 0, 0);
    const angle = angleOf(row, k), rise = (Math.abs(Math.sin(angle)) * p.half[0] + Math.abs(Math.cos(angle)) * p.half[1]) * scale;
    const shade = g.createLinearGradient(frame[4] - 0.25 * rise, frame[5] - rise, frame[4] + 0.25 * rise, frame[5] + rise);
    shade.addColorStop(0, 'rgba(255,250,230,0.36)');
    shade.addColorStop(0.3, 'rgba(255,250,230,0.08)');
    shade.addColorStop(0.62, 'rgba(30,14,0,0.10)');
    shade.addColorStop(1, 'rgba(24,10,0,0.46)');
    g.fillStyle = shade;
    const reach = 2 * (p.half[0] + p.half[1]) * scale;
    g.fillRect(frame[4] - reach, frame[5] - reach, 2 * reach, 2 * reach);
    g.restore();
  }
  g.restore();
  const lid = Math.max(0, 1 - Math.abs((now + 3 * chance(Math.floor(now / 4), 7)) % 4 - 2) / 0.11);
  const head = frames[body.eyes.on].frame;
  body.eyes.at.forEach((eye, i) => {
    const x = head[0] * eye[0] + head[2] * eye[1] + head[4], y = head[1] * eye[0] + head[3] * eye[1] + head[5];
    drawEye(g, body, x, y, body.eyes.r * scale * (i ? 1 : 0.88), lid, gaze);
  });
}

function drawEye(g, body, x, y, r, lid, gaze) {
  const to = gaze ? [gaze[0] - x, gaze[1] - y] : [body.way[0], -body.way[1] + 0.15], length = Math.hypot(...to) || 1;
  for (let j = 0; j < 2; j++) body.look[j] += 0.12 * (to[j] / length - body.look[j]);
  const disc = (cx, cy, radius, colour) => {
    g.fillStyle = colour;
    g.beginPath();
    g.arc(cx, cy, radius, 0, 7);
    g.fill();
  };
  disc(x, y, r + Math.max(1.5, 0.14 * r), '#1a1310');
  disc(x, y, r, '#fdfaf2');
  const px = x + body.look[0] * r * 0.34, py = y + body.look[1] * r * 0.34;
  disc(px, py, 0.62 * r, oklch(body.told.hue + 0.5, 0.52, 0.11));
  disc(px, py, 0.43 * r, '#0c0c12');
  disc(px - 0.2 * r, py - 0.22 * r, 0.17 * r, '#fff');
  if (lid <= 0) return;
  g.save();
  g.beginPath();
  g.arc(x, y, r + 1, 0, 7);
  g.clip();
  g.fillStyle = body.parts[body.eyes.on].dark;
  g.fillRect(x - r - 2, y - r - 2, 2 * r + 4, 2 * (r + 2) * lid);
  g.restore();
}

// The camera of space: looks at a place from the side and a little from above.
function spaceView(target, yaw, pitch, scale, width, height) {
  const right = [Math.cos(yaw), 0, -Math.sin(yaw)], back = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
  const up = [-Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch), -Math.sin(pitch) * Math.cos(yaw)];
  const distance = height / scale * 1.6, dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return {
    right, up, back, place: [0, 1, 2].map(i => target[i] + distance * back[i]),
    see(place) {
      const way = [place[0] - target[0], place[1] - target[1], place[2] - target[2]];
      const depth = distance - dot(way, back), s = scale * distance / Math.max(depth, 0.05);
      return [width / 2 + s * dot(way, right), height / 2 - s * dot(way, up), depth];
    },
    // The place at the depth of another one that is seen at these pixels.
    at(x, y, near) {
      const [nx, ny, depth] = this.see(near), s = scale * distance / Math.max(depth, 0.05);
      return [0, 1, 2].map(i => near[i] + (x - nx) / s * right[i] - (y - ny) / s * up[i]);
    },
  };
}

const LIGHT = [-0.4, 0.8, 0.45];  // towards the light

// Draws the ground of space, endless up to the horizon, with a line each metre.
function drawFloor(g, view, near, width, height, night) {
  const horizon = SPACE_HORIZON * height;
  g.fillStyle = gradient(g, 0, horizon, 0, height, night ? ['#1d2a33', '#15211c'] : ['#a9c793', '#6fa24c', '#4f8a33']);
  g.fillRect(0, horizon, width, height - horizon);
  const line = (from, to, strength) => {
    const [a, b] = [view.see(from), view.see(to)];
    if (a[2] < 0.3 || b[2] < 0.3) return;
    g.strokeStyle = `rgba(255,255,240,${strength})`;
    g.beginPath();
    g.moveTo(a[0], a[1]);
    g.lineTo(b[0], b[1]);
    g.stroke();
  };
  g.lineWidth = 1.5;
  const reach = 14, [x, z] = [Math.round(near[0]), Math.round(near[2])];
  for (let i = -reach; i <= reach; i++) for (let j = -reach; j < reach; j++) {
    const strength = 0.34 * Math.max(0, 1 - Math.hypot(i, j) / reach) ** 2;
    if (strength < 0.01) continue;
    line([x + i, 0, z + j], [x + i, 0, z + j + 1], strength);
    line([x + j, 0, z + i], [x + j + 1, 0, z + i], strength);
  }
}

// Draws the shadows of all parts on the ground, as one.
function drawShadows(g, body, row, view) {
  const shadow = new Path2D();
  body.parts.forEach((p, k) => {
    const q = attitudeOf(row, k), half = halfOf(row, k), place = placeOf(row, k), points = [];
    for (let corner = 0; corner < 8; corner++) {
      const local = [0, 1, 2].map(i => corner >> i & 1 ? half[i] : -half[i]), at = turned(q, local).map((v, i) => v + place[i]);
      const fall = Math.max(0, at[1]) / LIGHT[1], [x, y, depth] = view.see([at[0] - fall * LIGHT[0], 0, at[2] - fall * LIGHT[2]]);
      if (depth < 0.1) return;
      points.push([x, y]);
    }
    // The convex hull (A. M. Andrew, 1979), always turning the same way.
    points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const chain = list => list.reduce((hull, c) => {
      while (hull.length > 1) {
        const [a, b] = hull.slice(-2);
        if ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0) break;
        hull.pop();
      }
      return [...hull, c];
    }, []);
    [...chain(points).slice(0, -1), ...chain(points.slice().reverse()).slice(0, -1)].forEach(([x, y], i) => shadow[i ? 'lineTo' : 'moveTo'](x, y));
    shadow.closePath();
  });
  g.fillStyle = 'rgba(16,28,8,0.34)';
  g.filter = 'blur(3px)';
  g.fill(shadow);
  g.filter = 'none';
}

// Draws the creature in space: the visible faces of its boxes, from far to near.
function drawBoxes(g, body, row, view) {
  const faces = [];
  body.parts.forEach((p, k) => {
    const q = attitudeOf(row, k), half = halfOf(row, k), place = placeOf(row, k);
    for (let axis = 0; axis < 3; axis++) for (const sign of [-1, 1]) {
      const normal = turned(q, [0, 1, 2].map(i => i === axis ? sign : 0)), a = (axis + 1) % 3, b = (axis + 2) % 3;
      const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => {
        const local = [0, 0, 0];
        local[axis] = sign * half[axis];
        local[a] = u * half[a];
        local[b] = v * half[b];
        return turned(q, local).map((c, i) => c + place[i]);
      });
      const seen = corners.map(c => view.see(c));
      const towards = normal.reduce((sum, n, i) => sum + n * (view.place[i] - place[i] - n * half[axis]), 0);
      if (towards <= 0) continue;
      const shine = normal[0] * LIGHT[0] + normal[1] * LIGHT[1] + normal[2] * LIGHT[2];
      faces.push({ seen, depth: Math.max(...seen.map(s => s[2])) + seen.reduce((sum, s) => sum + s[2], 0), p, shine });
    }
  });
  faces.sort((a, b) => b.depth - a.depth);
  g.lineJoin = 'round';
  for (const { seen, p, shine } of faces) {
    g.fillStyle = oklch(p.hue, clamp(p.light - 0.06 + 0.2 * shine, 0.2, 0.93), 0.1);
    g.strokeStyle = g.fillStyle;
    g.lineWidth = 5;
    g.beginPath();
    seen.forEach(([x, y], i) => g[i ? 'lineTo' : 'moveTo'](x, y));
    g.closePath();
    g.stroke();
    g.fill();
    g.strokeStyle = oklch(p.hue, 0.3, 0.06, 0.55);
    g.lineWidth = 1.4;
    g.stroke();
  }
}
