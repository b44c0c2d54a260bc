'use strict';
// The places in which creatures live: a meadow, water, or air; painted once, moved with the camera.

const sheet = (w, h) => Object.assign(document.createElement('canvas'), { width: Math.max(1, Math.round(w)), height: Math.max(1, Math.round(h)) });
const wrapped = (v, period) => (v % period + period) % period;

// A smooth line that repeats after 1, from 0 to 1.
function ridge(x, seed) {
  const noise = (n, s) => {
    const at = x * n, i = Math.floor(at), f = at - i, t = f * f * (3 - 2 * f);
    return chance(wrapped(i, n), s) * (1 - t) + chance(wrapped(i + 1, n), s) * t;
  };
  return 0.5 * noise(5, seed) + 0.27 * noise(11, seed + 1) + 0.14 * noise(23, seed + 2) + 0.09 * noise(61, seed + 3);
}

function gradient(g, x0, y0, x1, y1, colours) {
  const made = g.createLinearGradient(x0, y0, x1, y1);
  colours.forEach((colour, i) => made.addColorStop(i / (colours.length - 1), colour));
  return made;
}

function hills(w, h, colours, seed, low, high) {
  const made = sheet(w, h), g = made.getContext('2d');
  g.fillStyle = gradient(g, 0, 0.25 * h, 0, h, colours);
  g.beginPath();
  g.moveTo(0, h);
  for (let x = 0; x <= w; x += 2) g.lineTo(x, h - h * (low + high * ridge(x / w, seed)));
  g.lineTo(w, h);
  g.fill();
  return made;
}

function cloud(w, h, seed) {
  const made = sheet(w, h), g = made.getContext('2d');
  for (let i = 0; i < 46; i++) {
    const t = i / 45, r = h * (0.13 + 0.22 * chance(i, seed)) * (1 - Math.abs(2 * t - 1) ** 3) + 0.1;
    const x = w * (0.12 + 0.76 * t), y = h * (0.62 - 0.22 * chance(i, seed + 1) * (1 - (2 * t - 1) ** 2));
    const puff = g.createRadialGradient(x, y - 0.2 * r, 0, x, y, r);
    puff.addColorStop(0, 'rgba(255,255,255,0.55)');
    puff.addColorStop(1, 'rgba(255,255,255,0)');
    g.fillStyle = puff;
    g.fillRect(x - r, y - r, 2 * r, 2 * r);
  }
  return made;
}

function soil(w, h) {
  const made = sheet(w, h), g = made.getContext('2d'), turf = 0.055 * h + 3;
  g.fillStyle = gradient(g, 0, 0, 0, h, ['#8a5a3a', '#4a2f1f']);
  g.fillRect(0, 0, w, h);
  for (let i = 0; i < w * h / 900; i++) {
    g.fillStyle = chance(i, 3) < 0.5 ? 'rgba(40,20,8,0.10)' : 'rgba(255,220,170,0.05)';
    g.beginPath();
    g.arc(chance(i, 1) * w, chance(i, 2) * h, 2 + 9 * chance(i, 4), 0, 7);
    g.fill();
  }
  for (let x = 0; x < w; x += 3) {
    g.fillStyle = chance(x, 21) < 0.5 ? '#5d9a36' : '#4d8a2e';
    g.fillRect(x, 0, 3, turf + 7 * chance(x, 22));
  }
  return made;
}

function grass(w, h) {
  const made = sheet(w, h), g = made.getContext('2d');
  g.lineWidth = 1.3;
  for (let x = 0; x < w; x += 2.2) {
    const tall = h * (0.25 + 0.75 * chance(x, 41)) * 0.9, lean = 8 * (chance(x, 42) - 0.5);
    g.strokeStyle = ['#5fa23a', '#74b548', '#4b8a2c'][mixed(Math.round(x * 10)) % 3];
    g.beginPath();
    g.moveTo(x, h);
    g.quadraticCurveTo(x, h - 0.6 * tall, x + lean, h - tall);
    g.stroke();
  }
  return made;
}

const HORIZON = 0.785;       // height of the ground in the picture
const PITCH = 0.14;          // rad; of the camera in space
const SPACE_HORIZON = 0.5 - 1.6 * Math.tan(PITCH);

// Paints the place of a creature for a picture of this size.
function placeFor(told, width, height) {
  const space = told.dimensions === 3, lift = space ? (SPACE_HORIZON - 0.8) * height : 0;
  const kind = told.ground ? told.light ? 'night' : 'meadow' : told.medium > 5 || told.gravity === 0 ? 'water' : told.light ? 'night' : 'air';
  const layers = [], back = sheet(width, height), g = back.getContext('2d');
  const add = (picture, depth, y) => layers.push({ picture, depth, y });
  const skies = {
    meadow: ['#3f7fc9', '#7fb2e2', '#c3dcee', '#e8eef0', '#e8eef0'], air: ['#3f7fc9', '#7fb2e2', '#c3dcee', '#e8eef0'],
    water: ['#5fc0c9', '#2a8596', '#0e4257', '#082735'], night: ['#0a1230', '#141f45', '#2a2f55', '#3a3850', '#3a3850'],
  };
  g.fillStyle = gradient(g, 0, 0, 0, height, skies[kind]);
  g.fillRect(0, 0, width, height);
  if (kind === 'water') {
    for (let i = 0; i < 7; i++) {
      const x = width * (0.05 + 0.16 * i + 0.06 * chance(i, 2)), w = width * (0.02 + 0.035 * chance(i, 3)), lean = 0.25 * height;
      g.fillStyle = gradient(g, 0, 0, 0, 0.9 * height, ['rgba(200,255,245,0.2)', 'rgba(200,255,245,0)']);
      g.beginPath();
      g.moveTo(x, 0);
      g.lineTo(x + w, 0);
      g.lineTo(x + 2.4 * w - lean, height);
      g.lineTo(x - w - lean, height);
      g.fill();
    }
    add(hills(1.3 * width, 0.3 * height, ['rgba(6,52,66,0.75)', 'rgba(5,34,45,0.9)'], 33, 0.1, 0.9), 0.25, 0.74 * height);
    add(hills(1.5 * width, 0.2 * height, ['rgba(5,38,48,0.9)', '#04202a'], 43, 0.2, 0.65), 0.5, 0.84 * height);
  } else if (kind === 'night') {
    for (let i = 0; i < 150; i++) {
      g.fillStyle = `rgba(255,255,240,${0.15 + 0.7 * chance(i, 8) ** 3})`;
      g.fillRect(width * chance(i, 9), 0.75 * height * chance(i, 10), 2, 2);
    }
  } else {
    const x = 0.8 * width, y = 0.2 * height, r = 0.06 * height, glow = g.createRadialGradient(x, y, 0.4 * r, x, y, 5 * r);
    glow.addColorStop(0, 'rgba(255,246,214,0.95)');
    glow.addColorStop(0.18, 'rgba(255,240,200,0.5)');
    glow.addColorStop(1, 'rgba(255,240,200,0)');
    g.fillStyle = glow;
    g.fillRect(0, 0, width, height);
    g.fillStyle = '#fff3cf';
    g.beginPath();
    g.arc(x, y, r, 0, 7);
    g.fill();
    for (let i = 0; i < 4; i++)
      add(cloud(width * (0.3 + 0.2 * chance(i, 6)), 0.2 * height, 50 + i), 0.03 + 0.02 * i, height * (0.03 + (kind === 'air' ? 0.23 : 0.11) * i));
  }
  if (kind === 'meadow' || kind === 'night' && told.ground) {
    const far = kind === 'night' ? [['#1b2244', '#232a4a'], ['#151c38', '#1a2340'], ['#10182e', '#152036']]
      : [['#a9b9d6', '#c3d4e4'], ['#7fae8a', '#9cc4a0'], ['#5c9a5b', '#76b06a']];
    add(hills(1.3 * width, 0.3 * height, far[0], 3, 0.2, 0.65), 0.1, 0.5 * height + lift);
    add(hills(1.4 * width, 0.26 * height, far[1], 13, 0.2, 0.65), 0.2, 0.56 * height + lift);
    add(hills(1.5 * width, 0.2 * height, far[2], 23, 0.2, 0.65), 0.38, 0.63 * height + lift);
    if (!space && !told.surface.length) {
      add(soil(width, 0.24 * height), 1, 0.78 * height);
      add(grass(width, 0.035 * height), 1, 0.746 * height);
    }
  }
  const motes = Array.from({ length: 46 }, (_, i) => [chance(i, 61), chance(i, 62), 0.35 + 0.65 * chance(i, 63)]);
  return { kind, space, back, layers, motes, width, height };
}

// Draws the place behind a camera at a point of the world.
function drawPlace(g, place, camera, scale, now) {
  const { kind, width, height } = place;
  g.drawImage(place.back, 0, 0);
  for (const { picture, depth, y } of place.layers) {
    const sky = depth < 0.1, period = sky ? 1.9 * width : picture.width;
    const drift = sky ? 4 * depth * now - 3.1 * y : 0, lift = place.space ? 0 : camera[1] * scale * depth * (kind === 'water' ? 0.5 : 1);
    for (let x = -wrapped(camera[0] * scale * depth + drift, period); x < width; x += period) g.drawImage(picture, x, y + lift);
  }
  if (kind === 'meadow') return;
  for (const [mx, my, depth] of place.motes) {  // they show how fast the creature is
    const x = wrapped(mx * width - camera[0] * scale * depth, width), y = wrapped(my * height + camera[1] * scale * depth - 6 * depth * now, height);
    g.fillStyle = kind === 'water' ? `rgba(190,240,235,${0.1 + 0.22 * depth})` : `rgba(255,255,255,${0.3 * depth})`;
    g.beginPath();
    g.arc(x, y, (kind === 'water' ? 1.2 + 2.2 * depth : 1.5) * width / 1000, 0, 7);
    g.fill();
  }
}
