// Formulas, and the list of versions that stand beside this one.
document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".math")) {
    katex.render(place.textContent, place, { displayMode: place.classList.contains("display"), throwOnError: false });
  }
  document.documentElement.dataset.formulas = "drawn";
  const list = document.getElementById("versions");
  if (!list) return;
  const script = document.createElement("script");
  script.src = list.dataset.root + "versions.js";
  script.onload = () => {
    for (const version of window.fabricshVersions) {
      const here = version === list.dataset.version;
      list.add(new Option(version, list.dataset.root + version + "/index.html", here, here));
    }
  };
  list.onchange = () => { location.href = list.value; };
  document.head.append(script);
});
