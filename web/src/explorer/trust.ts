/** What the page's Trusted Types policy lets through. */

interface Policies {
  createPolicy(name: string, policy: { createScriptURL(address: string): string | null }): unknown;
}

/** The one address of a script that the page makes by itself is its worker's. */
export function trustOwnScripts(): void {
  const { trustedTypes } = globalThis as { trustedTypes?: Policies };
  trustedTypes?.createPolicy("default", {
    createScriptURL: (address) =>
      new URL(address, location.href).origin === location.origin ? address : null,
  });
}
