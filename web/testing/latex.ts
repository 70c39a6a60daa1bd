// Works out formulas of `src/equation` from their text alone: what a reader of them would do.

import type { Arithmetic } from "./arithmetic";

type Env<T> = Readonly<Record<string, T>>;
type Expression<T> = (env: Env<T>, index: string) => T;
type Call<T> = (name: string, values: readonly T[]) => T;

interface Definition<T> {
  readonly parameters: readonly string[];
  readonly body: Expression<T>;
}

/** What the formulas define, by name: `q_1`, `x`, and `H_j` for every `j`. */
export class Formulary<T> {
  readonly #arithmetic: Arithmetic<T>;
  readonly #definitions = new Map<string, Definition<T>>();
  /** The same is asked again and again. */
  readonly #known = new Map<string, T>();

  constructor(formulas: readonly string[], arithmetic: Arithmetic<T>) {
    this.#arithmetic = arithmetic;
    for (const line of formulas.flatMap(lines)) this.#define(line);
  }

  at(name: string, ...values: readonly number[]): number {
    const { from, to } = this.#arithmetic;
    return to(this.#value(name, values.map(from)));
  }

  #value(name: string, values: readonly T[]): T {
    const key = `${name} ${values.join(" ")}`;
    const known = this.#known.get(key);
    if (known !== undefined) return known;
    const [letter = "", index = ""] = name.split("_");
    const definition = this.#definitions.get(name) ?? this.#definitions.get(`${letter}_j`);
    if (!definition) throw new Error(`nothing says what ${name} is`);
    const env: Record<string, T> = {};
    definition.parameters.forEach((parameter, at) => {
      const value = values[at];
      if (value !== undefined) env[parameter] = value;
    });
    const found = definition.body(env, index);
    this.#known.set(key, found);
    return found;
  }

  #define(line: string): void {
    const equals = line.indexOf("=");
    const left = line.slice(0, equals).replace("&", "");
    const [, name = "", list = ""] = /^([A-Za-z](?:_\{\w+\})?)\(([^)]*)\)$/.exec(left) ?? [];
    if (name === "") throw new Error(`no definition: ${line}`);
    const parser = new Parser(line.slice(equals + 1), this.#arithmetic, (of, values) => this.#value(of, values));
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
  // The lines of cases are not lines of their own, nor are those that go on.
  const whole = (aligned[1] ?? "").replace(/\\begin\{cases\}.*?\\end\{cases\}/g, (cases) =>
    cases.replaceAll("\\\\", "\\;"),
  );
  return whole
    .replaceAll("\\\\&\\quad ", "")
    .split("\\\\")
    .map((line) => line.replaceAll("\\;", "\\\\"));
}

class Parser<T> {
  readonly #tokens: readonly string[];
  readonly #arithmetic: Arithmetic<T>;
  readonly #call: Call<T>;
  #at = 0;

  constructor(text: string, arithmetic: Arithmetic<T>, call: Call<T>) {
    const all = text.match(/\d+(?:\.\d+)?|\\[A-Za-z]+|\\\\|\\,|\S/g) ?? [];
    this.#tokens = all.filter((token) => !["\\,", "\\left", "\\right"].includes(token));
    this.#arithmetic = arithmetic;
    this.#call = call;
  }

  whole(): Expression<T> {
    this.#take("&");
    const found = this.#sum();
    if (this.#at < this.#tokens.length) throw new Error(`left over: ${this.#tokens.slice(this.#at).join(" ")}`);
    return found;
  }

  #sum(): Expression<T> {
    const { add, multiply, from } = this.#arithmetic;
    const [none, minus] = [from(0), from(-1)];
    let negative = this.#take("-");
    if (!negative) this.#take("+");
    const terms: Expression<T>[] = [];
    do {
      const product = this.#product();
      terms.push(negative ? (env, index) => multiply(minus, product(env, index)) : product);
      negative = this.#token === "-";
    } while (this.#take("+") || this.#take("-"));
    return (env, index) => terms.reduce((sum, term) => add(sum, term(env, index)), none);
  }

  #product(): Expression<T> {
    const { multiply, from } = this.#arithmetic;
    const one = from(1);
    const factors: Expression<T>[] = [];
    while (this.#begins()) {
      this.#take("\\cdot");
      factors.push(this.#power());
    }
    if (factors.length === 0) throw new Error(`nothing before ${this.#token}`);
    return (env, index) => factors.reduce((product, factor) => multiply(product, factor(env, index)), one);
  }

  #power(): Expression<T> {
    const { multiply, divide, from } = this.#arithmetic;
    const one = from(1);
    const base = this.#base();
    if (!this.#take("^")) return base;
    this.#expect("{");
    const isNegative = this.#take("-");
    const times = Number(this.#next());
    this.#expect("}");
    return (env, index) => {
      const value = base(env, index);
      const power = Array.from({ length: times }).reduce<T>((product) => multiply(product, value), one);
      return isNegative ? divide(one, power) : power;
    };
  }

  #base(): Expression<T> {
    const { of, pi, divide, functions } = this.#arithmetic;
    const token = this.#next();
    if (/^\d/.test(token)) {
      const number = of(token);
      return () => number;
    }
    if (token === "(") return this.#closed();
    if (token === "\\pi") return () => pi;
    if (token === "\\frac") {
      const [above, below] = [this.#braced(), this.#braced()];
      return (env, index) => divide(above(env, index), below(env, index));
    }
    if (token === "\\begin") return this.#cases();
    if (token.startsWith("\\")) {
      const wave = functions[token.slice(1) as keyof typeof functions];
      this.#expect("(");
      const inside = this.#closed();
      return (env, index) => wave(inside(env, index));
    }
    if (!/^[A-Za-z]$/.test(token)) throw new Error(`unknown: ${token}`);
    return this.#take("_") ? this.#called(token) : (env) => valueIn(env, token);
  }

  /** Up to the bracket that ends it. */
  #closed(): Expression<T> {
    const inside = this.#sum();
    this.#expect(")");
    return inside;
  }

  #called(letter: string): Expression<T> {
    this.#expect("{");
    const own = this.#next();
    this.#expect("}");
    this.#expect("(");
    const given = [this.#sum()];
    while (this.#take(",")) given.push(this.#sum());
    this.#expect(")");
    const call = this.#call;
    return (env, index) =>
      call(
        `${letter}_${own === "j" ? index : own}`,
        given.map((each) => each(env, index)),
      );
  }

  #cases(): Expression<T> {
    for (const token of ["{", "c", "a", "s", "e", "s", "}"]) this.#expect(token);
    const rows: { readonly from: Expression<T>; readonly to: Expression<T>; readonly body: Expression<T> }[] = [];
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
    return (env, index) => {
      const u = valueIn(env, "u");
      const row = rows.find(({ from, to }) => u >= from(env, index) && u <= to(env, index));
      if (!row) throw new Error(`no case for u = ${u}`);
      return row.body(env, index);
    };
  }

  #braced(): Expression<T> {
    this.#expect("{");
    const inside = this.#sum();
    this.#expect("}");
    return inside;
  }

  #begins(): boolean {
    return this.#token !== "" && !/^([-+)}&,=^_]|\\\\|\\end|\\le)$/.test(this.#token);
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

function valueIn<T>(env: Env<T>, name: string): T {
  const found = env[name];
  if (found === undefined) throw new Error(`nothing says what ${name} is`);
  return found;
}
