import { expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { linkInText, linkOf } from "./link-in-text";

const ADDRESS = "https://pasu.example/";

test.each([
  [
    "See https://pasu.example/?view=1,80,2#1/second-order?height=5, and tell me.",
    "?view=1,80,2#1/second-order?height=5",
  ],
  ["My pot (https://pasu.example/#1~eNoV_-x); yours: https://pasu.example/#1~other", "#1~eNoV_-x"],
  ["It is \u201chttps://pasu.example/#1/second-order?height=5\u201d.\n", "#1/second-order?height=5"],
  ["<https://pasu.example/#1/second-order>", "#1/second-order"],
])("the first link in a text ends where words go on: %s", (text, link) => {
  expect(linkInText(text)).toBe(ADDRESS + link);
});

test("there is no link in words, in a bare fragment and in a document", () => {
  for (const text of ["milk, eggs", "1/second-order?height=5", ' {"pasu": 1, "title": "#1/ and more"}'])
    expect(linkInText(text)).toBeNull();
});

test("texts of marks of links alone have an end", () => {
  expect(linkInText("http:#1".repeat(1 << 20))).toBeNull();
  expect(linkInText(`${"?".repeat(1 << 22)} #1/`)).toBe("#1/");
});

const LINK = `${ADDRESS}#1/bloor-wilson?n1=5&a=0.01`;

test.each([
  ["a link alone", ` ${LINK}\n`],
  ["one that a mail program broke over two lines", `${LINK.slice(0, 40)}\n${LINK.slice(40)}`],
  ["and quoted", `> ${LINK.slice(0, 40)}\n> ${LINK.slice(40)}`],
  ["words before it", `See ${LINK}`],
  ["a document", '{ "pasu": 1, "title": "#1/" }'],
  ["words alone", "milk, eggs"],
])("%s is opened as it is", async (_, text) => {
  const { solver } = realSolver({ free: true });
  expect(await linkOf(text, solver)).toBe(text);
});

test("words behind a link are left out, also on a line of their own", async () => {
  const { solver } = realSolver({ free: true });
  for (const text of [`See ${LINK}, and tell me.`, `${LINK}\nCheers`, `(${LINK}) is mine`])
    expect(await linkOf(text, solver)).toBe(LINK);
});
