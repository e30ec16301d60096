import { execFile } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseWrinkleSetDocument } from 'furrow'
import { describe, expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const TSC = join(ROOT, 'node_modules/typescript/bin/tsc')
const PAGES = [
  'README.md',
  'CONTRIBUTING.md',
  'SECURITY.md',
  'CODE_OF_CONDUCT.md',
  'site/README.md',
  'godot/README.md',
  'packages/furrow/README.md',
  'packages/cli/README.md',
  ...readdirSync(join(ROOT, 'docs'))
    .filter((file) => file.endsWith('.md'))
    .map((file) => `docs/${file}`),
]

/** Pages of the generated API reference. */
const REFERENCE = [
  'README.md',
  ...Object.keys(JSON.parse(readFileSync(join(ROOT, 'packages/furrow/package.json'), 'utf8')).exports).map(
    (entry) => `furrow${entry.slice(1).replaceAll('/', '.')}.md`,
  ),
]

const read = (path: string) => readFileSync(join(ROOT, path), 'utf8')

/** Returns the fenced code blocks of one language on a page. */
function blocks(page: string, language: string): string[] {
  return [...read(page).matchAll(new RegExp(`^\`\`\`${language}\n([\\s\\S]*?)^\`\`\`$`, 'gm'))].map(
    (match) => match[1],
  )
}

describe('documentation', () => {
  it('shows examples/minimal.html in the README, without its meta tags, in at most 25 lines', () => {
    const page = read('examples/minimal.html').replace(/<meta name="(description|keywords|group)".*\n/g, '')
    expect(blocks('README.md', 'html')).toEqual([page])
    expect(page.trimEnd().split('\n').length).toBeLessThanOrEqual(25)
  })

  it('has examples, and recipes for Svelte and Vue, all of which compile', async () => {
    const [plain, react] = [examplesIn('ts'), examplesIn('tsx')]
    expect(plain.size).toBeGreaterThan(3)
    expect(react.size).toBeGreaterThan(3)
    const recipes = ['svelte', 'vue'].flatMap((language) =>
      blocks('docs/frameworks.md', language).map((text, i): [string, string] => [
        `recipe-${language}-${i}.ts`,
        /<script[^>]*>([\s\S]*?)<\/script>/.exec(text)![1],
      ]),
    )
    expect(recipes).toHaveLength(3)
    const errors = await compile(new Map([...plain, ...react, ...recipes]))
    // Ignores unused declarations in recipes, because the template of the component uses them.
    expect(errors.filter((line) => !/recipe-.*: error TS(6133|6192|6196):/.test(line))).toEqual([])
  })

  it('has a wrinkles.json that parses', () => {
    const [document] = blocks('docs/guide.md', 'json')
    expect(parseWrinkleSetDocument(JSON.parse(document)).areas.map(({ name }) => name)).toEqual([
      'foreheadLeft',
      'glabella',
    ])
  })

  it.each(PAGES)('%s passes --yes wherever npx may download a package', (page) => {
    expect(read(page)).not.toMatch(/npx (?=\S*(furrow-cli|http-server))(?!--yes )/)
  })

  it.each(PAGES)('%s links to existing files', (page) => {
    const links = [...read(page).matchAll(/\]\((?!https?:|#)([^)#]+)\)/g)].map((match) => match[1])
    for (const link of links) {
      // The API reference is generated and not in the repository. It has a page per entry point.
      if (/^(\.\.\/|\.\/)*(docs\/)?api\//.test(link)) {
        expect(REFERENCE, `${page}: ${link}`).toContain(link.replace(/^.*api\//, ''))
        continue
      }
      const target = resolve(ROOT, dirname(page), link)
      expect(existsSync(target), `${page}: ${link}`).toBe(true)
    }
  })

  it.each(PAGES)('%s names existing paths', (page) => {
    const missing = pathsIn(page).filter(
      (path) => ![...SOURCE_ROOTS, dirname(page)].some((folder) => isPresent(join(ROOT, folder, path))),
    )
    expect(missing).toEqual([])
  })
})

/** Folders to which paths in documents may be relative, besides the folder of the document. */
const SOURCE_ROOTS = ['', 'packages/furrow/src']

/** Paths that exist only after a build. */
const GENERATED = /^(docs\/(api|.*\.html)|site\/dist|faces\/\.venv|blender\/\.venv)/

/** Finds a page's code spans that are paths in the repository: they begin with one of its folders, or name a source file. */
function pathsIn(page: string): string[] {
  const folders = readdirSync(ROOT).filter((name) => name !== 'node_modules')
  return [...read(page).matchAll(/`([\w.@<>*-]+(?:\/[\w.@<>*-]+)+)\/?`/g)]
    .map(([, path]) => path)
    .filter((path) => folders.includes(path.split('/')[0]) || /\.(ts|tsx|mjs|py)$/.test(path))
    .filter((path) => !GENERATED.test(path))
}

/** Tells whether a file or folder exists. For a pattern, checks the folder before the first wildcard. */
function isPresent(path: string): boolean {
  return existsSync(path.replace(/\/[^/]*[*<].*$/, ''))
}

/** Returns all code blocks of one language, by the file name under which they are compiled. */
function examplesIn(language: string): Map<string, string> {
  const name = (page: string, i: number) => `${page.replaceAll('/', '-')}-${i}.${language}`
  return new Map(PAGES.flatMap((page) => blocks(page, language).map((text, i) => [name(page, i), text])))
}

/** Type-checks texts as files of the project. Returns the lines that the compiler prints. */
async function compile(files: Map<string, string>): Promise<string[]> {
  const folder = mkdtempSync(join(ROOT, 'test/unit/.examples-'))
  try {
    for (const [name, text] of files) writeFileSync(join(folder, name), text)
    const compilerOptions = { jsxImportSource: 'react' }
    // Lists the files, because patterns skip folders whose name begins with a dot.
    const config = {
      extends: '../../../tsconfig.json',
      compilerOptions,
      files: [...files.keys(), '../frameworks.d.ts'],
      include: [],
    }
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config))
    const printed = await new Promise<string>((done) =>
      execFile(process.execPath, [TSC, '-p', folder], (_error, stdout, stderr) => done(stdout + stderr)),
    )
    return printed.split('\n').filter((line) => line !== '')
  } finally {
    rmSync(folder, { recursive: true })
  }
}
