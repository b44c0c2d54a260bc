// In a worker: verifies a creature, or evolves a population generation by generation.
onmessage = async ({ data: { module, file, settings } }) => {
  try {
    const engine = await startEngine(module);
    if (file) {
      const start = performance.now();
      engine.read(file);
      postMessage({ ...engine.verify(), took: performance.now() - start });
      return;
    }
    engine.settings(settings);
    for (;;) {
      const start = performance.now(), generation = engine.generation();
      postMessage({ ...generation, took: performance.now() - start });
    }
  } catch (error) {
    postMessage({ error: error.message });
  }
};
