// node scripts/outlines.mjs: offsets of glyphs and icons beside Clipper2's, by area.
//
// Fonts and icons come from the npm registry, into target/: no other command needs them.
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inflateSync } from "node:zlib";

import { main, npm, root, run } from "./command.mjs";

const packages = {
  "@fontsource/dejavu-sans": "5.3.0",
  "@fontsource/lora": "5.3.0",
  "@fontsource/roboto": "5.3.0",
  "@mdi/svg": "7.4.47",
};
const folder = join(root, "target/outlines");
const modules = join(folder, "node_modules");

main(async () => {
  mkdirSync(folder, { recursive: true });
  if (!existsSync(join(modules, "@mdi/svg"))) {
    writeFileSync(join(folder, "package.json"), "{}");
    const named = Object.entries(packages).map(([name, version]) => `${name}@${version}`);
    await npm(["install", "--no-audit", "--no-fund", "--prefix", folder, ...named]);
  }
  const fonts = ["dejavu-sans", "lora", "roboto"].map((name) => {
    const woff = join(modules, `@fontsource/${name}/files/${name}-latin-400-normal.woff`);
    const file = join(folder, `${name}.ttf`);
    writeFileSync(file, unpacked(readFileSync(woff)));
    return file;
  });
  const bench = ["bench", "--quiet", "--package", "peers", "--bench", "outlines", "--"];
  const icons = join(folder, "icons.txt");
  writeFileSync(icons, iconPaths(500).join("\n"));
  await run("cargo", [...bench, icons, ...fonts, ...process.argv.slice(2)]);
});

/** Names and outlines of so many icons, evenly spread over the alphabet. */
function iconPaths(count) {
  const svg = join(modules, "@mdi/svg/svg");
  const names = readdirSync(svg).sort();
  const step = names.length / count;
  return Array.from({ length: count }, (_, i) => {
    const name = names[Math.floor(i * step)];
    const [, outline] = readFileSync(join(svg, name), "utf8").match(/ d="([^"]*)"/);
    return `${name.replace(".svg", "")} ${outline}`;
  });
}

/** A font without the compression of WOFF (W3C, WOFF File Format 1.0, sections 4 and 5). */
function unpacked(woff) {
  const count = woff.readUInt16BE(12);
  const tables = Array.from({ length: count }, (_, i) => {
    const at = 44 + 20 * i;
    const [offset, packed, length, checksum] = [4, 8, 12, 16].map((k) => woff.readUInt32BE(at + k));
    const stored = woff.subarray(offset, offset + packed);
    const data = packed < length ? inflateSync(stored) : stored;
    return { tag: woff.subarray(at, at + 4), data, checksum };
  });
  const head = Buffer.alloc(12 + 16 * count);
  woff.copy(head, 0, 4, 8);
  head.writeUInt16BE(count, 4);
  const parts = [head];
  let offset = head.length;
  tables.forEach(({ tag, data, checksum }, i) => {
    const at = 12 + 16 * i;
    tag.copy(head, at);
    head.writeUInt32BE(checksum, at + 4);
    head.writeUInt32BE(offset, at + 8);
    head.writeUInt32BE(data.length, at + 12);
    const padded = Buffer.alloc(Math.ceil(data.length / 4) * 4);
    data.copy(padded);
    parts.push(padded);
    offset += padded.length;
  });
  return Buffer.concat(parts);
}
