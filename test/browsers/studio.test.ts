/** Uses the studio by mouse in browsers other than Chromium, in fewer steps than `test/pages/studio-way.ts`. */

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import sharp from 'sharp'
import type { ViteDevServer } from 'vite'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { io, plainHuman } from '../pages/avatars.ts'
import { serveStudio } from '../pages/opened-studio.ts'
import { runFurrow } from '../pages/run-furrow.ts'
import { CUT_CONTROLS, meanPngDifference } from '../pages/studio-page.ts'
import { DRIVEN } from './drive/browsers.ts'
import type { BrowserKind } from './drive/driven-browser.ts'
import { withHelper } from './page-helper.ts'
import { openWindow } from './window.ts'

const WIDE = { width: 1280, height: 800 }
const NARROW = { width: 447, height: 844 }

/** Window sizes to test. WebKitGTK gets only one, because it takes three minutes per size. */
const windowsOf = ({ name }: BrowserKind) => (name === 'webkit' ? [WIDE] : [WIDE, NARROW])

/** Vertical position of the chin, as a fraction of the stage's height. */
const CHIN = 0.67

const BROWS = ['browInnerUp', 'browOuterUpLeft', 'browOuterUpRight']

let server: ViteDevServer
let address: string
let avatar: Uint8Array

beforeAll(async () => {
  ;({ server, address } = await serveStudio([{ name: 'helper', transformIndexHtml: withHelper }]))
  avatar = await io.writeBinary(await plainHuman())
})

afterAll(() => server?.close())

describe.each(DRIVEN)('studio in %s', (_, kind) => {
  const window = openWindow(kind)

  describe.each(windowsOf(kind))('$width pixels wide', ({ width, height }) => {
    const folder = mkdtempSync(join(tmpdir(), 'furrow-studio-'))
    let exported: Uint8Array

    const isShown = "document.querySelector('#stage[aria-busy=false]')"

    /** Passes a file to the page as if the user had picked it. */
    async function openFile(fileName: string, bytes: Uint8Array, face: string): Promise<void> {
      await window.evaluate(`
        const transfer = new DataTransfer()
        const bytes = Uint8Array.from(atob('${Buffer.from(bytes).toString('base64')}'), (c) => c.charCodeAt(0))
        transfer.items.add(new File([bytes], '${fileName}'))
        const input = document.querySelector('#top input[type=file]')
        input.files = transfer.files
        input.dispatchEvent(new Event('change', { bubbles: true }))`)
      const chosen = "document.querySelector('#face option:checked')?.textContent"
      await window.until(`${chosen} === '${face}' && ${isShown}`)
    }

    /** Takes pictures of the middle of the stage until two consecutive ones are equal. */
    async function shoot(): Promise<Buffer> {
      const stage = await window.find('#viewport')
      const middle = {
        left: Math.round(stage.x + 0.3 * stage.width),
        top: Math.round(stage.y + 0.2 * stage.height),
        width: Math.round(0.4 * stage.width),
        height: Math.round(0.5 * stage.height),
      }
      const take = async () => {
        const picture = await window.browser.screenshot()
        return sharp(picture).extract(middle).png().toBuffer()
      }
      for (let before = await take(); ; ) {
        await new Promise((resolve) => setTimeout(resolve, 500))
        const after = await take()
        if (before.equals(after)) return after
        before = after
      }
    }

    /** Opens a panel. On a narrow page, one sheet shows one of the panels. */
    async function showPanel(name: 'Regions' | 'Selection' | 'Expressions'): Promise<void> {
      if (
        await window.evaluate(
          `return furrowTest.findElement('[aria-expanded=false]', '${name}') !== undefined`,
        )
      )
        await window.click('button', name)
    }

    async function setMode(mode: string): Promise<void> {
      await window.click('button', 'Preferences')
      await window.click('label', mode, 'Shading of wrinkles')
      await window.click('button', 'Close')
    }

    async function changeByWrinkles(): Promise<number> {
      const wrinkled = await shoot()
      await setMode('Off')
      const plain = await shoot()
      await setMode('Default')
      return meanPngDifference(wrinkled, plain)
    }

    /** Drags the divider between the smooth and the wrinkled part to the left edge of the stage. */
    async function showWrinklesEverywhere(): Promise<void> {
      const divider = await window.find('#divider')
      const [x, y] = [divider.x + divider.width / 2, divider.y + divider.height / 2]
      await window.drag([x, x / 2, 0].map((left) => [left, y] as const))
      await window.until("document.querySelector('#divider').ariaValueNow === '0'")
    }

    async function raiseBrows(): Promise<void> {
      await showPanel('Expressions')
      if (await window.evaluate("return furrowTest.findElement('#filter') === undefined"))
        await window.click('button', 'Sliders')
      await window.type('brow', 'input', 'Filter blendshapes')
      for (const shape of BROWS) {
        await window.dragSlider(1, `#targets .row:has(label[title=${shape}]) input[type=range]`)
      }
      await showPanel('Regions')
      await window.until(
        "document.querySelector('#areas .row:has(label[title=foreheadInnerLeft]) input[type=range]')?.value > 0.8",
      )
    }

    const save = (step: string) => window.save(`studio-${width}-${step}`)

    beforeAll(async () => {
      await window.resize(width, height)
      await window.browser.open(address)
      await window.until(isShown)
    })

    afterAll(() => rmSync(folder, { recursive: true, force: true }))

    test('makes wrinkles for an avatar, so that raised brows crease its forehead', async () => {
      await openFile('plain.glb', avatar, 'Plain')
      await showPanel('Regions')
      await window.find('input[type=radio]', 'Select Inner forehead, left foreheadInnerLeft')
      await window.until("!document.body.textContent.includes('Making wrinkles')")
      await showWrinklesEverywhere()
      await raiseBrows()
      await save('wrinkles')
      expect(await changeByWrinkles()).toBeGreaterThan(0.5)
    })

    test('paints an area', async () => {
      await showPanel('Regions')
      await window.click('input[type=radio]', 'Select Chin chin')
      await window.click('button', 'Paint')
      await window.until("furrowTest.findElement('button[aria-pressed=true]', 'Paint')")
      const stage = await window.find('#viewport')
      const [x, y] = [stage.x + stage.width / 2, stage.y + CHIN * stage.height]
      await window.drag([0, 1, 2, 3, 4].map((i) => [x + 10 * i, y - 5 * i] as const))
      await window.until("furrowTest.findElement('button', 'Undo').title === 'Undo: Paint Chin'")
      await save('painted')
      await window.click('button', 'Select')
    })

    test('exports a file that furrow validate accepts', async () => {
      await window.click('button', 'Export')
      await window.until('furrowTest.savedFiles.length > 0')
      exported = Buffer.from(await window.evaluate<string>('return furrowTest.readSaved()'), 'base64')
      writeFileSync(join(folder, 'exported.glb'), exported)
      const { code, stdout } = await runFurrow(folder, {}, 'validate', 'exported.glb')
      expect({ code, stdout }).toEqual({ code: 0, stdout: expect.stringContaining(': 0 errors') })
    })

    test('opens the exported file with its wrinkles', async () => {
      await openFile('exported.glb', exported, 'Exported')
      await save('reopened')
      await showWrinklesEverywhere()
      await raiseBrows()
      expect(await changeByWrinkles()).toBeGreaterThan(0.5)
      await save('reopened-wrinkles')
      expect(await window.evaluate("return document.querySelector('#errors').textContent")).toBe('')
    })

    test('shows all controls in full', async () => {
      await showPanel('Selection')
      await window.click('button', 'Edit wrinkles')
      await showPanel('Regions')
      await window.click('input[type=radio]', 'Select Chin chin')
      for (const panel of ['Regions', 'Selection', 'Expressions'] as const) {
        await showPanel(panel)
        expect(await window.evaluate(`return ${CUT_CONTROLS}`)).toEqual([])
        await save(`unfolded-${panel.toLowerCase()}`)
      }
      await window.click('button', 'Preferences')
      await window.find('label', 'Off', 'Shading of wrinkles')
      expect(await window.evaluate(`return ${CUT_CONTROLS}`)).toEqual([])
      await save('preferences')
      await window.click('button', 'Close')
    })
  })
})
