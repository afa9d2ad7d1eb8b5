/** The package finds its wasm beside its code: on the server it must stay where it is. */
export default { serverExternalPackages: ["bough"] };
