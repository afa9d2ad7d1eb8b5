/** The declaration as a JSON Schema of the params that users write: everything may be left out. */
import { help } from "../../generated/help.ts";
import { declaredParameters, groupAndField } from "./declaration.ts";

type Schema = Record<string, unknown>;
type Declared = (typeof declaredParameters)[number];

/** The JSON Schema (2020-12) of the params: what `grow` takes. */
export const schema: Readonly<Record<string, unknown>> = paramsSchema();

function paramsSchema(): Schema {
  const groups: Record<string, Record<string, Schema>> = {};
  for (const parameter of declaredParameters) {
    const [group, field] = groupAndField(parameter.path);
    groups[group] ??= {};
    groups[group][field] = described(parameter);
  }
  const properties = Object.entries(groups).map(([group, fields]) => [group, objectOf(fields)]);
  return {
    $schema: "https://json-schema.org/draft/2020-12/schema",
    title: "Bough params",
    description: "Everything that determines a plant. What is left out takes its default.",
    ...objectOf(Object.fromEntries(properties)),
  };
}

function described(parameter: Declared): Schema {
  const { path, label: title, unit } = parameter;
  const [text] = help[path] ?? [""];
  const description = unit === "" ? text : `${text} Unit: ${unit}.`;
  return { ...typeOf(parameter), default: parameter.default, title, description };
}

function typeOf({ kind, options, min: minimum, max: maximum }: Declared): Schema {
  const vector = { type: "array", minItems: 3, maxItems: 3, items: { type: "number", minimum, maximum } };
  switch (kind) {
    case "number":
    case "integer":
      return { type: kind, minimum, maximum };
    case "optional":
      return { type: ["number", "null"], minimum, maximum };
    case "choice":
      return { enum: options };
    case "flag":
      return { type: "boolean" };
    case "vector":
      return vector;
    case "forces":
      return {
        type: "array",
        items: {
          ...objectOf({ segment: { type: "integer", minimum: 0 }, force: vector }),
          required: ["segment", "force"],
        },
      };
  }
}

/** An object with no other keys than these. */
function objectOf(properties: Record<string, unknown>): Schema {
  return { type: "object", additionalProperties: false, properties };
}
