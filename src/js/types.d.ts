/** Loads the package's WebAssembly; in Node it is loaded already. */
export default function init(
  source?: RequestInfo | URL | BufferSource | WebAssembly.Module,
): Promise<void>;

/** The version of the package. */
export function version(): string;
