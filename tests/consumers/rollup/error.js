export { BoughError } from "bough";
