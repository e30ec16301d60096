/** Tests saving projects as files and folders, links that contain the state, two tabs, and the page without a network. */

import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { isDeepStrictEqual } from 'node:util'
import { strFromU8, unzipSync } from 'fflate'
import type { Browser, BrowserContext, Page } from 'playwright-core'
import { type PreviewServer, preview, type ViteDevServer } from 'vite'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { Workshop } from '../unit/cli/workshop.ts'
import { writeAvatars } from './avatars.ts'
import { openBrowser } from './browser.ts'
import { serveStudio } from './opened-studio.ts'
import {
  areaNames,
  chooseTool,
  dropPaths,
  expectValue,
  exportFile,
  openRecent,
  projectCard,
  saveProject,
  showSliders,
  slider,
  waitUntilReady,
} from './studio-page.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const CONFIG = join(ROOT, 'studio/vite.config.ts')
const folder = mkdtempSync(join(tmpdir(), 'furrow-keep-'))
const shop = new Workshop()
let server: ViteDevServer
let browser: Browser
let context: BrowserContext
let page: Page
let address: string

beforeAll(async () => {
  await writeAvatars(folder)
  ;({ server, address } = await serveStudio())
  browser = await openBrowser()
  context = await browser.newContext({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' })
  context.setDefaultTimeout(0)
  page = await openStudio(address)
})

afterAll(async () => {
  await browser?.close()
  await server?.close()
  rmSync(folder, { recursive: true, force: true })
})

async function openStudio(url: string): Promise<Page> {
  const opened = await context.newPage()
  await opened.goto(url)
  await waitUntilReady(opened)
  return opened
}

const errors = (of = page) => of.textContent('#errors')
const button = (name: string | RegExp, of = page) => of.getByRole('button', { name })
const areas = (of = page) => areaNames(of)
const waitForWrinkles = (of = page) => of.getByText('Making wrinkles').waitFor({ state: 'detached' })

async function copyLink(of: Page): Promise<void> {
  await button('Share', of).click()
  await of.getByRole('button', { name: 'Copy link' }).click()
  await of.keyboard.press('Escape')
}

/** Packs a subfolder of the temporary folder with `furrow pack`. */
async function pack(name: string): Promise<Buffer> {
  await shop.run('pack', shop.path(name), '-o', shop.path(`${name}.glb`))
  return readFileSync(shop.path(`${name}.glb`))
}

let names: string[]

test('a project is saved as a .zip, from which furrow pack makes the same bytes as the export', async () => {
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await page.locator('#areas .row').first().waitFor()
  await waitForWrinkles()
  names = await areas()
  const exported = readFileSync(await (await exportFile(page)).path())
  const zip = await saveProject(page)
  expect(zip.suggestedFilename()).toBe('plain.zip')
  await zip.saveAs(join(folder, 'plain.zip'))
  for (const [path, bytes] of Object.entries(unzipSync(readFileSync(join(folder, 'plain.zip'))))) {
    shop.write(path, bytes)
    mkdirSync(dirname(join(folder, path)), { recursive: true })
    writeFileSync(join(folder, path), bytes)
  }
  expect((await pack('plain')).equals(exported)).toBe(true)
})

test.each(['plain.zip', 'plain'])('%s opens with the same work', async (path) => {
  await page.goto(address)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, path)], 'Plain')
  await expect.poll(areas, { timeout: 300_000 }).toEqual(names)
  expect(await page.getByRole('slider', { name: 'Age' }).inputValue()).toBe('45')
  const again = unzipSync(readFileSync(await (await saveProject(page)).path()))
  const before = unzipSync(readFileSync(join(folder, 'plain.zip')))
  expect(Object.keys(again)).toEqual(Object.keys(before))
  // Leaves out maps, which the studio draws again from the strokes.
  const kept = Object.keys(before).filter((name) => !name.startsWith('plain/layers/'))
  const contentOf = (bytes: Uint8Array, name: string) =>
    name.endsWith('.json') ? JSON.parse(strFromU8(bytes)) : Buffer.from(bytes).toString('base64')
  for (const name of kept) {
    // The fields of a JSON file may have another order.
    const isSame = isDeepStrictEqual(contentOf(again[name], name), contentOf(before[name], name))
    expect(isSame, name).toBe(true)
  }
  expect(await errors()).toBe('')
})

test('a project is saved to a folder, and again with one click after a reload', async () => {
  // Tests cannot use the dialog that picks a folder. The replacement returns a folder of the browser's private file system.
  await context.addInitScript(() => {
    Object.assign(globalThis, {
      showDirectoryPicker: async () =>
        (await navigator.storage.getDirectory()).getDirectoryHandle('my project', { create: true }),
    })
  })
  await page.goto(address)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, 'plain.zip')], 'Plain')
  await expect.poll(areas, { timeout: 300_000 }).toEqual(names)
  const face = readFileSync(await (await exportFile(page)).path())
  await projectCard(page)
  await button('Save to folder…').click()
  await page.getByText('Saved to the folder my project').waitFor()
  const written = await readProject()
  const zipped = unzipSync(readFileSync(join(folder, 'plain.zip')))
  expect(Object.keys(written).sort()).toEqual(
    Object.keys(zipped)
      .map((path) => path.slice('plain/'.length))
      .sort(),
  )
  for (const [path, base64] of Object.entries(written))
    shop.write(`disk/${path}`, Buffer.from(base64, 'base64'))
  expect((await pack('disk')).equals(face)).toBe(true)

  await page.reload()
  await waitUntilReady(page)
  await expect.poll(areas, { timeout: 300_000 }).toEqual(names)
  await button('New region').click()
  await projectCard(page)
  await button('Save to my project').click()
  await page.getByText('Saved to the folder my project').waitFor()
  expect(Object.keys(await readProject())).toContain('areas/area.png')
  expect(await errors()).toBe('')
})

/** Reads the files in the picked folder as base64. */
function readProject(): Promise<Record<string, string>> {
  return page.evaluate(async () => {
    const files: Record<string, string> = {}
    const list = async (directory: FileSystemDirectoryHandle, path: string) => {
      for await (const [name, handle] of directory.entries()) {
        if (handle.kind === 'directory') await list(handle as FileSystemDirectoryHandle, `${path}${name}/`)
        else {
          const file = await (handle as FileSystemFileHandle).getFile()
          const bytes = new Uint8Array(await file.arrayBuffer())
          let text = ''
          for (let i = 0; i < bytes.length; i += 8192)
            text += String.fromCharCode(...bytes.subarray(i, i + 8192))
          files[path + name] = btoa(text)
        }
      }
    }
    await list(await (await navigator.storage.getDirectory()).getDirectoryHandle('my project'), '')
    return files
  })
}

test('a hand-made folder of wrinkles can be edited, and a line can be drawn over its normal map', async () => {
  await page.goto(address)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, 'wrinkles')], 'Face')
  await button('Edit wrinkles').click()
  await button('Edit wrinkles').waitFor({ state: 'detached' })
  expect(await areas()).toEqual(['everywhere'])
  // The studio draws the normal map again, with the line. The new map must have the size of the folder's other maps.
  await chooseTool(page, 'Draw a wrinkle')
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  await page.mouse.move(x + 0.45 * width, y + 0.35 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.55 * width, y + 0.35 * height, { steps: 8 })
  await page.mouse.up()
  await expect.poll(() => button('Undo').isEnabled(), { timeout: 60_000 }).toBe(true)
  await page.getByText('Kept in this browser').waitFor()
  expect(await errors()).toBe('')
})

test('a link contains expression, camera and avatar', async () => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await page.goto(address)
  await waitUntilReady(page)
  await showSliders(page)
  await page.getByLabel('Filter blendshapes').fill('jawOpen')
  await slider(page, 'jawOpen').fill('0.4')
  await page.locator('#viewport').press('ArrowLeft')
  await copyLink(page)
  await page.getByText('Copied the link: it opens this avatar').waitFor()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  expect(link).toContain('#model=faces/human.glb&pose=')
  expect(link.length).toBeLessThan(1000)

  const other = await openStudio(link)
  await showSliders(other)
  await other.getByLabel('Filter blendshapes').fill('jawOpen')
  await expectValue(slider(other, 'jawOpen'), 0.4)
  await copyLink(other)
  await other.getByText('Copied the link').waitFor()
  expect(await other.evaluate(() => navigator.clipboard.readText())).toBe(link)
  expect(await errors(other)).toBe('')
  await other.close()
})

test('an invalid link shows one message', async () => {
  const other = await openStudio(`${address}#model=javascript:alert(1)&pose=jawOpen:9`)
  await other.getByRole('alert').getByText('the link cannot be used: the address of its model').waitFor()
  await button('Dismiss', other).click()
  const gone = `${new URL('faces/none.glb', address)}`
  await other.evaluate((model) => location.assign(`#model=${model}`), gone)
  await other.getByRole('alert').getByText('an avatar cannot be fetched (HTTP status 404)').waitFor()
  await waitUntilReady(other)
  expect(await other.locator('#face').inputValue()).toBe('human')
  await other.close()
})

test('a link contains the options of automatic wrinkles', async () => {
  writeFileSync(join(folder, 'public.glb'), readFileSync(join(folder, 'plain.glb')))
  await context.route('**/faces/public.glb', (route) => route.fulfill({ path: join(folder, 'public.glb') }))
  const other = await openStudio(`${address}#model=faces/public.glb&auto=63,0.5,512,7`)
  await other.locator('#areas .row').first().waitFor()
  await expectValue(other.getByRole('slider', { name: 'Age' }), 63)
  await expectValue(other.getByRole('slider', { name: 'Strength' }), 0.5)
  await waitForWrinkles(other)
  await copyLink(other)
  await expect.poll(() => other.url()).toContain('auto=63,0.5,512,7')
  await other.close()
})

test('a key and a button list the shortcuts', async () => {
  await page.keyboard.press('?')
  const list = page.getByRole('dialog', { name: 'Shortcuts' })
  await list.waitFor()
  expect(await list.getByText('Larger brush').isVisible()).toBe(true)
  await page.keyboard.press('Escape')
  await list.waitFor({ state: 'hidden' })
  await button('Shortcuts').click()
  await list.getByRole('button', { name: 'Close' }).click()
  await list.waitFor({ state: 'hidden' })
})

test('a tab says that another tab has its project open, and can keep a copy or take over', async () => {
  await page.goto(address)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, 'plain.zip')], 'Plain')
  await expect.poll(areas, { timeout: 300_000 }).toEqual(names)
  await button('New region').click()
  await page.getByText('Kept in this browser').waitFor()
  const second = await openStudio(address)
  const openThere = async () => {
    await openRecent(second, /^plain/)
    await second.getByText('Open in another tab').waitFor()
  }
  await openThere()
  await button('Go on here', second).click()
  await second.getByText('Kept in this browser').waitFor()
  await expect.poll(() => areas(second), { timeout: 60_000 }).toEqual(await areas())
  await page.getByText('Open in another tab').waitFor()
  // The first tab saves its changes as a copy.
  await button('New region').click()
  expect(await button('Go on here').count()).toBe(0)
  await button('Keep a copy').click()
  await page.getByText('Kept in this browser').waitFor()
  expect((await areas()).length).toBe((await areas(second)).length + 1)
  expect([await errors(), await errors(second)]).toEqual(['', ''])
  await second.close()
})

test('the message about another tab goes when that tab closes the project', async () => {
  const second = await openStudio(address)
  await openRecent(second, /^plain/)
  await second.getByText('Open in another tab').waitFor()
  await page.goto('about:blank')
  await second.getByText('Kept in this browser').waitFor()
  await second.close()
})

test('the built page works without a network', async () => {
  const dist = join(folder, 'dist')
  // Builds in a separate process, because NODE_ENV is `test` in this one.
  const vite = join(ROOT, 'node_modules/vite/bin/vite.js')
  const env = { ...process.env, NODE_ENV: 'production' }
  execFileSync(process.execPath, [vite, 'build', join(ROOT, 'studio'), '--outDir', dist], { env })
  const built: PreviewServer = await preview({
    configFile: CONFIG,
    logLevel: 'error',
    build: { outDir: dist },
    preview: { port: 0, host: '127.0.0.1' },
  })
  const other = await openStudio(`${built.resolvedUrls!.local[0]}?face=human`)
  await other.evaluate(() => navigator.serviceWorker.ready)
  await built.close()
  await context.setOffline(true)
  await other.reload()
  await waitUntilReady(other)
  await dropPaths(other, [join(folder, 'plain.glb')], 'Plain')
  await other.locator('#areas .row').first().waitFor()
  await waitForWrinkles(other)
  expect((await areas(other)).length).toBe(names.length)
  await exportFile(other)
  await button('Exported file', other).click()
  await other.getByText('The wrinkles have no errors.').waitFor()
  expect(await errors(other)).toBe('')
  await context.setOffline(false)
})
