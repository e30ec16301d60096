// Where files of the repository are on the site. Pages keep their folders, so that links between them stay as they are written.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs'
import { posix } from 'node:path'
import { join } from 'node:path/posix'
import { ROOT } from '../scripts/lib/run.mjs'

/** Folders of which every Markdown file is a page, and single pages. */
const FOLDERS = [
  'docs',
  'docs/api',
  'bench',
  'faces',
  'faces/human',
  'faces/human-2',
  'faces/hand',
  'faces/neck',
]
const SUBFOLDERS = ['bench']
const SINGLE = [
  'README.md',
  'CONTRIBUTING.md',
  'CHANGELOG.md',
  'SECURITY.md',
  'CODE_OF_CONDUCT.md',
  'studio/README.md',
]

/** Files that pages link to, and that are on the site as they are. */
const PUBLIC = /^docs\/schema\/.*\.json$/

/** Folders of the repository that are applications on the site. */
const APPLICATIONS = new Map([['studio', 'studio/index.html']])

/** Markdown files of the repository that are pages of the site. */
export function pageFiles() {
  const below = SUBFOLDERS.flatMap((folder) =>
    readdirSync(join(ROOT, folder), { withFileTypes: true })
      .filter((entry) => entry.isDirectory())
      .map(({ name }) => `${folder}/${name}`),
  )
  // The API reference is only there once it was generated.
  const present = [...FOLDERS, ...below].filter((folder) => existsSync(join(ROOT, folder)))
  const found = present.flatMap((folder) =>
    readdirSync(join(ROOT, folder))
      .filter((name) => name.endsWith('.md'))
      .map((name) => `${folder}/${name}`),
  )
  return [...SINGLE.filter((file) => existsSync(join(ROOT, file))), ...found]
}

/** Names of the examples: `minimal` is examples/minimal.html. */
export function exampleNames() {
  return readdirSync(join(ROOT, 'examples'))
    .filter((name) => name.endsWith('.html'))
    .map((name) => name.slice(0, -'.html'.length))
    .sort()
}

/** The page of a Markdown file, relative to the site: a folder's README is its index, the repository's own an overview. */
export function pageOf(file) {
  if (file === 'README.md') return 'overview.md'
  return file.replace(/(^|\/)README\.md$/, '$1index.md')
}

/** The file of the repository that a page is made of. */
export function fileOf(page) {
  if (page === 'overview.md') return 'README.md'
  return /\/index\.md$/.test(page) ? page.replace(/index\.md$/, 'README.md') : page
}

/**
 * Where a link in a file of the repository leads on the site.
 *
 * @param {string} file the file with the link.
 * @param {string} link relative, with or without a fragment.
 * @returns {{ href: string, leaves?: true } | undefined} `leaves`: to something that is no page. Undefined where the site does not have it and
 *   nobody knows the repository's address.
 */
export function targetOf(file, link) {
  const [path, fragment] = link.split(/(?=#)/)
  const target = join(posix.dirname(file), path).replace(/\/$/, '')
  const from = posix.dirname(pageOf(file))
  const to = (place, more) => ({ href: `./${posix.relative(from, place)}${fragment ?? ''}`, ...more })
  if (pages.has(target)) return to(pageOf(target))
  if (pages.has(`${target}/README.md`) && !APPLICATIONS.has(target)) return to(pageOf(`${target}/README.md`))
  const [, example] = /^examples\/([\w-]+)\.html$/.exec(target) ?? []
  if (example) return to(`examples/${example}.md`)
  if (target === 'examples') return to('examples/index.md')
  if (APPLICATIONS.has(target)) return to(APPLICATIONS.get(target), { leaves: true })
  if (PUBLIC.test(target)) return to(target, { leaves: true })
  const address = repositoryAddress()
  if (!address) return undefined
  const isFolder = statSync(join(ROOT, target)).isDirectory()
  return { href: `${address}/${isFolder ? 'tree' : 'blob'}/HEAD/${target}${fragment ?? ''}` }
}

const pages = new Set(pageFiles())

/** The repository's address for readers, as package.json has it; undefined while it has none. */
export function repositoryAddress() {
  const { repository } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'))
  return (repository?.url ?? repository)?.replace(/^git\+/, '').replace(/\.git$/, '')
}
