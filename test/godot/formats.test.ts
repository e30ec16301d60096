import { expect, it } from 'vitest'
import { bytesOf, FACE } from './files.ts'
import { type GodotScene, godot, type Json } from './harness.ts'

const harness = godot()
const load = async (address: string) => (await fetch(address)).arrayBuffer()

it('shows wrinkles from KTX 2 arrays as from PNG', async () => {
  const pictures = []
  for (const name of ['images', 'arrays']) {
    const scene = (await harness.open(await load(`/packed/${name}.glb`))) as GodotScene
    expect(scene.faces).toBe(1)
    const weights: Json = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 }
    await scene.call('pose', { weights })
    pictures.push(await scene.draw('draw_forehead'))
    await scene.call('pose', {})
    pictures.push(await scene.draw('draw_forehead'))
    await scene.close()
  }
  const [wrinkled, smooth, fromArrays] = pictures
  const mean = (other: Uint8Array) =>
    wrinkled.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / wrinkled.length
  expect(mean(smooth)).toBeGreaterThan(2)
  expect(mean(fromArrays)).toBeLessThan(mean(smooth) / 5)
})

it('reads WebP', async () => {
  const canvas = new OffscreenCanvas(16, 16)
  const context = canvas.getContext('2d')!
  context.fillStyle = '#fff'
  context.fillRect(0, 0, 16, 16)
  const webp = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/webp' })).arrayBuffer())
  const scene = (await harness.open(
    bytesOf({
      ...FACE,
      edit(json) {
        const { index } = json.materials[0].extensions.FURROW_wrinkle_maps.areas[0].texture
        const { source } = json.textures[index]
        const uri = `data:image/webp;base64,${btoa(String.fromCharCode(...webp))}`
        json.images[source] = { uri, mimeType: 'image/webp' }
        json.textures[index] = { extensions: { EXT_texture_webp: { source } } }
        json.extensionsUsed.push('EXT_texture_webp')
      },
    }),
  )) as GodotScene
  expect(scene.faces).toBe(1)
  await scene.close()
})
