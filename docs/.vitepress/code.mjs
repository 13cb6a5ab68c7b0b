/** How code looks: ink of several strengths, as the only colours of a page are those of its figures. */

/**
 * @param {"light" | "dark"} type
 * @param {{surface: string, text: string, second: string, third: string}} colors as the style sheet has them
 * @returns {import("vitepress").MarkdownOptions["theme"] & object}
 */
const ink = (type, { surface, text, second, third }) => ({
  name: `directrix-${type}`,
  type,
  colors: { "editor.background": surface, "editor.foreground": text },
  settings: [
    { settings: { foreground: text, background: surface } },
    { scope: ["comment", "punctuation.definition.comment"], settings: { foreground: third, fontStyle: "italic" } },
    { scope: ["string", "punctuation"], settings: { foreground: second } },
    { scope: ["keyword", "storage", "entity.name.tag", "entity.name.section", "markup.heading"], settings: { fontStyle: "bold" } },
  ],
});

export const code = {
  light: ink("light", { surface: "#f6f6f7", text: "#17191d", second: "#585d68", third: "#6a707c" }),
  dark: ink("dark", { surface: "#16181c", text: "#eceef2", second: "#a3a8b4", third: "#8c929e" }),
};
