import { Color, PerspectiveCamera, Scene } from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import { harnessOn, RENDERERS } from './harness.ts'
import { litPicture, loadFile } from './loaded.ts'
import { wrinkledFile } from './wrinkled-file.ts'

describe.each(RENDERERS)('fully redrawn influence maps, on %s', (name) => {
  const harness = harnessOn(name)
  let file: Uint8Array
  beforeAll(async () => {
    file = await wrinkledFile()
  })

  it('keep nothing of the previous frame, and do not affect other faces', async () => {
    const [first, second] = await Promise.all([loadFile(harness, file), loadFile(harness, file)])
    const [a, b] = [first, second].map(({ userData }) => userData.wrinkles[0])
    for (const wrinkles of [a, b]) wrinkles.driven = false
    const pictures = async () => [
      await litPicture(harness, first.scene),
      await litPicture(harness, second.scene),
    ]
    // Compares each face only with itself, because coordinates round differently in another cell of the atlas.
    const [plain, otherPlain] = await pictures()
    a.setActivation('a', 1)
    b.setActivation('c', 1)
    const [shown, other] = await pictures()
    expect(shown).not.toEqual(plain)
    expect(other).not.toEqual(otherPlain)
    // Changes one face first, then both.
    a.setActivation('a', 0)
    expect(await pictures()).toEqual([plain, other])
    a.setActivation('a', 1)
    b.setActivation('c', 0)
    expect(await pictures()).toEqual([shown, otherPlain])
    for (const wrinkles of [a, b]) wrinkles.dispose()
  })

  it("keep the renderer's clear colour", async () => {
    const { renderer } = harness
    const before = renderer.getClearColor(new Color() as never).clone()
    const alpha = renderer.getClearAlpha()
    renderer.setClearColor(0x336699, 0.5)
    const { scene, userData } = await loadFile(harness, file)
    userData.wrinkles[0].driven = false
    userData.wrinkles[0].setActivation('a', 1)
    renderer.render(new Scene().add(scene), new PerspectiveCamera())
    await litPicture(harness, scene)
    expect(renderer.getClearColor(new Color() as never).getHex()).toBe(0x336699)
    expect(renderer.getClearAlpha()).toBe(0.5)
    renderer.setClearColor(before, alpha)
    userData.wrinkles[0].dispose()
  })
})
