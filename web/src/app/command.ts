/** What a person asks of the page as a whole, from wherever on it. */

export type Command =
  | "new"
  | "surprise"
  | "draw"
  | "redraw"
  | "scan"
  | "gallery"
  | "mix"
  | "shelf"
  | "open"
  | "save"
  | "export"
  | "link"
  | "share"
  | "embed"
  | "compare"
  | "patches"
  | "picture"
  | "help";

/** What the bar across the top has a button for. */
export type BarCommand = Exclude<Command, "draw" | "redraw" | "scan" | "patches">;

export class CommandEvent extends Event {
  readonly command: Command;
  constructor(command: Command) {
    super("command-chosen", { bubbles: true, composed: true });
    this.command = command;
  }
}
