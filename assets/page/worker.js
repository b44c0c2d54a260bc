// In a worker: verifies a creature, or takes part in the evolution of a population (population.js).
let evolving = null;

// Tells about the generations that are evaluated, and how many trials the next needs.
function goOn() {
  for (;;) {
    const needs = evolving.needs();
    if (needs) return postMessage({ needs });
    postMessage({ generation: evolving.generation() });
  }
}

onmessage = async ({ data: { module, file, settings, run, take, result } }) => {
  try {
    if (file) {
      const engine = await startEngine(module), start = performance.now();
      engine.read(file);
      return postMessage({ ...engine.verify(), took: performance.now() - start });
    }
    if (settings) {
      evolving = await startEngine(module);
      evolving.settings(settings);
    }
    if (run !== undefined) postMessage({ ran: run, result: evolving.run(run) });
    else if (take !== undefined) evolving.take(take, result);
    else goOn();
  } catch (error) {
    postMessage({ error: error.message });
  }
};
