// Reads a decimal number.

/**
 * The finite number that a text is, if it is one.
 *
 * @param {string} text
 */
export function decimal(text) {
  const isDecimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text);
  const value = Number(text);
  return isDecimal && Number.isFinite(value) ? value : undefined;
}
