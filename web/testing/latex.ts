// Works out formulas of `src/equation` from their text alone: what a reader of them would do with a pocket calculator.

type Env = Readonly<Record<string, number>>;
type Expression = (env: Env) => number;

interface Definition {
  readonly parameters: readonly string[];
  readonly body: Expression;
}

const WAVES: Readonly<Record<string, (x: number) => number>> = {
  sin: Math.sin,
  cos: Math.cos,
  sinh: Math.sinh,
  cosh: Math.cosh,
};

/** What the formulas define, by name: `q_1`, `x`, and `H_j` for every `j`. */
export class Formulary {
  readonly #definitions = new Map<string, Definition>();

  constructor(formulas: readonly string[]) {
    for (const line of formulas.flatMap(lines)) this.#define(line);
  }

  at(name: string, ...values: readonly number[]): number {
    const [letter = "", index = ""] = name.split("_");
    const own = this.#definitions.get(name);
    const definition = own ?? this.#definitions.get(`${letter}_j`);
    if (!definition) throw new Error(`nothing says what ${name} is`);
    const env = Object.fromEntries(definition.parameters.map((parameter, at) => [parameter, values[at] ?? Number.NaN]));
    return definition.body({ ...env, j: Number(index) });
  }

  #define(line: string): void {
    const equals = line.indexOf("=");
    const left = line.slice(0, equals).replace("&", "");
    const [, name = "", list = ""] = /^([A-Za-z](?:_\{\w+\})?)\(([^)]*)\)$/.exec(left) ?? [];
    if (name === "") throw new Error(`no definition: ${line}`);
    const parser = new Parser(line.slice(equals + 1), (of, values) => this.at(of, ...values));
    this.#definitions.set(name.replace(/[{}]/g, ""), { parameters: list.split(","), body: parser.whole() });
  }
}

/** The lines of an aligned block, each a definition, without marks. */
function lines(formula: string): string[] {
  let text = formula;
  const mark = /\\class\{m\d+\}\{((?:[^{}]|\{[^{}]*\})*)\}/g;
  while (mark.test(text)) text = text.replace(mark, "$1");
  const aligned = /^\\begin\{aligned\}(.*)\\end\{aligned\}$/.exec(text);
  if (!aligned) return [text];
  // The lines of cases are not lines of their own.
  const whole = (aligned[1] ?? "").replace(/\\begin\{cases\}.*?\\end\{cases\}/g, (cases) =>
    cases.replaceAll("\\\\", "\\;"),
  );
  return whole
    .replaceAll("\\\\&\\quad ", "")
    .split("\\\\")
    .map((line) => line.replaceAll("\\;", "\\\\"));
}

class Parser {
  readonly #tokens: readonly string[];
  readonly #call: (name: string, values: readonly number[]) => number;
  #at = 0;

  constructor(text: string, call: (name: string, values: readonly number[]) => number) {
    const all = text.match(/\d+(?:\.\d+)?|\\[A-Za-z]+|\\\\|\\,|\S/g) ?? [];
    this.#tokens = all.filter((token) => !["\\,", "\\left", "\\right"].includes(token));
    this.#call = call;
  }

  whole(): Expression {
    this.#take("&");
    const found = this.#sum();
    if (this.#at < this.#tokens.length) throw new Error(`left over: ${this.#tokens.slice(this.#at).join(" ")}`);
    return found;
  }

  #sum(): Expression {
    let negative = this.#take("-");
    if (!negative) this.#take("+");
    const terms: Expression[] = [];
    do {
      const product = this.#product();
      const sign = negative ? -1 : 1;
      terms.push((env) => sign * product(env));
      negative = this.#token === "-";
    } while (this.#take("+") || this.#take("-"));
    return (env) => terms.reduce((sum, term) => sum + term(env), 0);
  }

  #product(): Expression {
    const factors: Expression[] = [];
    while (this.#begins()) {
      this.#take("\\cdot");
      factors.push(this.#power());
    }
    if (factors.length === 0) throw new Error(`nothing before ${this.#token}`);
    return (env) => factors.reduce((product, factor) => product * factor(env), 1);
  }

  #power(): Expression {
    const base = this.#base();
    if (!this.#take("^")) return base;
    const exponent = this.#braced();
    return (env) => base(env) ** exponent(env);
  }

  #base(): Expression {
    const token = this.#next();
    if (/^\d/.test(token)) return () => Number(token);
    if (token === "(") {
      const inside = this.#sum();
      this.#expect(")");
      return inside;
    }
    if (token === "\\pi") return () => Math.PI;
    if (token === "\\frac") {
      const [above, below] = [this.#braced(), this.#braced()];
      return (env) => above(env) / below(env);
    }
    if (token === "\\begin") return this.#cases();
    const wave = WAVES[token.slice(1)];
    if (token.startsWith("\\") && wave) {
      this.#expect("(");
      const inside = this.#sum();
      this.#expect(")");
      return (env) => wave(inside(env));
    }
    if (!/^[A-Za-z]$/.test(token)) throw new Error(`unknown: ${token}`);
    if (!this.#take("_")) return (env) => value(env, token);
    this.#expect("{");
    const index = this.#next();
    this.#expect("}");
    this.#expect("(");
    const given = [this.#sum()];
    while (this.#take(",")) given.push(this.#sum());
    this.#expect(")");
    const call = this.#call;
    return (env) => {
      const which = index === "j" ? value(env, "j") : index;
      return call(
        `${token}_${which}`,
        given.map((each) => each(env)),
      );
    };
  }

  #cases(): Expression {
    for (const token of ["{", "c", "a", "s", "e", "s", "}"]) this.#expect(token);
    const rows: { readonly from: Expression; readonly to: Expression; readonly body: Expression }[] = [];
    do {
      const body = this.#sum();
      this.#expect("&");
      const from = this.#sum();
      this.#expect("\\le");
      this.#expect("u");
      this.#expect("\\le");
      rows.push({ body, from, to: this.#sum() });
    } while (this.#take("\\\\"));
    for (const token of ["\\end", "{", "c", "a", "s", "e", "s", "}"]) this.#expect(token);
    return (env) => {
      const u = value(env, "u");
      const row = rows.find(({ from, to }) => u >= from(env) && u <= to(env));
      if (!row) throw new Error(`no case for u = ${u}`);
      return row.body(env);
    };
  }

  #braced(): Expression {
    this.#expect("{");
    const inside = this.#sum();
    this.#expect("}");
    return inside;
  }

  #begins(): boolean {
    const token = this.#token;
    return token !== "" && !/^([-+)}&,=^_]|\\\\|\\end|\\le)$/.test(token);
  }

  get #token(): string {
    return this.#tokens[this.#at] ?? "";
  }

  #next(): string {
    const token = this.#token;
    this.#at += 1;
    return token;
  }

  #take(token: string): boolean {
    if (this.#token !== token) return false;
    this.#at += 1;
    return true;
  }

  #expect(token: string): void {
    if (!this.#take(token)) throw new Error(`expected ${token}, found ${this.#token} in ${this.#tokens.join(" ")}`);
  }
}

function value(env: Env, name: string): number {
  const found = env[name];
  if (found === undefined) throw new Error(`nothing says what ${name} is`);
  return found;
}
