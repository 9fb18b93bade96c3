/// <reference types="node" />
// What the tests of the page share: opening it, and finding places of the picture on the screen.
import type { Locator, Page } from "@playwright/test";
import { expect } from "@playwright/test";

/** A point [mm] or a place on the screen [px]. */
export type Point = readonly [x: number, y: number];

/** A file: a text, or its bytes. */
export interface Dropped {
  readonly name: string;
  readonly text?: string;
  readonly bytes?: readonly number[];
}

/** The page as a user meets it. */
export class G41Page {
  readonly canvas: Locator;
  readonly base: Locator;
  readonly program: Locator;
  readonly output: Locator;
  readonly errors: string[] = [];

  constructor(readonly page: Page) {
    this.canvas = page.locator("canvas.overlay");
    this.base = page.locator("canvas.base");
    this.program = page.locator("#panel-program textarea");
    this.output = page.locator("#panel-output textarea");
    page.on("pageerror", (error) => this.errors.push(error.message));
    page.on("console", (message) => message.type() === "error" && this.errors.push(message.text()));
  }

  /** Opens the page and waits for the first tool path. */
  async open(example?: string): Promise<void> {
    await this.page.goto("./");
    await expect(this.output).toHaveValue(/G1/);
    if (example) {
      const before = await this.output.inputValue();
      await this.page.getByLabel("Example").selectOption(example);
      await expect(this.output).not.toHaveValue(before);
    }
    await this.frames(3);
  }

  /** Drops files onto the page. */
  async drop(...files: Dropped[]): Promise<void> {
    await this.page.evaluate((all) => {
      const dataTransfer = new DataTransfer();
      for (const { name, text, bytes } of all) {
        const content = bytes ? Uint8Array.from(bytes) : (text ?? "");
        dataTransfer.items.add(new File([content], name, { type: "text/plain" }));
      }
      for (const type of ["dragenter", "dragover", "drop"]) {
        const event = new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
        document.body.dispatchEvent(event);
      }
    }, files);
  }

  /** Saves by a button, and returns the name and the text of the file. */
  async saved(button: Locator): Promise<{ name: string; text: string }> {
    const [download] = await Promise.all([this.page.waitForEvent("download"), button.click()]);
    const chunks: Buffer[] = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk as Buffer);
    return { name: download.suggestedFilename(), text: Buffer.concat(chunks).toString() };
  }

  /** Waits for animation frames. */
  async frames(count: number): Promise<void> {
    await this.page.evaluate(async (frames) => {
      for (let i = 0; i < frames; i += 1) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
    }, count);
  }

  /** Where points of the program are on the screen, found with the coordinates that are read out. */
  async locator(): Promise<(point: Point) => Point> {
    await this.canvas.scrollIntoViewIfNeeded();
    const box = await this.canvas.boundingBox();
    if (!box) throw new Error("the canvas is not shown");
    const read = async (at: Point): Promise<Point> => {
      await this.page.mouse.move(...at);
      await expect(this.page.locator("#readout")).toHaveText(/X/);
      const text = (await this.page.locator("#readout").textContent()) ?? "";
      const [x, y] = [...text.matchAll(/-?\d+(?:\.\d+)?/g)].map(Number);
      return [x as number, y as number];
    };
    const a: Point = [box.x + 4, box.y + 4];
    const b: Point = [box.x + box.width - 4, box.y + box.height - 4];
    const [p, q] = [await read(a), await read(b)];
    return ([x, y]) => [
      a[0] + ((x - p[0]) / (q[0] - p[0])) * (b[0] - a[0]),
      a[1] + ((y - p[1]) / (q[1] - p[1])) * (b[1] - a[1]),
    ];
  }

  /** Drags with the mouse from one place to another. */
  async drag(from: Point, to: Point, steps = 8): Promise<void> {
    await this.page.mouse.move(...from);
    await this.page.mouse.down();
    await this.page.mouse.move(...to, { steps });
    await this.page.mouse.up();
    await this.settled();
  }

  /** Waits until the tool path belongs to the text that is shown. */
  async settled(): Promise<void> {
    await this.frames(1);
    await expect(this.page.locator("#stage")).toHaveAttribute("aria-busy", "false");
    await this.frames(2);
  }

  /** What the static layer shows, as a string to compare. */
  async picture(): Promise<string> {
    return this.base.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  }

  /** The number beside a kind in the legend. */
  async count(kind: "Shortened" | "Elongated" | "Inserted"): Promise<number> {
    const item = this.page.locator("#legend li", { hasText: kind });
    return Number(await item.locator("small").textContent());
  }
}

/** What axe finds to be wrong for people who use other means than eyes and mouse. */
export async function violations(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: "node_modules/axe-core/axe.min.js" });
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    const result = await axe.run();
    return result.violations.map(({ id, nodes }) => `${id}: ${nodes.map((n) => n.html)}`);
  });
}
