// Leaves out of a library what nobody can call: functions, methods and fields holding functions whose names are mentioned nowhere in the code that
// is left. Bundlers do that for what a module exports, and not for the methods of a class, which are two thirds of three.

/** A node of a syntax tree (ESTree), as bundlers hand them out. */
interface Node {
  type: string;
  start: number;
  end: number;
  [field: string]: unknown;
}

/** A piece of code that can go when its name is not mentioned. */
interface Piece {
  start: number;
  end: number;
  name: string;
  /** What stands in its place when it goes: what a module exports has to be something. */
  remains: string;
  isField: boolean;
  /** What it mentions itself, without the pieces in it. */
  words: Set<string>;
  inner: Piece[];
}

/** A text to be shaken, and its syntax tree. */
export interface Source {
  code: string;
  tree: unknown;
}

const isNode = (value: unknown): value is Node =>
  typeof value === "object" && value !== null && typeof (value as Node).type === "string";

const fieldName = (key: unknown): string | undefined =>
  isNode(key) && key.type === "Identifier" ? (key.name as string) : undefined;

/** The name without which a node cannot be reached; `undefined` where it stands for more than that. */
function pieceName(node: Node, parent: Node | undefined): string | undefined {
  const [id, key, value, expression] = [node.id, node.key, node.value, node.expression];
  switch (node.type) {
    case "FunctionDeclaration":
    case "ClassDeclaration":
      return fieldName(id);
    case "VariableDeclaration": {
      const [first, ...more] = node.declarations as Node[];
      return parent?.type === "Program" && more.length === 0 ? fieldName(first?.id) : undefined;
    }
    case "MethodDefinition":
      return node.computed || node.kind === "constructor" ? undefined : fieldName(key);
    case "Property":
      // Of an object that is returned: tables are also read by computed names.
      if (node.computed || parent?.type !== "ReturnedObject") return undefined;
      return isNode(value) && /^(Identifier|FunctionExpression)$/.test(value.type) ? fieldName(key) : undefined;
    case "ExpressionStatement": {
      if (!isNode(expression) || expression.type !== "AssignmentExpression") return undefined;
      const [to, from] = [expression.left, expression.right];
      if (!isNode(to) || !isNode(from) || to.type !== "MemberExpression" || to.computed) return undefined;
      const object = to.object;
      if (!isNode(object)) return undefined;
      if (object.type === "ThisExpression") {
        return /^(Identifier|FunctionExpression|ArrowFunctionExpression)$/.test(from.type)
          ? fieldName(to.property)
          : undefined;
      }
      // `Class.field = …` and `Class.prototype.field = …` beside the class.
      if (parent?.type !== "Program" || /Call|New/.test(from.type)) return undefined;
      return fieldName(object) ?? (object.type === "MemberExpression" ? fieldName(object.object) : undefined);
    }
    default:
      return undefined;
  }
}

function collect(node: Node, parent: Node | undefined, into: Piece): void {
  const name = pieceName(node, parent);
  let here = into;
  if (name !== undefined) {
    const exported = parent?.type === "Program" && node.type !== "ExpressionStatement";
    const remains = exported ? `var ${name};` : "";
    const isField = node.type === "Property";
    here = { start: node.start, end: node.end, name, remains, isField, words: new Set(), inner: [] };
    into.inner.push(here);
  }
  // Where a piece says its own name is no mention of it, nor is a list of exports, which the bundler looks at.
  if (/^(Import|ExportNamed)Declaration$/.test(node.type)) return;
  const own = name === undefined ? undefined : ownName(node);
  if (node.type === "Identifier" || node.type === "PrivateIdentifier") here.words.add(node.name as string);
  if (node.type === "Literal" && typeof node.value === "string") {
    for (const word of node.value.match(/[\w$]+/g) ?? []) here.words.add(word);
  }
  const asParent =
    node.type === "ObjectExpression" && parent?.type === "ReturnStatement" ? { ...node, type: "ReturnedObject" } : node;
  for (const child of Object.values(node)) {
    for (const item of Array.isArray(child) ? child : [child]) {
      if (isNode(item) && item !== own) collect(item, asParent, here);
    }
  }
}

/** The node by which a piece names itself. */
function ownName(node: Node): unknown {
  if (node.type === "ExpressionStatement") {
    const to = (node.expression as Node).left as Node;
    return to;
  }
  if (node.type === "VariableDeclaration") return (node.declarations as Node[])[0]?.id;
  return node.id ?? node.key;
}

/** The same texts without the pieces that neither `words` nor what is left of the texts mentions. */
export function withoutUnmentioned(sources: readonly Source[], words: Iterable<string>): string[] {
  const wholes = sources.map(({ code, tree }) => {
    const whole: Piece = {
      start: 0,
      end: code.length,
      name: "",
      remains: "",
      isField: false,
      words: new Set(),
      inner: [],
    };
    collect(tree as Node, undefined, whole);
    return whole;
  });
  const mentioned = new Set<string>();
  const waiting = new Map<string, Piece[]>();
  const live = new Set<Piece>();
  const arrive = (piece: Piece) => {
    live.add(piece);
    for (const inner of piece.inner) {
      if (mentioned.has(inner.name)) arrive(inner);
      else waiting.set(inner.name, [...(waiting.get(inner.name) ?? []), inner]);
    }
    for (const word of piece.words) mention(word);
  };
  const mention = (word: string) => {
    if (mentioned.has(word)) return;
    mentioned.add(word);
    for (const piece of waiting.get(word) ?? []) arrive(piece);
    waiting.delete(word);
  };
  for (const word of words) mention(word);
  for (const whole of wholes) arrive(whole);
  return wholes.map((whole, index) => remaining(sources[index]?.code ?? "", whole, live));
}

function remaining(code: string, piece: Piece, live: ReadonlySet<Piece>): string {
  let text = "";
  let at = piece.start;
  for (const inner of piece.inner) {
    text += code.slice(at, inner.start);
    text += live.has(inner) ? remaining(code, inner, live) : inner.remains;
    at = inner.end;
    // With a field of an object goes its comma.
    if (!live.has(inner) && inner.isField) at += /^\s*,?/.exec(code.slice(at, at + 200))?.[0].length ?? 0;
  }
  return text + code.slice(at, piece.end);
}
