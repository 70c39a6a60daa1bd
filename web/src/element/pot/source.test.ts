import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { MOST_BYTES, sourceOf, textAt } from "./source";

const PAGE = "https://page.example/article/";

describe("where a design comes from", () => {
  it("is a link, in itself or at the end of an address", () => {
    expect(sourceOf(" #1/second-order ", PAGE)).toEqual({ kind: "link", link: "#1/second-order" });
    expect(sourceOf("https://pasu.example/#1~abc", PAGE)).toEqual({ kind: "link", link: "#1~abc" });
  });

  it("is a document at an address, seen from the page", () => {
    const document = (src: string) => sourceOf(src, PAGE);
    expect(document("vase.json")).toEqual({ kind: "document", address: `${PAGE}vase.json` });
    expect(document("/vase.json#part")).toEqual({ kind: "document", address: "https://page.example/vase.json#part" });
  });

  it("is refused where it is no address", () => {
    expect(() => sourceOf("http://[", PAGE)).toThrow(expect.objectContaining({ code: "not-an-address", path: "src" }));
  });
});

describe("the text of a document", () => {
  const server = createServer((request, response) => {
    if (request.url === "/missing") response.writeHead(404).end();
    else if (request.url === "/fits") response.end(" ".repeat(MOST_BYTES));
    // Says nothing of its length.
    else if (request.url === "/large") response.write("x".repeat(MOST_BYTES), () => response.end("x"));
    else response.end("Käse");
  });
  const at = (path: string) => `http://127.0.0.1:${(server.address() as AddressInfo).port}${path}`;
  const fetched = (path: string) => textAt(at(path), new AbortController().signal);

  beforeAll(() => new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve)));
  afterAll(() => new Promise<void>((resolve) => server.close(() => resolve())));

  it("is read up to a mebibyte", async () => {
    expect(await fetched("/short")).toBe("Käse");
    expect(await fetched("/fits")).toHaveLength(MOST_BYTES);
    await expect(fetched("/large")).rejects.toMatchObject({ code: "too-large", path: "src" });
  });

  it("is refused in words where there is none", async () => {
    await expect(fetched("/missing")).rejects.toMatchObject({
      code: "unreachable",
      message: expect.stringContaining("404"),
    });
    await expect(textAt("http://127.0.0.1:1/", new AbortController().signal)).rejects.toMatchObject({
      code: "unreachable",
    });
  });

  it("is not missed where nobody waits for it any more", async () => {
    const gone = new AbortController();
    gone.abort();
    await expect(textAt(at("/short"), gone.signal)).rejects.toMatchObject({ name: "AbortError" });
  });
});
