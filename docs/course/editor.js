// An editor of CodeMirror's for the lines of a region.
import {Compartment, EditorState} from "@codemirror/state";
import {EditorView, keymap, lineNumbers, drawSelection} from "@codemirror/view";
import {defaultKeymap, history, historyKeymap} from "@codemirror/commands";
import {HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting}
  from "@codemirror/language";
import {setDiagnostics} from "@codemirror/lint";
import {cpp} from "@codemirror/lang-cpp";
import {tags} from "@lezer/highlight";

const colour = name => ({color: `var(--fragment-${name})`});
const colours = HighlightStyle.define([
  {tag: [tags.keyword, tags.modifier, tags.self], ...colour("keyword")},
  {tag: tags.controlKeyword, ...colour("keywordflow")},
  {tag: [tags.typeName, tags.standard(tags.typeName)], ...colour("keywordtype")},
  {tag: [tags.number, tags.string, tags.bool], ...colour("token")},
  {tag: tags.comment, ...colour("comment")},
  {tag: tags.processingInstruction, ...colour("preprocessor")}]);

/// \param id of the field that takes the keys
/// \param changed called with the text at every keystroke
export function make_editor(id, label, text, changed) {
  let quiet = false, first = 1;  // number of the first line
  const numbers = new Compartment();
  const numbered = () => lineNumbers({formatNumber: line => String(line + first - 1)});
  const view = new EditorView({doc: text, extensions: [
    numbers.of(numbered()), history(), drawSelection(), indentOnInput(), bracketMatching(), cpp(),
    indentUnit.of("  "), syntaxHighlighting(colours), EditorView.lineWrapping,
    EditorState.tabSize.of(2), keymap.of([...defaultKeymap, ...historyKeymap]),
    EditorView.contentAttributes.of({id, "aria-label": label, spellcheck: "false"}),
    EditorView.updateListener.of(update => {
      if (update.docChanged && !quiet) changed(view.state.doc.toString());
    })]});
  return {
    element: view.dom,
    text: () => view.state.doc.toString(),
    set(words) {
      quiet = true;
      view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: words}});
      quiet = false;
    },
    /// Counts the lines as the reader's file does.
    number_from(line) {
      if (line === first) return;
      first = line;
      view.dispatch({effects: numbers.reconfigure(numbered())});
    },
    /// Shows words at a line, from 1; without a line nothing is marked any more.
    mark(line, words) {
      const at = line >= 1 && line <= view.state.doc.lines ? view.state.doc.line(line) : null;
      view.dispatch(setDiagnostics(view.state, at
        ? [{from: at.from, to: at.to, severity: "error", message: words}] : []));
    },
  };
}
