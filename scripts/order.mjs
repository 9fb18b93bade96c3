// Lays out the functions of the wasm so that those that are alike lie near each other.
//
// gzip finds repetitions in the last 32 KB only, and the code is many times that. The compiler
// leaves functions in the order in which it came to need them; what is alike, the copies of one
// generic function above all, is then found too late.

import { leb, section } from "./wasm.mjs";

/** Bytes that are compared at a time: about two instructions. */
const gram = 5;

/** How far back gzip looks, less what the function at hand takes up itself [bytes]. */
const reach = 28_000;

/** Grams in more functions than this are everywhere, and tell nothing. */
const mostCommon = 60;

/** Counted on top of every function's length, lest the shortest come first [bytes]. */
const overhead = 20;

/**
 * The wasm in `bytes` with names of its functions that are in the order in which they should lie,
 * for wasm-opt's `--reorder-functions-by-name`.
 */
export function namedInOrder(bytes) {
  const { imported, bodies } = functions(bytes);
  const names = new Array(imported + bodies.length);
  for (let i = 0; i < imported; i += 1) {
    names[i] = `a${i}`;
  }
  order(bodies).forEach((index, place) => {
    names[imported + index] = `f${String(place).padStart(6, "0")}`;
  });
  return Buffer.concat([bytes, nameSection(names)]);
}

/** Indices of `bodies`, each followed by the one that shares most with what lies before it. */
function order(bodies) {
  const grams = bodies.map(gramsOf);
  const holders = new Map();
  grams.forEach((set, index) => {
    for (const one of set) {
      const list = holders.get(one);
      if (list) {
        list.push(index);
      } else {
        holders.set(one, [index]);
      }
    }
  });
  const shared = new Float64Array(bodies.length);
  const seen = new Map();
  const count = (index, step) => {
    for (const one of grams[index]) {
      const list = holders.get(one);
      const before = seen.get(one) ?? 0;
      seen.set(one, before + step);
      if (list.length <= mostCommon && (before === 0 || before + step === 0)) {
        for (const other of list) {
          shared[other] += step;
        }
      }
    }
  };
  const left = new Set(bodies.keys());
  const near = [];
  const placed = [];
  for (let size = 0; left.size > 0; ) {
    const next = best(left, (index) => shared[index] / (bodies[index].length + overhead));
    left.delete(next);
    placed.push(next);
    near.push(next);
    count(next, 1);
    for (size += bodies[next].length; size > reach && near.length > 1; ) {
      const gone = near.shift();
      size -= bodies[gone].length;
      count(gone, -1);
    }
  }
  return placed;
}

/** The one of `candidates` that `value` is largest for, of several the first. */
function best(candidates, value) {
  let found;
  let most = -1;
  for (const candidate of candidates) {
    const own = value(candidate);
    if (own > most) {
      [found, most] = [candidate, own];
    }
  }
  return found;
}

function gramsOf(body) {
  const set = new Set();
  for (let i = 0; i + gram <= body.length; i += 1) {
    set.add(body.toString("latin1", i, i + gram));
  }
  return set;
}

/** How many functions a module imports, and the bodies of its own. */
function functions(bytes) {
  const imports = section(bytes, 2);
  const imported = imports ? imports.number() : 0;
  for (let left = imported; left > 0; left -= 1) {
    imports.take(imports.number());
    imports.take(imports.number());
    if (imports.byte() !== 0) {
      throw new Error("the wasm imports something else than functions");
    }
    imports.number();
  }
  const code = section(bytes, 10);
  const bodies = [];
  for (let left = code.number(); left > 0; left -= 1) {
    bodies.push(code.take(code.number()));
  }
  return { imported, bodies };
}

/** A custom section "name" with names of functions. */
function nameSection(names) {
  const entries = names.map((name, index) => [...leb(index), ...text(name)]);
  const functionNames = [...leb(names.length), ...entries.flat()];
  const content = [...text("name"), 1, ...leb(functionNames.length), ...functionNames];
  return Buffer.from([0, ...leb(content.length), ...content]);
}

function text(string) {
  return [...leb(string.length), ...Buffer.from(string)];
}
