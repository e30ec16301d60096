import { readFileSync } from 'node:fs'
import { skinOf as characterSkin } from 'furrow/internal'
import { expressionsOfMesh, nameTargets, readMeshes } from 'furrow/internal/three'
import { findSkin } from 'furrow-files'
import type { Mesh } from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { describe, expect, it } from 'vitest'
import { documentOf } from '../../../packages/files/src/gltf/document.ts'
import { decodeGlb } from '../../../packages/files/src/gltf/glb-file.ts'
import { namesOfTargets, targetNamesOf } from '../../../packages/files/src/json/gltf-json.ts'
import { hoistNames } from '../../../studio/src/open/target-names.ts'
import { editGlb } from '../../glb.ts'
import { HUMAN } from './auto-variants.ts'

// biome-ignore lint/suspicious/noExplicitAny: tests edit the JSON in ways that no type allows
type Json = any

/** Edits the JSON of the face and loads it with three.js, without materials. */
async function loadBare(edit: (json: Json) => void, loader = new GLTFLoader()): Promise<GLTF> {
  const bytes = editGlb(readFileSync(HUMAN), (json) => {
    for (const key of ['materials', 'textures', 'images', 'extensionsUsed', 'extensions']) delete json[key]
    for (const mesh of json.meshes) for (const primitive of mesh.primitives) delete primitive.material
    edit(json)
  })
  return loader.setMeshoptDecoder(MeshoptDecoder).parseAsync(new Uint8Array(bytes).buffer, '')
}

const skinOf = ({ scene }: GLTF) => scene.getObjectByName('skin') as Mesh

describe('names of blendshapes', () => {
  it('are read from extras.targetNames', () => {
    expect(namesOfTargets(['a', '', 7], 3)).toEqual(['a', '', '7'])
  })

  it('are indices if names are missing, too few, or too many', () => {
    expect(namesOfTargets(undefined, 2)).toEqual(['0', '1'])
    expect(namesOfTargets('ab', 2)).toEqual(['0', '1'])
    expect(namesOfTargets(['a'], 2)).toEqual(['0', '1'])
    expect(namesOfTargets(['a', 'b', 'c'], 2)).toEqual(['0', '1'])
  })

  it('are indices if a name is no text', () => {
    expect(namesOfTargets(['a', {}, null, { toString: 1, valueOf: null }, []], 5)).toEqual([
      'a',
      '1',
      '2',
      '3',
      '4',
    ])
  })
})

describe('names that exporters write elsewhere', () => {
  const read = (mesh: object) => {
    const json = { asset: { version: '2.0' }, meshes: [mesh] }
    return decodeGlb(new TextEncoder().encode(JSON.stringify(json)), 'face.gltf', 'test').json.meshes![0]!
  }
  const targets = [{ POSITION: 1 }, { POSITION: 2 }]
  const names = ['browDownLeft', 'jawOpen']

  it.each([
    ['extras of a primitive', { targets, extras: { targetNames: names } }],
    [
      'targets[].extra',
      { targets: targets.map((target, i) => ({ ...target, extra: { targetName: names[i] } })) },
    ],
    [
      'targets[].extras',
      { targets: targets.map((target, i) => ({ ...target, extras: { targetName: names[i] } })) },
    ],
  ])('are read from %s', (_, primitive) => {
    const mesh = read({ primitives: [primitive] })
    expect(targetNamesOf(mesh)).toEqual(names)
    expect(mesh.primitives[0]!.targets).toEqual(targets)
  })

  it('do not replace names in the extras of the mesh, and are ignored if some are missing', () => {
    const extras = { targetNames: ['a', 'b'] }
    expect(
      targetNamesOf(read({ extras, primitives: [{ targets, extras: { targetNames: names } }] })),
    ).toEqual(['a', 'b'])
    const one = [{ POSITION: 1, extra: { targetName: 'a' } }, { POSITION: 2 }]
    expect(targetNamesOf(read({ primitives: [{ targets: one }] }))).toEqual(['0', '1'])
  })

  it.each<[string, string[], string[]]>([
    ['empty', ['jawOpen', ''], ['jawOpen', '1']],
    ['too long', ['x'.repeat(257), 'jawOpen'], ['0', 'jawOpen']],
    ['empty beside an index', ['', '0'], ['blendshape 0', '0']],
    ['those of a later one too', ['jawOpen', 'jawOpen'], ['0', 'jawOpen']],
  ])('become indices if they are %s', (_, given, expected) => {
    expect(targetNamesOf(read({ extras: { targetNames: given }, primitives: [{ targets }] }))).toEqual(
      expected,
    )
  })

  it('are used by the loader of the studio, and by automatic wrinkles on a page', async () => {
    const toPrimitives = (json: Json) => {
      for (const mesh of json.meshes) {
        for (const primitive of mesh.primitives) primitive.extras = mesh.extras
        delete mesh.extras
      }
    }
    const names = async (gltf: GLTF) => Object.keys(skinOf(gltf).morphTargetDictionary!)
    expect(await names(await loadBare(toPrimitives, new GLTFLoader().register(hoistNames)))).toContain(
      'browInnerUp',
    )
    const gltf = await loadBare(toPrimitives)
    const before = structuredClone(gltf.parser.json)
    nameTargets(gltf.parser, [skinOf(gltf)])
    expect(readMeshes([skinOf(gltf)]).names).toContain('browInnerUp')
    expect(gltf.parser.json).toEqual(before)
  })

  it.each([
    [
      'VRM 0',
      (mesh: number) => ({
        VRM: {
          blendShapeMaster: {
            blendShapeGroups: [{ name: 'BrowInnerUp', binds: [{ mesh, index: 3, weight: 100 }] }],
          },
        },
      }),
    ],
    [
      'VRM 1.0',
      (_: number, node: number) => ({
        VRMC_vrm: {
          expressions: { custom: { BrowInnerUp: { morphTargetBinds: [{ node, index: 3, weight: 1 }] } } },
        },
      }),
    ],
  ])('are those of the expressions of %s that move one blendshape', async (_, extensionsOf) => {
    const glb = decodeGlb(readFileSync(HUMAN), HUMAN, 'test')
    const mesh = glb.json.meshes!.findIndex(({ name }) => name === 'skin')
    const node = glb.json.nodes!.findIndex((one) => one.mesh === mesh)
    delete glb.json.meshes![mesh]!.extras
    glb.json.extensions = extensionsOf(mesh, node)
    const { skin } = findSkin(await documentOf(glb, HUMAN, 'test'), HUMAN, 'test', 'skin')
    expect(skin.targets.flatMap(({ name, expression }) => (expression ? [[name, expression]] : []))).toEqual([
      ['3', 'BrowInnerUp'],
    ])
    const gltf = await loadBare((json) => {
      delete json.meshes[mesh].extras
      json.extensions = extensionsOf(mesh, node)
    })
    const loaded = skinOf(gltf)
    const { targets } = characterSkin(readMeshes([loaded], expressionsOfMesh(gltf.parser, loaded)))
    expect(targets.map(({ name, expression }) => [name, expression])).toEqual(
      skin.targets.map(({ name, expression }) => [name, expression]),
    )
  })
})
