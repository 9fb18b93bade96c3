// Numbers as people type them into a field: 12.5, 12,5 or 10/2+3.

/** The value of an arithmetic expression; undefined for what is none. */
export function evaluate(text: string): number | undefined {
  const source = text.replace(/,/g, ".").replace(/\s+/g, "");
  let at = 0;

  const number = (): number => {
    const found = /^(?:\d+\.?\d*|\.\d+)/.exec(source.slice(at));
    if (!found) return Number.NaN;
    at += found[0].length;
    return Number(found[0]);
  };
  const factor = (): number => {
    const sign = source[at];
    if (sign === "-" || sign === "+") {
      at += 1;
      return sign === "-" ? -factor() : factor();
    }
    if (sign !== "(") return number();
    at += 1;
    const inner = sum();
    if (source[at] !== ")") return Number.NaN;
    at += 1;
    return inner;
  };
  const product = (): number => {
    let value = factor();
    while (source[at] === "*" || source[at] === "/") {
      const times = source[at] === "*";
      at += 1;
      value = times ? value * factor() : value / factor();
    }
    return value;
  };
  const sum = (): number => {
    let value = product();
    while (source[at] === "+" || source[at] === "-") {
      const plus = source[at] === "+";
      at += 1;
      value = plus ? value + product() : value - product();
    }
    return value;
  };

  const value = sum();
  return at === source.length && source !== "" && Number.isFinite(value) ? value : undefined;
}

/** A length as shown in a field and in words: at most three decimals. */
export function format(value: number, digits = 3): string {
  const text = value.toFixed(digits).replace(/\.0+$|(\.\d*?)0+$/, "$1");
  return text === "-0" ? "0" : text;
}
