import { createApp } from "vue";
import "pasu-pot";

const app = createApp({ data: () => ({ dints: 5, link: "" }) });
// Not a component of Vue's.
app.config.compilerOptions.isCustomElement = (name) => name === "pasu-pot";
app.mount("#app");
