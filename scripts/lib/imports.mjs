import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, relative, resolve, sep } from 'node:path'
import { parseSync, Visitor } from 'vite'
import { Failure, ROOT } from './run.mjs'

/** Folders with build outputs, installed packages, and temporary code of `test/unit/docs.test.ts`, which runs at the same time. */
const SKIPPED = /(^|\/)(node_modules|dist|cache|\.venv[^/]*|\.examples-[^/]*)$|^site\/pages$/

/**
 * Returns the imports of all code files in some folders, including type imports.
 *
 * @param {string[]} folders paths relative to the root of the repository.
 * @returns {{ path: string, imports: string[] }[]} files and their imports. Paths are relative to the root. Imports of
 *   packages are specifiers.
 */
export function readImports(folders) {
  return folders.flatMap(codeIn).map((path) => ({ path, imports: importsOf(path) }))
}

function codeIn(folder) {
  return readdirSync(join(ROOT, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = `${folder}/${entry.name}`
    if (entry.isDirectory()) return SKIPPED.test(path) ? [] : codeIn(path)
    return /\.(ts|tsx|mjs)$/.test(entry.name) ? [path] : []
  })
}

function importsOf(path) {
  return importsIn(path, readFileSync(join(ROOT, path), 'utf8')).map(({ specifier }) => {
    if (!specifier.startsWith('.')) return specifier
    const file = relative(ROOT, resolve(ROOT, dirname(path), specifier))
    return file.replaceAll(sep, '/')
  })
}

/**
 * Returns the imports of a module, including type imports.
 *
 * @param {string} name file name. Its extension selects the language.
 * @param {string} text
 * @returns {{ specifier: string, isDynamic: boolean }[]}
 */
export function importsIn(name, text) {
  const { program, errors } = parseSync(name, text)
  if (errors.length > 0) throw new Failure(`${name}: ${errors[0].message}`)
  const found = []
  const add = (isDynamic) => (node) => {
    if (typeof node.source?.value === 'string') found.push({ specifier: node.source.value, isDynamic })
  }
  new Visitor({
    ImportDeclaration: add(false),
    ExportAllDeclaration: add(false),
    ExportNamedDeclaration: add(false),
    TSImportType: add(false),
    ImportExpression: add(true),
  }).visit(program)
  return found
}
