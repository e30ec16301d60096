// Tests the built command `furrow batch`, which runs its jobs in separate processes.

import { readdirSync, readFileSync, statSync } from 'node:fs'
import { cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { setTimeout as sleep } from 'node:timers/promises'
import { pathToFileURL } from 'node:url'
import { decodeGlb } from 'furrow-files'
import type { Browser, Page } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { batchPage } from '../../packages/cli/src/batch/report/page.ts'
import type { ResultLine } from '../../packages/cli/src/batch/results.ts'
import { isCompleteGlb, makeFaces } from '../batch/faces.ts'
import { sheet, sheetGlb } from '../unit/cli/sheet.ts'
import { openBrowser, openPage } from './browser.ts'
import { runFurrow, startFurrow } from './run-furrow.ts'

let root: string
let face: Uint8Array

beforeAll(async () => {
  root = await mkdtemp(join(tmpdir(), 'furrow-batch-'))
  ;[face] = await makeFaces(1)
})
afterAll(() => rm(root, { recursive: true }))

/** Creates a folder whose subfolder `in` contains `count` faces. */
async function inputs(name: string, count: number): Promise<string> {
  const folder = join(root, name)
  await mkdir(join(folder, 'in'), { recursive: true })
  const faces = await makeFaces(count)
  await Promise.all(faces.map((bytes, i) => writeFile(join(folder, 'in', `${i}.glb`), bytes)))
  return folder
}

const batch = (folder: string, ...words: string[]) =>
  runFurrow(folder, {}, 'batch', ...words, '--thumbnails', '0', '--json')

const options = ['-o', 'out', '--size', '512']

const linesOf = (folder: string, file = 'out/results.jsonl'): ResultLine[] =>
  readFileSync(join(folder, file), 'utf8')
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line))

/** Lists the outputs in a folder and checks that all are complete. */
function outputs(folder: string): string[] {
  const names = readdirSync(join(folder, 'out')).filter((name) => name.endsWith('.glb'))
  for (const name of names) expect(isCompleteGlb(readFileSync(join(folder, 'out', name)))).toBe(true)
  return names.sort()
}

describe('a batch', () => {
  it('processes every input once, collects failures, and repeats only inputs whose output was deleted', async () => {
    const folder = await inputs('whole', 3)
    await cp(join(folder, 'in/0.glb'), join(folder, 'in/copy.glb'))
    await writeFile(join(folder, 'in/broken.glb'), 'text')
    const { code, stdout } = await batch(folder, 'in/*.glb', ...options, '--age', '60')
    expect(code).toBe(1)
    expect(JSON.parse(stdout)).toMatchObject({ inputs: 5, done: 4, failed: 1, shared: 1, kept: 0 })
    expect(outputs(folder)).toEqual(['0.glb', '1.glb', '2.glb', 'copy.glb'])
    const lines = linesOf(folder)
    expect(lines.find(({ status }) => status === 'failed')).toMatchObject({
      input: 'in/broken.glb',
      kind: 'file',
      reason: expect.stringMatching(/^furrow auto: in\/broken\.glb is not usable: it is text/),
    })
    expect(lines.find(({ input }) => input === 'in/copy.glb')!.sameAs).toBe('in/0.glb')
    expect(readFileSync(join(folder, 'out/0.glb'))).toEqual(readFileSync(join(folder, 'out/copy.glb')))
    const page = readFileSync(join(folder, 'out/report.html'), 'utf8')
    expect(page.match(/<tr class="(failed|done|warned)">/g)).toHaveLength(5)
    expect(page).toContain('it is text')

    const again = await batch(folder, 'in/*.glb', ...options, '--age', '60')
    expect(again.code).toBe(1)
    expect(JSON.parse(again.stdout)).toMatchObject({ done: 4, failed: 1, kept: 5 })
    expect(linesOf(folder)).toHaveLength(5)

    await rm(join(folder, 'out/1.glb'))
    const retried = await batch(folder, 'in/*.glb', ...options, '--age', '60')
    expect(JSON.parse(retried.stdout)).toMatchObject({ done: 4, kept: 4 })
    expect(outputs(folder)).toHaveLength(4)
  })

  it('resumes after it was killed, and leaves nothing half-written', async () => {
    const folder = await inputs('killed', 6)
    const words = ['in/*.glb', ...options, '--jobs', '1', '--thumbnails', '0']
    const child = startFurrow(folder, {}, 'batch', ...words)
    const ended = new Promise((done) => child.once('close', done))
    const results = join(folder, 'out/results.jsonl')
    const done = () => {
      try {
        return readFileSync(results, 'utf8').split('\n').length - 1
      } catch {
        return 0
      }
    }
    while (done() < 2 && child.exitCode === null) await sleep(20)
    child.kill('SIGKILL')
    await ended
    const before = done()
    expect(before).toBeLessThan(6)
    expect(outputs(folder).length).toBeGreaterThanOrEqual(before)
    const { code, stdout } = await batch(folder, ...words.slice(0, -2))
    expect(code).toBe(0)
    expect(JSON.parse(stdout)).toMatchObject({ done: 6, kept: before })
    expect(linesOf(folder)).toHaveLength(6)
    expect(outputs(folder)).toHaveLength(6)
  })

  it('ends its processes when interrupted', async () => {
    const folder = await inputs('interrupted', 3)
    const child = startFurrow(folder, {}, 'batch', 'in/*.glb', ...options, '--jobs', '2', '--thumbnails', '0')
    const ended = new Promise((done) => child.once('close', (_, signal) => done(signal)))
    const jobs = () => childrenOf(child.pid!)
    // Two jobs, and the process that watches their temporary folder.
    while (jobs().length < 3) await sleep(20)
    const pids = jobs()
    child.kill('SIGINT')
    expect(await ended).toBe('SIGINT')
    await sleep(500)
    expect(pids.filter(isRunning)).toEqual([])
  })

  it('processes each input exactly once if split by --shard', async () => {
    const folder = await inputs('parts', 4)
    const parts = [1, 2].map((part) => batch(folder, 'in/*.glb', ...options, '--shard', `${part}/2`))
    const counts = (await Promise.all(parts)).map(({ stdout }) => JSON.parse(stdout))
    expect(counts[0].done + counts[1].done).toBe(4)
    expect(outputs(folder)).toHaveLength(4)
  })

  it('reads a manifest with addresses and options per input', async () => {
    const folder = await inputs('listed', 1)
    const asked: string[] = []
    const server = createServer((request, response) => {
      asked.push(`${request.method} ${request.url}`)
      if (request.url !== '/face.glb') return void response.writeHead(404).end()
      response.writeHead(200, { etag: '"1"' }).end(request.method === 'HEAD' ? undefined : face)
    })
    await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
    const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`
    const list = [
      { input: 'in/0.glb', output: 'out/a.glb', options: { age: 70 } },
      { input: `${origin}/face.glb`, output: 'out/b.glb' },
      { input: `${origin}/none.glb`, output: 'out/c.glb' },
    ]
    await writeFile(join(folder, 'list.jsonl'), list.map((line) => JSON.stringify(line)).join('\n'))
    const { code } = await batch(folder, '--manifest', 'list.jsonl', '--results', 'out', '--size', '512')
    server.close()
    expect(code).toBe(1)
    expect(outputs(folder)).toEqual(['a.glb', 'b.glb'])
    expect(linesOf(folder).find(({ status }) => status === 'failed')!.reason).toMatch(
      /none\.glb \(HTTP status 404\)/,
    )
    expect(asked).toEqual(expect.arrayContaining(['HEAD /face.glb', 'GET /face.glb', 'HEAD /none.glb']))
  })
})

describe("a batch's downloads", () => {
  /**
   * Starts a server without ETags. The first download of the face is complete. If `isCompleteGlb` is false, later downloads stall
   * halfway.
   */
  async function serve(bytes: Uint8Array, isCompleteGlb: boolean) {
    const server = createServer((request, response) => {
      response.writeHead(200)
      if (request.method === 'HEAD') return void response.end()
      if (isCompleteGlb || asked++ === 0) return void response.end(bytes)
      response.write(bytes.subarray(0, bytes.length / 2))
    })
    let asked = 0
    await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
    const close = () => {
      server.closeAllConnections()
      server.close()
    }
    return { url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/face.glb`, close }
  }

  /** Creates a temporary folder in which an attacker has placed links to a file, under names that a program might use. */
  async function trap(name: string) {
    const folder = join(root, name)
    const tmp = join(folder, 'tmp')
    await mkdir(tmp, { recursive: true })
    await writeFile(join(folder, 'precious'), 'precious')
    const planted = ['input-1.glb', 'input-2.glb', 'output-1.glb']
    for (const link of planted) await symlink('../precious', join(tmp, link))
    const others = () => readdirSync(tmp).filter((found) => !planted.includes(found))
    const check = () => expect(readFileSync(join(folder, 'precious'), 'utf8')).toBe('precious')
    return { folder, tmp, others, check }
  }

  it.each([
    ['is used', () => face, 0],
    ['is refused', () => Buffer.from('text'), 1],
  ] as const)('are deleted after the file %s', async (name, bytes, expected) => {
    const { folder, tmp, others, check } = await trap(`web ${name}`)
    const { url, close } = await serve(bytes(), true)
    const { code, stderr } = await runFurrow(
      folder,
      { TMPDIR: tmp },
      ...['batch', url, ...options, '--thumbnails', '0'],
    )
    close()
    expect(code, stderr).toBe(expected)
    expect(others()).toEqual([])
    check()
  })

  it.each(['SIGINT', 'SIGKILL'] as const)('are in a private folder, and deleted after %s', async (signal) => {
    const { folder, tmp, others, check } = await trap(`web ${signal}`)
    const { url, close } = await serve(face, false)
    const child = startFurrow(folder, { TMPDIR: tmp }, 'batch', url, ...options, '--thumbnails', '0')
    const ended = new Promise((done) => child.once('close', done))
    const parts = () =>
      others().flatMap((own) => readdirSync(join(tmp, own), { recursive: true }).map(String))
    while (!parts().some((part) => part.endsWith('.glb'))) await sleep(20)
    expect(others().map((own) => statSync(join(tmp, own)).mode & 0o777)).toEqual([0o700])
    child.kill(signal)
    await ended
    close()
    await expect.poll(others).toEqual([])
    check()
  })
})

describe('a job', () => {
  it('is ended if it exceeds the memory or time limit, and the others continue', async () => {
    const folder = await inputs('limits', 1)
    await writeFile(join(folder, 'in/large.glb'), await sheetGlb(sheet(800)))
    const words = ['in/*.glb', ...options, '--jobs', '1']
    const { code } = await batch(folder, ...words, '--memory', '256')
    expect(code).toBe(1)
    expect(linesOf(folder).find(({ input }) => input === 'in/large.glb')).toMatchObject({
      status: 'failed',
      kind: 'memory',
      attempts: 2,
    })
    expect(outputs(folder)).toEqual(['0.glb'])
    await batch(folder, ...words, '--timeout', '1')
    expect(linesOf(folder).at(-1)).toMatchObject({ input: 'in/large.glb', kind: 'time', attempts: 1 })
  })
})

it('a batch of validate or inspect puts its findings into the results', async () => {
  const folder = await inputs('found', 1)
  for (const command of ['validate', 'inspect']) {
    const { code } = await batch(folder, 'in/*.glb', '--command', command, '--results', command)
    expect(code).toBe(0)
  }
  expect(linesOf(folder, 'validate/results.jsonl')[0].result).toMatchObject({ errors: 0 })
  expect(linesOf(folder, 'inspect/results.jsonl')[0].result).toMatchObject({ wrinkles: false })
})

it('many ordinary inputs cause no warning of Node', async () => {
  const folder = await inputs('quiet', 30)
  const bin = Buffer.from(await readFile(join(folder, 'in/0.glb')))
  const { json, bin: data } = decodeGlb(bin, '0.glb', 'test')
  json.images = Array.from({ length: 30 }, (_, i) => ({ uri: `${i}.png` }))
  json.buffers![0].uri = 'face.bin'
  const png = await sharp({ create: { width: 2, height: 2, channels: 3, background: 'gray' } })
    .png()
    .toBuffer()
  for (const { uri } of json.images) await writeFile(join(folder, 'in', uri!), png)
  await writeFile(join(folder, 'in/face.bin'), data)
  await writeFile(join(folder, 'in/face.gltf'), JSON.stringify(json))
  const env = { NODE_OPTIONS: '--trace-warnings --pending-deprecation' }
  const words = ['in/*.{glb,gltf}', '--command', 'inspect', '--results', 'found', '--thumbnails', '0']
  const { code, stderr } = await runFurrow(folder, env, 'batch', ...words)
  expect([code, stderr]).toEqual([0, ''])
  expect(linesOf(folder, 'found/results.jsonl')).toHaveLength(31)
  const sheet = ['in/face.gltf', '--sheet', 'sheet.png']
  expect((await runFurrow(folder, env, 'inspect', ...sheet)).stderr).toBe('')
})

it('thumbnails show the face before and after', async () => {
  const folder = await inputs('drawn', 1)
  const { code } = await runFurrow(folder, {}, 'batch', 'in/*.glb', ...options)
  expect(code).toBe(0)
  const names = readdirSync(join(folder, 'out/thumbnails')).sort()
  expect(names).toEqual([expect.stringMatching(/-after\.webp$/), expect.stringMatching(/-before\.webp$/)])
  const [after, before] = names.map((name) => readFileSync(join(folder, 'out/thumbnails', name)))
  expect(after).not.toEqual(before)
  expect(readFileSync(join(folder, 'out/report.html'), 'utf8')).toContain(`thumbnails/${names[0]}`)
})

it('a batch without a browser succeeds, and its page says why thumbnails are missing', async () => {
  const folder = await inputs('undrawn', 1)
  const { code, stderr } = await runFurrow(
    folder,
    { FURROW_CHROMIUM: '/none' },
    'batch',
    'in/*.glb',
    ...options,
  )
  expect(code).toBe(0)
  expect(stderr).toMatch(
    /^furrow batch: some thumbnails are missing \(furrow: FURROW_CHROMIUM is not a program.*\n$/,
  )
  expect(readFileSync(join(folder, 'out/report.html'), 'utf8')).toContain('Some thumbnails are missing')
})

describe('the results page', () => {
  /** Rows in the initial order of the page: failures first, then by file name. */
  const ROWS = [
    { input: 'in/c10.glb', status: 'failed', kind: 'file', reason: 'it is text', warnings: [], seconds: 0.4 },
    { input: 'in/b.glb', status: 'done', bytes: 9000, warnings: ['odd'], seconds: 12.5, areas: 3 },
    { input: 'in/c2.glb', status: 'done', bytes: 20_000, warnings: [], seconds: 2.25, areas: 12 },
    { input: 'in/d.glb', status: 'done', bytes: 500, warnings: [], seconds: 2.5, areas: 2 },
  ]
  /** Order of the files when sorted by each column, ascending and descending. Two files with equal states keep their order. */
  const SORTED = [
    ['File', 'b c2 c10 d', 'd c10 c2 b'],
    ['State', 'c2 d c10 b', 'b c10 c2 d'],
    ['Found', 'c10 d b c2', 'c2 b d c10'],
    ['Size', 'c10 d b c2', 'c2 b d c10'],
    ['Time', 'c10 c2 d b', 'b d c2 c10'],
  ] as const
  const FIRST = 'c10 b c2 d'
  let browser: Browser
  let address: string

  beforeAll(async () => {
    const lines = ROWS.map(
      ({ areas, ...line }) =>
        ({ command: 'auto', attempts: 1, ...line, ...(areas && { result: { areas } }) }) as ResultLine,
    )
    const path = join(root, 'page.html')
    const html = batchPage({
      command: 'auto',
      lines,
      summary: '3 of 4 done, 1 failed',
      results: 'results.jsonl',
      thumbnails: () => undefined,
      linkTo: (output) => output,
      notes: [],
    })
    await writeFile(path, html)
    address = pathToFileURL(path).href
    browser = await openBrowser()
  })
  afterAll(() => browser.close())

  async function openAt(width: number, height: number): Promise<Page> {
    const { page, complaints } = await openPage(browser, { viewport: { width, height } })
    await page.goto(address)
    expect(complaints).toEqual([])
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    return page
  }

  /** Returns the names of the visible files, in order. */
  async function filesOf(page: Page): Promise<string> {
    const names = await page.locator('tbody tr:not([hidden]) th').allTextContents()
    return names.map((name) => name.replace(/^in\/|\.glb$/g, '')).join(' ')
  }

  it.each(SORTED)('sorts by %s with the mouse, up and down', async (name, up, down) => {
    const page = await openAt(1280, 800)
    expect(await filesOf(page)).toBe(FIRST)
    const head = page.getByRole('columnheader', { name })
    await head.getByRole('button').click()
    expect(await filesOf(page)).toBe(up)
    expect(await head.getAttribute('aria-sort')).toBe('ascending')
    await head.getByRole('button').click()
    expect(await filesOf(page)).toBe(down)
    expect(await head.getAttribute('aria-sort')).toBe('descending')
    expect(await page.locator('[aria-sort]').count()).toBe(1)
    await page.context().close()
  })

  it('can be sorted and filtered by keyboard', async () => {
    const page = await openAt(1280, 800)
    for (const [i, [name, up, down]] of SORTED.entries()) {
      // The first press of Tab reaches the filter in front of the table.
      for (let tabs = i === 0 ? 2 : 1; tabs > 0; tabs--) await page.keyboard.press('Tab')
      expect(await page.evaluate(() => document.activeElement!.textContent)).toBe(name)
      await page.keyboard.press('Enter')
      expect(await filesOf(page)).toBe(up)
      await page.keyboard.press('Space')
      expect(await filesOf(page)).toBe(down)
    }
    await page.getByLabel('Show').focus()
    await page.keyboard.type('failed')
    expect(await filesOf(page)).toBe('c10')
    expect(await page.getByRole('status').textContent()).toBe('1 shown')
    await page.context().close()
  })

  it('can be sorted on a phone, and reset', async () => {
    const page = await openAt(390, 844)
    const order = page.getByLabel('Order')
    for (const [name, up, down] of SORTED) {
      await order.selectOption({ label: `${name}, up` })
      expect(await filesOf(page)).toBe(up)
      await order.selectOption({ label: `${name}, down` })
      expect(await filesOf(page)).toBe(down)
    }
    await order.selectOption({ label: 'failures first' })
    expect(await filesOf(page)).toBe(FIRST)
    // Without a focus, Tab starts at the first control. It must skip the column buttons, which are hidden on a phone.
    await page.evaluate(() => (document.activeElement as HTMLElement).blur())
    for (const name of ['show', 'order']) {
      await page.keyboard.press('Tab')
      expect(await page.evaluate(() => document.activeElement!.id)).toBe(name)
    }
    await page.keyboard.press('Tab')
    expect(await page.evaluate(() => document.activeElement!.tagName)).not.toBe('BUTTON')
    await page.context().close()
  })
})

/** Returns the child processes of a process. Works only on Linux. */
function childrenOf(pid: number): number[] {
  return readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8')
    .trim()
    .split(' ')
    .filter(Boolean)
    .map(Number)
}

function isRunning(pid: number): boolean {
  try {
    // The state Z is a zombie, which has ended but still has an id.
    return !/\) Z /.test(readFileSync(`/proc/${pid}/stat`, 'utf8'))
  } catch {
    return false
  }
}
