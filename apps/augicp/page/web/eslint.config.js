// SPDX-License-Identifier: MIT
import js from "@eslint/js";
import typescript from "typescript-eslint";

const noMarkup = ["innerHTML", "outerHTML"].map((property) => ({
  selector: `MemberExpression[property.name='${property}']`,
  message: "Text from outside must stay text: use textContent.",
}));

export default typescript.config(
  { ignores: ["node_modules"] },
  js.configs.recommended,
  {
    files: ["src/**/*.ts"],
    extends: [typescript.configs.strictTypeChecked],
    languageOptions: { parserOptions: { projectService: true } },
    rules: {
      "no-restricted-syntax": ["error", ...noMarkup],
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
    },
  },
  {
    files: ["*.mjs", "test/*.mjs"],
    languageOptions: { globals: { console: "readonly", process: "readonly", Buffer: "readonly", document: "readonly", window: "readonly", URL: "readonly", performance: "readonly", requestAnimationFrame: "readonly", setTimeout: "readonly" } },
  },
);
