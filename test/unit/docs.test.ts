import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseWrinkleSetDocument } from 'furrow'
import ts from 'typescript'
import { describe, expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const PAGES = [
  'README.md',
  'CONTRIBUTING.md',
  'SECURITY.md',
  'CODE_OF_CONDUCT.md',
  'site/README.md',
  'packages/furrow/README.md',
  'packages/cli/README.md',
  ...readdirSync(join(ROOT, 'docs'))
    .filter((file) => file.endsWith('.md'))
    .map((file) => `docs/${file}`),
]

/** Pages of the API reference. */
const REFERENCE = [
  'README.md',
  ...Object.keys(JSON.parse(readFileSync(join(ROOT, 'packages/furrow/package.json'), 'utf8')).exports).map(
    (entry) => `furrow${entry.slice(1).replaceAll('/', '.')}.md`,
  ),
]

const read = (path: string) => readFileSync(join(ROOT, path), 'utf8')

/** Fenced blocks of one language on one page. */
function blocks(page: string, language: string): string[] {
  return [...read(page).matchAll(new RegExp(`^\`\`\`${language}\n([\\s\\S]*?)^\`\`\`$`, 'gm'))].map(
    (match) => match[1],
  )
}

describe('documentation', () => {
  it('has the minimal page in the README as it is, in at most 25 lines', () => {
    const page = read('examples/minimal.html')
    expect(blocks('README.md', 'html')).toEqual([page])
    expect(page.trimEnd().split('\n').length).toBeLessThanOrEqual(25)
  })

  it('has examples that compile', () => {
    const [plain, react] = [examplesIn('ts'), examplesIn('tsx')]
    expect(plain.size).toBeGreaterThan(3)
    expect(react.size).toBeGreaterThan(3)
    expect(compile(new Map([...plain, ...react]))).toEqual([])
  })

  it('has recipes for other frameworks that compile', () => {
    const scripts = ['svelte', 'vue'].flatMap((language) =>
      blocks('docs/frameworks.md', language).map(
        (text) => /<script[^>]*>([\s\S]*?)<\/script>/.exec(text)![1],
      ),
    )
    expect(scripts).toHaveLength(2)
    const files = new Map(scripts.map((text, i) => [join(ROOT, `test/recipe-${i}.ts`), text]))
    // The template uses what the script declares.
    expect(compile(files, { noUnusedLocals: false })).toEqual([])
  })

  it('has a wrinkles.json that parses', () => {
    const [document] = blocks('docs/guide.md', 'json')
    expect(parseWrinkleSetDocument(JSON.parse(document)).areas.map(({ name }) => name)).toEqual([
      'foreheadLeft',
      'glabella',
    ])
  })

  it.each(PAGES)('%s does not let npx ask whether it may download what is not installed', (page) => {
    expect(read(page)).not.toMatch(/npx (?=\S*(furrow-cli|http-server))(?!--yes )/)
  })

  it.each(PAGES)('%s links to files that are there', (page) => {
    const links = [...read(page).matchAll(/\]\((?!https?:|#)([^)#]+)\)/g)].map((match) => match[1])
    for (const link of links) {
      // The reference is generated: a page for each entry of the package.
      if (/^(\.\.\/|\.\/)*(docs\/)?api\//.test(link)) {
        expect(REFERENCE, `${page}: ${link}`).toContain(link.replace(/^.*api\//, ''))
        continue
      }
      const target = resolve(ROOT, dirname(page), link)
      expect(ts.sys.fileExists(target) || ts.sys.directoryExists(target), `${page}: ${link}`).toBe(true)
    }
  })

  it.each(PAGES)('%s names paths that are there', (page) => {
    const missing = pathsIn(page).filter(
      (path) => ![...SOURCE_ROOTS, dirname(page)].some((folder) => isThere(join(ROOT, folder, path))),
    )
    expect(missing).toEqual([])
  })
})

/** Folders that paths in documents begin at. */
const SOURCE_ROOTS = ['', 'packages/furrow/src']

/** Paths that builds make. */
const GENERATED = /^(docs\/(api|.*\.html)|site\/dist|faces\/\.venv|blender\/\.venv)/

/** Paths of the repository among the code spans of a page: in one of its folders, or of a source file. */
function pathsIn(page: string): string[] {
  const folders = readdirSync(ROOT).filter((name) => name !== 'node_modules')
  return [...read(page).matchAll(/`([\w.@<>*-]+(?:\/[\w.@<>*-]+)+)\/?`/g)]
    .map(([, path]) => path)
    .filter((path) => folders.includes(path.split('/')[0]) || /\.(ts|tsx|mjs|py)$/.test(path))
    .filter((path) => !GENERATED.test(path))
}

/** Whether a file or folder is there; of a pattern, the folder before its first wildcard. */
function isThere(path: string): boolean {
  const fixed = path.replace(/\/[^/]*[*<].*$/, '')
  return ts.sys.fileExists(fixed) || ts.sys.directoryExists(fixed)
}

/** All blocks of one language, by the paths that they are compiled at. */
function examplesIn(language: string): Map<string, string> {
  const path = (page: string, i: number) => join(ROOT, `test/${page.replaceAll('/', '-')}-${i}.${language}`)
  return new Map(PAGES.flatMap((page) => blocks(page, language).map((text, i) => [path(page, i), text])))
}

/** Type-checks texts as if they were files of the project; returns what the compiler says. */
function compile(files: Map<string, string>, own: ts.CompilerOptions = {}): string[] {
  const config = ts.readConfigFile(join(ROOT, 'tsconfig.json'), ts.sys.readFile)
  const { options: ofProject } = ts.parseJsonConfigFileContent(config.config, ts.sys, ROOT)
  const options = { ...ofProject, jsxImportSource: 'react', ...own }
  const host = ts.createCompilerHost(options)
  const { readFile, fileExists } = host
  host.readFile = (path) => files.get(path) ?? readFile(path)
  host.fileExists = (path) => files.has(path) || fileExists(path)
  const getSourceFile = host.getSourceFile.bind(host)
  host.getSourceFile = (path, ...rest) => {
    const text = files.get(path)
    return text === undefined
      ? getSourceFile(path, ...rest)
      : ts.createSourceFile(path, text, ts.ScriptTarget.ES2022)
  }
  const types = join(ROOT, 'test/unit/frameworks.d.ts')
  const program = ts.createProgram([...files.keys(), types], options, host)
  // The project's own files are those of the type check.
  return [...files.keys()]
    .flatMap((path) => ts.getPreEmitDiagnostics(program, program.getSourceFile(path)))
    .map(({ file, messageText }) => `${file?.fileName}: ${ts.flattenDiagnosticMessageText(messageText, ' ')}`)
}
