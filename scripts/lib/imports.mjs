import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, relative, resolve, sep } from 'node:path'
import ts from 'typescript'
import { ROOT } from './run.mjs'

/** Folders of builds and installed packages. */
const SKIPPED = /(^|\/)(node_modules|dist|cache|\.venv[^/]*)$|^site\/pages$/

/**
 * Reads what each code file of some folders imports, types included.
 *
 * @param {string[]} folders relative to the root of the repository.
 * @returns {{ path: string, imports: string[] }[]} paths and imported files relative to the root; packages by their specifiers.
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
  const { importedFiles } = ts.preProcessFile(readFileSync(join(ROOT, path), 'utf8'), true, true)
  return importedFiles.map(({ fileName }) => {
    if (!fileName.startsWith('.')) return fileName
    const file = relative(ROOT, resolve(ROOT, dirname(path), fileName))
    return file.replaceAll(sep, '/')
  })
}
