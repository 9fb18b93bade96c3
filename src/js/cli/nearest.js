// Finds the name that was probably meant.

/**
 * The name nearest to what was given, unless it is too far off to have been meant.
 *
 * @param {string} given
 * @param {readonly string[]} names
 */
export function nearest(given, names) {
  const wanted = given.toLowerCase();
  let best;
  // A letter in three may be wrong.
  let least = Math.max(1, Math.floor(wanted.length / 3)) + 1;
  for (const name of names) {
    const steps = name.startsWith(wanted) && wanted.length > 1 ? 1 : distance(wanted, name);
    if (steps < least) {
      [best, least] = [name, steps];
    }
  }
  return best;
}

/**
 * The number of letters to insert, leave out, replace or swap with their neighbour (Damerau and
 * Levenshtein, in the form that changes no letter twice).
 *
 * @param {string} a
 * @param {string} b
 */
function distance(a, b) {
  /** @type {number[][]} */
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)];
  /** @type {(i: number, j: number) => number} */
  const at = (i, j) => rows[i]?.[j] ?? Number.POSITIVE_INFINITY;
  for (let i = 1; i <= a.length; i++) {
    const row = [i];
    rows.push(row);
    for (let j = 1; j <= b.length; j++) {
      const replaced = at(i - 1, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1);
      const swapped = a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1] ? at(i - 2, j - 2) + 1 : 99;
      row.push(Math.min(at(i - 1, j) + 1, at(i, j - 1) + 1, replaced, swapped));
    }
  }
  return at(a.length, b.length);
}
