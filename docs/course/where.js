// Where the course's files are: beside the page. The one-file edition has inside.js instead.
export {keep_offline} from "./offline.js";

const root = new URL("../", import.meta.url);

/// The address of a file of the site.
export const at = name => new URL(name, root).href;
export const text = async name => (await fetch(at(name))).text();
export const worker = name => new Worker(at(`course/${name}`));
/// What the compiler's worker needs to load a pack.
export const pack = async name => ({name});
/// The place in the page that its address names.
export const where_in_page = () => location.hash.slice(1);
