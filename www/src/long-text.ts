// Texts too long for a string that is passed around: bytes that are moved from the worker, not copied,
// and of which only the lines that are seen are ever decoded.

/** A very long text. */
export interface LongText {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Where each line begins. */
  readonly starts: Uint32Array<ArrayBuffer>;
  readonly encoding: "utf-8" | "windows-1252";
}

/** A text, and bytes that it can be decoded from line by line. */
export interface DecodedText {
  readonly text: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly encoding: LongText["encoding"];
}

/**
 * The text of the bytes of a file: UTF-16 with its mark, UTF-8, or what old editors write; undefined for
 * what is no text.
 */
export function decoded(file: Uint8Array<ArrayBuffer>): DecodedText | undefined {
  const wide = file[0] === 0xff && file[1] === 0xfe ? "utf-16le" : "utf-16be";
  if (wide === "utf-16le" || (file[0] === 0xfe && file[1] === 0xff)) {
    const text = new TextDecoder(wide).decode(file);
    // Lines are looked for by a byte, which in UTF-16 may be half of another letter.
    if (text.includes("\0")) return undefined;
    return { text, bytes: new TextEncoder().encode(text), encoding: "utf-8" };
  }
  const bytes = withoutLeader(file);
  if (bytes.includes(0)) return undefined;
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return { text, bytes, encoding: "utf-8" };
  } catch {
    const encoding = "windows-1252";
    return { text: new TextDecoder(encoding).decode(bytes), bytes, encoding };
  }
}

/** Ctrl+Z, the mark that DOS ends a text with. */
const END_OF_TEXT = 0x1a;

/** Bytes without that mark, and without the zeros at both ends, which are blank tape. */
function withoutLeader(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  let [from, to] = [0, bytes.length];
  while (from < to && bytes[from] === 0) from += 1;
  while (from < to && (bytes[to - 1] === 0 || bytes[to - 1] === END_OF_TEXT)) to -= 1;
  return bytes.subarray(from, to);
}

/** Finds the lines of a text. */
export function longText(
  bytes: Uint8Array<ArrayBuffer>,
  encoding: LongText["encoding"] = "utf-8",
): LongText {
  let starts = new Uint32Array(1 << 16);
  let count = 1;
  for (let at = bytes.indexOf(10); at >= 0; at = bytes.indexOf(10, at + 1)) {
    if (count === starts.length) {
      const larger = new Uint32Array(2 * count);
      larger.set(starts);
      starts = larger;
    }
    starts[count] = at + 1;
    count += 1;
  }
  return { bytes, starts: starts.slice(0, count), encoding };
}

const decoders = {
  "utf-8": new TextDecoder("utf-8"),
  "windows-1252": new TextDecoder("windows-1252"),
};

/** A line of a text, counted from 0, without its end. */
export function lineAt({ bytes, starts, encoding }: LongText, index: number): string {
  const next = starts[index + 1];
  const end = next === undefined ? bytes.length : next - 1;
  return decoders[encoding].decode(bytes.subarray(starts[index], end)).replace(/\r$/, "");
}
