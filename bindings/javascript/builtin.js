// SPDX-License-Identifier: MIT
//
// Imports modules that only Node has. Bundlers for a browser ignore the import.

/** @param {string} name @returns {Promise<any>} */
export const builtin = (name) => import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${name}`);
