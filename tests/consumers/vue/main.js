import { define } from "bough/element";
import { createApp } from "vue";
import App from "./App.vue";

define();
createApp(App).mount("#app");
