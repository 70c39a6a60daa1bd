import { describe, expect, it } from "vitest";
import { type Embedding, elementSnippet, frameSnippet } from "./embed-snippets";

const PLAIN: Embedding = {
  site: "https://pots.example/pasu/",
  folder: "pot/0.1",
  link: "#1/bloor-wilson?a=6&n1=5",
  alt: "A vase",
  controls: [],
  turns: false,
};

describe("what is put into another page", () => {
  it("is a script and an element", () => {
    expect(elementSnippet(PLAIN)).toBe(
      '<script type="module" src="https://pots.example/pasu/pot/0.1/pasu-pot.js"></script>\n' +
        '<pasu-pot src="#1/bloor-wilson?a=6&amp;n1=5" alt="A vase"></pasu-pot>',
    );
    expect(elementSnippet({ ...PLAIN, controls: ["n1", "h[0]"], turns: true })).toContain(
      ' alt="A vase" controls="n1, h[0]" auto-rotate></pasu-pot>',
    );
  });

  it("is a frame, whose address says the same", () => {
    const snippet = frameSnippet({ ...PLAIN, controls: ["n1", "a"], turns: true });
    const address = new URL((/src="([^"]*)"/.exec(snippet)?.[1] ?? "").replaceAll("&amp;", "&"));
    expect(address.origin + address.pathname).toBe("https://pots.example/pasu/embed.html");
    expect(Object.fromEntries(address.searchParams)).toEqual({ alt: "A vase", controls: "n1,a", "auto-rotate": "" });
    expect(address.hash).toBe(PLAIN.link);
  });

  it("has no way out of its quotes", () => {
    const alt = '"><script>alert(1)</script>&';
    for (const snippet of [elementSnippet({ ...PLAIN, alt }), frameSnippet({ ...PLAIN, alt })]) {
      expect(snippet).not.toContain("<script>alert");
      expect(snippet).toContain("&quot;&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;");
    }
  });
});
