import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Plugin } from 'vite'

/** Change of an expression or statement within one source line. */
export interface Mutant {
  id: number
  file: string
  /** Text of the line, without indentation. */
  line: string
  /** Index of the line among equal lines of the file; default 0. */
  nth?: number
  /** Column where the changed text begins. The indentation does not count. */
  at: number
  was: string
  becomes: string
  kind: string
  isStatement?: boolean
}

/** Mutant with the current position of its text. */
export interface FoundMutant extends Mutant {
  path: string
  /** Index of the changed text within the file's text. */
  start: number
}

const SOURCES = ['packages/furrow/src', 'packages/cli/src', 'packages/files/src']

/** Locates each mutant in its file, or else at the only equal line of all sources. Mutants without exactly one such line are lost. */
export function findMutants(
  mutants: readonly Mutant[],
  root: string,
): { found: FoundMutant[]; lost: Mutant[] } {
  const texts = new Map(SOURCES.flatMap((folder) => textsIn(root, folder)))
  const found: FoundMutant[] = []
  const lost: Mutant[] = []
  for (const mutant of mutants) {
    const start = startOf(mutant, texts.get(mutant.file) ?? '', mutant.nth ?? 0)
    const others = [...texts].flatMap(([path, text]) => {
      const starts = [0, 1, 2, 3]
        .map((nth) => startOf(mutant, text, nth))
        .filter((each) => each !== undefined)
      return starts.length === 1 ? [{ path, start: starts[0] }] : starts.map(() => ({ path: '', start: 0 }))
    })
    if (start !== undefined) found.push({ ...mutant, path: mutant.file, start })
    else if (others.length === 1 && others[0].path !== '') found.push({ ...mutant, ...others[0] })
    else lost.push(mutant)
  }
  return { found, lost }
}

function textsIn(root: string, folder: string): [string, string][] {
  const names = ((): string[] => {
    try {
      return readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
    } catch {
      return []
    }
  })()
  const sources = names.filter((name) => name.endsWith('.ts')).map((name) => `${folder}/${name}`)
  return sources.map((path) => [path, readFileSync(join(root, path), 'utf8')])
}

/** Returns the index at which the text to change begins, or undefined if the file has no matching line. */
function startOf({ line, at, was }: Mutant, text: string, nth: number): number | undefined {
  let begin = 0
  for (const each of text.split('\n')) {
    const indent = each.length - each.trimStart().length
    if (each.trim() === line && nth-- === 0) {
      const start = begin + indent + at
      return text.startsWith(was, start) ? start : undefined
    }
    begin += each.length + 1
  }
  return undefined
}

/**
 * Applies mutants to modules while they load.
 *
 * @param only id of the only mutant to apply. By default all are applied, and `furrowMutant` in `switch.ts` decides which is active.
 */
export function mutate(mutants: readonly FoundMutant[], root: string, only?: number): Plugin {
  const chosen = only === undefined ? mutants : mutants.filter(({ id }) => id === only)
  return {
    name: 'furrow-mutants',
    enforce: 'pre',
    transform(code, id) {
      const path = id.split('?')[0].slice(root.length).replace(/^\//, '')
      const own = chosen.filter((mutant) => mutant.path === path)
      if (own.length === 0) return undefined
      let text = code
      for (const { id, start, was, becomes, isStatement } of own.toSorted((a, b) => b.start - a.start)) {
        if (!text.startsWith(was, start)) throw new Error(`${path}: the text of mutant ${id} has moved`)
        const switched = `(globalThis.furrowMutant?.(${id}) ? (${becomes}) : (${was}))`
        // Without `void`, a statement that starts with a bracket would continue the previous line.
        const instead = only !== undefined ? becomes : isStatement ? `void ${switched}` : switched
        text = text.slice(0, start) + instead + text.slice(start + was.length)
      }
      return { code: text, map: null }
    },
  }
}
