// Clean folders outside the repository, each with one consumer and the packed tarball that it installs.

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { npm } from "../commands.mjs";
import { packageFolder, root } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";

const fixtures = join(root, "tests", "consumers");

export class Workshop {
  #folder = mkdtempSync(join(tmpdir(), "bough-consumers-"));
  #tarball = "";

  /** Packs what lies in dist/package. */
  async open() {
    this.#tarball = await this.#pack(root, "bough.tgz");
  }

  /**
   * A folder with a consumer, its packages installed.
   * @param {string} fixture a folder in tests/consumers
   * @param {Record<string, string>} [packages] versions of packages it needs besides its own
   */
  async install(fixture, packages = {}) {
    const folder = this.#copy(join(fixtures, fixture), fixture);
    for (const file of ["program.js", "plants.js"]) cpSync(join(fixtures, file), join(folder, file));
    writeFileSync(join(folder, "fingerprint.js"), await plainFingerprint());
    await this.#installIn(folder, fixture, packages);
    return folder;
  }

  /**
   * An example as somebody has it who copied its folder.
   * @param {string} example a folder in examples
   */
  async installExample(example) {
    const folder = this.#copy(join(root, "examples", example), example);
    await this.#installIn(folder, `example ${example}`, {});
    return folder;
  }

  /**
   * @param {string} source
   * @param {string} name
   */
  #copy(source, name) {
    const folder = mkdtempSync(join(this.#folder, `${name}-`));
    cpSync(source, folder, { recursive: true });
    return folder;
  }

  /**
   * @param {string} folder
   * @param {string} name
   * @param {Record<string, string>} packages
   */
  async #installIn(folder, name, packages) {
    cpSync(this.#tarball, join(folder, "bough.tgz"));
    const manifest = join(folder, "package.json");
    const content = JSON.parse(readFileSync(manifest, "utf8"));
    if (content.dependencies["bough-next"]) await this.#packNext(folder);
    const dependencies = { ...content.dependencies, bough: "file:./bough.tgz" };
    const devDependencies = { ...content.devDependencies, ...packages };
    writeFileSync(manifest, JSON.stringify({ ...content, dependencies, devDependencies }));
    const quietly = ["--no-audit", "--no-fund", "--no-package-lock", "--prefer-offline"];
    await runCommand(`installing ${name}`, [...npm(), "install", ...quietly], { cwd: folder, limit: 600 });
  }

  close() {
    rmSync(this.#folder, { recursive: true, force: true });
  }

  /**
   * The package as a later version, which differs in nothing but its number.
   * @param {string} folder
   */
  async #packNext(folder) {
    const copy = mkdtempSync(join(this.#folder, "next-"));
    const { version, ...manifest } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
    const later = `${version}-next`;
    writeFileSync(join(copy, "package.json"), JSON.stringify({ ...manifest, version: later }));
    cpSync(packageFolder, join(copy, "dist", "package"), { recursive: true });
    const declaration = join(copy, "dist", "package", "generated", "declaration.js");
    // In the quotes that the minifier chose.
    const text = readFileSync(declaration, "utf8").replace(/(?<=version:.)\d[^"'`]*/, later);
    writeFileSync(declaration, text);
    cpSync(await this.#pack(copy, "bough-next.tgz"), join(folder, "bough-next.tgz"));
  }

  /**
   * @param {string} source
   * @param {string} name
   */
  async #pack(source, name) {
    const into = mkdtempSync(join(this.#folder, "tarball-"));
    const pack = [...npm(), "pack", "--silent", "--pack-destination", into];
    const printed = await runCommand(`packing ${name}`, pack, { cwd: source });
    return join(into, printed.trim().split("\n").at(-1) ?? "");
  }
}

/** tests/fingerprint.ts as plain JavaScript. */
async function plainFingerprint() {
  const { default: ts } = await import("typescript");
  const source = readFileSync(join(root, "tests", "fingerprint.ts"), "utf8");
  const compilerOptions = { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext };
  return ts.transpileModule(source, { compilerOptions }).outputText;
}
