// When the page has shown what it was opened for, and the network is free.

/** Resolves once `app` has solved its first design, or said why not, and the browser had time to draw it. */
export async function pictured(app: HTMLElement): Promise<void> {
  await new Promise<void>((resolve) => {
    const look = () => {
      const { state } = app.dataset;
      if (state === undefined || state === "solving") return;
      changes.disconnect();
      resolve();
    };
    const changes = new MutationObserver(look);
    changes.observe(app, { attributeFilter: ["data-state"] });
    look();
  });
  // The picture is drawn in the next frame, and stands on the screen when that is over.
  for (let frame = 0; frame < 2; frame += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  await new Promise<void>((resolve) => {
    if ("requestIdleCallback" in globalThis) requestIdleCallback(() => resolve());
    else setTimeout(resolve);
  });
}
