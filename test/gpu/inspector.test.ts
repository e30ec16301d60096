import { WrinkleInspector } from 'furrow/inspector'
import { addDrivers } from 'furrow/three'
import { BufferAttribute, DirectionalLight, Mesh, MeshStandardMaterial, PlaneGeometry, Scene } from 'three'
import { afterEach, beforeEach, describe, expect, it, type MockInstance, vi } from 'vitest'
import { layer, randomNormals } from '../cases.ts'
import { morph } from '../drivers.ts'
import { seeded } from '../random.ts'
import { harnessOn, RENDERERS, squareCamera } from './harness.ts'

const SIZE = 32
const full = { width: 1, height: 1, data: Uint8Array.of(255) }

describe.each(RENDERERS)('the inspector on %s', (name) => {
  const harness = harnessOn(name)
  let warn: MockInstance
  let scene: Scene
  let mesh: Mesh<PlaneGeometry, MeshStandardMaterial>
  let wrinkles: InstanceType<typeof harness.Wrinkles>
  let inspector: WrinkleInspector

  beforeEach(() => {
    warn = vi.spyOn(console, 'warn')
    mesh = squeezedSquare()
    wrinkles = new harness.Wrinkles(mesh, {
      layers: [layer('skin', 'detail', randomNormals(seeded(1), 4))],
      areas: ['brow', 'nose'].map((area) => ({ name: area, weights: full })),
    })
    addDrivers(wrinkles, [morph('brow', 'squeeze')])
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    scene = new Scene().add(mesh, light)
    inspector = new WrinkleInspector(wrinkles)
  })

  afterEach(() => {
    wrinkles.dispose()
    expect(document.querySelector('.lil-gui')).toBeNull()
    expect(warn).not.toHaveBeenCalled()
    warn.mockRestore()
  })

  const picture = () => harness.renderBytes(scene, squareCamera(), SIZE)
  const centre = (pixels: Uint8Array) => [...pixels.subarray(4 * (SIZE / 2) * (SIZE + 1)).subarray(0, 3)]
  const choose = (label: string, value: unknown) =>
    inspector.gui.controllers.find(({ _name }) => _name === label)!.setValue(value)

  it('lists areas with their activations and the inputs that drive them', async () => {
    mesh.morphTargetInfluences![0] = 0.5
    await picture()
    await vi.waitFor(() => {
      const [areas, cost] = inspector.gui.folders
      expect(areas.controllers.map((slider) => slider.getValue())).toEqual([0.5, 0])
      expect(areas.domElement.textContent).toMatch(/squeeze 0\.50.*no drivers/)
      expect(cost.controllers.map((text) => text.getValue())).toEqual(['1 of 2', '2, 0.0 MB', '2'])
    })
  })

  it('a slider stops the drivers and activates its area', async () => {
    await picture()
    inspector.gui.folders[0].controllers[0].setValue(0.25)
    expect(wrinkles.driven).toBe(false)
    await picture()
    expect(wrinkles.getActivation('brow')).toBe(0.25)
  })

  it('shows influence, normals, strain and wireframe, and then the face as before', async () => {
    mesh.morphTargetInfluences![0] = 0.5
    const shaded = await picture()
    choose('View', 'influence')
    await picture()
    // The influence is 0.5, without gamma encoding.
    for (const value of centre(await picture())) expect(Math.abs(value - 128)).toBeLessThanOrEqual(1)
    choose('View', 'normals')
    await picture()
    await nextFrame()
    const [, , z] = centre(await picture())
    expect(z).toBeGreaterThan(128)
    choose('View', 'strain')
    await nextFrame()
    const [red, , blue] = centre(await picture())
    expect(red).toBeGreaterThan(4 * blue)
    choose('View', 'wireframe')
    expect(centre(await picture())).not.toEqual(centre(shaded))
    choose('View', 'shaded')
    await picture()
    expect(await picture()).toEqual(shaded)
    expect(scene.children).toHaveLength(2)
  })

  it('changes mode and relief, and reports a mode that is not possible', async () => {
    choose('Mode', 'off')
    expect(wrinkles.mode).toBe('off')
    choose('Relief', 'off')
    expect(wrinkles.relief).toBe('off')
    choose('Mode', 'default')
    warn.mockImplementation(() => {})
    choose('Mode', 'sideways')
    expect(warn.mock.calls).toEqual([[expect.stringContaining('sideways')]])
    expect(wrinkles.mode).toBe('default')
    warn.mockClear()
  })
})

/** Creates a square with a blendshape that makes it half as wide. */
function squeezedSquare() {
  const geometry = new PlaneGeometry(2, 2)
  const { position } = geometry.attributes
  const offsets = Float32Array.from(position.array, (value, i) => (i % 3 === 0 ? -value / 2 : 0))
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = [Object.assign(new BufferAttribute(offsets, 3), { name: 'squeeze' })]
  return new Mesh(geometry, new MeshStandardMaterial())
}

function nextFrame(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))
}
