// npm run build, and npm pack before it packs: builds the package in dist/.
import { main } from "./command.mjs";
import { makePackage } from "./package.mjs";

main(makePackage);
