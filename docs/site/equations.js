// Typesets every equation of the page. An equation that cannot be read is an error in the console.
document.addEventListener("DOMContentLoaded", () => {
  for (const element of document.querySelectorAll(".arithmatex")) {
    const source = element.textContent.trim();
    const display = source.startsWith("\\[");
    katex.render(source.slice(2, -2), element, { displayMode: display, strict: "error", throwOnError: true });
  }
});
