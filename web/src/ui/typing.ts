/** What hears that somebody types into a number, before it is read: it may be the number that there is, which is no change. */
export function typing(hear: () => void): EventListenerObject & { readonly capture: true } {
  return { capture: true, handleEvent: hear };
}
