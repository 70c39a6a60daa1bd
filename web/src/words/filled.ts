/** Sentences with something in them that is more than text. */

/** The pieces of a sentence, with what stands for `{0}`, `{1}` and so on in their places. */
export function filled<T extends object>(sentence: string, parts: readonly T[]): readonly (string | T)[] {
  const pieces = sentence.split(/\{(\d+)\}/);
  return pieces.flatMap((piece, index): (string | T)[] => {
    if (index % 2 === 0) return piece === "" ? [] : [piece];
    const part = parts[Number(piece)];
    return part === undefined ? [] : [part];
  });
}
