// Counts in words: how many of what there are.

/** A whole number, its digits in groups of three: 11,399. */
export function grouped(count: number): string {
  return count.toLocaleString("en");
}

/** A count and what is counted, in the plural where it is not one. */
export function counted(count: number, noun: string): string {
  return `${grouped(count)} ${noun}${count === 1 ? "" : "s"}`;
}
