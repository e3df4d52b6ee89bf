// SPDX-License-Identifier: MIT
//
// Writes the types of puzzles, shots, answers and recordings from the engine's schema:
//   node types.mjs PACKAGE_FOLDER > documents.d.ts
import { pathToFileURL } from 'node:url';

const { load } = await import(pathToFileURL(`${process.argv[2]}/index.js`).href);
const engine = await load();

const pascal = (name) => name.replace(/(^|_)[a-z]/g, (start) => start.at(-1).toUpperCase());

function list({ items, minItems, maxItems }) {
  if (minItems === undefined) return `Array<${type(items)}>`;
  if (minItems !== maxItems) throw new Error(`no type for lists from ${minItems} to ${maxItems} long`);
  return `[${Array(minItems).fill(type(items)).join(', ')}]`;
}

const plain = { number: 'number', integer: 'number', string: 'string', boolean: 'boolean', null: 'null' };

/** Converts a part of a schema to TypeScript. An unknown construct is an error, not `any`. */
function type(schema) {
  if (schema === true || Object.keys(schema).every((key) => ['description', 'examples', 'default'].includes(key)))
    return 'unknown';
  if (schema.$ref) return pascal(schema.$ref.replace('#/$defs/', ''));
  if (schema.anyOf) return schema.anyOf.map(type).join(' | ');
  if (schema.enum) return schema.enum.map((word) => JSON.stringify(word)).join(' | ');
  if ('const' in schema) return JSON.stringify(schema.const);
  if (schema.type === 'array') return list(schema);
  if (schema.type === 'object') return `Record<string, ${type(schema.additionalProperties)}>`;
  const all = [schema.type].flat().map((name) => plain[name]);
  if (all.includes(undefined)) throw new Error(`no type for ${JSON.stringify(schema)}`);
  return all.join(' | ');
}

const told = (indent, text) => (text ? `${indent}/** ${text.replaceAll('*/', '* /')} */\n` : '');

function member([name, schema], needed) {
  return `${told('  ', schema.description)}  ${JSON.stringify(name)}${needed.includes(name) ? '' : '?'}: ${type(schema)};\n`;
}

function object(name, { description, properties, required = [] }) {
  const members = Object.entries(properties).map((one) => member(one, required));
  return `${told('', description)}export interface ${pascal(name)} {\n${members.join('')}}\n`;
}

/** @type {Map<string, string>} by name, which means the same object in every document */
const objects = new Map();
for (const document of ['puzzle', 'shot', 'answer', 'recording']) {
  const { $defs, ...schema } = engine.schema(document);
  objects.set(document, object(document, schema));
  for (const [name, one] of Object.entries($defs)) objects.set(name, object(name, one));
}
process.stdout.write(['// By bankshot schema; docs/format.md tells more.\n', ...objects.values()].join('\n'));
