import { expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { readFile } from "./open-file";
import { isShortcut, linkIn } from "./shortcut";

const LINK = "https://pasu.example/?lang=en#1/fourth-order?r0=2&h1=5";
const LONG = `${LINK}&rm=${"1".repeat(300)}`;

const utf8 = (text: string) => new TextEncoder().encode(text);
const utf16 = (text: string) =>
  Uint8Array.from([0xff, 0xfe, ...[...text].flatMap((letter) => [letter.charCodeAt(0), 0])]);
const plist = (text: string) =>
  `<?xml version="1.0" encoding="UTF-8"?>\n<plist version="1.0"><dict>\n\t<key>URL</key>\n\t<string>${text}</string>\n</dict></plist>`;
/** As macOS writes it in bytes, but for the table behind the strings. */
const binary = (text: string) => {
  const length = text.length < 256 ? [0x10, text.length] : [0x11, text.length >> 8, text.length & 255];
  return Uint8Array.from([...utf8("bplist00"), 0xd1, 1, 2, ...utf8("SURL_"), ...length, ...utf8(text), 8, 11, 15]);
};

const READERS = { solver: realSolver({ free: true }).solver, maker: async () => null };

test.each([
  ["Windows", "pot.url", utf8(`[InternetShortcut]\r\nURL=${LINK}\r\nIconIndex=0\r\n`), LINK],
  [
    "Windows with another address before",
    "pot.url",
    utf8(`[DEFAULT]\r\nBASEURL=https://x.org/\r\n[InternetShortcut]\r\nURL=${LINK}`),
    LINK,
  ],
  ["Windows in UTF-16", "pot.URL", utf16(`[InternetShortcut]\r\nURL=${LINK}\r\n`), LINK],
  ["Linux", "pot.desktop", utf8(`[Desktop Entry]\nType=Link\nName=Pot\nURL=${LINK}\n`), LINK],
  ["macOS", "pot.webloc", utf8(plist(LINK.replaceAll("&", "&amp;"))), LINK],
  ["macOS in bytes", "pot.webloc", binary(LINK), LINK],
  ["macOS in bytes, a long one", "pot.webloc", binary(LONG), LONG],
])("a shortcut of %s opens the pot that it leads to", async (_, name, bytes, link) => {
  expect(await readFile(new File([bytes], name), READERS)).toEqual({ text: link, made: null });
});

test.each([
  ["elsewhere", utf8("[InternetShortcut]\r\nURL=https://example.org/#about\r\n")],
  ["elsewhere, in bytes", binary("https://example.org/#about")],
  ["nowhere", utf8("[InternetShortcut]\r\n")],
  ["an end in the middle", binary(LONG).subarray(0, 16)],
  ["nothing", new Uint8Array()],
])("a shortcut that leads %s holds no link", (_, bytes) => {
  expect(linkIn(bytes)).toBeNull();
});

test("what is called otherwise is none", () => {
  for (const name of ["pot.json", "url", "pot.url.txt", "webloc"]) expect(isShortcut(name)).toBe(false);
});

test("of a file that is all beginnings of strings none is decoded", () => {
  const bytes = new Uint8Array(1 << 21).fill(0x5f);
  bytes.set(new TextEncoder().encode("bplist00"));
  for (let at = 8; at + 6 < bytes.length; at += 6) bytes.set([0x5f, 0x12, 0x7f, 0xff, 0xff, 0xff], at);
  let n = 0;
  const { decode } = TextDecoder.prototype;
  TextDecoder.prototype.decode = function (...given) {
    n += 1;
    return decode.apply(this, given);
  };
  try {
    expect(linkIn(bytes)).toBeNull();
  } finally {
    TextDecoder.prototype.decode = decode;
  }
  // The whole, to see what it is.
  expect(n).toBe(1);
});
