/** Whether plain data say the same; what they share is not looked through. */
export function isAlike(one: unknown, other: unknown): boolean {
  if (one === other || !(one instanceof Object) || !(other instanceof Object)) return one === other;
  const names = Object.keys(one) as (keyof typeof one)[];
  return names.length === Object.keys(other).length && names.every((name) => isAlike(one[name], other[name]));
}
