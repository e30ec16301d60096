import { join } from 'node:path'
import { expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { dropPaths, meanPngDifference, shootPlainHuman, shootStage } from './studio-page.ts'

const studio = openStudio({ width: 1000, height: 560 })

test('avatars in other formats are shown when dropped, framed at the face', async () => {
  const { page, folder } = studio
  const human = await shootPlainHuman(page)
  const dropped = [
    ['draco.glb', 'Draco'],
    // A folder that contains a .gltf and its textures.
    ['separate', 'Avatar'],
  ]
  for (const [path, name] of dropped) {
    await dropPaths(page, [join(folder, path)], name)
    expect(await meanPngDifference(human, await shootStage(page)), path).toBeLessThan(1)
  }
})
