// The page's Content-Security-Policy, as a tag because a static host cannot be asked to send a header.

import type { Plugin } from "vite";

const POLICY = {
  "default-src": "'none'",
  // The solver is a WebAssembly module; nothing else may be compiled from text.
  "script-src": "'self' 'wasm-unsafe-eval'",
  // Lit's styles are constructed style sheets, which need no exception; style attributes stay forbidden.
  "style-src": "'self'",
  "img-src": "'self' blob: data:",
  "connect-src": "'self'",
  "worker-src": "'self'",
  "manifest-src": "'self'",
  "base-uri": "'none'",
  "form-action": "'none'",
};

/** What the policy is for a page in a frame: where the frame is sandboxed it has no origin, and starts its worker from a blob. */
const FRAMED = { ...POLICY, "worker-src": "'self' blob:" };

export function metaPolicy({ framed }: { framed: boolean }): string {
  return Object.entries(framed ? FRAMED : POLICY)
    .map(([directive, sources]) => `${directive} ${sources}`)
    .join("; ");
}

/**
 * Puts the policy at the head of every built page. The development server is left alone: hot reloading needs inline
 * styles and a socket.
 */
export function contentSecurityPolicy(): Plugin {
  const content = metaPolicy({ framed: false });
  return {
    name: "pasu:content-security-policy",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler: () => [
        { tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content }, injectTo: "head-prepend" },
      ],
    },
  };
}
