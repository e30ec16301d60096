// Maps files of the repository to pages of the site. A page keeps the path of its file, so relative links between pages
// stay valid.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs'
import { posix } from 'node:path'
import { join } from 'node:path/posix'
import { ROOT } from '../scripts/lib/run.mjs'

/** Folders in which all Markdown files become pages. */
const FOLDERS = ['docs', 'docs/api', 'bench', 'faces', 'faces/human', 'faces/human-2', 'godot']
/** In the direct subfolders of these folders, all Markdown files become pages too. */
const SUBFOLDERS = ['bench']
/** Other Markdown files that become pages. */
const SINGLE = [
  'README.md',
  'CONTRIBUTING.md',
  'CHANGELOG.md',
  'SECURITY.md',
  'CODE_OF_CONDUCT.md',
  'studio/README.md',
]

/** Files that the site serves unchanged, because pages link to them. */
const PUBLIC = /^docs\/schema\/.*\.json$/

/** Folders of applications, each with the path of its start page on the site. */
const APPLICATIONS = new Map([['studio', 'studio/index.html']])

/** Returns the Markdown files of the repository that become pages. */
export function pageFiles() {
  const below = SUBFOLDERS.flatMap((folder) =>
    readdirSync(join(ROOT, folder), { withFileTypes: true })
      .filter((entry) => entry.isDirectory())
      .map(({ name }) => `${folder}/${name}`),
  )
  // docs/api exists only after `npm run api`.
  const present = [...FOLDERS, ...below].filter((folder) => existsSync(join(ROOT, folder)))
  const found = present.flatMap((folder) =>
    readdirSync(join(ROOT, folder))
      .filter((name) => name.endsWith('.md'))
      .map((name) => `${folder}/${name}`),
  )
  return [...SINGLE.filter((file) => existsSync(join(ROOT, file))), ...found]
}

/**
 * Returns the path of a Markdown file's page on the site. The README of a folder becomes index.md, and the README of
 * the repository becomes overview.md.
 */
export function pageOf(file) {
  if (file === 'README.md') return 'overview.md'
  return file.replace(/(^|\/)README\.md$/, '$1index.md')
}

/** Returns the path of the Markdown file that becomes the given page. This is the inverse of `pageOf`. */
export function fileOf(page) {
  if (page === 'overview.md') return 'README.md'
  return /\/index\.md$/.test(page) ? page.replace(/index\.md$/, 'README.md') : page
}

/**
 * Converts a relative link in a file of the repository to a link on the site.
 *
 * @param {string} file file that contains the link.
 * @param {string} link relative link, with or without a fragment.
 * @returns {{ href: string, isExternal?: true } | undefined} `isExternal` is true if the target is on the site, but
 *   is not a page of VitePress. The result is undefined if the target is not on the site and package.json names no
 *   repository.
 */
export function resolveLink(file, link) {
  const [path, fragment] = link.split(/(?=#)/)
  const target = join(posix.dirname(file), path).replace(/\/$/, '')
  const from = posix.dirname(pageOf(file))
  const to = (path, more) => ({ href: `./${posix.relative(from, path)}${fragment ?? ''}`, ...more })
  if (pages.has(target)) return to(pageOf(target))
  if (pages.has(`${target}/README.md`) && !APPLICATIONS.has(target)) return to(pageOf(`${target}/README.md`))
  const [, example] = /^examples\/([\w-]+)\.html$/.exec(target) ?? []
  if (example) return to(`examples/${example}.md`)
  if (target === 'examples') return to('examples/index.md')
  if (APPLICATIONS.has(target)) return to(APPLICATIONS.get(target), { isExternal: true })
  if (PUBLIC.test(target)) return to(target, { isExternal: true })
  const address = repositoryAddress()
  if (!address) return undefined
  const isFolder = statSync(join(ROOT, target)).isDirectory()
  return { href: `${address}/${isFolder ? 'tree' : 'blob'}/HEAD/${target}${fragment ?? ''}` }
}

const pages = new Set(pageFiles())

/** Returns the web address of the repository from package.json. Returns undefined if package.json names none. */
export function repositoryAddress() {
  const { repository } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'))
  return (repository?.url ?? repository)?.replace(/^git\+/, '').replace(/\.git$/, '')
}
