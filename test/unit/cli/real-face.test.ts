import { existsSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { describe, expect, it } from 'vitest'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../../packages/cli/src/commands/strokes.ts'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { Workshop } from './workshop.ts'

const fromHere = (path: string) => fileURLToPath(new URL(path, import.meta.url))
const REAL_FACE = fromHere('../../../../shared/real-face/ict-face.glb')
const STROKES = fromHere('../../real-face/strokes.json')
const shop = new Workshop()

describe.skipIf(!existsSync(REAL_FACE))('a scanned face with drawn wrinkles', () => {
  it.each([[[]], [['--ktx2', '--size', '512']]])(
    'is valid to the last warning once it is packed: %j',
    async (form) => {
      // The scan's own file has wrong bounds in its accessors; any tool that writes it anew computes them.
      const face = shop.path('face.glb')
      writeFileSync(face, await new NodeIO().writeBinary(await new NodeIO().read(REAL_FACE)))
      const folder = shop.path('drawn')
      const normal = shop.path('drawn/layers/expression/normal.png')
      shop.json('drawn/wrinkles.json', { version: 1 })
      shop.write('drawn/layers/expression/.keep', '')
      shop.write('drawn/areas/.keep', '')
      const maps = ['-o', shop.path('height.png'), '--normal', normal, '--areas', `${folder}/areas`]
      await shop.run(strokesCommand, STROKES, '--face', face, '--mesh', 'face', ...maps)
      const packed = shop.path('packed.glb')
      await shop.run(packCommand, folder, '--face', face, '--mesh', 'face', '-o', packed, ...form)
      shop.printed = ''
      await shop.run(validateCommand, packed)
      expect(shop.printed).toBe(`${packed}: 0 errors, 0 warnings\n`)
    },
  )
})
