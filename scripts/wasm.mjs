// Reads a WebAssembly module as the bytes that it is.

/** Reads bytes and numbers one after the other. */
export class Reader {
  /** From the byte `at` of `bytes` on. */
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    this.at += 1;
    return this.bytes[this.at - 1];
  }

  /** A number as LEB128. */
  number() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.byte();
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) {
        return value;
      }
    }
  }

  /** The bytes that come next. */
  take(length) {
    this.at += length;
    return this.bytes.subarray(this.at - length, this.at);
  }
}

/** A reader at the contents of the section with number `wanted`; undefined if there is none. */
export function section(bytes, wanted) {
  const reader = new Reader(bytes, 8);
  while (reader.at < bytes.length) {
    const id = reader.byte();
    const size = reader.number();
    if (id === wanted) {
      return reader;
    }
    reader.take(size);
  }
  return undefined;
}

/** A number as LEB128. */
export function leb(number) {
  const bytes = [];
  for (let rest = number; ; rest >>>= 7) {
    if (rest < 128) {
      return [...bytes, rest];
    }
    bytes.push((rest & 127) | 128);
  }
}
