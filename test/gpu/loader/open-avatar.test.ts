import type { Mesh } from 'three'
import { describe, expect, it } from 'vitest'
import { disposeAvatar, faceOf, openAvatar } from '../../../studio/src/open/avatar.ts'
import { asVrm0, asVrm1, type Vrm0Shader } from '../../vrm.ts'
import { quietConsole } from '../quiet-console.ts'
import { vrmFile } from '../vrm-file.ts'
import { wrinkledFile } from '../wrinkled-file.ts'

// The tests open edited versions of `wrinkledFile`, in which two quads form one face.

quietConsole()

const droppedAs = (name: string, ...parts: BlobPart[]) => ({ path: name, file: new File(parts, name) })

// biome-ignore lint/suspicious/noExplicitAny: the complete JSON of the file
type Edit = (json: any) => unknown

/** Opens `wrinkledFile` with edited JSON. */
async function open(edit: Edit) {
  return openAvatar(droppedAs('face.glb', await wrinkledFile(undefined, edit)))
}

/** Removes the wrinkles. */
const plain: Edit = (json) => delete json.materials[0].extensions

describe('an opened avatar', () => {
  it('has the wrinkles of its file on one skin of several primitives', async () => {
    const avatar = await open(() => {})
    expect(avatar).toMatchObject({ name: 'face', skin: 0, notes: [], vrm: null })
    expect(avatar.skins).toMatchObject([{ name: 'face', triangles: 4, blendshapes: 1, problem: null }])
    const face = faceOf(avatar)
    expect(face.parts).toHaveLength(1)
    expect(face.wrinkles?.set.areas.map(({ name }) => name)).toEqual(['a', 'b', 'c', 'd'])
  })

  it('has no wrinkles, and a note, if its wrinkles are damaged', async () => {
    const avatar = await openAvatar(
      droppedAs('face.glb', await wrinkledFile((maps) => delete (maps as Partial<typeof maps>).layers)),
    )
    expect(faceOf(avatar).wrinkles).toBe(null)
    expect(avatar.notes).toEqual([
      expect.stringMatching(/^FURROW_wrinkle_maps: .*; the face is shown without wrinkles$/),
    ])
  })

  it.each<[string, Edit, string]>([
    [
      'no texture coordinates',
      (json) => {
        for (const { attributes } of json.meshes[0].primitives) delete attributes.TEXCOORD_0
      },
      'face cannot wrinkle: it has no texture coordinates: unwrap it, and export it again',
    ],
    [
      'an unlit material',
      (json) => {
        json.materials[0].extensions = { KHR_materials_unlit: {} }
        json.extensionsUsed.push('KHR_materials_unlit')
      },
      'face cannot wrinkle: its material is unlit: give it a lit one, and export it again',
    ],
    [
      'no blendshapes',
      (json) => {
        delete json.meshes[0].weights
        for (const primitive of json.meshes[0].primitives) delete primitive.targets
      },
      'face has no blendshapes: it can be painted, but no expression moves it',
    ],
  ])('has a note if the file has %s', async (_, edit, note) => {
    const avatar = await open((json) => {
      plain(json)
      edit(json)
    })
    expect(avatar.notes).toEqual([note])
  })

  it('opens without blendshape names', async () => {
    const avatar = await open((json) => {
      plain(json)
      delete json.meshes[0].extras
    })
    expect(avatar.skins[0].blendshapes).toBe(1)
    expect(avatar.notes).toEqual([])
  })

  it('has another mesh as skin after the user picks it', async () => {
    const avatar = await open((json) => {
      // Turns the second quad into a separate mesh.
      json.meshes.push({ name: 'other', primitives: json.meshes[0].primitives.splice(1) })
      json.nodes.push({ name: 'other', mesh: 1 })
      json.scenes[0].nodes.push(json.nodes.length - 1)
    })
    expect(avatar.skins.map(({ name }) => name)).toEqual(['face', 'other'])
    expect(faceOf({ ...avatar, skin: 1 }).skin).toBe(avatar.skins[1].meshes[0])
  })

  it('frees its geometries and images on dispose', async () => {
    const avatar = await open(() => {})
    const { skin } = faceOf(avatar)
    const image = (skin.material as { normalMap?: { image: ImageBitmap } }).normalMap!.image
    let isDisposed = false
    skin.geometry.addEventListener('dispose', () => {
      isDisposed = true
    })
    disposeAvatar(avatar)
    expect(isDisposed).toBe(true)
    expect(image.width).toBe(0)
  })
})

describe('an opened VRM', () => {
  it('has the materials and bones of a VRM', async () => {
    const avatar = await openAvatar(droppedAs('avatar.vrm', await vrmFile(true)))
    expect(avatar.vrm?.meta.metaVersion).toBe('1')
    const { skin } = faceOf(avatar)
    expect([skin.material].flat()).toHaveLength(2)
    expect(avatar.skins[0].triangles).toBe(4)
  })

  it.each<Vrm0Shader>(['VRM/MToon', 'VRM/UnlitTexture'])(
    'has its wrinkles as a VRM 0 with %s',
    async (shader) => {
      const avatar = await openAvatar(droppedAs('avatar.vrm', asVrm0(await wrinkledFile(), shader)))
      expect(avatar.vrm?.meta.metaVersion).toBe('0')
      expect(avatar.notes).toEqual([])
      expect(faceOf(avatar).wrinkles?.set.areas.map(({ name }) => name)).toEqual(['a', 'b', 'c', 'd'])
    },
  )

  it.each(['VRM 0', 'VRM 1.0'])(
    'has the expressions of its file as a %s, as blendshapes',
    async (version) => {
      const bytes = await wrinkledFile()
      const avatar = await openAvatar(
        droppedAs(
          'avatar.vrm',
          version === 'VRM 0'
            ? asVrm0(bytes, 'VRM/MToon', ({ extensions: { VRM } }) => {
                const binds = [{ mesh: 0, index: 0, weight: 50 }]
                const still = { name: 'Neutral', presetName: 'neutral', binds: [] }
                VRM.blendShapeMaster.blendShapeGroups = [still, { name: 'Joy', presetName: 'joy', binds }]
              })
            : asVrm1(bytes, ({ nodes, extensions: { VRMC_vrm } }) => {
                const node = nodes.findIndex(({ mesh }: { mesh?: number }) => mesh === 0)
                const morphTargetBinds = [{ node, index: 0, weight: 0.5 }]
                VRMC_vrm.expressions = { preset: { neutral: {}, happy: { morphTargetBinds } } }
              }),
        ),
      )
      expect(avatar.expressions).toEqual([{ name: 'happy', targets: { browInnerUp: 0.5 }, activations: {} }])
    },
  )

  it('opens as plain glTF if its VRM extension is broken', async () => {
    const bytes = await wrinkledFile(undefined, (json) => {
      json.extensionsUsed.push('VRMC_vrm')
      json.extensions = { VRMC_vrm: { specVersion: '1.0', meta: {}, humanoid: { humanBones: { hips: {} } } } }
    })
    const avatar = await openAvatar(droppedAs('avatar.vrm', bytes))
    expect(avatar.vrm).toBe(null)
    expect(faceOf(avatar).wrinkles).not.toBe(null)
  })
})

describe('a compressed file', () => {
  it.each(['ktx2', 'draco'])('is decoded: %s', async (name) => {
    const bytes = await (await fetch(`/packed/${name}.glb`)).arrayBuffer()
    const avatar = await openAvatar(droppedAs(`${name}.glb`, bytes))
    expect(avatar.notes).toEqual([])
    const { skin, wrinkles } = faceOf(avatar)
    expect(skin.name).toBe('skin')
    expect(wrinkles?.set.areas.length).toBeGreaterThan(5)
  })
})

describe('the files of a .gltf', () => {
  const split = async (uri: string) => {
    const glb = await wrinkledFile()
    const view = new DataView(glb.buffer)
    const end = 20 + view.getUint32(12, true)
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, end)))
    json.buffers[0].uri = uri
    return { gltf: JSON.stringify(json), bin: glb.slice(end + 8) }
  }

  it.each([
    ['beside it', 'a/face.gltf', 'data.bin', 'a/data.bin'],
    ['in a folder, with an escape', 'a/face.gltf', 'my%20data/data.bin', 'a/my data/data.bin'],
    ['above it', 'a/deep/face.gltf', '../data.bin', 'a/data.bin'],
    ['dropped without their folder', 'face.gltf', 'buffers/data.bin', 'DATA.bin'],
  ])('are found %s', async (_, path, uri, at) => {
    const { gltf, bin } = await split(uri)
    const face = droppedAs(path, gltf)
    const avatar = await openAvatar(face, { files: [face, droppedAs(at, bin), droppedAs('other.bin', 'x')] })
    expect(avatar.files.map((file) => file.path)).toEqual([path, at])
    expect((avatar.skins[0].meshes[0] as Mesh).geometry.attributes.position.count).toBe(4)
  })

  it.each([
    ['data.bin', [], 'refers to a file that was not dropped, got "data.bin"'],
    ['data.bin', ['b/data.bin', 'c/data.bin'], 'refers to one of 2 files of the same name, got "data.bin"'],
    ['https://example.org/data.bin', [], 'references a remote file'],
  ])('are reported missing: %s among %j', async (uri, others, expected) => {
    const { gltf } = await split(uri)
    const face = droppedAs('a/face.gltf', gltf)
    const files = [face, ...others.map((path) => droppedAs(path, 'x'))]
    await expect(openAvatar(face, { files })).rejects.toThrow(`Studio: a/face.gltf ${expected}`)
  })
})

describe('an unreadable file', () => {
  it.each<[string, BlobPart, string]>([
    ['empty', '', 'it is empty'],
    ['text', 'hello', 'it is text, not glTF'],
    ['JSON of something else', '{}', 'its JSON has no asset.version'],
    ['glTF 1', Uint8Array.of(0x67, 0x6c, 0x54, 0x46, 1, ...Array(15).fill(0)), 'it has version 1'],
  ])('is refused with a one-line error: %s', async (_, content, problem) => {
    const error = await openAvatar(droppedAs('face.glb', content)).catch((thrown: Error) => thrown)
    expect((error as Error).name).toBe('FurrowError')
    expect((error as Error).message).toMatch(/^Studio: face\.glb is not usable: [^\n]+$/)
    expect((error as Error).message).toContain(problem)
  })

  it.each<[string, Edit, string]>([
    [
      'an accessor beyond its buffer',
      (json) => Object.assign(json.accessors[0], { byteOffset: 1e9 }),
      'cannot be loaded',
    ],
    ['counts beyond all proportion', (json) => Object.assign(json.accessors[0], { count: 1e9 }), 'decode to'],
    ['no mesh', (json) => delete json.nodes[0].mesh, 'has no mesh'],
  ])('is refused with a one-line error: %s', async (_, edit, problem) => {
    const error = await open(edit).catch((thrown: Error) => thrown)
    expect((error as Error).name).toBe('FurrowError')
    expect((error as Error).message).toContain(problem)
    expect((error as Error).message).not.toContain('\n')
  })
})
