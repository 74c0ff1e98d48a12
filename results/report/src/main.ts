import { readReport } from "./data";
const app = document.getElementById("app");
if (app) app.textContent = readReport(document).title;
