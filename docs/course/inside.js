// Where the course's files are in the one-file edition: in the window around the page.
const {site} = parent;

export const at = name => site.address(name);
export const text = async name => site.text(name);
export const worker = name => new Worker(site.worker(`course/${name}`));
export const pack = async name => ({name, blob: await site.pack(name)});
export const keep_offline = () => {};  // it needs no network
export const where_in_page = () => decodeURIComponent(parent.location.hash).split("#")[2] || "";
