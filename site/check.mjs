// `npm run site:check`: checks the built site. Linkinator checks links, and Lighthouse checks performance,
// accessibility and best practices. npx fetches both programs, because package.json should not contain their 300
// packages.

import { execFile } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { mkdtemp, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from '../scripts/lib/browser.mjs'
import { Failure, main, ROOT, run, say } from '../scripts/lib/run.mjs'
import { serveSite } from './serve.mjs'

const LINKINATOR = 'linkinator@7.6.1'
const LIGHTHOUSE = 'lighthouse@12.8.2'

/** Pages that Lighthouse checks, each with the minimum score that it must have in every category, 0..100. */
const PAGES = [
  ['docs/guide.html', 95],
  ['docs/api/furrow.three.html', 95],
  ['', 90],
]
const CATEGORIES = ['performance', 'accessibility', 'best-practices']

/** Runs Chromium without a display, and without its sandbox, which containers do not allow. */
const FLAGS = '--headless=new --no-sandbox --enable-unsafe-swiftshader'

await main(async () => {
  const server = await serveSite()
  const folder = await mkdtemp(join(tmpdir(), 'furrow-site-'))
  try {
    const problems = [
      ...(await checkLinks(server.address, folder)),
      ...(await checkPages(server.address, folder)),
    ]
    if (problems.length > 0) throw new Failure(`site: ${problems.join('; ')}`)
    say('site: no broken link, all scores high enough')
  } finally {
    await rm(folder, { recursive: true })
    await server.close()
  }
})

/** Follows all links between pages of the site, but no links to other sites. Checks that the targets of fragments exist. */
async function checkLinks(address, folder) {
  const config = join(folder, 'linkinator.json')
  const others = `^(?!${address})`
  await writeFile(config, JSON.stringify({ recurse: true, checkFragments: true, skip: others }))
  const words = ['npx', '-y', LINKINATOR, address, '--config', config, '--format', 'json']
  const { links } = JSON.parse(await outputOf(words))
  const broken = links.filter(({ state }) => state === 'BROKEN')
  say(`links     ${links.length} checked, ${broken.length} broken`)
  for (const { url, parent, status } of broken) say(`  ${status} ${url} on ${parent}`)
  return broken.length > 0 ? [`${broken.length} broken links`] : []
}

async function checkPages(address, folder) {
  process.env.CHROME_PATH = await ensureBrowser()
  const problems = []
  for (const [i, [page, minimum]] of PAGES.entries()) {
    const output = join(folder, `page-${i}.json`)
    const only = `--only-categories=${CATEGORIES.join(',')}`
    const words = ['npx', '-y', LIGHTHOUSE, `${address}${page}`, only, `--chrome-flags=${FLAGS}`, '--quiet']
    if ((await run([...words, '--output=json', `--output-path=${output}`], { quiet: true })) !== 0) {
      throw new Failure(`Lighthouse failed on ${page || 'the first page'}`)
    }
    const { categories, audits } = JSON.parse(readFileSync(output, 'utf8'))
    const scores = CATEGORIES.map((name) => Math.round(100 * categories[name].score))
    const of = (name) => audits[name].displayValue
    const times = `paint ${of('largest-contentful-paint')}, blocked ${of('total-blocking-time')}, shift ${of('cumulative-layout-shift')}`
    say(
      `${(page || 'first page').padEnd(28)} ${CATEGORIES.map((name, k) => `${name} ${scores[k]}`).join(', ')}; ${times}`,
    )
    if (scores.some((score) => score < minimum))
      problems.push(`${page || 'first page'} scores less than ${minimum}`)
    for (const name of CATEGORIES) {
      const lost = categories[name].auditRefs.filter(
        ({ id, weight }) => weight > 0 && (audits[id].score ?? 1) < 0.9,
      )
      for (const { id } of lost) say(`  ${name}: ${audits[id].title}`)
    }
  }
  return problems
}

/**
 * Runs a program and returns its output. Ignores the exit code: Linkinator fails if links are broken, but its JSON
 * lists these links.
 */
function outputOf([program, ...words]) {
  return new Promise((done) => {
    execFile(program, words, { cwd: ROOT, maxBuffer: 1 << 28 }, (_, stdout) => done(stdout))
  })
}
