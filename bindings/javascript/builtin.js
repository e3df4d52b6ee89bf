// SPDX-License-Identifier: MIT
//
// What only Node has, asked for where nothing else will do: those who bundle for a browser need not know of it.

/** @param {string} name @returns {Promise<any>} */
export const builtin = (name) => import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${name}`);
