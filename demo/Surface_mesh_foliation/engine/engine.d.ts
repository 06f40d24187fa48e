// The module that build_engine.sh makes of bindings.cpp; what it gives is told in Engine.ts.
declare module '*/engine/engine.js' {
  const createEngine: (options?: object) => Promise<unknown>;
  export default createEngine;
}
