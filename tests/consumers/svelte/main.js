import { define } from "bough/element";
import { mount } from "svelte";
import App from "./App.svelte";

define();
mount(App, { target: document.querySelector("#app") });
