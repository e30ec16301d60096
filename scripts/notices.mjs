// `npm run notices`: lists all packages that npm installs with furrow-cli in THIRD_PARTY_NOTICES.md, with the texts of
// their licences. Packages that npm installs only on some platforms are listed without texts.

import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Failure, main, ROOT } from './lib/run.mjs'

const PACKAGE = 'packages/cli'
const TARGET = join(ROOT, PACKAGE, 'THIRD_PARTY_NOTICES.md')

/**
 * Folder with licences for packages that ship none. The licences are copied from the repositories of the packages. A
 * file has the name of its package.
 */
const LICENCES = join(ROOT, 'scripts/licences')

/** Markdown fence around a licence. It is longer than all fences inside licences. */
const FENCE = '````'

const { packages } = JSON.parse(readFileSync(join(ROOT, 'package-lock.json'), 'utf8'))

await main(() => {
  const [, , target = TARGET] = process.argv
  writeFileSync(target, notices(listInstalled()))
})

/**
 * Returns all direct and indirect dependencies, sorted by name and version. `path` is the folder of the package, relative
 * to the root of the repository. The other properties are from package-lock.json.
 */
function listInstalled() {
  const found = new Map()
  const visit = (from) => {
    const { dependencies, peerDependencies, peerDependenciesMeta, optionalDependencies } = packages[from]
    for (const name of Object.keys({ ...dependencies, ...peerDependencies, ...optionalDependencies })) {
      if (peerDependenciesMeta?.[name]?.optional) continue
      const path = resolvePackage(name, from)
      if (found.has(path)) continue
      found.set(path, { name, path, ...packages[path] })
      visit(path)
    }
  }
  visit(PACKAGE)
  const key = ({ name, version }) => `${name} ${version}`
  return [...found.values()].sort((a, b) => (key(a) < key(b) ? -1 : 1))
}

/**
 * Resolves a dependency as Node does: first in node_modules of the package itself, then in node_modules of its parent
 * folders.
 */
function resolvePackage(name, from) {
  for (let folder = from; ; folder = folder.replace(/\/?[^/]*$/, '')) {
    const path = join(folder, 'node_modules', name).replaceAll('\\', '/')
    if (packages[path]) return path
    if (folder === '') throw new Failure(`${from} depends on ${name}, which package-lock.json does not list`)
  }
}

function notices(installed) {
  const everywhere = installed.filter(({ optional }) => !optional)
  const somewhere = installed.filter(({ optional }) => optional)
  const list = (entries) => entries.map(({ name, version, license }) => `- ${name} ${version}: ${license}`)
  const lines = [
    '# Third-party notices',
    'npm installs these packages with `furrow-cli`. `dist/page/LICENSES.md` lists the packages whose code is in `dist/page`.',
    list(everywhere).join('\n'),
    'npm installs these packages only on some platforms:',
    list(somewhere).join('\n'),
    ...[...byText(everywhere)].map(
      ([text, names]) => `## ${[...names].join(', ')}\n\n${FENCE}text\n${text}\n${FENCE}`,
    ),
  ]
  return `${lines.join('\n\n')}\n`
}

/** Groups the names of packages by the text of their licences. */
function byText(entries) {
  const texts = new Map()
  for (const entry of entries) {
    const text = readLicence(entry)
    texts.set(text, (texts.get(text) ?? new Set()).add(entry.name))
  }
  return texts
}

/** Reads the licence and notices of a package. If the package ships none, reads them from `scripts/licences`. */
function readLicence({ name, path }) {
  const folder = join(ROOT, path)
  const files = readdirSync(folder)
    .sort()
    .filter((file) => /^(licen[cs]e|copying|notices?|third.*notices?)\b/i.test(file))
    .map((file) => join(folder, file))
  const own = join(LICENCES, `${name}.txt`)
  if (files.length === 0 && existsSync(own)) files.push(own)
  if (files.length === 0)
    throw new Failure(`${name} ships no licence; add it as scripts/licences/${name}.txt`)
  return files.map((file) => readFileSync(file, 'utf8').replaceAll('\r', '').trimEnd()).join('\n\n')
}
