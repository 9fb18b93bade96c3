// Takes out of the wasm what only words the message of a panic.
//
// A panic is a trap for callers whatever it says (`code` "trapped", src/js/lifecycle.js), and nothing
// prints its message. Standing traps in place of the functions that begin one lets wasm-opt drop
// the formatting behind them and what is passed to them; the places in the source that they would
// name are blanked, so that no bytes are shipped for them.
import binaryen from "binaryen";

import { section } from "./wasm.mjs";

/** Functions that begin or word a panic; none of them returns. */
const panics = [
  /\bcore(\[\w+\])?::panicking::/,
  /\bcore(\[\w+\])?::(option|result)::\w+_failed\b/,
  /\bcore(\[\w+\])?::(slice|str)::(\w+::)*\w+_fail\b/,
  /\bcore(\[\w+\])?::cell::panic_/,
  /\bcore(\[\w+\])?::slice::(\w+::)*panic_on_ord_violation\b/,
  /\balloc(\[\w+\])?::vec::.*::assert_failed\b/,
  /\balloc(\[\w+\])?::raw_vec::(handle_error|capacity_overflow)\b/,
  /\balloc(\[\w+\])?::alloc::handle_alloc_error\b/,
  /::(rust_begin_unwind|__rust_start_panic|rust_panic)$/,
];

/**
 * What only a message of a panic calls, through the table of functions: `f64::clamp` alone brings in
 * every way to print a number. `tests/architecture.rs` sees to it that nothing else uses these.
 */
const words = [
  /^<.+ as core(\[\w+\])?::fmt::(Debug|LowerHex|UpperHex)>::fmt\b/,
  /\bstd(\[\w+\])?::panicking::(\w+::)*\w+Payload\b/,
  /\bcore(\[\w+\])?::num::flt2dec::/,
];

/** The tables behind the digits of a number, which nothing reads any more: first words, and bytes. */
const tables = [
  { begins: [0x3d1a45df, 0xe61acf03], length: 81 * 16 },
  { begins: [0x85acef81, 0x2d6d415b], length: (3 + 5 + 10 + 19) * 4 },
];

/** The wasm in `bytes`, which still has its names, with nothing to say when it panics. */
export function withoutPanicMessages(bytes) {
  const module = binaryen.readBinary(withoutTables(withoutLocations(bytes)));
  for (let i = 0; i < module.getNumFunctions(); i += 1) {
    const reference = module.getFunctionByIndex(i);
    const { name, base, results } = binaryen.getFunctionInfo(reference);
    const patterns = results === binaryen.none ? [...panics, ...words] : words;
    if (!base && patterns.some((pattern) => pattern.test(name))) {
      binaryen.Function.setBody(reference, module.unreachable());
    }
  }
  const trimmed = module.emitBinary();
  module.dispose();
  return trimmed;
}

/** Blanks every `core::panic::Location`: address and length of a file's name, line, and column. */
function withoutLocations(bytes) {
  const copy = Uint8Array.from(bytes);
  const segments = dataSegments(copy);
  const view = new DataView(copy.buffer);
  const named = [];
  for (const { from, to } of segments) {
    for (let at = from; at + 16 <= to; at += 4) {
      const [name, length, line, column] = [0, 4, 8, 12].map((k) => view.getUint32(at + k, true));
      const place =
        length < 256 && line > 0 && column > 0 && fileName(copy, segments, name, length);
      if (place) {
        named.push([at, 16], [place, length]);
      }
    }
  }
  for (const [at, length] of named) {
    copy.fill(0, at, at + length);
  }
  return copy;
}

/** Blanks the tables; where the standard library has others, they stay. */
function withoutTables(bytes) {
  const file = Buffer.from(bytes.buffer);
  for (const { begins, length } of tables) {
    const at = file.indexOf(new Uint8Array(Uint32Array.from(begins).buffer));
    if (at >= 0) {
      file.fill(0, at, at + length);
    }
  }
  return bytes;
}

/** Where in the file the name of a Rust source at an address in memory is; 0 if there is none. */
function fileName(bytes, segments, address, length) {
  const segment = segments.find(
    ({ address: start, from, to }) => address >= start && address + length <= start + to - from,
  );
  if (!segment) {
    return 0;
  }
  const at = segment.from + address - segment.address;
  const text = new TextDecoder("latin1").decode(bytes.subarray(at, at + length));
  return /^[\w./-]+\.rs\0?$/.test(text) ? at : 0;
}

/** The data of a module: the address in memory of each segment, and its bytes in the file. */
function dataSegments(bytes) {
  const segments = [];
  const data = section(bytes, 11);
  for (let left = data ? data.number() : 0; left > 0; left -= 1) {
    // Active ones alone have an address: 0, i32.const, the address, end.
    if (data.number() !== 0) {
      throw new Error("a data segment is not placed by a constant");
    }
    data.byte();
    const address = data.number();
    data.byte();
    const length = data.number();
    segments.push({ address, from: data.at, to: data.at + length });
    data.take(length);
  }
  return segments;
}
