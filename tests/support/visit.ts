// A person at the designer: the gestures that tests are written in, and what went wrong meanwhile.
//
// Nothing here waits for a time. A gesture is over when the page says so (`data-state`, `data-fingerprint` on <pasu-app>).

import type { Browser, BrowserContext, BrowserContextOptions, Download, Locator, Page } from "playwright-core";
import { TEXELS } from "../../web/src/render/ground.ts";

interface GridSize {
  readonly rows: number;
  readonly columns: number;
}

export interface VisitOptions extends BrowserContextOptions {
  /** What follows the address, with its `#`. */
  readonly link?: string;
  /** Rows and columns of every mesh on the stage, in the place of those that the designer chooses; null leaves it the choice. */
  readonly grid?: GridSize | null;
  /** Whether the colours of the stage's pixels are computed. All else of a frame is as ever where they are not. */
  readonly painted?: boolean;
  /** Runs before the page opens: the place to count or to measure what it does from its first moment. */
  readonly before?: (there: Visit) => Promise<void>;
}

/** A small desktop window, just wide enough for the whole bar: software WebGL pays by the pixel. Without damped motion the camera is where it goes at once. */
const DESKTOP: BrowserContextOptions = { viewport: { width: 1100, height: 600 }, reducedMotion: "reduce" };

/** The picture as people have it, for tests that look at it: a pixel of the screen for each of the page's, and the designer's own grid. */
export const SHARP: VisitOptions = { deviceScaleFactor: 1, grid: null, painted: true };

/** A picture that is quickly drawn in software: a quarter of the pixels, and a fourteenth of the vertices. */
export const COARSE: VisitOptions = { deviceScaleFactor: 0.5, grid: { rows: 49, columns: 97 } };

/** A picture with all of its pixels, on the vertices of a coarse one: for tests that compare pictures with each other. In software vertices cost most of a sharp picture. */
export const CLEAR: VisitOptions = {
  ...COARSE,
  deviceScaleFactor: 1,
  viewport: { width: 1100, height: 440 },
  painted: true,
};

/** For tests that look at neither the picture nor the copy of the site for later: the stage is not painted, and no copy is made, as in a private window. */
export const QUICK: VisitOptions = { ...COARSE, painted: false, serviceWorkers: "block" };

/** Longer than anything takes on a busy machine, measuring a wall that had to be thinned all round among it; then the gesture that failed is named, not the test as a whole. */
const PATIENCE = 120_000;

/** A phone held upright; its screen is coarser than that of any phone, for the same reason. */
export const PHONE: BrowserContextOptions = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 1,
  isMobile: true,
  hasTouch: true,
  reducedMotion: "reduce",
};

/** Opens the designer in a fresh profile and waits for the first pot. */
export async function visit(
  browser: Browser,
  url: string,
  { link = "", grid = null, painted = true, before, ...options }: VisitOptions = {},
): Promise<Visit> {
  const context = await browser.newContext({ ...DESKTOP, ...options });
  context.setDefaultTimeout(PATIENCE);
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(url).origin });
  const there = new Visit(context, await context.newPage(), url);
  await there.listen();
  if (grid) await there.draw(grid);
  if (!painted) await there.leaveUnpainted();
  await before?.(there);
  await there.page.goto(url + link);
  return there;
}

export class Visit {
  /** Errors in the console, uncaught ones, broken policies and requests to other places; a healthy visit has none. */
  readonly troubles: string[] = [];

  constructor(
    readonly context: BrowserContext,
    readonly page: Page,
    readonly url: string,
  ) {}

  async listen(): Promise<void> {
    const { context, page, troubles } = this;
    const { origin } = new URL(this.url);
    page.on("console", (message) => {
      if (message.type() === "error") troubles.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => troubles.push(`uncaught: ${error.message}`));
    page.on("crash", () => troubles.push("the page crashed"));
    context.on("request", (request) => {
      const address = request.url();
      if (/^https?:/.test(address) && new URL(address).origin !== origin) troubles.push(`request: ${address}`);
    });
    context.on("requestfailed", (request) => {
      const why = request.failure()?.errorText ?? "";
      // Leaving a page ends what it was still fetching.
      if (!this.offline && why !== "net::ERR_ABORTED") troubles.push(`failed: ${request.url()} ${why}`);
    });
    await context.exposeBinding("pasuViolation", (_, text: string) => troubles.push(`policy: ${text}`));
    await context.addInitScript(() => {
      const report = (globalThis as unknown as { pasuViolation(text: string): void }).pasuViolation;
      document.addEventListener("securitypolicyviolation", (event) =>
        report(`${event.violatedDirective} ${event.blockedURI} ${event.sourceFile}:${event.lineNumber}`),
      );
    });
  }

  /** Has every mesh on the stage made of so many rows and columns; to be called before the page opens. */
  async draw(grid: GridSize): Promise<void> {
    await this.context.addInitScript(async (size) => {
      await customElements.whenDefined("pasu-app");
      // Where another language than English is fetched first, the page comes after its code.
      const app = await new Promise<Element>((found) => {
        const look = () => {
          const there = document.querySelector("pasu-app");
          if (there) found(there);
          return there !== null;
        };
        if (!look())
          new MutationObserver((_, observer) => look() && observer.disconnect()).observe(document, {
            childList: true,
            subtree: true,
          });
      });
      const { designer } = app as unknown as { designer: { surface: { grid: () => GridSize } } };
      designer.surface.grid = () => size;
    }, grid);
  }

  /**
   * Has the stage's frames drawn to the last call, and leaves out what the graphics card would do then; to be called before the page opens. What is drawn at another size than
   * the canvas's is painted all the same, but for its shadow: pictures for files, thumbnails, and the pixel that tells which part was clicked on.
   */
  async leaveUnpainted(): Promise<void> {
    await this.context.addInitScript((shadow) => {
      Object.assign(globalThis, { pasuUnpainted: true });
      const { prototype } = WebGL2RenderingContext;
      const { viewport } = prototype;
      let frame = false;
      prototype.viewport = function (x, y, width, height) {
        frame =
          (width === this.canvas.width && height === this.canvas.height) || (width === shadow && height === shadow);
        viewport.call(this, x, y, width, height);
      };
      for (const name of ["drawElements", "drawArrays", "drawArraysInstanced"] as const) {
        const draw = prototype[name] as (...given: number[]) => void;
        prototype[name] = function (this: WebGL2RenderingContext, ...given: number[]) {
          if (!frame) draw.apply(this, given);
        };
      }
    }, TEXELS);
  }

  private offline = false;

  get app(): Locator {
    return this.page.locator("pasu-app");
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole("button", { name, exact: typeof name === "string" });
  }

  /** The text field of a parameter. */
  field(name: string): Locator {
    return this.page.getByRole("spinbutton", { name, exact: true });
  }

  slider(name: string): Locator {
    return this.page.getByRole("slider", { name, exact: true });
  }

  dialog(name: string): Locator {
    return this.page.getByRole("dialog", { name });
  }

  /** The fingerprint of the pot on the stage, once it is the one in the panel and drawn to the end. */
  async fingerprint(): Promise<string> {
    return await this.fingerprintOtherThan("");
  }

  /** Waits until another pot than the one with this fingerprint stands finished on the stage. */
  async fingerprintOtherThan(before: string): Promise<string> {
    const found = await this.page.waitForFunction((old) => {
      const { fingerprint, state } = document.querySelector<HTMLElement>("pasu-app")?.dataset ?? {};
      return state === "ready" && fingerprint !== "" && fingerprint !== old ? fingerprint : null;
    }, before);
    return (await found.jsonValue()) ?? "";
  }

  /** Waits until the pot with this fingerprint stands finished on the stage. */
  async shows(fingerprint: string): Promise<void> {
    await this.page.waitForFunction((wanted) => {
      const data = document.querySelector<HTMLElement>("pasu-app")?.dataset;
      return data?.state === "ready" && data.fingerprint === wanted;
    }, fingerprint);
  }

  /** Drags a slider's thumb to a share of its track, in so many steps. `held` runs before the release. */
  async drag(
    name: string,
    share: number,
    { steps = 4, held }: { readonly steps?: number; readonly held?: () => Promise<void> } = {},
  ): Promise<void> {
    const slider = this.slider(name);
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    if (!box) throw new Error(`the slider “${name}” cannot be seen`);
    const now = await slider.evaluate((input: HTMLInputElement) => {
      const [value, min, max] = [input.valueAsNumber, Number(input.min), Number(input.max)];
      return Math.min(1, Math.max(0, (value - min) / (max - min)));
    });
    const thumb = 18;
    const at = (part: number) => box.x + thumb / 2 + part * (box.width - thumb);
    const y = box.y + box.height / 2;
    const { mouse } = this.page;
    await mouse.move(at(now), y);
    await mouse.down();
    for (let step = 1; step <= steps; step += 1) await mouse.move(at(now + (step / steps) * (share - now)), y);
    await held?.();
    await mouse.up();
  }

  /** Types into a parameter's field as a person does: everything in it is replaced, then it is left. */
  async type(name: string, text: string): Promise<void> {
    const field = this.field(name);
    await field.click();
    await field.fill(text);
    await field.blur();
  }

  /** Undo or Redo in the bar. */
  history(name: "Undo" | "Redo"): Locator {
    return this.page.locator("pasu-top-bar").getByRole("button", { name, exact: true });
  }

  async undo(): Promise<void> {
    await this.history("Undo").click();
  }

  async redo(): Promise<void> {
    await this.history("Redo").click();
  }

  /** A command of the bar, which narrow windows keep in a menu. */
  async command(
    name:
      | "Compare with…"
      | "Gallery"
      | "Mix with…"
      | "My designs"
      | "New"
      | "Open"
      | "Save"
      | "Export"
      | "Picture"
      | "Embed"
      | "Help",
  ): Promise<void> {
    if (!(await this.button(name).isVisible())) await this.button("More").click();
    await this.button(name).click();
  }

  async tab(name: "Shape" | "Profile" | "Equation" | "Look" | "Wall" | "Measures"): Promise<void> {
    await this.page.getByRole("tab", { name }).click();
  }

  /** Follows a link in the same page, as by pasting it into the address bar. */
  async openLink(link: string): Promise<void> {
    await this.page.evaluate((hash) => {
      location.hash = hash;
    }, link);
  }

  /** What “Copy link” put on the clipboard. */
  async copyLink(): Promise<string> {
    await this.button("Copy link").click();
    await this.page.getByText("Link copied").waitFor();
    return await this.page.evaluate(() => navigator.clipboard.readText());
  }

  /** What a press of this button downloads. */
  async download(name: string): Promise<{ readonly name: string; readonly bytes: Buffer }> {
    const pressed = Promise.all([this.page.waitForEvent("download"), this.button(name).click()]);
    const [download] = await pressed.catch(async (error: Error) => {
      const dialog = await this.page.getByRole("dialog").allInnerTexts();
      throw new Error(`“${name}” downloads nothing; the page says: ${dialog.join("\n")}\n${this.troubles.join("\n")}`, {
        cause: error,
      });
    });
    return { name: download.suggestedFilename(), bytes: await bytesOf(download) };
  }

  /** Gives the selected part a wall, and waits until the pot stands there with it. */
  async makePot(): Promise<void> {
    await this.tab("Wall");
    await this.button("Make it a pot").click();
    await this.page.getByText(/^Holds .* to the brim/).waitFor();
  }

  /** Drops a file onto the page. */
  async dropFile(name: string, content: string | Buffer): Promise<void> {
    await this.dropFiles([[name, content]]);
  }

  /** Drops several files onto the page at once. */
  async dropFiles(files: readonly (readonly [name: string, content: string | Buffer])[]): Promise<void> {
    const data = await this.page.evaluateHandle(
      (all) => {
        const transfer = new DataTransfer();
        for (const [fileName, base64] of all) {
          const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
          transfer.items.add(new File([bytes], fileName));
        }
        return transfer;
      },
      files.map(([name, content]) => [name, Buffer.from(content).toString("base64")] as const),
    );
    for (const event of ["dragenter", "dragover", "drop"]) {
      await this.page.dispatchEvent("pasu-app", event, { dataTransfer: data });
    }
  }

  async chooseFile(name: string, text: string): Promise<void> {
    const [chooser] = await Promise.all([this.page.waitForEvent("filechooser"), this.command("Open")]);
    await chooser.setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
  }

  async goOffline(): Promise<void> {
    this.offline = true;
    await this.context.setOffline(true);
  }

  /** The part of the address behind `#`. */
  async address(): Promise<string> {
    return await this.page.evaluate(() => location.hash);
  }

  async leave(): Promise<void> {
    await this.context.close();
  }
}

async function bytesOf(download: Download): Promise<Buffer> {
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk as Buffer);
  return Buffer.concat(chunks);
}
