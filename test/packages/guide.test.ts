// Runs the commands of docs/guide.md in order, in a folder that contains only an avatar and painted maps.

import { cp, mkdir, readFile, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import sharp from 'sharp'
import { beforeAll, expect, inject, it } from 'vitest'
import { BARE_FACES } from '../bare-faces/bare-faces.ts'
import { openPage, useBrowser } from '../pages/browser.ts'
import { openPaused, playSurprise } from '../pages/paused-page.ts'
import { contrast } from '../pages/pixels.ts'
import { readCanvas } from '../pages/read-canvas.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { DEPENDENCIES, ROOT, run } from './npm.ts'
import { useFolder } from './pages.ts'

/** Scanned face if available, otherwise a shipped face without its wrinkles. */
const AVATAR = BARE_FACES.at(-1)!.path

/** Images that the guide asks the reader to paint, each of one colour: a flat normal map, and areas of weight 0.5. */
const PAINTED = {
  'painted/layers/expression/normal.png': '#8080ff',
  'painted/areas/foreheadLeft.png': '#808080',
  'painted/areas/glabella.png': '#808080',
}

/** Matches a code block of the guide, and the name of its file on the line above it. */
const STEP = /^(?:`(?<file>\S+)`\n\n)?```(?<language>\w+)\n(?<text>.*?)^```$/gms

const folder = useFolder()
let walk: string
let tarballs: Record<string, string>
const browser = useBrowser()

beforeAll(async () => {
  walk = join(folder(), 'walk')
  tarballs = {
    ...inject('tarballs'),
    three: DEPENDENCIES.three,
    vite: DEPENDENCIES.vite,
  }
  await mkdir(walk)
  await cp(AVATAR, join(walk, 'avatar.glb'))
  for (const [file, background] of Object.entries(PAINTED)) {
    await mkdir(dirname(join(walk, file)), { recursive: true })
    await sharp({ create: { width: 64, height: 64, channels: 3, background } })
      .png()
      .toFile(join(walk, file))
  }
})

it('every command of the guide works, in order, and its page shows the face', async () => {
  const guide = await readFile(join(ROOT, 'docs/guide.md'), 'utf8')
  for (const { groups } of guide.matchAll(STEP)) {
    const { file, language, text } = groups!
    if (file) {
      await writeFile(join(walk, file), text)
    } else if (language === 'sh') {
      for (const command of text.trim().split('\n')) await runInWalk(command)
    }
  }
  const server = await startStaticServer(join(walk, 'dist'))
  const { page, complaints } = await openPage(browser(), { viewport: { width: 300, height: 300 } })
  try {
    await openPaused(page, `${server.origin}/index.html`)
    await playSurprise(page)
    expect(contrast(await readCanvas(page))).toBeGreaterThan(100)
    expect(complaints).toEqual([])
  } finally {
    server.close()
  }
})

/** Runs a command of the guide. Package names are replaced by packed packages or tested versions. */
async function runInWalk(command: string): Promise<void> {
  const [program, ...words] = command.split(' ')
  if (command.startsWith('npm install')) {
    await run(walk, program, '--prefer-offline', ...words.map((word) => tarballs[word] ?? word))
  } else {
    await run(walk, program, ...words)
  }
}
