// npm run build, and npm pack before it packs: builds the package in dist/.
import { Failure, main } from "./command.mjs";
import { buildPackage } from "./package.mjs";
import { setup } from "./setup.mjs";

main(async () => {
  await setup();
  const wasm = await buildPackage();
  if (!wasm.fits) {
    throw new Failure("the wasm has grown beyond its limit");
  }
});
