import { expect, it } from 'vitest'
import { curveAt } from '../../packages/furrow/src/drivers/curve.ts'
import { type GodotScene, godot } from './harness.ts'

const harness = godot()

interface BoneDriver {
  type: string
  measure: string
  area: string
  joints: [string, string]
  axis?: number[]
  curve: [number, number][]
}

it('bones of a skeleton drive the wrinkles of a hand', async () => {
  const bytes = await (await fetch('/faces/hand.glb')).arrayBuffer()
  const json = JSON.parse(
    new TextDecoder().decode(new Uint8Array(bytes, 20, new DataView(bytes).getUint32(12, true))),
  )
  const skin = json.materials.find(({ name }: { name: string }) => name === 'skin')
  const drivers: BoneDriver[] = skin.extensions.FURROW_wrinkle_maps.drivers
  const scene = (await harness.open(bytes)) as GodotScene
  expect(scene.faces).toBe(1)
  // Areas with several drivers show their sum.
  const isOnly = (area: string) => drivers.filter((driver) => driver.area === area).length === 1
  const bones = drivers.filter(({ measure, area }) => measure === 'angle' && isOnly(area))
  expect(bones.length).toBeGreaterThan(5)
  for (const { area, joints, axis = [1, 0, 0], curve } of bones) {
    for (const angle of [0, 0.4, 0.9]) {
      const args = { joint: joints[1], axis, angle, area }
      const activation = await scene.call<number>('turn_bone', args)
      expect(Math.abs(activation - curveAt(curve, angle))).toBeLessThan(1e-4)
    }
  }
  await scene.close()
})
