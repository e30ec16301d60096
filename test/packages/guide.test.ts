// Follows docs/guide.md from start to end with an avatar and painted maps, in an empty folder.

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

/** The scan if present, otherwise one of our faces. */
const AVATAR = BARE_FACES.at(-1)!.path

/** Images that the guide asks the reader to paint, with our colour: a flat normal, or half visible. */
const PAINTED = {
  'painted/layers/expression/normal.png': '#8080ff',
  'painted/areas/foreheadLeft.png': '#808080',
  'painted/areas/glabella.png': '#808080',
}

/** Step of a page: a block of commands, or a file named in a comment above its block. */
const STEP = /^(?:<!-- (?<file>\S+) -->\n)?```(?<language>\w+)\n(?<text>.*?)^```$/gms

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

/** Runs a command as printed. Packages come from the repository, in the tested versions. */
async function runInWalk(command: string): Promise<void> {
  const [program, ...words] = command.split(' ')
  if (command.startsWith('npm install')) {
    await run(walk, program, '--prefer-offline', ...words.map((word) => tarballs[word] ?? word))
  } else {
    await run(walk, program, ...words)
  }
}
