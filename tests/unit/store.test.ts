import { expect, test, vi } from "vitest";
import { initialState } from "../../web/src/params/state.ts";
import { Store } from "../../web/src/params/store.ts";

test("a settled change can be undone and redone", () => {
  const store = new Store();
  store.set({ theme: "dark" }, "settled");
  expect(store).toMatchObject({ canUndo: true, canRedo: false });
  store.undo();
  expect(store).toMatchObject({ state: initialState, canUndo: false, canRedo: true });
  store.redo();
  expect(store.state.theme).toBe("dark");
});

test("a whole gesture is one step", () => {
  const store = new Store();
  for (const step of [1, 2, 3]) store.set({ step }, "dragging");
  store.set({ step: 4 }, "settled");
  store.undo();
  expect(store).toMatchObject({ state: initialState, canUndo: false });
  store.redo();
  expect(store.state.step).toBe(4);
});

test("undo in the midst of a gesture goes back to before it, and redo to where it was", () => {
  const store = new Store();
  store.set({ step: 5 }, "settled");
  store.set({ step: 6 }, "dragging");
  expect(store.canUndo).toBe(true);
  store.undo();
  expect(store.state.step).toBe(5);
  store.redo();
  expect(store.state.step).toBe(6);
});

test("a gesture that ends where it began leaves nothing to undo", () => {
  const store = new Store();
  store.set({ step: 5 }, "dragging");
  store.set({ step: null }, "settled");
  expect(store.canUndo).toBe(false);
});

test("a new change ends what could be redone", () => {
  const store = new Store();
  store.set({ step: 5 }, "settled");
  store.undo();
  store.set({ theme: "dark" }, "settled");
  store.redo();
  expect(store.state).toEqual({ ...initialState, theme: "dark" });
});

test("history is bounded", () => {
  const store = new Store();
  for (let step = 1; step <= 1000; step++) store.set({ step }, "settled");
  let undone = 0;
  for (; store.canUndo; undone++) store.undo();
  expect(undone).toBe(200);
  expect(store.state.step).toBe(800);
});

test("nothing to undo or redo does nothing", () => {
  const store = new Store();
  const listener = vi.fn();
  store.subscribe(listener);
  store.undo();
  store.redo();
  expect(store.state).toBe(initialState);
  expect(listener).not.toHaveBeenCalled();
});

test("listeners hear every change and how it came about, and nothing else", () => {
  const store = new Store();
  const heard: unknown[] = [];
  const unsubscribe = store.subscribe(({ step }, change) => heard.push([step, change]));
  store.set({ step: 1 }, "dragging");
  store.set({ step: 1 }, "dragging");
  store.set({ step: 1 }, "settled");
  store.set({ step: 1 }, "settled");
  store.undo();
  store.redo();
  unsubscribe();
  store.set({ step: 2 }, "settled");
  expect(heard).toEqual([
    [1, "dragging"],
    [1, "settled"],
    [null, "undo"],
    [1, "redo"],
  ]);
});

test("a state once given out never changes", () => {
  const store = new Store();
  const before = store.state;
  store.set({ step: 3 }, "settled");
  expect(before).toEqual(initialState);
  expect(store.state).not.toBe(before);
});
