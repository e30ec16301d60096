import { fileURLToPath } from 'node:url'
import { expect, test } from 'vitest'
import { checkSkin } from '../../../../packages/furrow/src/author/auto/surface/check-skin.ts'
import { chooseSkin } from '../../../../packages/furrow/src/author/auto/surface/choose-skin.ts'
import { knownTargets } from '../../../../packages/furrow/src/author/auto/surface/known-targets.ts'
import { skinAt } from '../../../skin-at.ts'

test('blendshapes that were recognised to select the skin are not recognised again', async () => {
  const { targets, ...rest } = await skinAt(
    fileURLToPath(new URL('../../../../faces/human.glb', import.meta.url)),
  )
  const skin = { ...rest, targets: targets.map(({ offsets }, i) => ({ name: `${i}`, offsets })) }
  chooseSkin([{ skin, isLit: true, label: 'face' }])
  const checked = checkSkin({ ...skin, uvs: Array.from(skin.uvs) }).skin
  expect(knownTargets(checked)).toBe(knownTargets(skin))
  const moved = { ...skin, positions: Array.from(skin.positions) }
  expect(knownTargets(moved)).not.toBe(knownTargets(skin))
})
