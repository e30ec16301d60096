import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, relative, resolve, sep } from 'node:path'
import ts from 'typescript'
import { ROOT } from './run.mjs'

const CODE = /\.(ts|tsx|mjs)$/
const SKIPPED = /(^|\/)(node_modules|dist|\.vitepress|pages)(\/|$)/

/**
 * Reads what each code file of some folders imports, types included.
 *
 * @param {string[]} folders relative to the root of the repository.
 * @returns {{ path: string, imports: string[] }[]} `path` and imported files are relative to the root; packages keep their specifier.
 */
export function readImports(folders) {
  return folders.flatMap((folder) =>
    readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
      .map((path) => `${folder}/${path.split(sep).join('/')}`)
      .filter((path) => CODE.test(path) && !SKIPPED.test(path))
      .sort()
      .map((path) => ({ path, imports: importsOf(path) })),
  )
}

function importsOf(path) {
  const { importedFiles } = ts.preProcessFile(readFileSync(join(ROOT, path), 'utf8'), true, true)
  return importedFiles.map(({ fileName }) =>
    fileName.startsWith('.')
      ? relative(ROOT, resolve(ROOT, dirname(path), fileName))
          .split(sep)
          .join('/')
      : fileName,
  )
}
