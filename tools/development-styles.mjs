// Lets the development server style the page. A Vite plugin: while it serves, Vite puts what modules import as styles into
// <style> elements, which the page's policy forbids; the built site links its stylesheets and keeps the policy as it is.

/** @returns {import("vite").Plugin} */
export function developmentStyles() {
  return {
    name: "bough-development-styles",
    apply: "serve",
    transformIndexHtml: (html) => html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'"),
  };
}
