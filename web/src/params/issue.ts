/** What is wrong with given params, worded for a person. */

/** What kind of problem it is. */
export type IssueCode =
  /** Neither the group nor the key is declared. */
  | "unknownKey"
  /** The value is of another type: text for a number, say. */
  | "wrongType"
  /** Reading the value threw. */
  | "unreadable"
  /** A choice has no such option. */
  | "notAnOption"
  /** The number is NaN or infinite. */
  | "notFinite"
  /** The number lies outside its range. */
  | "outOfRange"
  /** The number is not whole. */
  | "notInteger"
  /** The model does not have this combination. */
  | "unsupported"
  /** Time or memory would not be enough. */
  | "tooLarge";

/** One problem with one parameter. */
export interface Issue {
  /** What kind of problem it is. */
  code: IssueCode;
  /** Path of the parameter; empty for the params as a whole. */
  path: string;
  /** The value as it was given. */
  value: unknown;
  /** A sentence that names the parameter and what it takes. */
  message: string;
  /** Smallest accepted value, where there is a range. */
  min?: number;
  /** Largest accepted value, where there is a range. */
  max?: number;
}

/** Params that no plant can be grown from; lists every problem at once. */
export class BoughError extends Error {
  /** All problems, in declared order; unknown keys last. */
  readonly issues: readonly Issue[];

  constructor(issues: readonly Issue[]) {
    super(issues.map((issue) => issue.message).join(" "));
    this.name = "BoughError";
    this.issues = issues;
  }
}
