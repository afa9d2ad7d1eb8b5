// docs/api.md: what each entry of the package exports, printed from the types and their comments.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import ts from "typescript";
import { Obstacle } from "./obstacle.mjs";
import { root } from "./paths.mjs";

const page = join(root, "docs", "api.md");

const entries = [
  { name: "bough", file: "index.ts", note: "The same from `bough/inline`, which has the wasm inside." },
  {
    name: "bough/element",
    file: "../element/index.ts",
    note: "[widget.md](widget.md) has its attributes, events and styles. Types that `bough` exports too are not repeated.",
  },
  {
    name: "bough/three",
    file: "../three/index.ts",
    note: "[three.md](three.md) shows it in use. What the classes have from three.js is not repeated.",
  },
  { name: "bough/worker", file: "worker.ts", note: "What `bough` exports too is not repeated." },
];

export function writeApiReference() {
  writeFileSync(page, apiReference());
  console.log("✓ printing docs/api.md");
}

export function checkApiReference() {
  const found = existsSync(page) ? readFileSync(page, "utf8") : "";
  if (found !== apiReference()) throw new Obstacle("docs/api.md is stale.", { remedy: "npm run fix" });
  console.log("✓ docs/api.md is up to date");
}

function apiReference() {
  const files = entries.map(({ file }) => join(root, "web", "src", "package", file));
  const config = ts.readConfigFile(join(root, "tsconfig.package.json"), ts.sys.readFile).config;
  const { options } = ts.parseJsonConfigFileContent(config, ts.sys, root);
  const program = ts.createProgram(files, options);
  const checker = program.getTypeChecker();
  /** @type {Set<ts.Symbol>} */
  const shown = new Set();
  const sections = entries.map(({ name, note }, index) => {
    const source = program.getSourceFile(files[index] ?? "");
    const module = source && checker.getSymbolAtLocation(source);
    if (!module) throw new Error(`${name} has no exports.`);
    const exports = checker.getExportsOfModule(module).map((symbol) => target(symbol, checker));
    const fresh = exports.filter((symbol) => !shown.has(symbol));
    for (const symbol of fresh) shown.add(symbol);
    const parts = fresh.sort(byKindAndName).map((symbol) => described(symbol, checker));
    return [`## \`${name}\``, note, ...parts].join("\n\n");
  });
  return `${introduction}\n${sections.join("\n\n")}\n`;
}

const introduction = `# API

Printed from the types in \`web/src\`; \`npm run fix\` prints it anew. [package.md](package.md) shows it in use. The params are not
repeated here: [parameters.md](parameters.md) has every one with unit, default and range.
`;

/** What is printed of each kind, in this order. */
const kinds = [
  { is: ts.isFunctionDeclaration, order: 0 },
  { is: ts.isVariableDeclaration, order: 1 },
  { is: ts.isClassDeclaration, order: 2 },
  { is: ts.isInterfaceDeclaration, order: 3 },
  { is: ts.isTypeAliasDeclaration, order: 4 },
];

/**
 * @param {ts.Symbol} a
 * @param {ts.Symbol} b
 */
function byKindAndName(a, b) {
  return orderOf(a) - orderOf(b) || a.name.localeCompare(b.name);
}

/** @param {ts.Symbol} symbol */
function orderOf(symbol) {
  return kinds.find(({ is }) => is(declarationOf(symbol)))?.order ?? kinds.length;
}

/** @param {ts.Symbol} symbol */
function declarationOf(symbol) {
  const [declaration] = symbol.declarations ?? [];
  if (!declaration) throw new Error(`${symbol.name} is declared nowhere.`);
  return declaration;
}

/**
 * @param {ts.Symbol} symbol
 * @param {ts.TypeChecker} checker
 */
function target(symbol, checker) {
  return symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
}

/**
 * @param {ts.Symbol} symbol
 * @param {ts.TypeChecker} checker
 */
function described(symbol, checker) {
  const declaration = declarationOf(symbol);
  const comment = commentOf(symbol, checker);
  if (symbol.name === "Params") return entry(symbol.name, comment, "See [parameters.md](parameters.md).");
  if (ts.isFunctionDeclaration(declaration)) return entry(signature(declaration), comment);
  if (ts.isVariableDeclaration(declaration)) {
    const type = checker.typeToString(checker.getTypeAtLocation(declaration));
    return entry(`${symbol.name}: ${type}`, comment);
  }
  if (ts.isTypeAliasDeclaration(declaration)) {
    return entry(symbol.name, comment, codeOf(shortened(declaration)), ...optionsOf(declaration, checker));
  }
  if (ts.isInterfaceDeclaration(declaration) || ts.isClassDeclaration(declaration)) {
    return entry(headingOf(declaration), comment, ...membersOf(declaration, checker));
  }
  throw new Error(`${symbol.name} is of a kind that the reference does not know.`);
}

/**
 * @param {string} heading
 * @param {readonly string[]} parts
 */
function entry(heading, ...parts) {
  return [`### \`${heading}\``, ...parts].filter((part) => part !== "").join("\n\n");
}

/** @param {ts.FunctionDeclaration | ts.MethodSignature | ts.MethodDeclaration} declaration */
function signature(declaration) {
  return `${declaration.name?.getText()}(${parametersOf(declaration)}): ${declaration.type?.getText()}`;
}

/** What is taken apart at once goes by the name of its type. @param {ts.SignatureDeclaration} declaration */
function parametersOf({ parameters }) {
  const shown = parameters.map(({ name, type, initializer, questionToken }) => {
    const mark = initializer || questionToken ? "?" : "";
    const [first = "", ...rest] = type?.getText() ?? "";
    const called = ts.isIdentifier(name) ? name.text : `${first.toLowerCase()}${rest.join("")}`;
    return `${called}${mark}: ${type?.getText()}`;
  });
  return shown.join(", ");
}

/** @param {ts.InterfaceDeclaration | ts.ClassDeclaration} declaration */
function headingOf({ name, heritageClauses = ts.factory.createNodeArray() }) {
  return [name?.text, ...heritageClauses.map((clause) => clause.getText())].join(" ");
}

/**
 * Public members as a table.
 * @param {ts.InterfaceDeclaration | ts.ClassDeclaration} declaration
 * @param {ts.TypeChecker} checker
 */
function membersOf(declaration, checker) {
  const rows = declaration.members.flatMap((/** @type {ts.TypeElement | ts.ClassElement} */ member) => {
    const isProperty = ts.isPropertySignature(member) || ts.isPropertyDeclaration(member);
    const isMethod = ts.isMethodSignature(member) || ts.isMethodDeclaration(member);
    const isGetter = ts.isGetAccessor(member);
    // What browsers call, and what only repeats the class it extends, is no business of authors.
    if (ts.isClassDeclaration(declaration) && ts.getJSDocCommentsAndTags(member).length === 0) return [];
    if (ts.isConstructorDeclaration(member)) {
      const said = ts.getJSDocCommentsAndTags(member).map(({ comment }) => ts.getTextOfJSDocComment(comment));
      const head = `new ${declaration.name?.text}(${parametersOf(member)})`;
      return [`| ${inCell(`\`${head}\``)} | ${inCell(said.join(" "))} |`];
    }
    if (member.name && ts.isPrivateIdentifier(member.name)) return [];
    const symbol = member.name && checker.getSymbolAtLocation(member.name);
    if (symbol && ts.isSetAccessor(member)) {
      const head = `${symbol.name}: ${member.parameters[0]?.type?.getText()}`;
      return [`| ${inCell(`\`${head}\``)} | ${inCell(commentOf(symbol, checker))} |`];
    }
    // What only repeats the class it extends has no type of its own.
    if (!symbol || !(isProperty || isMethod || isGetter) || !member.type) return [];
    const mark = isProperty && member.questionToken ? "?" : "";
    const head = isMethod ? signature(member) : `${symbol.name}${mark}: ${member.type.getText()}`;
    return [`| ${inCell(`\`${head}\``)} | ${inCell(commentOf(symbol, checker))} |`];
  });
  return rows.length === 0 ? [] : [["| member | what it is |", "| --- | --- |", ...rows].join("\n")];
}

/**
 * The comments inside a union of names.
 * @param {ts.TypeAliasDeclaration} declaration
 * @param {ts.TypeChecker} checker
 */
function optionsOf({ type }, checker) {
  if (!ts.isUnionTypeNode(type)) return [];
  const text = type.getSourceFile().text;
  const rows = type.types.flatMap((option, index) => {
    const before = text.slice(type.types[index - 1]?.end ?? type.getFullStart(), option.getStart());
    const [, comment] = /\/\*\* (.+?) \*\//.exec(before) ?? [];
    return comment
      ? [`| \`${checker.typeToString(checker.getTypeFromTypeNode(option))}\` | ${comment} |`]
      : [];
  });
  return rows.length === 0 ? [] : [["| value | what it means |", "| --- | --- |", ...rows].join("\n")];
}

/** A type alias without the comments inside it. @param {ts.TypeAliasDeclaration} declaration */
function shortened(declaration) {
  const printed = ts
    .createPrinter({ removeComments: true })
    .printNode(ts.EmitHint.Unspecified, declaration, declaration.getSourceFile());
  return printed
    .replace(/^export /, "")
    .replace(/;$/, "")
    .replace(/\s+/g, " ");
}

/** @param {string} code */
function codeOf(code) {
  return `\`${code}\``;
}

/**
 * @param {ts.Symbol} symbol
 * @param {ts.TypeChecker} checker
 */
function commentOf(symbol, checker) {
  const text = ts.displayPartsToString(symbol.getDocumentationComment(checker));
  const tags = symbol.getJsDocTags(checker).map(({ name, text: parts }) => {
    const said = ts.displayPartsToString(parts);
    if (name === "param") return `\`${said.split(" ")[0]}\`: ${said.replace(/^\S+ /, "")}.`;
    return name === "throws" ? `Throws ${said.replace(/^\{?(\w+)\}? /, "`$1` ")}.` : "";
  });
  return [text.replace(/\s*\n\s*/g, " "), ...tags]
    .filter((part) => part !== "")
    .join(" ")
    .trim();
}

/** @param {string} text */
function inCell(text) {
  return text.replaceAll("|", "\\|").replace(/\s+/g, " ");
}
