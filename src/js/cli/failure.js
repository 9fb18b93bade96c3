// How the command ends, and the failures that end it early.

/** The exit codes, which `--help` lists. */
export const exit = /** @type {const} */ ({
  fine: 0,
  faults: 1,
  usage: 2,
  file: 3,
  internal: 4,
});

/** A failure that the user can act on: printed without a stack trace. */
export class Failure extends Error {
  /**
   * @param {number} code the exit code
   * @param {string} message
   * @param {string} [hint] what to do about it
   */
  constructor(code, message, hint) {
    super(message);
    this.code = code;
    this.hint = hint;
  }
}

/**
 * Ends the command since it was called wrongly.
 *
 * @param {string} message
 * @param {string} [hint]
 * @returns {never}
 */
export function misused(message, hint) {
  throw new Failure(exit.usage, message, hint);
}

/**
 * Ends the command since something is wrong with a file.
 *
 * @param {string} path
 * @param {unknown} cause what went wrong, in words or as the system says it
 * @returns {never}
 */
export function fileTrouble(path, cause) {
  throw new Failure(exit.file, `${path}: ${typeof cause === "string" ? cause : reason(cause)}`);
}

/** What the most common faults of files are called. */
const reasons = new Map([
  ["ENOENT", "there is no such file or folder"],
  ["EACCES", "this may not be read or written by you"],
  ["EISDIR", "this is a folder"],
  ["ENOTDIR", "a part of the path is no folder"],
  ["ENOSPC", "there is no space left"],
  ["EROFS", "nothing can be written there"],
  ["ERR_STRING_TOO_LONG", "this is too large"],
  ["ERR_FS_FILE_TOO_LARGE", "this is too large"],
]);

/** @param {unknown} error */
function reason(error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  return reasons.get(code ?? "") ?? message;
}
