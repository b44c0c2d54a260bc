// Runs the engine of pages under node: every sample creature gives the score, the digest and the
// ticks of its file, and an evolution the digests that the program computed.
//   node engine_test.mjs ENGINE.wasm PAGE.html CREATURE...
import fs from 'node:fs';
import vm from 'node:vm';

const [, , wasm, page, ...creatures] = process.argv;
const html = fs.readFileSync(page, 'utf8');
const inside = id => html.match(new RegExp(`id="${id}"[^>]*>([^]*?)</script>`))[1];

// The very script of the page.
vm.runInThisContext(inside('engine-script') + '\n;globalThis.startEngine = startEngine;');
const module = await WebAssembly.compile(fs.readFileSync(wasm));
let faults = 0;
const check = (holds, words) => {
  if (holds) return;
  faults++;
  console.error(words);
};

const engine = await startEngine(module);
for (const file of creatures) {
  engine.read(fs.readFileSync(file, 'utf8'));
  const told = engine.verify();
  check(told.scored && told.same, `${file}: ${told.digest} instead of ${told.recorded}`);
  check(told.recordedTicks > 0 && told.differentTick === 0, `${file}: tick ${told.differentTick} differs`);
}
console.log(`${creatures.length} creatures computed`);

const damaged = fs.readFileSync(creatures[0], 'utf8').replace(/"fitness": [0-9.]+/, '"fitness": 123.0');
engine.read(damaged);
check(!engine.verify().same, 'a false score is not found');
for (const bad of ['', '{', '{"format": "x"}', 'null']) {
  let said = '';
  try { engine.read(bad); } catch (error) { said = error.message; }
  check(said.includes('the creature'), `"${bad}": refused as "${said}"`);
}

const plan = JSON.parse(inside('page')).evolve, run = await startEngine(module);
run.settings(plan.settings);
for (const expected of plan.digests) {
  const told = run.generation();
  check(told.digest === expected, `generation ${told.generation}: ${told.digest} instead of ${expected}`);
  engine.read(told.file);
  check(engine.verify().same, `the best of generation ${told.generation} is another when read`);
}
console.log(`${plan.digests.length} generations evolved`);
let refused = '';
try { run.settings('population.size=-3\n'); } catch (error) { refused = error.message; }
check(refused.includes('population.size'), `a bad setting is refused as "${refused}"`);
process.exitCode = faults ? 1 : 0;
