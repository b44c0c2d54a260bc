// Runs the engine of pages under node: every sample creature gives the score, the digest and the
// ticks of its file, and an evolution in one or three workers the digests that the program computed.
//   node engine_test.mjs PAGE.html CREATURE...
import fs from 'node:fs';
import vm from 'node:vm';
import { Worker } from 'node:worker_threads';

const [, , page, ...creatures] = process.argv;
const html = fs.readFileSync(page, 'utf8');
const inside = id => html.match(new RegExp(`id="${id}"[^>]*>([^]*?)</script>`))[1];

// The very script of the page.
vm.runInThisContext(inside('engine-script') + '\n;globalThis.startEngine = startEngine; globalThis.compileEngine = compileEngine;');
const module = await compileEngine(inside('engine'));
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

// The page's own workers, as threads of node.
const prelude = `const { parentPort } = require('node:worker_threads');
globalThis.postMessage = data => parentPort.postMessage(data);
parentPort.on('message', data => onmessage({ data }));
`;
function newWorker() {
  const worker = new Worker(prelude + inside('engine-script') + inside('worker-script'), { eval: true });
  const shown = { postMessage: data => worker.postMessage(data), end: () => worker.terminate() };
  worker.on('message', data => shown.onmessage({ data }));
  worker.on('error', error => shown.onerror(error));
  return shown;
}
vm.runInThisContext(inside('population-script') + '\n;globalThis.evolveTogether = evolveTogether;');
const plan = JSON.parse(inside('page')).evolve;
for (const count of [1, 3]) {
  const workers = Array.from({ length: count }, newWorker), generations = [];
  await new Promise((end, fail) => evolveTogether(workers, module, plan.settings, told => {
    generations.push(told);
    if (generations.length === plan.digests.length) end();
  }, fail));
  await Promise.all(workers.map(worker => worker.end()));
  plan.digests.forEach((expected, i) => {
    const told = generations[i];
    check(told.generation === i && told.digest === expected,
      `generation ${i} by ${count} workers: ${told.digest} instead of ${expected}`);
    engine.read(told.file);
    check(engine.verify().same, `the best of generation ${i} is another when read`);
  });
  console.log(`${plan.digests.length} generations evolved by ${count} workers`);
}
const run = await startEngine(module);
run.settings(plan.settings);
check(run.needs() > 0, 'no trials are needed');
let bad = '';
try { run.take(0, '{"format": "cambrian-one-result"}'); } catch (error) { bad = error.message; }
check(bad.includes('cambrian-one-result'), `a bad result is refused as "${bad}"`);
let refused = '';
try { run.settings('population.size=-3\n'); } catch (error) { refused = error.message; }
check(refused.includes('population.size'), `a bad setting is refused as "${refused}"`);
process.exitCode = faults ? 1 : 0;
