import { Wrinkles as WebGLWrinkles } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import {
  AmbientLight,
  DirectionalLight,
  type Material,
  type Mesh,
  MeshBasicMaterial,
  MeshMatcapMaterial,
  MeshNormalMaterial,
  MeshStandardMaterial,
  Scene,
  ShaderMaterial,
  type Texture,
} from 'three'
import { expression, Fn, vec3 } from 'three/tsl'
import { MeshStandardNodeMaterial, Node, type NodeBuilder } from 'three/webgpu'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { available } from './available.ts'
import { createHarness, type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { normalMap } from './normal-map.ts'
import { quietConsole } from './quiet-console.ts'

const written = quietConsole()

const set = () => randomSet(seeded(3), 4, 8, 16)

function sceneOf(mesh: Mesh): Scene {
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(1, 1, 1)
  return new Scene().add(mesh, light, new AmbientLight(0xffffff, 0.2))
}

/** Draws four frames and returns the last, because errors of a renderer take effect some frames later. */
async function picture(harness: Harness, mesh: Mesh): Promise<string> {
  const scene = sceneOf(mesh)
  for (let i = 0; i < 3; i++) await harness.renderBytes(scene, squareCamera(), 16)
  return (await harness.renderBytes(scene, squareCamera(), 16)).join()
}

/** Returns the warnings of Furrow, without those of three.js. */
const warnings = () =>
  written.warn.mock.calls.map(([text]) => String(text)).filter((text) => /^Wrinkles/.test(text))

/** Adds wrinkles, and expects that the picture does not change and that one warning gives the reason. */
async function expectPlain(harness: Harness, mesh: Mesh, why: RegExp) {
  const plain = await picture(harness, mesh)
  const wrinkles = new harness.Wrinkles(mesh, set(), { areaSize: 8 })
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 1)
  expect(await picture(harness, mesh)).toBe(plain)
  expect(wrinkles.mode).toBe('off')
  await picture(harness, mesh)
  expect(warnings()).toEqual([expect.stringMatching(why)])
  wrinkles.dispose()
}

/** Adds wrinkles, and expects that they show in the given mode, and that `dispose` restores the picture without wrinkles. */
async function expectWrinkles(harness: Harness, mesh: Mesh, mode: 'default' | 'composed') {
  const plain = await picture(harness, mesh)
  const wrinkles = new harness.Wrinkles(mesh, set(), { areaSize: 8 })
  expect(await picture(harness, mesh)).toBe(plain)
  wrinkles.setActivation('area1', 1)
  expect(await picture(harness, mesh)).not.toBe(plain)
  expect(wrinkles.mode).toBe(mode)
  wrinkles.dispose()
  expect(await picture(harness, mesh)).toBe(plain)
  expect(warnings()).toEqual([])
}

describe.each(RENDERERS)('materials on %s', (name) => {
  const harness = harnessOn(name)

  const unlit: [string, () => Material][] = [
    ['matcap', () => new MeshMatcapMaterial()],
    ['normal', () => new MeshNormalMaterial()],
  ]
  it.each(unlit)('wrinkle: %s', (_, create) => expectWrinkles(harness, square(create()), 'default'))

  it.each(unlit)('ignore maps they cannot use: %s', async (_, create) => {
    const { layers, areas } = set()
    const gray = { width: 16, height: 16, data: new Uint8Array(256).fill(90) }
    const layer = { ...layers[0], baseColor: layers[0].normal, roughness: gray, occlusion: gray }
    const mesh = square(create())
    const plain = await picture(harness, mesh)
    const wrinkles = new harness.Wrinkles(mesh, { layers: [layer], areas }, { areaSize: 8 })
    wrinkles.setActivation('area1', 1)
    expect(await picture(harness, mesh)).not.toBe(plain)
    expect(wrinkles.mode).toBe('default')
    expect(warnings()).toEqual([])
    wrinkles.dispose()
  })

  it('show the wrinkles of a multi-material mesh on the first material with a normal map', async () => {
    const mesh = square(new MeshBasicMaterial()) as Mesh<Mesh['geometry'], Material | Material[]>
    mesh.material = [new MeshBasicMaterial(), new MeshStandardMaterial({ name: 'skin' })]
    mesh.geometry.addGroup(0, 3, 0)
    mesh.geometry.addGroup(3, 3, 1)
    await expectWrinkles(harness, mesh as Mesh, 'default')
    const wrinkles = new harness.Wrinkles(mesh as Mesh, set())
    const copies = wrinkles.cloneMaterial() as Material[]
    expect(copies[0]).toBe(mesh.material[0])
    expect(copies[1]).not.toBe(mesh.material[1])
    expect(copies[1]).toMatchObject({ name: 'skin', normalMap: null })
    wrinkles.dispose()
  })

  it('accept any characters in the name of a mesh or material', async () => {
    const hostile = 'a\n#error "b"\\'
    const mesh = square(new MeshStandardMaterial())
    const plain = await picture(harness, mesh)
    mesh.name = hostile
    ;(mesh.material as Material).name = hostile
    for (const mode of ['default', 'composed', 'paper'] as const) {
      const wrinkles = new harness.Wrinkles(mesh, set(), { mode, areaSize: 8 })
      expect(await picture(harness, mesh)).toBe(plain)
      wrinkles.setActivation('area1', 1)
      expect(await picture(harness, mesh)).not.toBe(plain)
      expect(wrinkles.mode).toBe(mode)
      wrinkles.dispose()
    }
    expect(warnings()).toEqual([])
  })

  it.each(['default', 'composed', 'paper'] as const)(
    "stay plain in %s mode with the wrong renderer's entry point, with one warning that names the right one",
    async (mode) => {
      const Other = name === 'webgl' ? WebGPUWrinkles : WebGLWrinkles
      const mesh = square(new MeshStandardMaterial())
      const plain = await picture(harness, mesh)
      const own = await createHarness(name)
      const wrinkles = new Other(mesh, set(), { mode })
      wrinkles.setActivation('area1', 1)
      expect(await picture(own, mesh)).toBe(plain)
      expect(await picture(own, mesh)).toBe(plain)
      const said = written.error.mock.calls
        .map(([text]) => String(text))
        .filter((text) => /^Wrinkles/.test(text))
      expect(said).toEqual([
        name === 'webgl'
          ? 'Wrinkles of furrow/webgpu: unsupported renderer, got "WebGLRenderer", allowed: WebGPURenderer; import Wrinkles and the loader plugin from furrow/three; until then the face has no wrinkles'
          : 'Wrinkles of furrow/three: unsupported renderer, got "WebGPURenderer", allowed: WebGLRenderer; import Wrinkles and the loader plugin from furrow/webgpu; until then the face has no wrinkles',
      ])
      expect(() => wrinkles.update(own.renderer)).toThrow(said[0])
      wrinkles.dispose()
      own.dispose()
    },
  )
})

describe('shaders on webgl', () => {
  const harness = harnessOn('webgl')

  it("keep the user's edits when they are patched", async () => {
    const material = new MeshStandardMaterial()
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <opaque_fragment>',
        'outgoingLight.r = 0.5;\n#include <opaque_fragment>',
      )
    }
    await expectWrinkles(harness, square(material), 'default')
  })

  it("show the composed map from the second frame on if the user's edits prevent patching", async () => {
    const material = new MeshStandardMaterial()
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <normal_fragment_maps>',
        'vec3 own = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;\nnormal = normalize( tbn * own );',
      )
    }
    const own = normalMap(5, 16)
    material.normalMap = own
    await expectWrinkles(harness, square(material), 'composed')
    expect(material.normalMap).toBe(own)
  })

  it('use the composed mode at once for a ShaderMaterial with a normal map', async () => {
    const mesh = square(new OwnShader('texture2D( normalMap, vUv ).xyz'))
    await expectWrinkles(harness, mesh, 'composed')
    const wrinkles = new harness.Wrinkles(mesh, set())
    expect(wrinkles.mode).toBe('composed')
    expect(() => {
      wrinkles.mode = 'paper'
    }).toThrow(
      /^Wrinkles.mode: the material's shader cannot be patched, got "paper", allowed: composed or off/,
    )
    expect(wrinkles.mode).toBe('composed')
    wrinkles.dispose()
  })

  it('are refused if a ShaderMaterial reads no normal map', () => {
    const mesh = square(new OwnShader('vec3( vUv, 0.5 )'))
    expect(() => new harness.Wrinkles(mesh, set())).toThrow(
      /material ShaderMaterial does not support normal maps/,
    )
    expect((mesh.material as OwnShader).normalMap).toBeNull()
  })

  it.each([true, false])(
    'fall back to the plain face, with one warning, if they fail to compile with wrinkles (checkShaderErrors %s)',
    async (checkShaderErrors) => {
      const material = new MeshStandardMaterial()
      material.customProgramCacheKey = () => `taken ${checkShaderErrors}`
      material.onBeforeCompile = (shader) => {
        shader.fragmentShader = `float furrowMixNormals;\n${shader.fragmentShader}`
      }
      harness.renderer.debug.checkShaderErrors = checkShaderErrors
      const mesh = square(material)
      mesh.name = 'head'
      await expectPlain(
        harness,
        mesh,
        /^Wrinkles: the shader of mesh "head" does not compile in the default mode, so its wrinkles are off, got ".+"; use the composed mode, or another material$/,
      )
      expect(material.normalMap).toBeNull()
      harness.renderer.debug.checkShaderErrors = true
    },
  )

  it('of instances get no wrinkles, and one warning, if they cannot be patched', async () => {
    const { InstancedMesh, Matrix4 } = await import('three')
    const material = new MeshStandardMaterial()
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_maps>', '')
    }
    const mesh = new InstancedMesh(square(material).geometry, material, 2)
    for (const i of [0, 1]) mesh.setMatrixAt(i, new Matrix4())
    await expectPlain(harness, mesh, /^Wrinkles.mode: mode unsupported for instances/)
  })
})

describe.each(available(['webgpu', 'webgpu on webgl2'] as const))('nodes on %s', (name) => {
  const harness = harnessOn(name)

  /** Creates a material with a node that fails only after Furrow has patched the material's normals. */
  const failing = (fail: () => Node<'vec3'>) => {
    const material = new MeshStandardNodeMaterial()
    material.emissiveNode = Fn((_: [], builder: NodeBuilder) => {
      const isPatched = (builder.material as typeof material).normalNode !== null
      return isPatched ? fail() : vec3(0.1)
    })()
    return material
  }

  it.each([
    ['shaders that the GPU refuses', () => vec3(expression('furrow_undeclared', 'vec3') as never)],
    ['nodes that cannot be built', () => vec3(new Unbuildable('vec3') as never)],
  ])('fall back to the plain face with one warning: %s', async (_, fail) => {
    await expectPlain(harness, square(failing(fail)), /does not compile in the default mode/)
  })

  it("keep the material's own normals under the wrinkles", async () => {
    const material = new MeshStandardNodeMaterial()
    material.normalNode = vec3(0.3, 0.2, 0.93).normalize()
    await expectWrinkles(harness, square(material), 'default')
  })

  it('wrinkle a material that is compiled ahead while frames are drawn', async () => {
    const mesh = square(new MeshStandardNodeMaterial())
    const plain = await picture(harness, mesh)
    const wrinkles = new harness.Wrinkles(mesh, set(), { areaSize: 8 })
    const { renderer } = harness as unknown as { renderer: import('three/webgpu').WebGPURenderer }
    const compiled = renderer.compileAsync(sceneOf(mesh), squareCamera())
    await picture(harness, mesh)
    await compiled
    wrinkles.setActivation('area1', 1)
    expect(await picture(harness, mesh)).not.toBe(plain)
    expect(wrinkles.mode).toBe('default')
    expect(warnings()).toEqual([])
    wrinkles.dispose()
  })
})

class Unbuildable extends Node {
  override generate(): string {
    throw new Error('no such node')
  }
}

/** Unlit ShaderMaterial like those of other libraries. The GLSL expression `colour` may read the normal map. */
class OwnShader extends ShaderMaterial {
  constructor(colour: string) {
    super({
      uniforms: { normalMap: { value: null } },
      vertexShader:
        'varying vec2 vUv; void main() { vUv = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 ); }',
      fragmentShader: `varying vec2 vUv;${colour.includes('normalMap') ? ' uniform sampler2D normalMap;' : ''}
void main() { gl_FragColor = vec4( ${colour}, 1.0 ); }`,
    })
    this.normalMap = null
    if (!colour.includes('normalMap')) return
    this.normalMap = normalMap(5, 16)
  }
  get normalMap(): Texture | null {
    return this.uniforms.normalMap.value
  }
  set normalMap(map: Texture | null) {
    this.uniforms.normalMap.value = map
  }
}
