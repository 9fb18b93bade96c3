// npm start: builds the package and the page, and serves the page until it is stopped.
import { join } from "node:path";

import { Failure, main, root } from "./command.mjs";
import { makePackage } from "./package.mjs";
import { buildPage, serve } from "./page.mjs";

const port = Number(process.env.PORT ?? 4141);

main(async () => {
  await makePackage();
  await buildPage();
  const { url } = await serve(join(root, "www/dist"), port).catch((error) => {
    throw new Failure(`cannot serve on port ${port} (PORT=… chooses another): ${error.message}`);
  });
  console.log(`\ng41 is ready at ${url} (Ctrl+C stops it)`);
});
