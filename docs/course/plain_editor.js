// An editor where CodeMirror cannot be loaded: a plain field.

/// \param id of the field that takes the keys
/// \param changed called with the text at every keystroke
export function make_editor(id, label, text, changed) {
  const field = Object.assign(document.createElement("textarea"),
                              {id, value: text, spellcheck: false, autocapitalize: "off"});
  const fit = () => { field.rows = field.value.split("\n").length + 1; };
  field.setAttribute("aria-label", label);
  field.addEventListener("input", () => {
    fit();
    changed(field.value);
  });
  fit();
  return {element: field, text: () => field.value, mark() {}, number_from() {},
          set(words) { field.value = words; fit(); }};
}
