// Links that carry a program and its settings after their #, so that nothing is stored anywhere.

import { openText } from "./actions";
import { type Saved, validDocument } from "./autosave";
import type { Stage } from "./stage";
import { type Document, NO_PART, type Store } from "./state";

const KEY = "#p=";

/** Longer addresses are cut off by what passes them on. */
const MOST_LETTERS = 60_000;

/** The address that opens a document as it is; undefined where it would be too long. */
export async function linkTo({
  name,
  text,
  file,
  settings,
}: Document): Promise<string | undefined> {
  if (file) return undefined;
  const json = JSON.stringify({ name, text, settings } satisfies Saved);
  const bytes = await passed(new Blob([json]), new CompressionStream("deflate-raw"));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  const packed = btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  if (packed.length > MOST_LETTERS) return undefined;
  return `${location.href.replace(/#.*$/, "")}${KEY}${packed}`;
}

/** Opens what the address of the page carries, now and whenever it is given another. */
export function connectLinks(store: Store, stage: Stage): void {
  const open = async () => {
    const { hash } = location;
    if (!hash.startsWith(KEY)) return;
    // A reload shows what has become of it since, and not the link once more.
    history.replaceState(null, "", location.pathname + location.search);
    const found = await unpacked(hash.slice(KEY.length));
    if (found) {
      stage.fitNext();
      openText(store, { ...found, file: undefined, part: NO_PART, partText: "" });
    } else store.set({ notice: "The link is damaged: it holds no program." });
  };
  window.addEventListener("hashchange", open);
  void open();
}

async function unpacked(packed: string): Promise<Saved | undefined> {
  try {
    const letters = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const json = await passed(new Blob([bytes]), new DecompressionStream("deflate-raw"));
    return validDocument(JSON.parse(new TextDecoder().decode(json)));
  } catch {
    return undefined;
  }
}

async function passed(
  blob: Blob,
  through: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  return new Uint8Array(await new Response(blob.stream().pipeThrough(through)).arrayBuffer());
}
