import { type Anything, type GlbParts, joinGlb, setImage, splitGlb } from '../../fuzz/glb-parts.ts'
import { noise } from '../../noise.ts'
import { sheet, sheetGlb } from './sheet.ts'

/** Names of the bones, which are nodes 1 to 6. Node 0 is the skin. The last two belong to the hair. */
const BONES = ['hips', 'spine', 'neck', 'head', 'hair', 'hair tip'] as const
const bone = (name: (typeof BONES)[number]) => 1 + BONES.indexOf(name)

/** Names of the images. The glTF material uses `base`; only VRM extensions use the others. */
const PICTURES = ['base', 'shade', 'matcap', 'outline width', 'thumbnail'] as const
const picture = (name: (typeof PICTURES)[number]) => PICTURES.indexOf(name)

/** Returns a VRM 0 avatar. One extension refers by index to nodes, meshes, images and groups of colliders. */
export function vrm0Avatar(): Promise<Uint8Array> {
  return avatar((json) => {
    json.materials[0].extensions = { KHR_materials_unlit: {} }
    json.extensionsUsed = ['KHR_materials_unlit', 'VRM']
    const bound = { binds: [{ mesh: 0, index: 0, weight: 100 }], isBinary: false }
    const color = { materialName: 'cloth', propertyName: '_Color', targetValue: [1, 0.5, 0.5, 1] }
    json.extensions = {
      VRM: {
        exporterVersion: 'UniVRM-0.128.0',
        specVersion: '0.0',
        meta: { title: 'avatar', author: 'nobody', texture: picture('thumbnail'), licenseName: 'CC0' },
        humanoid: {
          humanBones: BONES.slice(0, 4).map((name) => ({
            bone: name,
            node: bone(name),
            useDefaultValues: true,
          })),
          armStretch: 0.05,
          hasTranslationDoF: false,
        },
        firstPerson: {
          firstPersonBone: bone('head'),
          meshAnnotations: [{ mesh: 0, firstPersonFlag: 'Auto' }],
        },
        blendShapeMaster: {
          blendShapeGroups: [{ name: 'Bend', presetName: 'unknown', ...bound, materialValues: [color] }],
        },
        secondaryAnimation: {
          boneGroups: [{ comment: 'hair', center: -1, bones: [bone('hair')], colliderGroups: [1, 0] }],
          colliderGroups: [
            { node: bone('neck'), colliders: [{ offset: { x: 0, y: 0, z: 0 }, radius: 0.05 }] },
            { node: bone('head'), colliders: [{ offset: { x: 0, y: 0.1, z: 0 }, radius: 0.1 }] },
          ],
        },
        materialProperties: [
          {
            name: 'cloth',
            renderQueue: 2000,
            shader: 'VRM/MToon',
            floatProperties: { _ShadeToony: 0.9 },
            textureProperties: {
              _MainTex: picture('base'),
              _ShadeTexture: picture('shade'),
              _SphereAdd: picture('matcap'),
              _OutlineWidthTexture: picture('outline width'),
            },
          },
        ],
      },
    }
  })
}

/** Returns the avatar of `vrm0Avatar` as VRM 1.0, with extensions on nodes and materials, and a thumbnail that no texture uses. */
export function vrm1Avatar(): Promise<Uint8Array> {
  return avatar((json) => {
    json.textures.splice(picture('thumbnail'), 1)
    json.materials[0].extensions = {
      KHR_materials_unlit: {},
      VRMC_materials_mtoon: {
        specVersion: '1.0',
        shadeMultiplyTexture: { index: picture('shade'), texCoord: 0 },
        matcapTexture: { index: picture('matcap') },
        outlineWidthMultiplyTexture: { index: picture('outline width') },
      },
    }
    json.nodes[bone('hair tip')].extensions = {
      VRMC_node_constraint: {
        specVersion: '1.0',
        constraint: { rotation: { source: bone('head'), weight: 0.5 } },
      },
    }
    json.extensionsUsed = [
      'KHR_materials_unlit',
      'VRMC_vrm',
      'VRMC_materials_mtoon',
      'VRMC_springBone',
      'VRMC_node_constraint',
    ]
    json.extensions = {
      VRMC_vrm: {
        specVersion: '1.0',
        meta: {
          name: 'avatar',
          authors: ['nobody'],
          licenseUrl: 'https://vrm.dev/licenses/1.0/',
          thumbnailImage: picture('thumbnail'),
        },
        humanoid: {
          humanBones: Object.fromEntries(BONES.slice(0, 4).map((name) => [name, { node: bone(name) }])),
        },
        firstPerson: { meshAnnotations: [{ node: 0, type: 'auto' }] },
        expressions: {
          custom: {
            bend: {
              morphTargetBinds: [{ node: 0, index: 0, weight: 1 }],
              materialColorBinds: [{ material: 0, type: 'color', targetValue: [1, 0.5, 0.5, 1] }],
              textureTransformBinds: [{ material: 0, scale: [1, 1], offset: [0.1, 0] }],
            },
          },
        },
      },
      VRMC_springBone: {
        specVersion: '1.0',
        colliders: [
          { node: bone('neck'), shape: { sphere: { offset: [0, 0, 0], radius: 0.05 } } },
          { node: bone('head'), shape: { capsule: { offset: [0, 0, 0], radius: 0.1, tail: [0, 0.1, 0] } } },
        ],
        colliderGroups: [{ name: 'head and neck', colliders: [1, 0] }],
        springs: [
          { name: 'hair', joints: [{ node: bone('hair') }, { node: bone('hair tip') }], colliderGroups: [0] },
        ],
      },
    }
  })
}

/** Makes a sheet of skin with a blendshape, a chain of bones, and a texture per image. */
async function avatar(edit: (json: Anything) => void): Promise<Uint8Array> {
  const parts = splitGlb(Buffer.from(await sheetGlb(sheet())))
  const { json } = parts
  json.nodes.push(...BONES.map((name, i) => ({ name, ...(name !== 'hair tip' && { children: [i + 2] }) })))
  json.scenes[0].nodes.push(1)
  Object.assign(json, { images: [], textures: [], samplers: [{ wrapS: 33648 }] })
  const file = await PICTURES.reduce<Promise<GlbParts>>(async (parts, name, i) => {
    json.images[i] = { name }
    json.textures[i] = { name, source: i, sampler: 0 }
    return setImage(await parts, i, Buffer.from(await noise(i, 4)), 'image/png')
  }, Promise.resolve(parts))
  json.materials[0].pbrMetallicRoughness = { baseColorTexture: { index: picture('base') } }
  edit(json)
  return joinGlb(file)
}
