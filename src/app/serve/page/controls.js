// The form: each control is named after the key of the scene that it sets.

/** @param {string} id @returns {any} */
export const $ = (id) => document.getElementById(id);

/**
 * @param {HTMLFormElement} form
 * @param {() => any} scene
 * @param {(before: any) => void} remember called at the end of each change, or of a whole slide
 * @param {(key: string) => void} changed also called while a control slides
 */
export function bind(form, scene, remember, changed) {
  let before = null;
  form.addEventListener('submit', (event) => event.preventDefault());
  // Some controls of the form stand elsewhere on the page.
  document.addEventListener('input', ({ target }) => {
    const control = /** @type {HTMLInputElement} */ (target);
    const now = scene();
    if (control.form !== form || !(control.name in now)) return;
    before ??= structuredClone(now);
    const value = read(control, now[control.name]);
    if (Number.isNaN(value)) return;
    now[control.name] = value;
    say(control);
    changed(control.name);
  });
  document.addEventListener('change', ({ target }) => {
    const control = /** @type {HTMLInputElement} */ (target);
    if (!before || control.form !== form) return;
    remember(before);
    before = null;
  });
}

/** Reads a control; numbers are kept within its limits. @param {HTMLInputElement} control */
function read(control, was) {
  if (control.type === 'checkbox') return control.checked;
  if (typeof was !== 'number') return control.value;
  const [value, least, most] = [control.valueAsNumber, Number(control.min), Number(control.max)];
  return Math.min(Math.max(value, least), most);
}

/** Shows the value of a slider. @param {HTMLInputElement} control */
function say(control) {
  const output = control.type === 'range' && control.parentElement.querySelector('.value');
  if (output) output.textContent = control.value;
}

/** @param {HTMLFormElement} form @param {any} scene */
export function show(form, scene) {
  for (const control of /** @type {Iterable<HTMLInputElement>} */ (/** @type {unknown} */ (form.elements))) {
    if (!(control.name in scene)) continue;
    if (control.type === 'checkbox') control.checked = scene[control.name];
    else control.value = String(scene[control.name]);
    say(control);
  }
}

/**
 * @param {HTMLSelectElement} select
 * @param {[string, string][]} choices value and name of each
 * @param {string} value
 */
export function options(select, choices, value) {
  select.replaceChildren(...choices.map(([of, name]) => new Option(name, of, false, of === value)));
}

/** Returns a choice whose value is its name. @param {string} name @returns {[string, string]} */
export const same = (name) => [name, name];
