'use strict';
// One population that several workers evolve (worker.js). Each has all of it and breeds it from the same
// bits; it evaluates the trials that it is handed, so results are all that workers exchange.

const IN_HAND = 2;  // trials that a worker is handed at once, so that it never waits for the next

// Calls `tell` with each generation, and `fail` with an error, after which nothing more comes.
function evolveTogether(workers, module, settings, tell, fail) {
  let ready = 0, needs = 0, next = 0, done = 0, told = [];
  const hand = worker => { if (next < needs) worker.postMessage({ run: next++ }); };
  const hear = (worker, data) => {
    if (data.error) return fail(Error(data.error));
    if (data.generation) {
      told.push(data.generation);
      if (told.length < workers.length) return;
      if (told.some(each => each.digest !== told[0].digest)) return fail(Error('the workers have different populations'));
      tell(told[0]);
      told = [];
    } else if ('needs' in data) {
      if (++ready < workers.length) return;
      [ready, needs, next, done] = [0, data.needs, 0, 0];
      for (let n = 0; n < IN_HAND; n++) workers.forEach(hand);
    } else {
      hand(worker);
      for (const other of workers) if (other !== worker) other.postMessage({ take: data.ran, result: data.result });
      if (++done === needs) for (const each of workers) each.postMessage({ goOn: true });
    }
  };
  for (const worker of workers) {
    worker.onmessage = ({ data }) => hear(worker, data);
    worker.onerror = event => fail(Error(event.message));
    worker.postMessage({ module, settings });
  }
}
