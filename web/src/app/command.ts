/** What a person asks of the page as a whole, from wherever on it. */

export type Command =
  | "new"
  | "surprise"
  | "gallery"
  | "mix"
  | "shelf"
  | "open"
  | "save"
  | "export"
  | "link"
  | "share"
  | "embed"
  | "picture"
  | "help";

export class CommandEvent extends Event {
  readonly command: Command;
  constructor(command: Command) {
    super("command-chosen", { bubbles: true, composed: true });
    this.command = command;
  }
}
