// npm start: builds the package and the page, and serves the page until it is stopped.
import { join } from "node:path";

import { Failure, main, root } from "./command.mjs";
import { buildPackage } from "./package.mjs";
import { buildPage, serve } from "./page.mjs";
import { setup } from "./setup.mjs";

const port = Number(process.env.PORT ?? 4141);

main(async () => {
  await setup();
  const wasm = await buildPackage();
  if (!wasm.fits) {
    throw new Failure("the wasm has grown beyond its limit");
  }
  await buildPage();
  const { url } = await serve(join(root, "www/dist"), port).catch((error) => {
    throw new Failure(`cannot serve on port ${port} (PORT=… chooses another): ${error.message}`);
  });
  console.log(`\ng41 is ready at ${url} (Ctrl+C stops it)`);
});
