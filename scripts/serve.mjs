// Serves the page as it was last built: `node scripts/serve.mjs PORT`.
import { join } from "node:path";

import { main, root } from "./command.mjs";
import { serve } from "./page.mjs";

main(async () => {
  const { url } = await serve(join(root, "www/dist"), Number(process.argv[2]));
  console.log(url);
});
