import init, { version } from "g41";

await init();
document.querySelector("output")?.append(version());
