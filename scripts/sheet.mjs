// `npm run sheet -- FACE.glb... --output sheet.jpg`: draws faces with automatic wrinkles on one sheet. The faces have
// ARKit blendshapes, whose names are removed before `furrow auto` runs. A face gets two rows of five expressions:
// the first row without wrinkles, the second with wrinkles.

import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { both } from './figures/close-ups.mjs'
import { writeSheet } from './figures/write.mjs'
import { ensureBrowser } from './lib/browser.mjs'
import { importSource } from './lib/import-source.mjs'
import { Failure, main, must, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

const POSES = {
  neutral: {},
  smile: { ...both('mouthSmile'), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.4) },
  surprise: { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.8), jawOpen: 0.3 },
  frown: { ...both('browDown'), ...both('noseSneer', 0.4), ...both('mouthFrown', 0.8) },
  speech: { jawOpen: 0.35, mouthFunnel: 0.7, ...both('mouthUpperUp', 0.3) },
}
const PICTURE = { width: 800, height: 800 }
const SHOWN = { crop: { left: 190, top: 40, width: 420, height: 520 }, scale: 0.55 }

await main(async () => {
  const { values, positionals: faces } = parseArgs({
    allowPositionals: true,
    options: { output: { type: 'string', short: 'o' } },
  })
  if (!values.output || faces.length === 0)
    throw new Failure('usage: npm run sheet -- FACE.glb... --output sheet.jpg')
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const { renderPictures } = await import('../packages/cli/dist/render/render-pictures.js')
  const folder = await mkdtemp(join(tmpdir(), 'furrow-sheet-'))
  try {
    const requests = []
    for (const [i, face] of faces.entries()) requests.push(...(await shots(face, join(folder, String(i)))))
    const pictures = await renderPictures(requests)
    const columns = Object.keys(POSES).length
    const shown = pictures.map((picture, i) => ({ ...picture, ...SHOWN, beginsRow: i % columns === 0 }))
    await writeSheet(shown, values.output)
    say(values.output)
  } finally {
    await rm(folder, { recursive: true })
  }
})

/**
 * Writes a face without blendshape names, and with automatic wrinkles. Returns the requests for its pictures.
 *
 * @param stem beginning of the paths of the files.
 */
async function shots(face, stem) {
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS)
  const document = await io.read(face)
  const { stripTargetNames } = await importSource('scripts/lib/strip-target-names.ts')
  const standIns = stripTargetNames(document)
  await io.write(`${stem}.glb`, document)
  const furrow = ['node', 'packages/cli/bin/furrow.js']
  await must([...furrow, 'auto', `${stem}.glb`, '-o', `${stem}-wrinkled.glb`], { quiet: true })
  return ['off', 'default'].flatMap((mode) =>
    Object.values(POSES).map((pose) => {
      const weights = Object.entries(pose).filter(([name]) => standIns.has(name))
      const targets = Object.fromEntries(weights.map(([name, weight]) => [standIns.get(name), weight]))
      return { ...PICTURE, input: `${stem}-wrinkled.glb`, mode, targets }
    }),
  )
}
